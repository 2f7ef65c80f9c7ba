#include "compiler/casadi/explicit_motion.hpp"

#include <algorithm>
#include <map>

#include "compiler/passes/passes.hpp"
#include "compiler/program/rewrite.hpp"

namespace mbgen {
namespace {

using Results = std::map<Slot, ValueId>;

constexpr bool is_monitor(const SlotGroup& group) {
  return group == Array::pivot || group == Array::inertia || group == Array::hold;
}

/// Everything that programs along a direction read.
std::vector<DirectionGroup> direction_groups(const SolverLayout& layout) {
  using enum Array;
  return direction_of(layout, {z, zd, x, t, in, par, zdd, lambda, drive});
}

/// One program that grows by others: what they give, later ones take.
class Composition {
 public:
  Composition(const char* name, const Programs& programs, const SolverLayout& layout, const ArgumentLayout& arguments,
              bool along)
      : programs_(programs), layout_(layout), arguments_(arguments), builder_(name), along_(along) {
    builder_.set_samples(programs.accelerations.samples);
    if (along) seed_arguments();
    if (layout.has_closure) close();
  }

  void add_accelerations() {
    const Results results = append(programs_.accelerations);
    take(results, Array::zdd, layout_.coordinates);
    for (const auto& [slot, value] : results)
      if (is_monitor(slot.group)) monitors_.insert({slot, value});
    rates_ = results;
  }

  void add_multipliers() {
    Results results = append(programs_.multipliers);
    take(results, Array::lambda, layout_.equations);
    take(results, Array::drive, layout_.drives);
    const int blocks = static_cast<int>(layout_.blocks.size());
    for (int b = 0; b < blocks; ++b)
      if (const auto found = results.find({Array::pivot, b}); found != results.end())
        monitors_.insert({{Array::pivot, blocks + b}, found->second});
  }

  /// The program with the rates of the states as outputs.
  Program rates() {
    for (int k = 0; k < arguments_.count(); ++k) {
      const int c = arguments_.free[static_cast<std::size_t>(k)];
      give(Array::zd, k, along_ ? slope({Array::zd, c}) : input({Array::zd, c}));
      give(Array::zdd, k, along_ ? slope({Array::zdd, c}) : known_.at({Array::zdd, c}));
    }
    for (int i = 0; i < arguments_.auxiliary; ++i)
      give(Array::xd, i, rates_.at({along_ ? derivative_of(Array::xd) : SlotGroup(Array::xd), i}));
    return finish();
  }

  /// The program with the outputs of the model.
  Program outputs() {
    const Results results = append(programs_.outputs);
    for (int i = 0; i < layout_.outputs; ++i)
      give(Array::y, i, results.at({along_ ? derivative_of(Array::y) : SlotGroup(Array::y), i}));
    return finish();
  }

 private:
  ValueId input(Slot slot) { return builder_.input(slot.group, slot.index); }

  ValueId slope(Slot slot) {
    const auto found = slopes_.find(slot);
    return found == slopes_.end() ? builder_.constant(0) : found->second;
  }

  void give(Array array, int index, ValueId value) {
    builder_.output(along_ ? derivative_of(array) : SlotGroup(array), index, value);
  }

  void seed_arguments() {
    const auto seed = [&](Array array, int index, int place) {
      slopes_[{array, index}] = builder_.input(Array::seed, place);
    };
    for (int k = 0; k < arguments_.count(); ++k) {
      seed(Array::z, arguments_.free[static_cast<std::size_t>(k)], k);
      seed(Array::zd, arguments_.free[static_cast<std::size_t>(k)], arguments_.count() + k);
    }
    for (int i = 0; i < arguments_.auxiliary; ++i) seed(Array::x, i, 2 * arguments_.count() + i);
    for (int i = 0; i < arguments_.inputs; ++i) seed(Array::in, i, arguments_.input(i));
    for (int i = 0; i < arguments_.parameters; ++i) seed(Array::par, i, arguments_.parameter(i));
    seed(Array::t, 0, arguments_.time());
  }

  bool is_free(int coordinate) const { return std::ranges::count(arguments_.free, coordinate) > 0; }

  /// Dependent velocities, and how dependent positions and velocities change.
  void close() {
    Results results = append(programs_.closure);
    if (along_) {
      for (int c = 0; c < layout_.coordinates; ++c)
        if (!is_free(c)) slopes_[{Array::z, c}] = results.at({derivative_of(Array::dz), c});
      results = append(programs_.closure);
    }
    for (int c = 0; c < layout_.coordinates; ++c) {
      if (is_free(c)) continue;
      known_[{Array::zd, c}] = results.at({Array::zd, c});
      if (along_) slopes_[{Array::zd, c}] = results.at({derivative_of(Array::zd), c});
    }
  }

  /// Later programs take this array of the results.
  void take(const Results& results, Array array, int size) {
    for (int i = 0; i < size; ++i) {
      const auto value = results.find({array, i}), slope = results.find({derivative_of(array), i});
      if (value != results.end()) known_[{array, i}] = value->second;
      if (slope != results.end()) slopes_[{array, i}] = slope->second;
    }
  }

  /// The value of an input of a program that is put in.
  ValueId taken(const Slot& slot, const std::vector<Slot>& direction) {
    if (slot.group == Array::seed) return slope(direction[static_cast<std::size_t>(slot.index)]);
    if (slot.group == Array::tau || slot.group == Array::charts) return builder_.constant(0);
    const auto found = known_.find(slot);
    return found == known_.end() ? input(slot) : found->second;
  }

  Results append(const Program& of_solver) {
    const std::vector<DirectionGroup> groups = direction_groups(layout_);
    std::vector<Slot> direction;
    for (const DirectionGroup& group : groups)
      for (int i = 0; i < group.size; ++i) direction.push_back({group.group, i});
    const Program derived = along_ ? differentiate(of_solver, seeds_of(of_solver, groups)) : Program{};
    const Program& program = along_ ? derived : of_solver;
    const std::vector<ValueId> renamed =
        put_in(builder_, program, [&](const Slot& slot) { return taken(slot, direction); });
    Results results;
    for (const auto& [slot, value] : program.outputs) results[slot] = renamed[value];
    return results;
  }

  Program finish() {
    for (const auto& [slot, value] : monitors_) builder_.output(slot.group, slot.index, value);
    return optimise(builder_.finish());
  }

  const Programs& programs_;
  const SolverLayout& layout_;
  const ArgumentLayout& arguments_;
  ProgramBuilder builder_;
  bool along_;  ///< with derivatives along a direction
  std::map<Slot, ValueId> known_, slopes_;
  Results rates_, monitors_;
};

Program composed_rates(const Programs& programs, const SolverLayout& layout, const ArgumentLayout& arguments,
                       bool along) {
  Composition motion("rates", programs, layout, arguments, along);
  motion.add_accelerations();
  return motion.rates();
}

Program composed_outputs(const Programs& programs, const SolverLayout& layout, const ArgumentLayout& arguments,
                         bool along) {
  const auto reads = [&](Array array) {
    return std::ranges::any_of(programs.outputs.inputs, [&](const Slot& slot) { return slot.group == array; });
  };
  const bool reads_forces = reads(Array::lambda) || reads(Array::drive);
  Composition motion("outputs", programs, layout, arguments, along);
  if (reads_forces || reads(Array::zdd)) motion.add_accelerations();
  if (reads_forces) motion.add_multipliers();
  return motion.outputs();
}

/// The program with those outputs alone.
template <class Wanted>
Program with_outputs(Program program, const Wanted& wanted) {
  std::erase_if(program.outputs, [&](const OutputValue& output) { return !wanted(output.slot.group); });
  return remove_dead_values(std::move(program));
}

}  // namespace

ArgumentLayout argument_layout(const SolverLayout& layout, const Topology& topology, const Analysis& analysis) {
  ArgumentLayout arguments{free_coordinates(topology, analysis), layout.auxiliary_states, layout.inputs,
                           layout.parameters};
  std::ranges::sort(arguments.free);
  return arguments;
}

ExplicitMotion explicit_motion(const Programs& programs, const SolverLayout& layout, const ArgumentLayout& arguments) {
  ExplicitMotion motion;
  if (layout.has_closure) {
    motion.closing = with_outputs(programs.closure, [](const SlotGroup& group) {
      return group == Array::dz || group == Array::residual || group == Array::pivot;
    });
  }
  motion.rates = composed_rates(programs, layout, arguments, false);
  if (layout.outputs > 0) motion.outputs = composed_outputs(programs, layout, arguments, false);
  return motion;
}

ExplicitMotion explicit_slopes(const Programs& programs, const SolverLayout& layout, const ArgumentLayout& arguments) {
  ExplicitMotion slopes;
  slopes.rates = composed_rates(programs, layout, arguments, true);
  if (layout.outputs > 0) slopes.outputs = composed_outputs(programs, layout, arguments, true);
  return slopes;
}

std::vector<bool> along_direction(const Program& program) {
  std::vector<bool> moves(program.nodes.size(), false);
  for (ValueId v = 0; v < program.nodes.size(); ++v) {
    const Node& node = program.nodes[v];
    moves[v] = node.op == Op::input && program.inputs[static_cast<std::size_t>(node.input)].group == Array::seed;
    for (int k = 0; k < arity(node.op); ++k) moves[v] = moves[v] || moves[node.operands[k]];
  }
  return moves;
}

SplitSlopes split_slopes(const Program& slopes) {
  const std::size_t count = slopes.nodes.size();
  const std::vector<bool> moves = along_direction(slopes);
  std::vector<bool> is_factor(count, false);
  for (ValueId v = 0; v < count; ++v) {
    const Node& node = slopes.nodes[v];
    for (int k = 0; k < arity(node.op) && moves[v]; ++k) is_factor[node.operands[k]] = !moves[node.operands[k]];
  }
  for (const OutputValue& output : slopes.outputs)
    if (output.slot.group.derivative > 0 && !moves[output.value]) is_factor[output.value] = true;

  ProgramBuilder factors = ProgramBuilder::like(slopes), directions = ProgramBuilder::like(slopes);
  std::vector<ValueId> still, moved;
  int factor_count = 0;
  for (ValueId v = 0; v < count; ++v) {
    const Node& node = slopes.nodes[v];
    const bool is_plain = node.op == Op::constant || node.op == Op::input;
    still.push_back(moves[v] ? kNoValue : factors.copy(slopes, node, still));
    if (is_factor[v] && !is_plain) {
      factors.output(Array::derived, factor_count, still.back());
      moved.push_back(directions.input(Array::derived, factor_count++));
    } else {
      moved.push_back(moves[v] || (is_factor[v] && is_plain) ? directions.copy(slopes, node, moved) : kNoValue);
    }
  }
  for (const auto& [slot, value] : slopes.outputs) {
    if (slot.group.derivative == 0) factors.output(slot.group, slot.index, still[value]);
    if (slot.group.derivative > 0) directions.output(slot.group, slot.index, moved[value]);
  }
  return {remove_dead_values(factors.finish()), remove_dead_values(directions.finish())};
}

}  // namespace mbgen
