#include "workbench/sweep/sweep_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/names.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/manoeuvre/manoeuvre.hpp"

namespace mbgen {
namespace {

constexpr double kMostCases = 1e7;
/// Tolerance for the end of a range, of a step.
constexpr double kEndOfRange = 1e-9;
/// Significant decimal digits that survive conversion to double and back.
constexpr int kDigits = 15;

std::vector<std::string> pieces(const std::string& text, char separator) {
  std::vector<std::string> list(1);
  for (const char letter : text) {
    if (letter == separator) {
      list.emplace_back();
    } else if (letter != ' ') {
      list.back() += letter;
    }
  }
  return list;
}

[[noreturn]] void refuse_vary(const std::string& text, const std::string& problem) {
  throw UserError(fmt::format("--vary \"{}\": {}\n", text, problem));
}

/// A value rounded to the intended decimal: 0.1 + 2 * 0.1 is 0.3. scale: largest of its operands.
double rounded(double value, double scale) {
  const int digits_before = static_cast<int>(std::floor(std::log10(scale))) + 1;
  const int decimals = std::clamp(kDigits - digits_before, 0, 300);
  return std::stod(fmt::format("{:.{}f}", value, decimals)) + 0.0;  // -0 + 0 is 0
}

/// Adds the values of "first:step:last".
void add_range(const std::string& text, const std::vector<std::string>& parts, std::vector<double>& values) {
  const std::string what = fmt::format("--vary \"{}\"", text);
  const double first = parse_number(parts[0], what), step = parse_number(parts[1], what),
               last = parse_number(parts[2], what);
  if (step == 0) refuse_vary(text, "the step of a range cannot be 0");
  const double steps = std::floor((last - first) / step + kEndOfRange);
  if (steps < 0) {
    refuse_vary(text, fmt::format("a range from {} by steps of {} does not come to {}", first, step, last));
  }
  if (!(steps < kMostCases)) refuse_vary(text, "the range has more than 10 million values");
  const double scale = std::max({std::abs(first), std::abs(last), std::abs(step)});
  for (long k = 0; k <= static_cast<long>(steps); ++k) {
    values.push_back(rounded(first + static_cast<double>(k) * step, scale));
  }
}

std::vector<double> read_values(const std::string& text, const std::string& list) {
  std::vector<double> values;
  for (const std::string& piece : pieces(list, ',')) {
    const std::vector<std::string> parts = pieces(piece, ':');
    if (parts.size() == 1) {
      values.push_back(parse_number(piece, fmt::format("--vary \"{}\"", text)));
    } else if (parts.size() == 3) {
      add_range(text, parts, values);
    } else {
      refuse_vary(text, "a range is written first:step:last");
    }
  }
  return values;
}

template <class Item>
int index_of(const std::vector<Item>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Item& item) { return item.name == name; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

[[noreturn]] void unknown_name(const std::string& text, const std::string& name, const Model& model) {
  std::vector<std::string_view> known;
  for (const Parameter& parameter : model.parameters) known.push_back(parameter.name);
  for (const Input& input : model.inputs) known.push_back(input.name);
  const std::string hint = known.empty() ? "it has none" : reading::did_you_mean(name, known);
  refuse_vary(text,
              fmt::format("the model has no parameter or input \"{}\"{}{}", name, hint.empty() ? "" : "; ", hint));
}

/// Unit of a number of the manoeuvre.
std::string unit_in_manoeuvre(const std::string& text, const std::string& name, const std::string& manoeuvre) {
  if (manoeuvre.empty()) refuse_vary(text, "there is no manoeuvre; give its file with --manoeuvre");
  if (name == "step") refuse_vary(text, "all cases have the same step; give it with --step");
  ManoeuvreNumber number = find_number(manoeuvre, name);
  if (!number.problem.empty()) refuse_vary(text, number.problem);
  return number.unit;
}

SweepAxis read_axis(const std::string& text, const Model& model, const std::string& manoeuvre) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) refuse_vary(text, "must be name=first:step:last or name=value,value");
  SweepAxis axis;
  axis.name = pieces(text.substr(0, sign), '=').front();
  const std::string values = text.substr(sign + 1);
  if (axis.name.starts_with(kOfManoeuvre)) {
    axis.of = SweepAxis::Of::manoeuvre;
    axis.unit = unit_in_manoeuvre(text, axis.name.substr(kOfManoeuvre.size()), manoeuvre);
    axis.values = read_values(text, values);
    return axis;
  }
  axis.index = index_of(model.parameters, axis.name);
  if (axis.index < 0) {
    axis.of = SweepAxis::Of::input;
    axis.index = index_of(model.inputs, axis.name);
  }
  if (axis.index < 0) unknown_name(text, axis.name, model);
  const auto index = static_cast<std::size_t>(axis.index);
  axis.unit = axis.of == SweepAxis::Of::input ? model.inputs[index].unit : model.parameters[index].unit;
  axis.values = read_values(text, values);
  return axis;
}

}  // namespace

long SweepGrid::size() const {
  long size = 1;
  for (const SweepAxis& axis : axes) size *= static_cast<long>(axis.values.size());
  return size;
}

std::vector<double> SweepGrid::values_of(long index) const {
  std::vector<double> values(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    const auto count = static_cast<long>(axes[a].values.size());
    values[a] = axes[a].values[static_cast<std::size_t>(index % count)];
    index /= count;
  }
  return values;
}

SweepGrid read_grid(const std::vector<std::string>& texts, const Model& model, const std::string& manoeuvre) {
  SweepGrid grid;
  double size = 1;
  for (const std::string& text : texts) {
    SweepAxis axis = read_axis(text, model, manoeuvre);
    if (index_of(grid.axes, axis.name) >= 0) refuse_vary(text, fmt::format("\"{}\" is varied twice", axis.name));
    size *= static_cast<double>(axis.values.size());
    if (!(size <= kMostCases)) refuse_vary(text, "the grid has more than 10 million cases");
    grid.axes.push_back(std::move(axis));
  }
  return grid;
}

}  // namespace mbgen
