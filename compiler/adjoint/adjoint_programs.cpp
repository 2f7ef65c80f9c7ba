#include "compiler/adjoint/adjoint_programs.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>

#include "compiler/passes/passes.hpp"
#include "compiler/program/rewrite.hpp"

namespace mbgen {
namespace {

/// The accelerations while laws are put into them.
class LawComposition {
 public:
  LawComposition(const Program& around, const std::vector<SharedLaw>& laws)
      : around_(around), laws_(laws), builder_(ProgramBuilder::like(around)), renamed_(around.nodes.size(), kNoValue) {
    for (const auto& [slot, value] : around.outputs) outputs_[slot] = value;
  }

  Program program() {
    // A law's results wait for its arguments, and values that follow from the results for these.
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (ValueId v = 0; v < around_.nodes.size(); ++v)
        if (renamed_[v] == kNoValue && put(v)) goes_on = true;
    }
    for (const auto& [slot, value] : around_.outputs)
      if (slot.group.array != Array::law_argument) builder_.output(slot.group, slot.index, renamed_[value]);
    return remove_dead_values(builder_.finish());
  }

 private:
  bool put(ValueId v) {
    const Node& node = around_.nodes[v];
    if (node.op == Op::input) {
      const Slot& slot = around_.inputs[static_cast<std::size_t>(node.input)];
      renamed_[v] =
          slot.group.array == Array::law_result ? result_of_law(slot) : builder_.input(slot.group, slot.index);
      return renamed_[v] != kNoValue;
    }
    for (int k = 0; k < arity(node.op); ++k)
      if (renamed_[node.operands[k]] == kNoValue) return false;
    renamed_[v] = builder_.copy(around_, node, renamed_);
    return true;
  }

  /// The value of a law's result, kNoValue while an argument of its element is not known.
  ValueId result_of_law(const Slot& slot) {
    const auto known = results_.find(slot);
    if (known != results_.end()) return known->second;
    const auto k = static_cast<std::size_t>(slot.group.block);
    const SharedLaw& law = laws_[k];
    const std::size_t elements = law.tyres.size(), element = static_cast<std::size_t>(slot.index) % elements;
    std::vector<ValueId> arguments;
    for (std::size_t a = 0; a < law.arguments.size(); ++a) {
      arguments.push_back(argument_of(law, k, a, element));
      if (arguments.back() == kNoValue) return kNoValue;
    }
    const std::vector<ValueId> values = put_in(builder_, law.program, [&](const Slot& argument) {
      return arguments[static_cast<std::size_t>(argument.index)];
    });
    for (const auto& [result, value] : law.program.outputs)
      results_[{slot.group, result.index * static_cast<int>(elements) + static_cast<int>(element)}] = values[value];
    return results_.at(slot);
  }

  ValueId argument_of(const SharedLaw& law, std::size_t k, std::size_t argument, std::size_t element) {
    const LawArgument& of = law.arguments[argument];
    if (!of.numbers.empty()) return builder_.constant(of.numbers[of.is_common ? 0 : element]);
    return renamed_[outputs_.at({of_block(Array::law_argument, k), argument_place(law, argument, element)})];
  }

  const Program& around_;
  const std::vector<SharedLaw>& laws_;
  ProgramBuilder builder_;
  std::vector<ValueId> renamed_;     ///< of values around the laws
  std::map<Slot, ValueId> outputs_;  ///< of the program around the laws
  std::map<Slot, ValueId> results_;  ///< of laws, in the new program
};

/// Without joint forces from outside, and with every ball in its first chart.
Program unforced(const Program& program) {
  return remove_dead_values(rewritten(program, [&](ProgramBuilder& builder, ValueId v, std::span<const ValueId>) {
    const Node& node = program.nodes[v];
    if (node.op != Op::input) return kNoValue;
    const Array array = program.inputs[static_cast<std::size_t>(node.input)].group.array;
    return array == Array::tau || array == Array::charts ? builder.constant(0) : kNoValue;
  }));
}

bool moves(const Slot& slot) { return slot.group.array != Array::t && slot.group.array != Array::due; }

Program adjoint_by(const Program& program, std::initializer_list<Array> weighted) {
  const auto is_weighted = [&](const Slot& slot) { return std::ranges::count(weighted, slot.group.array) > 0; };
  return adjoint(unforced(program), moves, is_weighted,
                 [](const Slot& slot) { return slot.group.array == Array::pivot; });
}

}  // namespace

Program with_laws(const Program& around, const std::vector<SharedLaw>& laws) {
  return LawComposition(around, laws).program();
}

AdjointPrograms adjoint_programs(const WrittenPrograms& written) {
  using enum Array;
  const Programs& programs = written.programs;
  const auto without_pivots = [](Program program) {
    std::erase_if(program.outputs, [](const OutputValue& output) { return output.slot.group.array == pivot; });
    return remove_dead_values(std::move(program));
  };
  AdjointPrograms all;
  all.accelerations = without_pivots(adjoint_by(with_laws(programs.accelerations, written.laws), {zdd, xd}));
  if (!programs.closure.outputs.empty()) {
    all.velocities = adjoint_by(programs.closure, {zd});
    all.positions = without_pivots(adjoint_by(programs.closure, {dz}));
  }
  if (!programs.multipliers.outputs.empty()) all.multipliers = adjoint_by(programs.multipliers, {lambda, drive});
  all.outputs = adjoint_by(programs.outputs, {y});
  if (!programs.derived_constants.outputs.empty()) all.derived = adjoint_by(programs.derived_constants, {derived});
  return all;
}

}  // namespace mbgen
