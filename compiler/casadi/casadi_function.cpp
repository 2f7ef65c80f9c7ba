#include "compiler/casadi/casadi_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "compiler/emit/mapped.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

std::string at(const char* array, int index) { return fmt::format("at->{}[{}]", array, index); }

/// Text of an input of a program.
std::string input_text(const ArgumentLayout& layout, const Slot& slot) {
  using enum Array;
  switch (slot.group.array) {
    case z:
      return at("z", slot.index);
    case zd:
      return at("x",
                layout.count() + static_cast<int>(std::ranges::find(layout.free, slot.index) - layout.free.begin()));
    case x:
      return at("x", 2 * layout.count() + slot.index);
    case in:
      return at("u", slot.index);
    case par:
      return at("p", slot.index);
    case t:
      return "at->t";
    case seed:
      return at("s", slot.index);
    case derived:
      return at("f", slot.index);
    default:
      throw std::logic_error("no place in C for " + text_of(slot));
  }
}

/// Slots of an array among the outputs of a program, ascending.
std::vector<Slot> slots_of(const Program& program, Array array) {
  std::vector<Slot> slots;
  for (const OutputValue& output : program.outputs)
    if (output.slot.group == array) slots.push_back(output.slot);
  std::ranges::sort(slots);
  return slots;
}

std::vector<Slot> joined_slots(std::initializer_list<std::vector<Slot>> lists) {
  std::vector<Slot> all;
  for (const std::vector<Slot>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Writes programs as functions of one solver.
struct FunctionMaker {
  std::string solver;
  const CasadiArguments& arguments;

  CFunctions functions(const Program& program, const std::string& name, const std::vector<Slot>& results) const {
    const auto place = [&](const Slot& slot) {
      const auto found = std::ranges::find(results, slot);
      if (found == results.end()) throw std::logic_error("no place in C for " + text_of(slot));
      return static_cast<int>(found - results.begin());
    };
    return c_functions(
        program, {solver + "_" + name, solver + "_point",
                  [&](const Slot& slot) { return input_text(arguments.layout, slot); }, place, solver + "_sample"});
  }

  /// letter: f or h.
  CasadiFunction function(const char* letter, const char* result, const Program& values, const Program& slopes,
                          std::vector<Slot> rows) const {
    CasadiFunction made{solver + "_" + letter, result, std::move(rows)};
    made.pivots = slots_of(values, Array::pivot);
    made.inertias = slots_of(values, Array::inertia);
    made.holds = slots_of(values, Array::hold);
    const std::vector<Slot> monitors = joined_slots({made.pivots, made.inertias, made.holds});
    made.values = functions(values, std::string(letter) + "_values", joined_slots({monitors, made.rows}));

    const SplitSlopes split = split_slopes(slopes);
    const std::vector<Slot> factors = slots_of(split.factors, Array::derived);
    const std::vector<Slot> changes = mapped(made.rows, [](const Slot& slot) {
      return Slot{derivative_of(slot.group), slot.index};
    });
    made.factors = static_cast<int>(factors.size());
    // Factors stand first: directions read them by their numbers.
    made.factor_values = functions(split.factors, std::string(letter) + "_factors", joined_slots({factors, monitors}));
    made.directions = functions(split.directions, std::string(letter) + "_directions", changes);
    std::vector<Slot> sums;
    std::vector<SlotPlace> weights, columns;
    for (int i = 0; i < static_cast<int>(changes.size()); ++i)
      weights.push_back({changes[static_cast<std::size_t>(i)], {Array::seed, i}});
    for (int j = 0; j < arguments.columns(); ++j) {
      sums.push_back({derivative_of(Array::seed), j});
      columns.push_back({{Array::seed, j}, sums.back()});
    }
    made.sums = functions(transposed(split.directions, weights, columns), std::string(letter) + "_sums", sums);
    made.jacobian = dependence(slopes, changes, arguments.columns());
    return made;
  }
};

bool reads_time(const Program& program) {
  return std::ranges::any_of(program.inputs, [](const Slot& slot) { return slot.group == Array::t; });
}

/// Outputs of the rates: velocities and accelerations of the independent coordinates, rates of the other states.
std::vector<Slot> rate_slots(const ArgumentLayout& layout) {
  std::vector<Slot> slots;
  for (const Array array : {Array::zd, Array::zdd})
    for (int k = 0; k < layout.count(); ++k) slots.push_back({array, k});
  for (int i = 0; i < layout.auxiliary; ++i) slots.push_back({Array::xd, i});
  return slots;
}

}  // namespace

CasadiFunctions casadi_functions(const std::string& solver, const Programs& programs, const Programs& for_slopes,
                                 const SolverLayout& layout, const ArgumentLayout& arguments) {
  const ExplicitMotion motion = explicit_motion(programs, layout, arguments);
  const ExplicitMotion slopes = explicit_slopes(for_slopes, layout, arguments);
  CasadiFunctions made{
      {arguments, reads_time(motion.closing) || reads_time(motion.rates) || reads_time(motion.outputs)}};
  const FunctionMaker maker{solver, made.arguments};
  if (layout.has_closure) {
    std::vector<Slot> corrections;
    for (int c = 0; c < layout.coordinates; ++c) corrections.push_back({Array::dz, c});
    const std::vector<Slot> residuals = slots_of(motion.closing, Array::residual),
                            pivots = slots_of(motion.closing, Array::pivot);
    made.closing = maker.functions(motion.closing, "closing", joined_slots({corrections, residuals, pivots}));
    made.closing_residuals = static_cast<int>(residuals.size());
    made.closing_pivots = static_cast<int>(pivots.size());
  }
  made.list.push_back(maker.function("f", "xdot", motion.rates, slopes.rates, rate_slots(arguments)));
  if (layout.outputs > 0)
    made.list.push_back(maker.function("h", "y", motion.outputs, slopes.outputs, slots_of(motion.outputs, Array::y)));
  return made;
}

}  // namespace mbgen
