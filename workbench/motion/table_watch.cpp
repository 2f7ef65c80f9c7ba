#include "workbench/motion/table_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace mbgen {
namespace {

constexpr long kReadingsPerMotion = 200;
constexpr double kWorthTelling = 1e-6;  // of the width of the points

/// The expression of one node. Fails: nothing, where it has variables of a law.
std::optional<Expression> expression_at(const Expression& whole, int node) {
  Expression part{whole.text, {whole.nodes.begin(), whole.nodes.begin() + node + 1}};
  const bool has_locals = std::any_of(part.nodes.begin(), part.nodes.end(), [](const ExpressionNode& one) {
    return one.kind == ExpressionNode::Kind::local;
  });
  return has_locals ? std::nullopt : std::optional(std::move(part));
}

/// The line of points of an argument.
const Table& line_of(const NamedTable& named, bool is_first) {
  if (const auto* curve = std::get_if<Table>(&named.table)) return *curve;
  const auto& map = std::get<CharacteristicMap>(named.table);
  return is_first ? map.along_x : map.along_y;
}

}  // namespace

TableWatch::TableWatch(const Compilation& compilation, const SimulationSettings& settings)
    : every_(std::max(1L, settings.steps / kReadingsPerMotion)) {
  Model model = compilation.model;
  model.outputs.clear();
  const auto watch = [&](const Expression& whole, const ExpressionNode& node, bool is_first) {
    std::optional<Expression> argument = expression_at(whole, is_first ? node.first : node.second);
    if (!argument) return;
    const Table& line = line_of(*node.table, is_first);
    arguments_.push_back({node.table, is_first ? "x" : "y", line.x.front(), line.x.back()});
    Quantity quantity;
    quantity.expression = static_cast<int>(model.expressions.size());
    model.expressions.push_back(std::move(*argument));
    model.outputs.push_back({"", {}, "", ExpressionOutput{quantity}});
  };
  for (const Expression& whole : compilation.model.expressions) {
    for (const ExpressionNode& node : whole.nodes) {
      if (!node.table || node.table->is_chosen) continue;
      watch(whole, node, true);
      if (node.table->arity() == 2) watch(whole, node, false);
    }
  }
  if (!arguments_.empty()) solver_.emplace(model, compilation.topology, compilation.analysis);
}

void TableWatch::add(const Sample& sample) {
  if (!solver_ || sample.step % every_ != 0) return;
  solver_->set_inputs(sample.inputs);
  const std::vector<double> no_forces(sample.state.z.size(), 0.0);
  GenericDerivative rates;
  if (!solver_->accelerations(sample.state, no_forces, rates).ok()) return;
  const GenericOutputs outputs = solver_->outputs(sample.state, no_forces, rates);
  for (std::size_t i = 0; i < arguments_.size(); ++i) {
    Argument& argument = arguments_[i];
    const double at = outputs.y[i];
    const double beyond = std::max(argument.first - at, at - argument.last) / (argument.last - argument.first);
    if (!(beyond > argument.beyond)) continue;
    argument.beyond = beyond, argument.at = at, argument.t = sample.state.t;
  }
}

void TableWatch::judge(const SimulationSummary&, StepVerdict& verdict) const {
  for (std::size_t i = 0; i < arguments_.size(); ++i) {
    const Argument& one = arguments_[i];
    const bool is_farthest = std::none_of(arguments_.begin(), arguments_.end(), [&](const Argument& other) {
      const bool comes_first = other.beyond > one.beyond || (other.beyond == one.beyond && &other < &one);
      return other.table == one.table && other.name == one.name && comes_first;
    });
    if (!(one.beyond > kWorthTelling) || !is_farthest) continue;
    verdict.warnings.push_back(
        fmt::format("table \"{}\" is read beyond its points, {} = {:.4g} at t = {:.4g} s, where they reach from {:g} "
                    "to {:g}: it goes "
                    "on straight; \"outside\" says whether it is to go on or to hold",
                    one.table->name, one.name, one.at, one.t, one.first, one.last));
  }
}

}  // namespace mbgen
