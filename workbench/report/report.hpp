#pragma once
// Interface of the report room: a result, or the modes of a model, as one self-contained HTML page.

#include <string>

#include "compiler/text/diagnostic.hpp"
#include "workbench/report/sources.hpp"

namespace mbgen {

/// Whether this mbgen contains the page's program; without it there are no reports.
bool has_report_page();

/// The page: animation, plots, summary, topology. Poses come from the coordinates by the generic runtime's kinematics,
/// with parameters at their values in the model. Rows closer than 10 ms, and rows beyond a few megabytes, are thinned
/// out evenly; extremes in the tables are taken over all rows. Names are escaped.
/// label: of the first result among others. Others are shown at the same time: mechanisms translucent, values of
/// columns with the same name and unit between their rows, nothing after their end. Fails: a result that lacks a
/// coordinate of its model (file: the result's name, for the message). Requires: has_report_page().
Result<std::string> report_html(const ReportSource& source, const std::string& file, const std::string& label = {},
                                const std::vector<OtherResult>& others = {});

/// The page: a list of the modes, each animated about the point with its loops closed, the eigenvalues in their plane,
/// summary, topology. Names are escaped.
/// Requires: has_report_page().
std::string modes_html(const ModesSource& source);

}  // namespace mbgen
