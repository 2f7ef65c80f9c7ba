#pragma once
// The door of the report room: a result and its model as one HTML page that needs nothing else.

#include <string>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/results/results.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Whether the page's program was bundled into this mbgen; without it there are no reports.
bool has_report_page();

/// What a report is made from.
struct ReportSource {
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  const Results& results;  ///< of this model: with a column z.NAME for each coordinate
};

/// The page: animation, plots, summary, topology. Poses come from the coordinates by the generic runtime's kinematics,
/// with parameters at their values in the model. Times closer than 10 ms, and what is over a few megabytes, is thinned
/// out evenly; extremes in the tables are those of all rows. Names are escaped.
/// Fails: a result that lacks a coordinate of the model (file: the result's name, for the message).
/// Requires: has_report_page().
Result<std::string> report_html(const ReportSource& source, const std::string& file);

}  // namespace mbgen
