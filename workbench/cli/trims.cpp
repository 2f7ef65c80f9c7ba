#include "workbench/cli/trims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/compiled.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/manoeuvre/manoeuvre_run.hpp"
#include "workbench/operating/operating_point.hpp"
#include "workbench/results/results.hpp"

namespace mbgen::cli {
namespace {

constexpr int kMostTrims = 1000;
constexpr double kSteepest = 1;  // rise over run

/// A number or FIRST:LAST:COUNT.
std::vector<double> numbers_of(const std::string& typed, const std::string& option) {
  std::vector<double> numbers;
  for (const std::string& part : split_at(typed, ':')) numbers.push_back(parse_number(part, option));
  if (numbers.size() == 1) return numbers;
  const bool is_range = numbers.size() == 3 && numbers[2] >= 2 && numbers[2] <= kMostTrims &&
                        numbers[2] == std::floor(numbers[2]) && numbers[0] != numbers[1];
  if (!is_range)
    throw UserError(
        fmt::format("{}: \"{}\" is no number and no range\n  hint: FIRST:LAST:COUNT, for example 10:40:7, up "
                    "to {} of them\n",
                    option, typed, kMostTrims));
  std::vector<double> values;
  for (double i = 0; i < numbers[2]; ++i) values.push_back(std::lerp(numbers[0], numbers[1], i / (numbers[2] - 1)));
  return values;
}

std::vector<TrimRequest> requests_of(const TrimArguments& arguments, std::string& varied) {
  const std::vector<double> speeds = numbers_of(arguments.speed, "--speed");
  std::vector<double> bends;
  if (!arguments.lateral_acceleration.empty())
    bends = numbers_of(arguments.lateral_acceleration, "--lateral-acceleration");
  if (!bends.empty() && arguments.radius)
    throw UserError("--radius, --lateral-acceleration: a bend is asked by one of the two\n");
  if (speeds.size() > 1 && bends.size() > 1)
    throw UserError("--speed, --lateral-acceleration: one of the two may be a range\n");
  if (const double least = std::ranges::min(speeds); !(least > 0))
    throw UserError(fmt::format("--speed: {:g} m/s; a steady motion needs a speed above 0\n", least));
  if (arguments.radius && !(std::isfinite(*arguments.radius) && *arguments.radius != 0))
    throw UserError(fmt::format("--radius: {:g} m; a bend needs another radius\n", *arguments.radius));
  const double grade = arguments.grade.value_or(0);
  if (grade != 0 && (arguments.radius || !bends.empty()))
    throw UserError("--grade: a bend on a grade is not steady; leave out --radius and --lateral-acceleration\n");
  if (!(std::abs(grade) <= kSteepest))
    throw UserError(fmt::format("--grade: {:g}; rise over run, from -1 to 1\n", grade));
  varied = speeds.size() > 1 ? "speed" : bends.size() > 1 ? "lateral_acceleration" : "";
  std::vector<TrimRequest> requests;
  for (const double speed : speeds) {
    if (bends.empty()) requests.push_back({speed, {}, arguments.radius});
    for (const double bend : bends) requests.push_back({speed, bend, {}});
  }
  return requests;
}

/// The model at the speed, unless `set` has its parameter.
Model model_at_speed(const std::string& file, std::vector<std::string> set, double speed) {
  Model model = read_set_model(file, set);
  if (!model.vehicle || model.vehicle->speed < 0) return model;
  const std::string& name = model.parameters[static_cast<std::size_t>(model.vehicle->speed)].name;
  const auto sets_it = [&](const std::string& assignment) { return assignment.starts_with(name + "="); };
  if (std::ranges::any_of(set, sets_it)) return model;
  set.push_back(fmt::format("{}={}", name, speed));
  return read_set_model(file, set);
}

/// A value of a trim, SI units and radians.
struct TrimValue {
  std::string name, unit;
  double value = 0;
};

std::vector<TrimValue> values_of(const Model& model, const Trim& trim) {
  const Vehicle& vehicle = *model.vehicle;
  const auto input = [&](int place) { return model.inputs[static_cast<std::size_t>(place)]; };
  std::vector<TrimValue> values = {{"speed", "m/s", trim.speed},
                                   {"lateral_acceleration", "m/s^2", trim.lateral_acceleration},
                                   {"yaw_rate", "rad/s", trim.yaw_rate},
                                   {"radius", "m", trim.radius()},
                                   {input(vehicle.steer).name, input(vehicle.steer).unit, trim.steer}};
  if (trim.drive) values.push_back({input(vehicle.drive).name, input(vehicle.drive).unit, *trim.drive});
  values.insert(values.end(),
                {{"sideslip", "rad", trim.sideslip}, {"roll", "rad", trim.roll}, {"pitch", "rad", trim.pitch}});
  for (std::size_t i = 0; i < model.tyres.size(); ++i)
    values.push_back({"load_" + model.tyres[i].name, "N", trim.loads[i]});
  if (!trim.gains) return values;
  const SteeringGains& gains = *trim.gains;
  values.insert(values.end(), {{"yaw_rate_gain", "1/s", gains.yaw_rate},
                               {"lateral_acceleration_gain", "m/s^2/rad", gains.lateral_acceleration},
                               {"sideslip_gain", "1", gains.sideslip},
                               {"understeer_gradient", "rad/(m/s^2)", gains.understeer_gradient},
                               {"roll_gradient", "rad/(m/s^2)", gains.roll_gradient}});
  return values;
}

/// Angles in degrees.
TrimValue as_shown(TrimValue value) {
  if (!value.unit.starts_with("rad")) return value;
  value.unit.replace(0, 3, "deg");
  value.value *= 180 / std::numbers::pi;
  return value;
}

/// Straight on, up to rounding of the search.
bool is_straight(const Trim& trim) { return std::abs(trim.lateral_acceleration) < 1e-6; }

std::string single_text(const Model& model, const Trim& trim) {
  std::string text = fmt::format("steady motion, accelerations at most {:.1e}:\n", trim.steady.largest);
  for (const TrimValue& value : values_of(model, trim)) {
    if (value.name == "radius" && is_straight(trim)) continue;
    const TrimValue shown = as_shown(value);
    if (value.name == "yaw_rate_gain") text += "gains of steering at this speed:\n";
    text += fmt::format("  {:<32}{:>16.6g} {}\n", value.name, value.value, value.unit);
    if (shown.unit != value.unit) {
      text.pop_back();
      text += fmt::format(" = {:.5g} {}\n", shown.value, shown.unit);
    }
  }
  return text + "\n";
}

std::string table_text(const TrimStudy& study) {
  const Model& model = study.compilation.model;
  const auto input = [&](int place) { return model.inputs[static_cast<std::size_t>(place)].name; };
  std::vector<std::string> columns = {"speed", "lateral_acceleration", input(model.vehicle->steer)};
  if (model.vehicle->drive >= 0) columns.push_back(input(model.vehicle->drive));
  columns.insert(columns.end(), {"sideslip", "roll", "yaw_rate_gain", "sideslip_gain", "understeer_gradient"});
  std::string names, units, rows;
  for (const Trim& trim : study.trims) {
    const std::vector<TrimValue> values = values_of(model, trim);
    for (const std::string& column : columns) {
      const auto found = std::ranges::find(values, column, &TrimValue::name);
      if (found == values.end()) continue;
      const TrimValue value = as_shown(*found);
      const std::size_t width = std::max<std::size_t>(column.size(), 12) + 2;
      if (&trim == &study.trims.front()) {
        names += fmt::format("{:>{}}", column, width);
        units += fmt::format("{:>{}}", value.unit, width);
      }
      rows += fmt::format("{:>{}.5g}", value.value, width);
    }
    rows += "\n";
  }
  return fmt::format("{}\n{}\n{}", names, units, rows);
}

std::string table_csv(const TrimStudy& study) {
  std::string text;
  for (const TrimValue& value : values_of(study.compilation.model, study.trims.front()))
    text += (text.empty() ? "" : ",") + csv_field(heading_text({value.name, value.unit}));
  for (const Trim& trim : study.trims) {
    std::string row;
    for (const TrimValue& value : values_of(study.compilation.model, trim))
      row += fmt::format("{}{}", row.empty() ? "" : ",", value.value);
    text += "\n" + row;
  }
  return text + "\n";
}

/// A panel for each gain and angle over the varied quantity.
std::string table_svg(const TrimStudy& study) {
  const Model& model = study.compilation.model;
  std::vector<Panel> panels;
  Abscissa abscissa{study.varied, ""};
  std::vector<double> x;
  const std::vector<TrimValue> first = values_of(model, study.trims.front());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const TrimValue shown = as_shown(first[i]);
    Curve curve{first[i].name, {}, {}};
    for (const Trim& trim : study.trims) curve.y.push_back(as_shown(values_of(model, trim)[i]).value);
    if (first[i].name == study.varied) {
      abscissa.unit = shown.unit;
      x = curve.y;
      continue;
    }
    const bool is_drawn = first[i].unit.starts_with("rad") || first[i].name.ends_with("_gain");
    if (!is_drawn || first[i].name == "yaw_rate") continue;
    const auto panel = std::ranges::find(panels, shown.unit, &Panel::unit);
    if (panel == panels.end()) {
      panels.push_back({shown.unit, {curve}});
    } else {
      panel->curves.push_back(curve);
    }
  }
  for (Panel& panel : panels)
    for (Curve& curve : panel.curves) curve.x = x;
  return plot_svg(abscissa, panels);
}

/// The start of a search: the model's initial state, without its static equilibrium where there is none, as for a
/// vehicle on a hill. No rest is needed for a steady motion.
OperatingPoint start_of(const Compilation& level, const std::vector<std::string>& inputs) {
  StateArguments start;
  start.at = "initial";
  start.inputs = inputs;
  if (!level.model.initial.equilibrium) return operating_point(level, start).point;
  try {
    return operating_point(level, start).point;
  } catch (const UserError&) {
    Compilation moving = level;
    moving.model.initial.equilibrium = false;
    return operating_point(moving, start).point;
  }
}

}  // namespace

TrimStudy trim_study(const std::string& file, const std::vector<std::string>& set,
                     const std::vector<std::string>& inputs, const TrimArguments& arguments) {
  TrimStudy study;
  const std::vector<TrimRequest> requests = requests_of(arguments, study.varied);
  Model model = model_at_speed(file, set, requests.front().speed);
  prepare_trims(model);
  require_others_inputs(model, "--input", inputs, "a steady motion finds");
  const Compilation level = expect(decide(model));
  const OperatingPoint point = start_of(level, inputs);
  if (arguments.grade.value_or(0) != 0) incline(model, *arguments.grade, heading_at(level, point));
  study.compilation = compiled(std::move(model));
  TrimSeries series = trim_series(study.compilation, point, requests);
  study.trims = std::move(series.trims);
  study.end = std::move(series.end);
  if (study.trims.empty()) throw UserError(fmt::format("{}: {}\n", file, study.end));
  return study;
}

std::string trims_text(const TrimStudy& study) {
  if (!study.is_range()) return single_text(study.compilation.model, study.trims.front());
  return table_text(study);
}

nlohmann::ordered_json trims_json(const TrimStudy& study) {
  auto list = nlohmann::ordered_json::array();
  for (const Trim& trim : study.trims) {
    auto one = nlohmann::ordered_json::object();
    for (const TrimValue& value : values_of(study.compilation.model, trim)) one[value.name] = value.value;
    one["largest_acceleration"] = trim.steady.largest;
    list.push_back(std::move(one));
  }
  return list;
}

void write_trims(const TrimArguments& arguments, const TrimStudy& study, const std::vector<std::string>& read) {
  for (const std::string& file : arguments.files) {
    const bool is_table = file.ends_with(".csv");
    if (!is_table && !file.ends_with(".svg"))
      throw UserError(fmt::format("--handling-out: \"{}\" is no .csv and no .svg file\n", file));
    write_file(file, is_table ? table_csv(study) : table_svg(study), read);
  }
}

}  // namespace mbgen::cli
