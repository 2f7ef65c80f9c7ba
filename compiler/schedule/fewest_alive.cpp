#include "compiler/schedule/fewest_alive.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

/// Operations that stay together. Inputs, constants and operations outside are in memory and belong to no unit.
struct Unit {
  std::span<const ValueId> values;
  std::vector<std::uint32_t> operands, users;  ///< units, each once
};

constexpr std::uint32_t kElsewhere = 0xffffffffu;

std::vector<Unit> units_of(const Program& program, std::span<const std::vector<ValueId>> bundles) {
  std::vector<Unit> units;
  std::vector<std::uint32_t> unit_of(program.nodes.size(), kElsewhere);
  for (const std::vector<ValueId>& bundle : bundles) {
    const auto place = static_cast<std::uint32_t>(units.size());
    Unit unit{bundle, {}, {}};
    for (const ValueId v : bundle) {
      unit_of[v] = place;
      const Node& node = program.nodes[v];
      for (int k = 0; k < arity(node.op); ++k) {
        const std::uint32_t operand = unit_of[node.operands[k]];
        if (operand == kElsewhere || operand == place ||
            std::ranges::find(unit.operands, operand) != unit.operands.end())
          continue;
        unit.operands.push_back(operand);
        units[operand].users.push_back(place);
      }
    }
    units.push_back(std::move(unit));
  }
  return units;
}

using Order = std::vector<std::uint32_t>;  ///< of units

/// Order built from its end: next comes the unit, with all users placed, that makes the fewest new values alive; of
/// equals the latest.
Order order_from_end(const std::vector<Unit>& units) {
  std::vector<std::size_t> waiting(units.size());
  std::vector<int> unborn(units.size());
  std::vector<bool> is_alive(units.size(), false), is_placed(units.size(), false);
  std::priority_queue<std::pair<int, std::uint32_t>> ready;  ///< by minus the number of new live values, position
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    waiting[u] = units[u].users.size();
    unborn[u] = static_cast<int>(units[u].operands.size());
    if (waiting[u] == 0) ready.emplace(-unborn[u] - 1, u);
  }
  const auto priority = [&](std::uint32_t u) { return -unborn[u] - (units[u].users.empty() ? 1 : 0); };
  Order order;
  while (!ready.empty()) {
    const auto [known, u] = ready.top();
    ready.pop();
    if (is_placed[u] || known != priority(u)) continue;
    is_placed[u] = true;
    order.push_back(u);
    for (const std::uint32_t operand : units[u].operands) {
      if (!is_alive[operand]) {
        is_alive[operand] = true;
        for (const std::uint32_t user : units[operand].users) {
          --unborn[user];
          if (waiting[user] == 0 && !is_placed[user]) ready.emplace(priority(user), user);
        }
      }
      if (--waiting[operand] == 0) ready.emplace(priority(operand), operand);
    }
  }
  std::ranges::reverse(order);
  return order;
}

/// The same order, but a unit with the last use of a value moves up to the point where its operands are known.
Order order_with_early_ends(const std::vector<Unit>& units, const Order& order) {
  std::vector<std::size_t> waiting(units.size()), uses(units.size());
  std::vector<bool> is_placed(units.size(), false);
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    waiting[u] = units[u].operands.size();
    uses[u] = units[u].users.size();
  }
  const auto ends_a_life = [&](std::uint32_t u) {
    return std::ranges::any_of(units[u].operands, [&](std::uint32_t operand) { return uses[operand] == 1; });
  };
  Order result;
  std::queue<std::uint32_t> next;
  for (const std::uint32_t start : order) {
    next.push(start);
    while (!next.empty()) {
      const std::uint32_t u = next.front();
      next.pop();
      if (is_placed[u]) continue;
      is_placed[u] = true;
      result.push_back(u);
      for (const std::uint32_t operand : units[u].operands) --uses[operand];
      for (const std::uint32_t user : units[u].users) --waiting[user];
      std::vector<std::uint32_t> near = units[u].users;
      for (const std::uint32_t operand : units[u].operands)
        near.insert(near.end(), units[operand].users.begin(), units[operand].users.end());
      std::ranges::sort(near);
      for (const std::uint32_t user : near)
        if (!is_placed[user] && waiting[user] == 0 && ends_a_life(user)) next.push(user);
    }
  }
  return result;
}

}  // namespace

std::vector<ValueId> fewest_alive(const Program& program, std::span<const std::vector<ValueId>> bundles) {
  const std::vector<Unit> units = units_of(program, bundles);
  std::vector<ValueId> values;
  for (const std::uint32_t u : order_with_early_ends(units, order_from_end(units)))
    values.insert(values.end(), units[u].values.begin(), units[u].values.end());
  return values;
}

}  // namespace mbgen
