// mbgen plot: curves of results or of a study, over time, another column or frequency.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/result_labels.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/motion/result_file.hpp"
#include "workbench/results/results.hpp"
#include "workbench/signals/power_spectrum.hpp"
#include "workbench/signals/weighting.hpp"

namespace mbgen::cli {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;  // rad

struct PlotOptions {
  std::vector<std::string> results;
  std::string file = "-", over, by, weight;
  std::vector<std::string> columns, where;
  std::optional<double> segment;  ///< s
  PlotSize size;
  bool degrees = false, is_spectrum = false;
};

/// Parts of the series that a segment of a spectrum has where the command line does not say: seven segments that
/// overlap by half.
constexpr std::size_t kParts = 4;
/// Tolerance for equal steps of time, of a step.
constexpr double kSameStep = 1e-6;

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
  std::vector<bool> is_shown = {};  ///< per row
  std::string label = {};           ///< among several files
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

/// A condition on rows: "bar >= 7000".
struct Condition {
  std::string column, sign;
  double value = 0;
};

Condition condition_of(const std::string& text) {
  for (const std::string sign : {"<=", ">=", "!=", "=", "<", ">"}) {
    const std::size_t place = text.find(sign);
    if (place == std::string::npos || place == 0) continue;
    const auto bare = [](std::string word) {
      word.erase(0, word.find_first_not_of(' '));
      word.erase(word.find_last_not_of(' ') + 1);
      return word;
    };
    return {bare(text.substr(0, place)), sign, parse_number(bare(text.substr(place + sign.size())), "--where")};
  }
  throw UserError(fmt::format("--where \"{}\": must be COLUMN SIGN NUMBER, with one of = != < <= > >=\n", text));
}

bool holds(const Condition& condition, double x) {
  const double y = condition.value;
  if (condition.sign == "<=") return x <= y;
  if (condition.sign == ">=") return x >= y;
  if (condition.sign == "!=") return x != y && !std::isnan(x);
  if (condition.sign == "<") return x < y;
  return condition.sign == ">" ? x > y : x == y;
}

/// Marks the rows where all conditions hold. Fails: UserError if there are none.
void choose_rows(PlotSource& source, const std::vector<std::string>& conditions) {
  source.is_shown.assign(source.results.rows(), true);
  for (const std::string& text : conditions) {
    const Condition condition = condition_of(text);
    const Column& column = single_column(source, condition.column, "--where");
    for (std::size_t row = 0; row < column.values.size(); ++row)
      source.is_shown[row] = source.is_shown[row] && holds(condition, column.values[row]);
  }
  if (std::find(source.is_shown.begin(), source.is_shown.end(), true) != source.is_shown.end()) return;
  throw UserError(fmt::format("--where: {} has no such row\n", source.path));
}

PlotSource read_source(const std::string& path, const PlotOptions& options) {
  PlotSource source{.path = path, .results = read_result_or_sweep(path), .over = {}};
  source.is_sweep = source.results.columns.front().heading.name == "case";
  source.over = options.over.empty() ? source.results.columns.front() : single_column(source, options.over, "--over");
  source.over = drawn(source.over, options.degrees);
  choose_rows(source, options.where);
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
    if (!source.is_shown[row]) continue;
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

/// The step of a series at equal steps; a last one that is shorter is left out of the values. Fails: UserError.
double step_of(const Column& time, std::vector<double>& values, const std::string& path, const std::string& option) {
  if (time.heading.name != "t" || values.size() < 3)
    throw UserError(fmt::format("{}: {} is no series over time\n", option, path));
  const double step = time.values[1] - time.values[0];
  const auto is_same = [&](std::size_t i) {
    return std::abs(time.values[i] - time.values[i - 1] - step) <= kSameStep * step;
  };
  for (std::size_t i = 2; i < values.size(); ++i) {
    if (is_same(i)) continue;
    if (i + 1 == values.size()) {
      values.pop_back();
      break;
    }
    throw UserError(fmt::format("{}: the rows of {} are not at equal steps of time: {:.10g} s follows {:.10g} s\n",
                                option, path, time.values[i], time.values[i - 1]));
  }
  return step;
}

/// An acceleration under the weighting, with its numbers on standard error or output.
void weigh(Column& column, const PlotSource& source, const PlotOptions& options) {
  const Weighting weighting = *weighting_of(options.weight);
  const std::string& unit = column.heading.unit;
  if (unit != "m/s^2" && unit != "rad/s^2") {
    throw UserError(fmt::format("--weight: {} of {} is no acceleration, its unit is {}\n", column.heading.name,
                                source.path, unit.empty() ? "1" : unit));
  }
  const double step = step_of(source.over, column.values, source.path, "--weight");
  if (1 / step < least_rate(weighting) * (1 - kSameStep)) {
    throw UserError(fmt::format("--weight {}: {} has {:.4g} rows in a second, the weighting needs {:g}\n",
                                options.weight, source.path, 1 / step, least_rate(weighting)));
  }
  const Comfort comfort = comfort_of(column.values, step, weighting);
  print_beside(options.file,
               fmt::format("{} of {}, W_{} of ISO 2631-1: {:.5g} {} rms, crest factor {:.4g}, largest running rms "
                           "{:.5g} {}, dose {:.5g} {}\n",
                           column.heading.name, source.path, options.weight, comfort.rms, unit, comfort.crest,
                           comfort.transient, unit, comfort.dose, unit == "m/s^2" ? "m/s^1.75" : "rad/s^1.75"));
  column.values = weighted(without_mean(column.values), step, weighting);
  column.heading.name = fmt::format("W_{}({})", options.weight, column.heading.name);
}

/// The curve of a power spectral density.
Curve spectrum_of(Column column, const PlotSource& source, const PlotOptions& options) {
  const double step = step_of(source.over, column.values, source.path, "--psd");
  const std::size_t size = column.values.size();
  std::size_t points = std::max<std::size_t>(size / kParts, 2);
  if (options.segment) {
    points = static_cast<std::size_t>(std::max(0.0, std::round(*options.segment / step)));
    if (points < 2 || points > size) {
      throw UserError(
          fmt::format("--segment: must be from {:g} to {:g} s, the steps and the length of {}, found {:g}\n", 2 * step,
                      step * static_cast<double>(size), source.path, *options.segment));
    }
  }
  const PowerSpectrum spectrum = power_spectrum(column.values, step, points);
  Curve curve{column.heading.name, {}, spectrum.density};
  for (std::size_t k = 0; k < curve.y.size(); ++k) curve.x.push_back(spectrum.step * static_cast<double>(k));
  return curve;
}

/// The unit of a density over frequency.
std::string density_unit(const std::string& unit) {
  if (unit.empty()) return "1/Hz";
  return (unit.find_first_of("/ ") == std::string::npos ? unit : "(" + unit + ")") + "^2/Hz";
}

/// The panel of a unit, from the first new one on.
Panel& panel_of(const std::string& unit, std::size_t first, std::vector<Panel>& panels) {
  const auto is_it = [&](const Panel& panel) { return panel.unit == unit; };
  const auto found = std::find_if(panels.begin() + static_cast<std::ptrdiff_t>(first), panels.end(), is_it);
  return found == panels.end() ? panels.emplace_back(Panel{unit, {}}) : *found;
}

/// Columns of one --columns in one file: a panel for each of their units, in the order of the names. first: index of
/// the first new panel.
void add_panels(const PlotSource& source, const std::string& names, const PlotOptions& options, std::size_t first,
                std::vector<Panel>& panels) {
  const std::vector<Rows> all = rows_of(source, options);
  for (const int c : find_columns(source.results, names, source.path)) {
    Column column = source.results.columns[static_cast<std::size_t>(c)];
    if (!options.weight.empty()) weigh(column, source, options);
    column = drawn(std::move(column), options.degrees);
    const std::string unit = column.heading.unit == "1" ? "" : column.heading.unit;
    const std::string of_file = options.results.size() > 1 ? fmt::format(" ({})", source.label) : "";
    if (options.is_spectrum) {
      Curve curve = spectrum_of(column, source, options);
      curve.label += of_file;
      panel_of(density_unit(unit), first, panels).curves.push_back(std::move(curve));
      continue;
    }
    for (const Rows& rows : all) {
      Curve curve{column.heading.name, {}, {}};
      if (!rows.label.empty()) curve.label += ", " + rows.label;
      curve.label += of_file;
      for (const std::size_t row : rows.indices) {
        if (row >= column.values.size()) continue;
        curve.x.push_back(source.over.values[row]);
        curve.y.push_back(column.values[row]);
      }
      panel_of(unit, first, panels).curves.push_back(std::move(curve));
    }
  }
}

/// The curves as a table over their common abscissa. Fails: UserError if they have none.
std::string curves_csv(const Abscissa& abscissa, const std::vector<Panel>& panels) {
  const std::vector<double>& x = panels.front().curves.front().x;
  std::string text = csv_field(heading_text({abscissa.title == "time" ? "t" : abscissa.title, abscissa.unit}));
  for (const Panel& panel : panels) {
    for (const Curve& curve : panel.curves) {
      if (curve.x != x)
        throw UserError(fmt::format("--out: {} stands over other values than {}: one table cannot hold both\n",
                                    curve.label, panels.front().curves.front().label));
      text += "," + csv_field(heading_text({curve.label, panel.unit}));
    }
  }
  for (std::size_t row = 0; row < x.size(); ++row) {
    text += fmt::format("\n{}", x[row]);
    for (const Panel& panel : panels)
      for (const Curve& curve : panel.curves)
        text += std::isfinite(curve.y[row]) ? fmt::format(",{}", curve.y[row]) : ",";
  }
  return text + "\n";
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

/// Fails: UserError for options that do not go together.
void check(const PlotOptions& options) {
  if (!options.weight.empty() && !weighting_of(options.weight))
    throw UserError(
        fmt::format("--weight: there is no weighting \"{}\"; there are: k, d, c, e, j, f\n", options.weight));
  const char* series = options.is_spectrum ? "--psd" : options.weight.empty() ? nullptr : "--weight";
  if (options.segment && !options.is_spectrum) throw UserError("--segment: goes with --psd\n");
  if (!series) return;
  if (!options.where.empty()) throw UserError(fmt::format("--where: {} needs all rows\n", series));
  if (options.is_spectrum && !options.by.empty()) throw UserError("--by: --psd needs all rows\n");
  if (!options.over.empty()) throw UserError(fmt::format("--over: {} is of a series over time\n", series));
}

int run(const PlotOptions& options) {
  check(options);
  std::vector<PlotSource> sources;
  for (const std::string& path : options.results) sources.push_back(read_source(path, options));
  require_same_axis(sources);
  const std::vector<std::string> labels =
      result_labels(options.results, [&](std::size_t i) { return sources[i].results.run; });
  for (std::size_t i = 0; i < sources.size(); ++i) sources[i].label = labels[i];
  std::vector<Panel> panels;
  for (const std::string& names : options.columns) {
    const std::size_t first = panels.size();
    for (const PlotSource& source : sources) add_panels(source, names, options, first, panels);
  }
  const Heading& over = sources.front().over.heading;
  Abscissa abscissa{over.name == "t" ? "time" : over.name, over.unit == "1" ? "" : over.unit};
  if (options.is_spectrum) abscissa = {"frequency", "Hz", true};
  std::vector<std::string> read = options.results;
  for (const std::string& result : options.results) read.push_back(run_file(result));
  const bool is_table = options.file.ends_with(".csv");
  write_file(options.file, is_table ? curves_csv(abscissa, panels) : plot_svg(abscissa, panels, options.size), read);
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
      "         mbgen plot sweep.csv --columns roll_max --over speed --where 'bar_front >= 7000' -o study.svg\n"
      "         mbgen plot ride.csv --columns seat_az --psd --segment 4 -o density.svg\n"
      "         mbgen plot ride.csv --columns seat_az --weight k -o felt.svg\n"
      "Each --columns begins panels of its own, one for each unit among its columns; * stands for any letters.\n"
      "Cases of a study that failed are left out.");
  command.add_option("RESULT", options->results, "table of mbgen simulate (CSV or MAT) or of mbgen sweep; one or more")
      .required();
  command.add_option("--columns", options->columns, "names of columns with commas between them; may be repeated")
      .required()
      .one_value_at_a_time();
  command.add_option("--over", options->over, "column to draw over (default: t, of a study the case)");
  command.add_option("--by", options->by, "a curve for each value of this column");
  command.add_option("--where", options->where, "only rows with COLUMN = != < <= > >= NUMBER; may be repeated")
      .one_value_at_a_time();
  command.add_flag("--psd", options->is_spectrum,
                   "power spectral density over frequency, one-sided (Welch, Hann windows that overlap by half)");
  command.add_option("--segment", options->segment, "s, length of a window of --psd (default: a quarter of the rows)");
  command.add_option("--weight", options->weight,
                     "frequency weighting of accelerations, ISO 2631-1: k, d, c, e, j or f; prints the weighted rms");
  command.add_option("-o,--out", options->file,
                     "the picture, or FILE.csv for its curves as a table (default: standard output)");
  command.add_flag("--degrees", options->degrees, "angles in degrees");
  command.add_option("--width", options->size.width, "px").with_shown_default().between(200, 10000);
  command.add_option("--height", options->size.panel_height, "px, of a panel").with_shown_default().between(50, 10000);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
