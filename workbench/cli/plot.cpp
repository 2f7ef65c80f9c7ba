// mbgen plot: curves of results or of a study, over time or another column.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/motion/result_file.hpp"

namespace mbgen::cli {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;  // rad

struct PlotOptions {
  std::vector<std::string> results;
  std::string file = "-", over, by;
  std::vector<std::string> columns;
  PlotSize size;
  bool degrees = false;
};

/// A column for drawing: angles in degrees on request.
Column drawn(Column column, bool degrees) {
  std::string& unit = column.heading.unit;
  if (!degrees || !unit.starts_with("rad") || (unit.size() > 3 && unit[3] != '/')) return column;
  unit = "deg" + unit.substr(3);
  for (double& value : column.values) value /= kDegree;
  return column;
}

/// A file with data, and the column for the abscissa.
struct PlotSource {
  std::string path;
  Results results;
  Column over;
  bool is_sweep = false;
};

/// The only column of this name.
const Column& single_column(const PlotSource& source, const std::string& name, const std::string& option) {
  const Results& results = source.results;
  const Column& first = results.columns.front();
  if (name == first.heading.name || name == heading_text(first.heading)) return first;
  const std::vector<int> found = find_columns(results, name, source.path, option);
  if (found.size() == 1) return results.columns[static_cast<std::size_t>(found.front())];
  throw UserError(
      fmt::format("{}: \"{}\" must be one column of {}, found {}\n", option, name, source.path, found.size()));
}

PlotSource read_source(const std::string& path, const PlotOptions& options) {
  PlotSource source{path, read_result_or_sweep(path), {}, false};
  source.is_sweep = source.results.columns.front().heading.name == "case";
  source.over = options.over.empty() ? source.results.columns.front() : single_column(source, options.over, "--over");
  source.over = drawn(source.over, options.degrees);
  return source;
}

/// Rows of one curve, and the addition to its label.
struct Rows {
  std::string label;
  std::vector<std::size_t> indices;
};

/// All rows, or the rows of each value of the column `by`. Cases of a study are sorted by x.
std::vector<Rows> rows_of(const PlotSource& source, const PlotOptions& options) {
  std::vector<Rows> all;
  const Column* by = options.by.empty() ? nullptr : &single_column(source, options.by, "--by");
  for (std::size_t row = 0; row < source.results.rows(); ++row) {
    const std::string label = by == nullptr ? "" : fmt::format("{} = {:.6g}", by->heading.name, by->values[row]);
    const auto same = std::find_if(all.begin(), all.end(), [&](const Rows& rows) { return rows.label == label; });
    if (same != all.end()) {
      same->indices.push_back(row);
    } else {
      all.push_back({label, {row}});
    }
  }
  if (!source.is_sweep) return all;
  for (Rows& rows : all) {
    std::stable_sort(rows.indices.begin(), rows.indices.end(),
                     [&](std::size_t a, std::size_t b) { return source.over.values[a] < source.over.values[b]; });
  }
  return all;
}

/// Columns of one --columns in one file: a panel for each of their units, in the order of the names. first: index of
/// the first new panel.
void add_panels(const PlotSource& source, const std::string& names, const PlotOptions& options, std::size_t first,
                std::vector<Panel>& panels) {
  const std::vector<Rows> all = rows_of(source, options);
  for (const int c : find_columns(source.results, names, source.path)) {
    const Column column = drawn(source.results.columns[static_cast<std::size_t>(c)], options.degrees);
    const std::string unit = column.heading.unit == "1" ? "" : column.heading.unit;
    std::size_t panel = first;
    while (panel < panels.size() && panels[panel].unit != unit) ++panel;
    if (panel == panels.size()) panels.push_back({unit, {}});
    for (const Rows& rows : all) {
      Curve curve{column.heading.name, {}, {}};
      if (!rows.label.empty()) curve.label += ", " + rows.label;
      if (options.results.size() > 1) curve.label += fmt::format(" ({})", source.path);
      for (const std::size_t row : rows.indices) {
        curve.x.push_back(source.over.values[row]);
        curve.y.push_back(column.values[row]);
      }
      panels[panel].curves.push_back(std::move(curve));
    }
  }
}

/// Fails: UserError if the abscissas of files differ.
void require_same_axis(const std::vector<PlotSource>& sources) {
  const Heading& first = sources.front().over.heading;
  for (const PlotSource& source : sources) {
    const Heading& other = source.over.heading;
    if (other.name == first.name && other.unit == first.unit) continue;
    throw UserError(fmt::format("--over: {} is over {}, {} over {}; name a column that both have\n",
                                sources.front().path, heading_text(first), source.path, heading_text(other)));
  }
}

int run(const PlotOptions& options) {
  std::vector<PlotSource> sources;
  for (const std::string& path : options.results) sources.push_back(read_source(path, options));
  require_same_axis(sources);
  std::vector<Panel> panels;
  for (const std::string& names : options.columns) {
    const std::size_t first = panels.size();
    for (const PlotSource& source : sources) add_panels(source, names, options, first, panels);
  }
  const Heading& over = sources.front().over.heading;
  const Abscissa abscissa{over.name == "t" ? "time" : over.name, over.unit == "1" ? "" : over.unit};
  std::vector<std::string> read = options.results;
  for (const std::string& result : options.results) read.push_back(run_file(result));
  write_file(options.file, plot_svg(abscissa, panels, options.size), read);
  return kDone;
}

}  // namespace

void add_plot(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<PlotOptions>();
  NamedCommand command =
      application.add_command("plot", "draw columns of results over time, or over another column (SVG)");
  command.footer(
      "Example: mbgen plot coach.csv --columns roll,yaw_rate --columns 'load_*' --degrees -o coach.svg\n"
      "         mbgen plot coach.csv truck.csv --columns roll --over lateral_acceleration -o both.svg\n"
      "         mbgen plot sweep.csv --columns roll_max --over speed --by bar_front -o study.svg\n"
      "Each --columns begins panels of its own, one for each unit among its columns; * stands for any letters.\n"
      "Cases of a study that failed are left out.");
  command.add_option("RESULT", options->results, "table of mbgen simulate (CSV or MAT) or of mbgen sweep; one or more")
      .required();
  command.add_option("--columns", options->columns, "names of columns with commas between them; may be repeated")
      .required()
      .one_value_at_a_time();
  command.add_option("--over", options->over, "column to draw over (default: t, of a study the case)");
  command.add_option("--by", options->by, "a curve for each value of this column");
  command.add_option("-o,--out", options->file, "the picture (default: standard output)");
  command.add_flag("--degrees", options->degrees, "angles in degrees");
  command.add_option("--width", options->size.width, "px").with_shown_default().between(200, 10000);
  command.add_option("--height", options->size.panel_height, "px, of a panel").with_shown_default().between(50, 10000);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
