#pragma once
// Sources of a page: a result, or the modes about a point, with the model.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/linearisation/linearisation.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {

/// Sources of a report.
struct ReportSource {
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  const Results& results;  ///< of this model, with a column z.NAME for each coordinate
};

/// A further result on a page: drawn translucent, its columns beside those of the first one.
struct OtherResult {
  ReportSource source;
  std::string file, label;
};

/// A diagram of curves over a quantity that is not time.
struct PageDiagram {
  std::string title;
  Heading x, y;             ///< shown with these units
  std::string logarithmic;  ///< axes: "", "x" or "xy"
  struct Line {
    std::string name;
    std::vector<double> x, y;  ///< of one length; values that are not finite interrupt the curve
  };
  std::vector<Line> curves;
};

/// Sources of a page of modes.
struct ModesSource {
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  const OperatingPoint& point;
  const std::vector<Mode>& modes;           ///< about the point; at least one
  std::string state;                        ///< name of the state, for people
  double drift = 0;                         ///< largest rate of the states at the point
  std::vector<PageDiagram> responses = {};  ///< frequency responses about the point
};

}  // namespace mbgen
