// The adjoint of a program against its derivatives along directions: <w, J s> = <J' w, s>.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/program.hpp"
#include "tests/support/random_program.hpp"
#include "tests/support/slot_numbers.hpp"

namespace mbgen::adjoint_test {
namespace {

using Numbers = SlotNumbers;

constexpr auto kEvery = [](const Slot&) { return true; };
constexpr auto kNone = [](const Slot&) { return false; };

Slot derivative_slot(const Slot& slot) { return {derivative_of(slot.group), slot.index}; }

/// Weights of the outputs, derivatives of the inputs: any numbers, of the places alone.
double weight_of(const Slot& slot) { return 1 + 0.31 * ((slot.index * 7 + static_cast<int>(slot.group.array)) % 5); }
double rate_of(const Slot& slot) { return 0.8 - 0.23 * (slot.index % 6); }

void expect_transposed(const Program& program, const Numbers& at, const std::string& what) {
  Numbers given = at;
  std::vector<int> seeds;
  for (const Slot& slot : program.inputs) {
    given[{Array::seed, static_cast<int>(seeds.size())}] = rate_of(slot);
    seeds.push_back(static_cast<int>(seeds.size()));
  }
  for (const OutputValue& output : program.outputs) given[derivative_slot(output.slot)] = weight_of(output.slot);
  double forward = 0, size = 1, back = 0;
  for (const auto& [slot, value] : outputs_at(differentiate(program, seeds), given)) {
    if (slot.group.derivative == 0) continue;
    const double term = weight_of({SlotGroup(slot.group.array, slot.group.block), slot.index}) * value;
    forward += term;
    size += std::abs(term);
  }
  const Program adjoint_program = adjoint(contract(program), kEvery, kEvery, kNone);
  for (const auto& [slot, value] : outputs_at(adjoint_program, given))
    back += rate_of({SlotGroup(slot.group.array, slot.group.block), slot.index}) * value;
  EXPECT_NEAR(back, forward, 1e-12 * size) << what;
}

TEST(AdjointProgram, OfRandomPrograms) {
  Numbers at;
  for (int i = 0; i < 6; ++i) at[{Array::in, i}] = 0.37 * i - 0.9;
  for (int seed = 1; seed <= 40; ++seed)
    expect_transposed(random_program(static_cast<std::uint64_t>(seed), 80), at, std::to_string(seed));
}

TEST(AdjointProgram, KeepsResultsThatAreAskedFor) {
  ProgramBuilder builder("f");
  const ValueId x = builder.input(Array::x, 0), square = builder.append(Op::multiply, x, x);
  builder.output(Array::y, 0, square);
  builder.output(Array::pivot, 0, x);
  const Program program = builder.finish();
  const Program reversed = adjoint(
      program, kEvery, [](const Slot& slot) { return slot.group.array == Array::y; },
      [](const Slot& slot) { return slot.group.array == Array::pivot; });
  const Numbers results = outputs_at(reversed, {{{Array::x, 0}, 3.0}, {{derivative_of(Array::y), 0}, 0.5}});
  EXPECT_EQ(results, (Numbers{{{Array::pivot, 0}, 3.0}, {{derivative_of(Array::x), 0}, 3.0}}));
}

TEST(AdjointProgram, SlopesWithoutBoundAreNotFinite) {
  ProgramBuilder builder("f");
  builder.output(Array::y, 0, builder.append(Op::sqrt, builder.input(Array::x, 0)));
  const Program reversed = adjoint(builder.finish(), kEvery, kEvery, kNone);
  const Numbers results = outputs_at(reversed, {{{Array::x, 0}, 0.0}, {{derivative_of(Array::y), 0}, 1.0}});
  EXPECT_FALSE(std::isfinite(results.at({derivative_of(Array::x), 0})));
}

TEST(Transposed, RefusesWhatIsNotLinear) {
  ProgramBuilder builder("f");
  const ValueId x = builder.input(Array::x, 0);
  builder.output(Array::y, 0, builder.append(Op::multiply, x, x));
  const Program square = builder.finish();
  const std::vector<SlotPlace> rows = {{{Array::y, 0}, {Array::seed, 0}}}, columns = {{{Array::x, 0}, {Array::x, 0}}};
  EXPECT_THROW(transposed(square, rows, columns), std::logic_error);
  EXPECT_THROW(transposed(square, {}, columns), std::logic_error);
}

}  // namespace
}  // namespace mbgen::adjoint_test
