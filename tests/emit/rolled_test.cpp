// Loops over equal subsystems: what is found, and what the emitted code says about mechanisms made of many cells.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compiler/compile.hpp"
#include "compiler/schedule/roll.hpp"
#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

const Compiler kCompiler{"g++", CompilerFamily::gnu};

/// A model of bench/growth_model.sh.
Compilation grown(const std::string& kind, int size) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "model.json";
  const Finished made =
      run("sh " MBGEN_SOURCE_DIR "/bench/growth_model.sh " + kind + " " + std::to_string(size) + " > " + path.string());
  if (made.code != 0) throw std::runtime_error(made.text);
  Result<Compilation> compilation = compile(path.string());
  if (!compilation) throw std::runtime_error(to_text(compilation.problems()));
  return std::move(*compilation);
}

std::vector<EmittedFile> rolled_files(const Compilation& compilation) {
  return emit(compilation, {.runtime_headers = false, .roll_above = 0});
}

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Values of the accelerations' program at a state, by slot.
double interpreted(const Program& program, const std::vector<double>& state, const std::vector<double>& tau,
                   std::size_t coordinate) {
  std::vector<double> inputs;
  const std::size_t n = tau.size();
  for (const Slot& slot : program.inputs) {
    const auto index = static_cast<std::size_t>(slot.index);
    inputs.push_back(slot.group == Array::z ? state[index] : slot.group == Array::zd ? state[n + index] : tau[index]);
  }
  const std::vector<double> values = interpret(program, inputs);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Slot& slot = program.outputs[i].slot;
    if (slot.group == Array::zdd && slot.index == static_cast<int>(coordinate)) return values[i];
  }
  return NAN;
}

/// The largest difference of emitted and interpreted accelerations at random states, over the largest acceleration.
double largest_difference(const Compilation& compilation, const SolverTable& table) {
  const std::size_t n = compilation.topology.bodies.size();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-0.3, 0.3);
  std::vector<double> state(2 * n + 1), tau(n), derivative(n);
  for (double& value : state) value = unit(random);
  for (double& value : tau) value = unit(random);
  EXPECT_TRUE(table.accelerations(nullptr, nullptr, state.data(), tau.data(), derivative.data()).ok());
  const Programs counted = counted_programs(compilation);
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double expected = interpreted(counted.accelerations, state, tau, i);
    difference = std::max(difference, std::abs(derivative[i] - expected));
    size = std::max(size, std::abs(expected));
  }
  return difference / size;
}

TEST(Roll, findsEqualSlicesAndLeavesTheFirstStraight) {
  ProgramBuilder builder("cells");
  ValueId carried = builder.input(Array::t, 0);
  for (int cell = 0; cell < 40; ++cell) {
    const ValueId z = builder.input(Array::z, cell);
    const ValueId scaled = builder.append(Op::multiply, builder.constant(1.5 + cell), builder.append(Op::sin, z));
    const ValueId turned = builder.append(Op::divide, scaled, builder.append(Op::cos, z));
    carried = builder.append(Op::add, builder.append(Op::sqrt, turned), carried);
    builder.output(Array::zdd, cell, carried);
  }
  const Rolling rolling = roll(builder.finish(), {Array::z, Array::zdd});
  ASSERT_EQ(rolling.loops.size(), 1u);
  EXPECT_EQ(rolling.loops[0].period, 6u);
  EXPECT_EQ(rolling.order.size(), 240u);
  EXPECT_GE(rolling.loops[0].count, 38u);
  EXPECT_GE(rolling.loops[0].first, 6u);
}

TEST(Roll, inputsThatAreNoArrayTellSlicesApart) {
  ProgramBuilder builder("cells");
  for (int cell = 0; cell < 100; ++cell) {
    const ValueId p = builder.input(Array::par, cell);
    builder.output(Array::zdd, cell, builder.append(Op::sin, builder.append(Op::sqrt, p)));
  }
  EXPECT_TRUE(roll(builder.finish(), {Array::zdd}).loops.empty());
}

TEST(Rolled, theSameBytesTwice) {
  const auto once = rolled_files(grown("four-bar", 12)), again = rolled_files(grown("four-bar", 12));
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].text, again[i].text) << once[i].path;
}

TEST(Rolled, moreCellsMakeLongerTablesNotMoreCode) {
  const std::string few = rolled_files(grown("four-bar", 60))[1].text;
  const std::string many = rolled_files(grown("four-bar", 110))[1].text;
  EXPECT_GT(count_of(few, "for (int k"), 20);
  EXPECT_LE(count_of(many, "const double"), count_of(few, "const double"));
}

// N = 40 of the LIM benchmark: the parallelograms move like one pendulum, thetadd = A sin(theta), theta from upright
// (reference/a02_n_four_bar.json). Lever arms of 40 m leave rounding of 1e-13.
TEST(Rolled, fourBarsMoveLikeOnePendulum) {
  if (!is_installed(kCompiler)) GTEST_SKIP() << "g++ is not installed";
  constexpr int kBars = 40, kCoordinates = 2 * kBars + 1;
  const Compilation compilation = grown("four-bar", kBars);
  std::vector<EmittedFile> files = rolled_files(compilation);
  files.push_back(emit_driver(compilation.model));
  const Loaded loaded(files, solver_name(compilation.model), kCompiler);
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const double a = 9.81 * ((kBars + 1) / 2.0 + kBars) / ((kBars + 1) / 3.0 + kBars);
  const std::vector<double> tau(kCoordinates, 0.0);
  for (const double theta : {-0.8, 0.3, 1.1, 2.5}) {
    std::vector<double> state(2 * kCoordinates + 1, 0.0), derivative(kCoordinates);
    for (int i = 0; i < kCoordinates; ++i) {
      const double sense = compilation.topology.bodies[static_cast<std::size_t>(i)].coordinate[0] == 'A' ? -1 : 1;
      state[static_cast<std::size_t>(i)] = sense * theta;
      state[static_cast<std::size_t>(kCoordinates + i)] = sense * 1.7;
    }
    ASSERT_TRUE(loaded.table()->accelerations(nullptr, nullptr, state.data(), tau.data(), derivative.data()).ok());
    for (int i = 0; i < kCoordinates; ++i) {
      const double sense = compilation.topology.bodies[static_cast<std::size_t>(i)].coordinate[0] == 'A' ? -1 : 1;
      EXPECT_NEAR(derivative[static_cast<std::size_t>(i)], sense * a * std::sin(theta), 1e-11) << theta << " " << i;
    }
  }
  // Off the closures every cell has numbers of its own; the program is what the interpreter says.
  EXPECT_LT(largest_difference(compilation, *loaded.table()), 1e-11);
}

// A ring is an opened block: its equations need no partition, so that the program for one chosen at run time gives the
// same.
TEST(Opened, aRingMovesAsTheInterpreterSays) {
  if (!is_installed(kCompiler)) GTEST_SKIP() << "g++ is not installed";
  const Compilation compilation = grown("ring", 44);
  ASSERT_TRUE(compilation.topology.blocks[0].opened);
  std::vector<EmittedFile> files = emit(compilation, {.runtime_headers = false});
  files.push_back(emit_driver(compilation.model));
  const Loaded loaded(files, solver_name(compilation.model), kCompiler);
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  EXPECT_LT(largest_difference(compilation, *loaded.table()), 1e-11);
}

}  // namespace
}  // namespace mbgen::test
