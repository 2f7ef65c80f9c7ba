// The result of an optimisation for people.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/host/message.hpp"
#include "workbench/optimise/optimise.hpp"
#include "workbench/search/found_model.hpp"
#include "workbench/search/result_text.hpp"

namespace mbgen::optimise {
namespace {

/// Refused designs that are listed.
constexpr std::size_t kMostRefused = 3;

std::string with_unit(const std::string& name, const std::string& unit) {
  return fmt::format("{} [{}]", name, unit.empty() ? "1" : unit);
}

std::string count_text(long number, const char* word) {
  return fmt::format("{} {}{}", number, word, number == 1 ? "" : "s");
}

std::string variable_rows(const FoundDesign& design) {
  std::vector<TableRow> rows{{"variable", "value", "start", "bounds", "goal per unit", ""}};
  for (const FoundVariable& found : design.variables) {
    const Unknown& variable = found.variable;
    rows.push_back(
        {with_unit(variable.name, variable.unit), fmt::format("{:.7g}", found.value),
         fmt::format("{:.6g}", variable.start), fmt::format("{:.4g} to {:.4g}", variable.lower, variable.upper),
         found.at_bound != 0 && std::isfinite(found.multiplier) ? fmt::format("{:.3g}", found.multiplier) : "",
         found.at_bound < 0   ? "at its lower bound"
         : found.at_bound > 0 ? "at its upper bound"
                              : ""});
  }
  return aligned_rows(rows);
}

std::string wish_of(const Goal& goal) {
  return goal.kind == Goal::Kind::least     ? "least"
         : goal.kind == Goal::Kind::largest ? "largest"
                                            : "distance from " + goal.target_text;
}

std::string goal_rows(const FoundDesign& design) {
  std::vector<TableRow> rows{{"goal", "value", "start", "scale", "in the sum", ""}};
  for (const FoundGoal& found : design.goals)
    rows.push_back({with_unit(found.goal.name, found.unit), fmt::format("{:.7g}", found.value),
                    fmt::format("{:.6g}", found.start), fmt::format("{:.4g}", found.goal.scale),
                    fmt::format("{:.5g}", found.weighted), wish_of(found.goal)});
  return aligned_rows(rows);
}

std::string constraint_rows(const FoundDesign& design) {
  if (design.constraints.empty()) return "";
  std::vector<TableRow> rows{{"constraint", "value", "start", "limit", "goal per unit", ""}};
  for (const FoundConstraint& found : design.constraints)
    rows.push_back({with_unit(found.constraint.name, found.unit), fmt::format("{:.7g}", found.value),
                    fmt::format("{:.6g}", found.start), fmt::format("{:.6g}", found.limit),
                    found.is_active && std::isfinite(found.multiplier) ? fmt::format("{:.3g}", found.multiplier) : "",
                    found.is_broken   ? "BROKEN"
                    : found.is_active ? "active"
                                      : ""});
  return aligned_rows(rows);
}

std::string trade_off_rows(const OptimiseResult& result) {
  TableRow head{"point"};
  const FoundDesign& first = result.trade_off.front();
  for (const FoundGoal& goal : first.goals) head.push_back(with_unit(goal.goal.name, goal.unit));
  for (const FoundVariable& variable : first.variables)
    head.push_back(with_unit(variable.variable.name, variable.variable.unit));
  head.push_back("status");
  std::vector<TableRow> rows{head};
  for (const FoundDesign& point : result.trade_off) {
    TableRow row{fmt::format("{}", rows.size())};
    for (const FoundGoal& goal : point.goals) row.push_back(fmt::format("{:.6g}", goal.value));
    for (const FoundVariable& variable : point.variables) row.push_back(fmt::format("{:.6g}", variable.value));
    row.push_back(point.status);
    rows.push_back(std::move(row));
  }
  return aligned_rows(rows);
}

std::string values_text(const OptimiseResult& result, const std::vector<double>& values) {
  const std::vector<FoundVariable>& variables =
      result.is_trade_off() ? result.trade_off.front().variables : result.best.variables;
  std::string text;
  for (std::size_t v = 0; v < values.size() && v < variables.size(); ++v)
    text += fmt::format("{}{} = {:.6g}", v > 0 ? ", " : "", variables[v].variable.name, values[v]);
  return text;
}

std::string start_lines(const OptimiseResult& result) {
  if (result.starts.size() < 2) return "";
  std::size_t ok = 0, same = 0;
  for (const FoundStart& start : result.starts) {
    ok += start.status == "ok";
    same += start.status == "ok" && std::abs(start.sum - result.best.sum) <= 1e-6 * (1 + std::abs(result.best.sum));
  }
  return fmt::format("  {} starts: {} ended ok, {} of them as well as this one\n", result.starts.size(), ok, same);
}

std::string refused_lines(const OptimiseResult& result) {
  std::string text;
  const std::size_t shown = std::min(kMostRefused, result.refused.size());
  for (std::size_t k = 0; k < shown; ++k) {
    const std::string& reason = result.refused[k].reason;
    text += fmt::format("  refused: {}: {}\n", values_text(result, result.refused[k].values), first_line(reason));
  }
  if (result.refused.size() > shown)
    text += fmt::format("  refused: {} more designs without a result\n", result.refused.size() - shown);
  return text;
}

std::string warning_lines(const OptimiseResult& result) {
  std::string text;
  for (const std::string& warning : result.warnings) text += fmt::format("  warning: {}\n", warning);
  return text;
}

std::string head_line(const OptimiseResult& result, std::size_t variables) {
  return fmt::format("{}: {}, method {}, engine {}, {} ({} with derivatives), derivatives: {}\n", result.model,
                     count_text(static_cast<long>(variables), "variable"), result.method, result.engine,
                     count_text(result.evaluations, "evaluation"), result.with_derivatives, result.derivatives);
}

}  // namespace

std::string optimise_text(const OptimiseResult& result) {
  if (result.is_trade_off()) {
    if (result.trade_off.empty()) return fmt::format("{}: no point of the trade-off\n", result.model);
    std::string text = head_line(result, result.trade_off.front().variables.size());
    text += fmt::format("  trade-off of {} and {}\n", result.first, result.second) + trade_off_rows(result);
    return text + refused_lines(result) + warning_lines(result);
  }
  const FoundDesign& best = result.best;
  std::string text = head_line(result, best.variables.size());
  text += fmt::format("  {}: {}", best.status, best.ended);
  text += best.is_ok() ? fmt::format("; conditions of first order within {:.2g}\n", best.rest) : "\n";
  text += variable_rows(best) + goal_rows(best) + constraint_rows(best) + start_lines(result) + refused_lines(result);
  return text + warning_lines(result);
}

std::string optimised_model(const OptimiseResult& result, const std::string& path) {
  FoundModel found{result.model + "_optimised", "design found by mbgen optimise", result.model_file, {}};
  if (!result.best.is_ok()) found.description += ", " + result.best.status;
  for (const VariedParameter& parameter : result.set)
    if (parameter.name != kStepOfMotion) found.values.emplace_back(parameter.name, *parameter.value);
  for (const FoundVariable& variable : result.best.variables)
    found.values.emplace_back(variable.variable.name, variable.value);
  return text_of(found, path);
}

}  // namespace mbgen::optimise
