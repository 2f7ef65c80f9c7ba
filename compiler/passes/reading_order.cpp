#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

/// The values of a program that some output needs, put into the order of the paper's steps.
class ReadingOrder {
 public:
  explicit ReadingOrder(const Program& program)
      : program_(program),
        operations_(live_operations(program)),
        step_(program.nodes.size()),
        owner_(program.nodes.size()) {
    find_steps();
    find_owners();
  }

  /// Step after step, in each of them owner after owner as far as operands allow.
  std::vector<ValueId> order() const {
    std::map<Step, std::vector<ValueId>> by_step;
    for (const ValueId v : operations_) by_step[step_[v]].push_back(v);
    std::vector<ValueId> result;
    for (const auto& [step, values] : by_step) append_step(values, result);
    return result;
  }

  /// A value as it stands under its heading. Blocks share the heading of their step.
  Node placed(ValueId v) const {
    Node node = program_.nodes[v];
    node.section = {step_[v], -1};
    node.owner = owner_[v];
    return node;
  }

 private:
  Step own_step(ValueId v) const { return program_.nodes[v].section.step; }

  template <class Use>
  void each_operand(ValueId v, const Use& use) const {
    const Node& node = program_.nodes[v];
    for (int k = 0; k < arity(node.op); ++k)
      if (is_operation(program_.nodes[node.operands[k]])) use(node.operands[k]);
  }

  /// The formulation takes forces before closures, and a block with all of its steps before the next one. Inertias wait
  /// for the ones that elimination leaves on their bodies; any other value comes as early as a step needs it.
  void find_steps() {
    for (const ValueId v : operations_) {
      step_[v] = own_step(v);
      if (step_[v] < Step::accelerations) continue;
      each_operand(v, [&](ValueId operand) { step_[v] = std::max(step_[v], step_[operand]); });
    }
    for (auto v = operations_.rbegin(); v != operations_.rend(); ++v)
      each_operand(*v, [&](ValueId operand) { step_[operand] = std::min(step_[operand], step_[*v]); });
  }

  /// A value without a name that an earlier step needs stands beside its first user.
  void find_owners() {
    for (const ValueId v : operations_) owner_[v] = program_.nodes[v].owner;
    for (auto v = operations_.rbegin(); v != operations_.rend(); ++v)
      each_operand(*v, [&](ValueId operand) {
        const bool is_earlier = step_[operand] < own_step(operand) && program_.nodes[operand].label < 0;
        if (is_earlier && step_[operand] == step_[*v]) owner_[operand] = owner_[*v];
      });
  }

  void append_step(const std::vector<ValueId>& values, std::vector<ValueId>& result) const {
    std::map<ValueId, std::vector<ValueId>> users;
    std::map<ValueId, int> waits_for;
    std::map<Owner, std::set<ValueId>> ready;
    for (const ValueId v : values) {
      each_operand(v, [&](ValueId operand) {
        if (step_[operand] != step_[v]) return;
        users[operand].push_back(v);
        ++waits_for[v];
      });
      if (waits_for[v] == 0) ready[owner_[v]].insert(v);
    }
    for (auto owner = ready.end(); !ready.empty();) {
      if (owner == ready.end())
        owner = std::ranges::min_element(ready, {}, [](const auto& entry) { return *entry.second.begin(); });
      const ValueId v = *owner->second.begin();
      owner->second.erase(owner->second.begin());
      result.push_back(v);
      for (const ValueId user : users[v])
        if (--waits_for[user] == 0) ready[owner_[user]].insert(user);
      if (owner->second.empty()) owner = (ready.erase(owner), ready.end());
    }
  }

  const Program& program_;
  std::vector<ValueId> operations_;
  std::vector<Step> step_;
  std::vector<Owner> owner_;
};

}  // namespace

Program in_reading_order(const Program& program) {
  const ReadingOrder reading(program);
  const std::vector<bool> needed = needed_values(program);
  std::vector<ValueId> order;
  for (ValueId v = 0; v < program.nodes.size(); ++v)
    if (needed[v] && !is_operation(program.nodes[v])) order.push_back(v);
  const std::vector<ValueId> operations = reading.order();
  order.insert(order.end(), operations.begin(), operations.end());

  Program result = program;
  result.nodes.clear();
  result.inputs.clear();
  std::vector<ValueId> renumbered(program.nodes.size(), kNoValue);
  std::set<Section> sections;
  for (const ValueId v : order) {
    renumbered[v] = static_cast<ValueId>(result.nodes.size());
    Node node = is_operation(program.nodes[v]) ? reading.placed(v) : program.nodes[v];
    for (int k = 0; k < arity(node.op); ++k) node.operands[k] = renumbered[node.operands[k]];
    if (node.op == Op::input) {
      result.inputs.push_back(program.inputs[static_cast<std::size_t>(node.input)]);
      node.input = static_cast<std::int32_t>(result.inputs.size() - 1);
    }
    sections.insert(node.section);
    result.nodes.push_back(node);
  }
  sections.insert(Section{});
  result.sections.assign(sections.begin(), sections.end());
  for (OutputValue& output : result.outputs) output.value = renumbered[output.value];
  return verified(std::move(result));
}

WrittenPrograms written_for_reading(Programs programs) {
  WrittenPrograms written;
  for (Program* program : solver_programs(programs)) *program = in_reading_order(*program);
  written.programs = std::move(programs);
  return verified(std::move(written));
}

}  // namespace mbgen
