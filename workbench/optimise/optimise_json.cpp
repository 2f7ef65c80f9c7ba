// The result of an optimisation for programs, and a trade-off as a table.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compiler/text/json_text.hpp"
#include "workbench/optimise/optimise.hpp"
#include "workbench/results/csv.hpp"
#include "workbench/search/result_text.hpp"

namespace mbgen::optimise {
namespace {

using Json = nlohmann::ordered_json;

Json variables_json(const FoundDesign& design) {
  Json list = Json::array();
  for (const FoundVariable& found : design.variables)
    list.push_back({{"name", found.variable.name},
                    {"unit", found.variable.unit},
                    {"value", found.value},
                    {"start", found.variable.start},
                    {"lower", found.variable.lower},
                    {"upper", found.variable.upper},
                    {"at_bound", found.at_bound < 0   ? "lower"
                                 : found.at_bound > 0 ? "upper"
                                                      : ""},
                    {"goal_per_unit", number_or_null(found.multiplier)}});
  return list;
}

Json goals_json(const FoundDesign& design) {
  Json list = Json::array();
  for (const FoundGoal& found : design.goals)
    list.push_back({{"name", found.goal.name},
                    {"unit", found.unit},
                    {"value", number_or_null(found.value)},
                    {"start", number_or_null(found.start)},
                    {"scale", found.goal.scale},
                    {"in_sum", number_or_null(found.weighted)},
                    {"target", found.goal.target_text}});
  return list;
}

Json constraints_json(const FoundDesign& design) {
  Json list = Json::array();
  for (const FoundConstraint& found : design.constraints)
    list.push_back({{"name", found.constraint.name},
                    {"unit", found.unit},
                    {"value", number_or_null(found.value)},
                    {"start", number_or_null(found.start)},
                    {"limit", found.limit},
                    {"active", found.is_active},
                    {"broken", found.is_broken},
                    {"goal_per_unit", number_or_null(found.multiplier)}});
  return list;
}

Json design_json(const FoundDesign& design) {
  return {{"status", design.status},
          {"ended", design.ended},
          {"keeps_constraints", design.keeps_constraints},
          {"first_order", number_or_null(design.rest)},
          {"sum", number_or_null(design.sum)},
          {"variables", variables_json(design)},
          {"goals", goals_json(design)},
          {"constraints", constraints_json(design)}};
}

Json starts_json(const OptimiseResult& result) {
  Json list = Json::array();
  for (const FoundStart& start : result.starts)
    list.push_back({{"values", start.values}, {"status", start.status}, {"sum", number_or_null(start.sum)}});
  return list;
}

Json curves_json(const OptimiseResult& result) {
  Json list = Json::array();
  for (const FoundCurve& curve : result.curves)
    list.push_back({{"name", curve.name},
                    {"unit", curve.unit},
                    {"abscissa", curve.abscissa.name},
                    {"abscissa_unit", curve.abscissa.unit},
                    {"at", curve.at},
                    {"before", curve.before},
                    {"after", curve.after},
                    {"target", curve.target},
                    {"least", curve.least},
                    {"most", curve.most}});
  return list;
}

Heading heading_of(const std::string& name, const std::string& unit) { return {name, unit.empty() ? "1" : unit}; }

}  // namespace

std::string optimise_json(const OptimiseResult& result) {
  Json refused = Json::array();
  for (const RefusedDesign& one : result.refused) refused.push_back({{"values", one.values}, {"reason", one.reason}});
  Json all = {{"model", result.model},
              {"engine", result.engine},
              {"method", result.method},
              {"derivatives", result.derivatives},
              {"evaluations", result.evaluations},
              {"with_derivatives", result.with_derivatives}};
  if (result.is_trade_off()) {
    Json points = Json::array();
    for (const FoundDesign& point : result.trade_off) points.push_back(design_json(point));
    all["trade_off"] = {{"goals", {result.first, result.second}}, {"points", points}};
  } else {
    all.update(design_json(result.best));
    all["starts"] = starts_json(result);
    all["curves"] = curves_json(result);
  }
  all["refused"] = refused;
  all["warnings"] = result.warnings;
  return json_text(all);
}

std::string trade_off_csv(const OptimiseResult& result) {
  if (result.trade_off.empty()) return "point,status\n";
  const FoundDesign& first = result.trade_off.front();
  std::vector<Heading> headings{{"point", ""}};
  for (const FoundGoal& goal : first.goals) headings.push_back(heading_of(goal.goal.name, goal.unit));
  for (const FoundVariable& variable : first.variables)
    headings.push_back(heading_of(variable.variable.name, variable.variable.unit));
  std::string text;
  for (const Heading& heading : headings)
    text += csv_field(heading.unit.empty() ? heading.name : fmt::format("{} [{}]", heading.name, heading.unit)) + ",";
  text += "status\n";
  std::size_t number = 0;
  for (const FoundDesign& point : result.trade_off) {
    text += fmt::format("{},", ++number);
    for (const FoundGoal& goal : point.goals) text += fmt::format("{},", goal.value);
    for (const FoundVariable& variable : point.variables) text += fmt::format("{},", variable.value);
    text += csv_field(point.status) + "\n";
  }
  return text;
}

}  // namespace mbgen::optimise
