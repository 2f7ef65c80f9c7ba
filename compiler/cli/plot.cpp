// mbgen plot: columns of a result over time, as a picture.

#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/result_file.hpp"
#include "compiler/cli/user_error.hpp"
#include "compiler/drawing/drawing.hpp"

namespace mbgen::cli {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;  // rad

struct PlotOptions {
  std::string result, file = "-";
  std::vector<std::string> columns;
  PlotSize size;
  bool degrees = false;
};

/// A column as it is drawn: angles in degrees where that is asked for.
Column drawn(Column column, bool degrees) {
  std::string& unit = column.heading.unit;
  if (!degrees || !unit.starts_with("rad") || (unit.size() > 3 && unit[3] != '/')) return column;
  unit = "deg" + unit.substr(3);
  for (double& value : column.values) value /= kDegree;
  return column;
}

/// The columns of one --columns: a panel for each unit among them, in the order in which they are named.
void add_panels(const Results& results, const std::string& names, const PlotOptions& options,
                std::vector<Panel>& panels) {
  const std::size_t first = panels.size();
  for (const int c : find_columns(results, names, options.result)) {
    Column column = drawn(results.columns[static_cast<std::size_t>(c)], options.degrees);
    const std::string unit = column.heading.unit == "1" ? "" : column.heading.unit;
    std::size_t panel = first;
    while (panel < panels.size() && panels[panel].unit != unit) ++panel;
    if (panel == panels.size()) panels.push_back({unit, {}});
    panels[panel].curves.push_back({column.heading.name, std::move(column.values)});
  }
}

int run(const PlotOptions& options) {
  require_other_file(options.file, {options.result});
  const Results results = read_result_file(options.result);
  std::vector<Panel> panels;
  for (const std::string& names : options.columns) add_panels(results, names, options, panels);
  write_or_print(options.file, plot_svg(results.columns.front().values, panels, options.size));
  return kDone;
}

}  // namespace

void add_plot(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* command = application.add_subcommand("plot", "draw columns of a result over time (SVG)");
  command->footer(
      "Example: mbgen plot coach.csv --columns roll,yaw_rate --columns 'load_*' --degrees -o coach.svg\n"
      "Each --columns begins panels of its own, one for each unit among its columns; * stands for any letters.");
  command->add_option("RESULT", options->result, "what mbgen simulate wrote (CSV or MAT)")->required();
  command->add_option("--columns", options->columns, "names of columns with commas between them; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command->add_option("-o,--out", options->file, "the picture (default: standard output)");
  command->add_flag("--degrees", options->degrees, "angles in degrees");
  command->add_option("--width", options->size.width, "px")->capture_default_str()->check(CLI::Range(200, 10000));
  command->add_option("--height", options->size.panel_height, "px, of a panel")
      ->capture_default_str()
      ->check(CLI::Range(50, 10000));
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
