#pragma once
// The door of the report room: a result, or the modes of a model, as one HTML page that needs nothing else.

#include <string>

#include "compiler/analysis/analysis.hpp"
#include "compiler/linearisation/linearisation.hpp"
#include "compiler/model/model.hpp"
#include "compiler/results/results.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Whether the page's program was bundled into this mbgen; without it there are no reports.
bool has_report_page();

/// Sources of a report.
struct ReportSource {
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  const Results& results;  ///< of this model: with a column z.NAME for each coordinate
};

/// The page: animation, plots, summary, topology. Poses come from the coordinates by the generic runtime's kinematics,
/// with parameters at their values in the model. Rows closer than 10 ms, and rows beyond a few megabytes, are thinned
/// out evenly; extremes in the tables are taken over all rows. Names are escaped.
/// Fails: a result that lacks a coordinate of the model (file: the result's name, for the message).
/// Requires: has_report_page().
Result<std::string> report_html(const ReportSource& source, const std::string& file);

/// Sources of a page of modes.
struct ModesSource {
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  const OperatingPoint& point;
  const std::vector<Mode>& modes;  ///< about the point; at least one
  std::string state;               ///< which state the point is, for people
  double drift = 0;                ///< largest rate of the states at the point
};

/// The page: a list of the modes, each animated about the point with its loops closed, the eigenvalues in their plane,
/// summary, topology. Names are escaped.
/// Requires: has_report_page().
std::string modes_html(const ModesSource& source);

}  // namespace mbgen
