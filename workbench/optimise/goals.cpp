#include "workbench/optimise/goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "compiler/expressions/unit_exponents.hpp"
#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/search/rig.hpp"

namespace mbgen::optimise {
namespace {

constexpr const char* kGoalGrammar = "[NAME=]min:MEASURE[:SCALE], max:MEASURE[:SCALE] or min:MEASURE~TARGET[:SCALE]";
constexpr const char* kConstraintGrammar = "MEASURE<=LIMIT, MEASURE>=LIMIT, MEASURE==VALUE or LOW<=MEASURE<=HIGH";

std::string trimmed_text(const std::string& text) { return std::string(without_blanks(text)); }

/// A number at the start of a text, and the rest, which may be a unit; none for other texts.
std::optional<std::pair<double, std::string>> number_with_unit(const std::string& text) {
  double value = 0;
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [next, error] = std::from_chars(first, text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return {};
  const std::string rest = trimmed_text(text.substr(static_cast<std::size_t>(next - text.data())));
  if (!rest.empty() && !unit_exponents(rest)) return {};
  return std::pair{value, rest};
}

/// Fails: UserError for a text that is neither number nor table.
[[noreturn]] void refuse_limit(const std::string& what, const std::string& text) {
  const std::size_t end = text.find_first_not_of("+-.0123456789");
  if (end != std::string::npos && end > 0 && number_with_unit(text.substr(0, end)))
    throw UserError(fmt::format("{}: unknown unit {}: write a number in the unit of the measure\n", what,
                                in_quotes(trimmed_text(text.substr(end)))));
  throw UserError(fmt::format("{}: must be a number, with a unit where needed, or a table (CSV), found {}\n", what,
                              in_quotes(text)));
}

/// Whether a text is meant as a table.
bool is_table(const std::string& text) { return text.ends_with(".csv") || text.ends_with(".mat"); }

/// The column of a table that holds the wanted points: named like the measure, else the second one.
const Column& wanted_column(const MeasuredTable& table, const std::string& part, const std::string& computed) {
  for (const Column& column : table.columns)
    if (column.heading.name == part || column.heading.name == computed) return column;
  if (table.columns.size() == 2) return table.columns[1];
  throw UserError(fmt::format("{}: needs the column \"{}\"\n", table.header(), part));
}

/// Reads the wanted points of a curve; the measure becomes the column along this curve.
std::vector<double> read_points(const std::string& what, const std::string& file, const FreeModel& model,
                                RigReports& rigs, Measure& measure) {
  if (measure.of != Measure::Of::figure && measure.of != Measure::Of::curve)
    throw UserError(fmt::format("{}: points of {} are of a rig's curve: write kc:AXLE:COLUMN\n", what, file));
  const MeasuredTable table = read_measured_table(file);
  const KcReport& report = outline_of_rig(model, measure.axle, rigs);
  const KcTable* named = table_named(report, measure.curve);
  const KcTable& curve = named != nullptr ? *named : curve_of_table(table, report, true);
  const Column* computed = column_of(curve, measure.part);
  if (computed == nullptr)
    throw UserError(fmt::format("{}: the curve {} has no column \"{}\"\n", what, curve.name, measure.part));
  measure.of = Measure::Of::curve;
  measure.curve = curve.name;
  const std::vector<double> at = abscissas_of(table, curve.columns.front().heading);
  const Column& column = wanted_column(table, measure.part, computed->heading.name);
  const std::vector<double> values = in_unit(table, column, computed->heading.unit);
  std::vector<double> wanted;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isnan(values[row])) continue;
    measure.at.push_back(at[row]);
    wanted.push_back(values[row]);
  }
  if (wanted.empty()) throw UserError(fmt::format("{}: {} has no value\n", table.header(), column.heading.name));
  return wanted;
}

/// Reads one text after another.
class WishReader {
 public:
  WishReader(const FreeModel& model, const std::vector<std::string>& manoeuvres, RigReports& rigs)
      : model_(model), manoeuvres_(manoeuvres), rigs_(rigs) {}

  void read_goal(const std::string& text);
  void read_constraint(const std::string& text);
  Wishes take() { return std::move(wishes_); }

 private:
  /// Adds a measure, and reads its points where `wanted` is a table.
  std::size_t add_measure(const std::string& option, const std::string& text, const std::string& wanted,
                          std::vector<double>& points);
  void add_constraint(Constraint::Kind kind, const std::string& whole, const std::string& measure,
                      const std::string& limit);

  const FreeModel& model_;
  const std::vector<std::string>& manoeuvres_;
  RigReports& rigs_;
  Wishes wishes_;
};

std::size_t WishReader::add_measure(const std::string& option, const std::string& text, const std::string& wanted,
                                    std::vector<double>& points) {
  Measure measure = read_measure(option, text, model_.model, manoeuvres_);
  const std::string what = option + " " + in_quotes(text);
  if (is_table(wanted)) {
    points = read_points(what, wanted, model_, rigs_, measure);
    wishes_.files.push_back(wanted);
  } else if (!wanted.empty() && !number_with_unit(wanted)) {
    refuse_limit(what, wanted);
  }
  wishes_.measures.push_back(std::move(measure));
  return wishes_.measures.size() - 1;
}

/// Takes "NAME=" off the start of a goal.
std::string take_name(std::string& text) {
  const std::size_t sign = text.find('=');
  const std::size_t colon = text.find(':');
  if (sign == std::string::npos || (colon != std::string::npos && colon < sign)) return "";
  const std::string name = trimmed_text(text.substr(0, sign));
  text = text.substr(sign + 1);
  return name;
}

/// Takes ":SCALE" off the end of a goal.
std::optional<double> take_scale(const std::string& what, std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return {};
  const std::optional<std::pair<double, std::string>> scale = number_with_unit(text.substr(colon + 1));
  if (!scale || !scale->second.empty()) return {};
  if (!(scale->first > 0))
    throw UserError(fmt::format("{}: the scale must be above 0, found {}\n", what, scale->first));
  text = text.substr(0, colon);
  return scale->first;
}

void WishReader::read_goal(const std::string& typed) {
  std::string text = trimmed_text(typed);
  const std::string what = "--goal " + in_quotes(text);
  Goal goal{.name = take_name(text)};
  const bool is_least = text.starts_with("min:");
  if (!is_least && !text.starts_with("max:")) throw UserError(fmt::format("{}: must be {}\n", what, kGoalGrammar));
  goal.kind = is_least ? Goal::Kind::least : Goal::Kind::largest;
  text = text.substr(4);
  if (const std::optional<double> scale = take_scale(what, text)) {
    goal.scale = *scale;
    goal.has_scale = true;
  }
  const std::size_t sign = text.find('~');
  if (sign != std::string::npos) {
    if (!is_least) throw UserError(fmt::format("{}: a target is approached by min:\n", what));
    goal.kind = Goal::Kind::target;
    goal.target_text = trimmed_text(text.substr(sign + 1));
    if (goal.target_text.empty()) throw UserError(fmt::format("{}: must be {}\n", what, kGoalGrammar));
  }
  const std::string measure = trimmed_text(text.substr(0, sign));
  goal.measure = add_measure("--goal", measure, goal.target_text, goal.target);
  if (goal.kind != Goal::Kind::target && wishes_.measures.back().of == Measure::Of::curve)
    throw UserError(fmt::format("{}: a curve needs a target: min:{}~TABLE.csv\n", what, measure));
  if (goal.name.empty()) goal.name = measure;
  const auto is_same = [&](const Goal& one) { return one.name == goal.name; };
  if (std::ranges::any_of(wishes_.goals, is_same))
    throw UserError(fmt::format("--goal: \"{}\" stands twice: give one a name, NAME=min:...\n", goal.name));
  wishes_.goals.push_back(std::move(goal));
}

void WishReader::add_constraint(Constraint::Kind kind, const std::string& whole, const std::string& measure,
                                const std::string& limit) {
  Constraint constraint{.kind = kind, .name = whole, .limit_text = trimmed_text(limit)};
  if (constraint.limit_text.empty() || trimmed_text(measure).empty())
    throw UserError(fmt::format("--constraint {}: must be {}\n", in_quotes(whole), kConstraintGrammar));
  constraint.measure = add_measure("--constraint", trimmed_text(measure), constraint.limit_text, constraint.limit);
  wishes_.constraints.push_back(std::move(constraint));
}

void WishReader::read_constraint(const std::string& typed) {
  const std::string text = trimmed_text(typed);
  std::vector<std::string> signs, parts(1);
  for (std::size_t k = 0; k < text.size(); ++k) {
    const std::string sign = text.substr(k, 2);
    if (sign == "<=" || sign == ">=" || sign == "==") {
      signs.push_back(sign);
      parts.emplace_back();
      ++k;
    } else {
      parts.back() += text[k];
    }
  }
  using Kind = Constraint::Kind;
  if (signs.size() == 1 && number_with_unit(trimmed_text(parts[0])) && !number_with_unit(trimmed_text(parts[1]))) {
    std::swap(parts[0], parts[1]);  // 1.1<=MEASURE
    if (signs[0] != "==") signs[0] = signs[0] == "<=" ? ">=" : "<=";
  }
  if (signs.size() == 1) {
    add_constraint(signs[0] == "<="   ? Kind::at_most
                   : signs[0] == ">=" ? Kind::at_least
                                      : Kind::equal,
                   text, parts[0], parts[1]);
  } else if (signs.size() == 2 && signs[0] == "<=" && signs[1] == "<=") {
    add_constraint(Kind::at_least, trimmed_text(parts[1]) + ">=" + trimmed_text(parts[0]), parts[1], parts[0]);
    add_constraint(Kind::at_most, trimmed_text(parts[1]) + "<=" + trimmed_text(parts[2]), parts[1], parts[2]);
  } else {
    throw UserError(fmt::format("--constraint {}: must be {}\n", in_quotes(text), kConstraintGrammar));
  }
}

/// A typed number in the unit of a measure. Fails: UserError.
double in_unit_of(const std::string& what, const std::string& text, const Measure& measure, const std::string& unit) {
  const auto [value, typed] = *number_with_unit(text);
  if (typed.empty()) return value;
  if (measure.of == Measure::Of::metric)
    throw UserError(fmt::format("{}: a metric has the units of its outputs: leave out {}\n", what, in_quotes(typed)));
  const UnitExponents from = *unit_exponents(typed), to = unit_exponents(unit).value_or(UnitExponents{});
  if (!are_alike(from, to))
    throw UserError(
        fmt::format("{}: is in {}, found {}\n", what, in_quotes(unit.empty() ? "1" : unit), in_quotes(typed)));
  return value * from.factor / to.factor;
}

double largest_size(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

double distance_of(const std::vector<double>& values, const std::vector<double>& target) {
  double squares = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double error = values[k] - target[target.size() == 1 ? 0 : k];
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Fails: UserError where a lower limit of a measure lies above an upper one.
void refuse_empty(const Wishes& wishes) {
  const auto name_of = [&](const Constraint& one) { return wishes.measures[one.measure].name; };
  for (const Constraint& low : wishes.constraints)
    for (const Constraint& high : wishes.constraints) {
      const bool is_pair = low.kind != Constraint::Kind::at_most && high.kind != Constraint::Kind::at_least;
      if (!is_pair || name_of(low) != name_of(high) || low.limit.size() != 1 || high.limit.size() != 1) continue;
      if (low.limit[0] <= high.limit[0] + low.tolerance + high.tolerance) continue;
      throw UserError(fmt::format("--constraint: {} and {} leave no value\n", low.name, high.name));
    }
}

}  // namespace

Wishes read_wishes(const FreeModel& model, const std::vector<std::string>& goals,
                   const std::vector<std::string>& constraints, const std::vector<std::string>& manoeuvres,
                   RigReports& rigs) {
  WishReader reader(model, manoeuvres, rigs);
  for (const std::string& text : split_list(goals)) reader.read_goal(text);
  for (const std::string& text : split_list(constraints)) reader.read_constraint(text);
  return reader.take();
}

void set_numbers(const std::vector<Response>& start, Wishes& wishes) {
  for (Goal& goal : wishes.goals) {
    const Response& response = start[goal.measure];
    if (goal.kind == Goal::Kind::target && goal.target.empty())
      goal.target = {in_unit_of("--goal " + goal.name, goal.target_text, wishes.measures[goal.measure], response.unit)};
    if (goal.has_scale) continue;
    constexpr double kSame = 1e-6;  // a start this near to its target, in parts of it, has no distance to tell
    const double size = goal.kind == Goal::Kind::target
                            ? std::max(distance_of(response.values, goal.target), kSame * largest_size(goal.target))
                            : std::abs(response.values.front());
    goal.scale = size > 0 ? size : 1;
  }
  for (Constraint& constraint : wishes.constraints) {
    const Response& response = start[constraint.measure];
    if (constraint.limit.empty())
      constraint.limit = {in_unit_of("--constraint " + constraint.name, constraint.limit_text,
                                     wishes.measures[constraint.measure], response.unit)};
    const double of_limit = largest_size(constraint.limit), size = std::max(of_limit, largest_size(response.values));
    constraint.scale = size > 0 ? size : 1;
    constraint.tolerance = kPartBroken * (of_limit > 0 ? of_limit : constraint.scale);
  }
  refuse_empty(wishes);
}

}  // namespace mbgen::optimise
