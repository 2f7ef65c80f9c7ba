// Emitted code, compiled by both compilers with every warning an error, against what is known of it.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include "tests/emit/emit_support.hpp"
#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

/// The solver of an example, compiled once in a process for all tests that ask for it.
const Loaded& load(const Example& example, const Compiler& compiler) {
  static std::map<std::string, Loaded> known;
  std::vector<EmittedFile> files = emit(example, {.runtime_headers = false});
  files.push_back(emit_driver(example.model));
  std::string key = compiler.command;
  for (const EmittedFile& file : files) key += file.text;
  return known.try_emplace(key, files, solver_name(example.model), compiler).first->second;
}

class Emitted : public testing::TestWithParam<Compiler> {
 protected:
  void SetUp() override {
    if (!is_installed(GetParam())) GTEST_SKIP() << GetParam().command << " is not installed";
  }
};

/// Accelerations of the bead at angle a and rate w, from the pendulum equation in the angle.
void bead_answer(double a, double w, double mass, double fx, double fy, double* answer) {
  const double force = fx * -std::sin(a) + (fy - 9.81 * mass) * std::cos(a);
  const double rate = force / mass;
  answer[0] = -std::sin(a) * rate - std::cos(a) * w * w;
  answer[1] = std::cos(a) * rate - std::sin(a) * w * w;
}

TEST_P(Emitted, acceleratesTheBeadOnBothPaths) {
  const Loaded& loaded = load(bead_on_circle(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  EXPECT_EQ(table.layout, kSolverTableLayout);
  EXPECT_STREQ(table.model, "bead");
  EXPECT_EQ(table.state_size, 5);
  EXPECT_EQ(table.parameters, 2);
  EXPECT_EQ(table.default_parameters[0], 2);
  EXPECT_EQ(table.default_parameters[1], 1);
  const double mass = 3, push = 1.5, parameters[] = {mass, 1};
  // From the frozen partition at a = 0 through its monitor's threshold to its singularity at a quarter turn.
  for (const double a : {0.0, 0.7, 1.5, 1.56, std::numbers::pi / 2, 1.6, 3.0, -2.0}) {
    const double w = 1.3, tau[] = {0.4, -0.9};
    const double state[] = {std::cos(a), std::sin(a), -std::sin(a) * w, std::cos(a) * w, 0};
    double derivative[2], expected[2];
    bead_answer(a, w, mass, tau[0] + push, tau[1], expected);
    ASSERT_TRUE(table.accelerations(parameters, &push, state, tau, derivative).ok()) << a;
    // The frozen path loses two digits at the threshold, and rounding of the state two more.
    EXPECT_NEAR(derivative[0], expected[0], 1e-12) << a;
    EXPECT_NEAR(derivative[1], expected[1], 1e-12) << a;
    double lambda, drive;
    ASSERT_TRUE(table.multiplier_values(parameters, &push, state, tau, expected, &lambda, &drive).ok());
    EXPECT_NEAR(mass * expected[0], tau[0] + push - 2 * std::cos(a) * lambda, 1e-12) << a;
    EXPECT_NEAR(mass * expected[1], tau[1] - 9.81 * mass - 2 * std::sin(a) * lambda, 1e-12) << a;
  }
}

TEST_P(Emitted, timesTheStepsInADriverWithAClock) {
  const Example example = bead_on_circle();
  EXPECT_EQ(load(example, GetParam()).table()->step_ticks, nullptr);
  std::vector<EmittedFile> files = emit(example, {.runtime_headers = false});
  files.push_back(emit_clocked_driver({example.programs}, example.model, example.topology, example.analysis));
  const Loaded loaded(files, solver_name(example.model), GetParam(), "");
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  ASSERT_NE(table.step_ticks, nullptr);
  const double state[] = {1, 0, 0, 1, 0}, tau[] = {0, 0}, push = 0;
  long long ticks[kSteps];
  table.step_ticks(table.default_parameters, &push, state, tau, 1, 1000, ticks);
  for (int step = 1; step <= kSteps; ++step) EXPECT_GE(ticks[step - 1], 0) << step;
}

TEST_P(Emitted, outputsTakeMultipliersWhereTheFrozenPartitionHasNone) {
  const Loaded& loaded = load(bead_with_pull(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  const double push = 1.5, tau[] = {0.4, -0.9}, mass = table.default_parameters[0], w = 1.3;
  double energy[3], y[2];
  for (const double a : {0.7, std::numbers::pi / 2}) {
    const double state[] = {std::cos(a), std::sin(a), -std::sin(a) * w, std::cos(a) * w, 0};
    double derivative[2];
    bead_answer(a, w, mass, tau[0] + push, tau[1], derivative);
    ASSERT_TRUE(table.output_values(table.default_parameters, &push, state, tau, derivative, y, energy).ok());
    EXPECT_NEAR(y[0], 1, 1e-15);
    EXPECT_NEAR(2 * std::sin(a) * y[1], tau[1] - mass * (9.81 + derivative[1]), 1e-12) << a;
  }
  // At the centre there is none; what does not need it is given all the same.
  const double centre[] = {0, 0, 0, 0, 0}, still[] = {0, 0};
  ASSERT_TRUE(table.output_values(table.default_parameters, &push, centre, tau, still, y, energy).ok());
  EXPECT_EQ(y[0], 0);
  EXPECT_TRUE(std::isnan(y[1]));
}

TEST_P(Emitted, projectsFromAGuessAndLeavesTheStateWhenItCannot) {
  const Loaded& loaded = load(bead_on_circle(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  const double push = 0;
  double state[] = {0.4, 0.6, 7, 1, 0};
  ASSERT_TRUE(table.project(table.default_parameters, &push, state).ok());
  EXPECT_NEAR(state[0], 0.8, 1e-12);
  EXPECT_EQ(state[1], 0.6) << "independent";
  EXPECT_NEAR(state[2], -0.75, 1e-12);
  EXPECT_EQ(state[3], 1);

  // Near the top the pivoted partition moves y and keeps x.
  double top[] = {0.001, 0.7, 1, 7, 0};
  ASSERT_TRUE(table.project(table.default_parameters, &push, top).ok());
  EXPECT_EQ(top[0], 0.001);
  EXPECT_NEAR(top[1], std::sqrt(1 - 1e-6), 1e-12);
  EXPECT_EQ(top[2], 1);
  EXPECT_NEAR(top[3], -0.001 / top[1], 1e-12);
  double position, velocity;
  ASSERT_TRUE(table.residuals(table.default_parameters, &push, top, &position, &velocity).ok());
  EXPECT_LE(std::abs(position), 1e-12);
  EXPECT_LE(std::abs(velocity), 1e-12);

  const double impossible[] = {2, -1};
  double open[] = {0.53, 1.9, 0, 0, 0};
  const Status status = table.project(impossible, &push, open);
  EXPECT_EQ(status.code, Code::loop_not_closed);
  EXPECT_EQ(status.index, 0);
  EXPECT_STREQ(table.describe(status), "circle");
  EXPECT_EQ(open[0], 0.53);
  // At the centre every derivative of the closure is zero.
  double centre[] = {0, 0, 0, 0, 0};
  EXPECT_EQ(table.project(table.default_parameters, &push, centre).code, Code::loop_singular);
}

TEST_P(Emitted, namesWhatIsNotFinite) {
  const Loaded& loaded = load(bead_on_circle(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  const double nan = std::numeric_limits<double>::quiet_NaN(), push = 0, tau[] = {0, 0};
  double derivative[] = {7, 8};
  for (int i = 0; i < 5; ++i) {
    double state[] = {1, 0, 0, 1, 0};
    state[i] = i % 2 == 0 ? nan : std::numeric_limits<double>::infinity();
    const Status status = table.accelerations(table.default_parameters, &push, state, tau, derivative);
    const Code expected = i < 4 ? Code::not_a_number : Code::time_not_a_number;
    EXPECT_EQ(status.code, expected) << i;
    EXPECT_EQ(status.index, i < 4 ? i % 2 : -1) << i;
    EXPECT_EQ(table.project(table.default_parameters, &push, state).code, expected) << i;
  }
  const double state[] = {1, 0, 0, 1, 0};
  const Status of_input = table.accelerations(table.default_parameters, &nan, state, tau, derivative);
  EXPECT_EQ(of_input.code, Code::input_not_a_number);
  EXPECT_STREQ(table.describe(of_input), "push");
  EXPECT_EQ(derivative[0], 7) << "untouched";
  const double negative[] = {-1, 1};
  const Status status = table.accelerations(negative, &push, state, tau, derivative);
  EXPECT_EQ(status.code, Code::no_inertia);
  EXPECT_STREQ(table.describe(status), "y");
  // Large values whose sum overflows are still finite.
  const double large[] = {1, 0, 1e308, 1e308, 1e308};
  EXPECT_EQ(table.residuals(table.default_parameters, &push, large, derivative, derivative + 1).code, Code::ok);
}

/// Energy after one turn or so, with n steps.
double energy_drift(const SolverTable& table, int steps, bool adams) {
  const double push = 0, h = 2.0 / steps, tau[] = {0, 0};
  double state[] = {1, 0, 0, 6, 0};
  std::vector<double> history(table.history_bytes / sizeof(double) + 1);
  table.start_abm4(history.data());
  double first = 0, derivative[2] = {0, 0}, y, energy[3];
  for (int i = 0; i <= steps; ++i) {
    EXPECT_TRUE(table.output_values(table.default_parameters, &push, state, tau, derivative, &y, energy).ok());
    EXPECT_NEAR(y, 1, 1e-12);
    if (i == 0) first = energy[0] + energy[1];
    if (i == steps) break;
    const Status status = adams ? table.step_abm4(table.default_parameters, &push, state, history.data(), h)
                                : table.step_rk4(table.default_parameters, &push, state, h);
    EXPECT_TRUE(status.ok()) << i;
  }
  return std::abs(energy[0] + energy[1] - first);
}

TEST_P(Emitted, stepsWithOrderFourThroughSingularPartitions) {
  const Loaded& loaded = load(bead_on_circle(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  for (const bool adams : {false, true}) {
    const double coarse = energy_drift(*loaded.table(), 400, adams), fine = energy_drift(*loaded.table(), 800, adams);
    EXPECT_LT(coarse, 1e-3) << adams;
    EXPECT_GT(coarse / fine, 8) << adams << " " << coarse << " " << fine;
  }
  double state[] = {1, 0, 0, 6, 0};
  const double push = 0;
  EXPECT_EQ(loaded.table()->step_rk4(loaded.table()->default_parameters, &push, state, 0).code, Code::step_invalid);
}

TEST_P(Emitted, advancesInputsDuringAStep) {
  const Loaded& loaded = load(pushed_slider(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  const double jerk = 3, push = 2, rate = -1, inputs[] = {jerk, push, rate}, h = 0.5;
  std::vector<double> history(table.history_bytes / sizeof(double) + 1);
  table.start_abm4(history.data());
  for (const bool adams : {false, true}) {
    double state[] = {0, 0, 0, 0, 7};
    const Status status =
        adams ? table.step_abm4(nullptr, inputs, state, history.data(), h) : table.step_rk4(nullptr, inputs, state, h);
    ASSERT_TRUE(status.ok());
    // Runge-Kutta integrates a parabola exactly.
    EXPECT_DOUBLE_EQ(state[2], h * (push + h / 2 * (rate + h / 3 * jerk)));
    EXPECT_DOUBLE_EQ(state[0], h * h * (push / 2 + h * (rate / 6 + h * jerk / 24)));
    EXPECT_EQ(state[1], 0);
  }
}

TEST_P(Emitted, followsMotionsOnBothPaths) {
  const Loaded& loaded = load(driven_bead(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  const SolverTable& table = *loaded.table();
  EXPECT_EQ(table.drives, 1);
  const double push = 0, tau[] = {0, 0};
  // y(2) = 1 is the top, where x has no derivative; shortly before it the frozen monitor has tripped.
  for (const double t : {0.0, 1.0, 1.99, 1.9999}) {
    const double y = 0.3 * t + 0.1 * t * t, yd = 0.3 + 0.2 * t, x = std::sqrt((1 - y) * (1 + y));
    double state[] = {x + 0.3, y - 0.2, 5, 6, t};
    ASSERT_TRUE(table.project(table.default_parameters, &push, state).ok()) << t;
    EXPECT_NEAR(state[1], y, 1e-15);
    EXPECT_NEAR(state[0], x, 1e-12 / x);
    EXPECT_NEAR(state[3], yd, 1e-15);
    EXPECT_NEAR(state[2], -y * yd / state[0], 1e-12 / x);
    double derivative[2];
    ASSERT_TRUE(table.accelerations(table.default_parameters, &push, state, tau, derivative).ok());
    const double xdd = -(state[2] * state[2] + yd * yd + 0.2 * y) / state[0];
    EXPECT_EQ(derivative[1], 0.2);
    EXPECT_NEAR(derivative[0], xdd, 1e-13 * std::abs(xdd));
    double lambda, drive;
    ASSERT_TRUE(table.multiplier_values(table.default_parameters, &push, state, tau, derivative, &lambda, &drive).ok());
    const double mass = table.default_parameters[0], needed = mass * (0.2 + 9.81) + 2 * state[1] * lambda;
    EXPECT_NEAR(2 * state[0] * lambda, -mass * derivative[0], 1e-13 * std::abs(mass * xdd)) << t;
    EXPECT_NEAR(drive, needed, 1e-13 * std::abs(2 * lambda)) << t;
  }
  // Past the top the motion leaves the circle.
  double state[] = {0.1, 1, 0, 0, 2.5};
  EXPECT_EQ(table.project(table.default_parameters, &push, state).code, Code::loop_not_closed);
}

TEST_P(Emitted, watchesRedundantEquations) {
  const double push = 0;
  for (const double gap : {1e-8, 1e-3}) {
    const Loaded& loaded = load(redundant_bead(gap), GetParam());
    ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
    // On the frozen path, and with the partition that pivoting chooses.
    for (const double x : {0.8, 0.001}) {
      double state[] = {x, 0.6, 0, 0, 0};
      const Status status = loaded.table()->project(loaded.table()->default_parameters, &push, state);
      EXPECT_EQ(status.code, gap < 1e-6 ? Code::ok : Code::loop_not_closed) << gap << " " << x;
      EXPECT_EQ(status.index, gap < 1e-6 ? -1 : 0);
    }
  }
}

TEST_P(Emitted, timesEveryState) {
  const Loaded& loaded = load(bead_on_circle(), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  std::vector<double> states, taus(2 * 37, 0.0);
  for (int i = 0; i < 37; ++i) states.insert(states.end(), {std::cos(i), std::sin(i), 0, 0, 0});
  states[20 * 5] = std::numeric_limits<double>::quiet_NaN();
  const double push = 0;
  EXPECT_EQ(
      loaded.table()->time_accelerations(loaded.table()->default_parameters, &push, states.data(), taus.data(), 37, 10),
      10);
}

/// A random program with every operation, `size` values and y[0..outputs).
Program random_program(int size, int outputs) {
  std::mt19937 random(7);
  ProgramBuilder builder("outputs");
  std::vector<ValueId> values;
  for (int i = 0; i < 2; ++i) {
    for (const Array array : {Array::z, Array::zd, Array::zdd}) values.push_back(builder.input(array, i));
  }
  const auto any = [&] { return values[std::uniform_int_distribution<std::size_t>(0, values.size() - 1)(random)]; };
  const auto recent = [&] {
    return values[values.size() - 1 -
                  std::uniform_int_distribution<std::size_t>(0, std::min<std::size_t>(values.size() - 1, 40))(random)];
  };
  const Op ops[] = {Op::add, Op::subtract, Op::multiply, Op::divide, Op::negate,  Op::sqrt,  Op::sin,
                    Op::cos, Op::tan,      Op::asin,     Op::acos,   Op::atan,    Op::atan2, Op::exp,
                    Op::log, Op::pow,      Op::tanh,     Op::abs,    Op::min,     Op::max,   Op::select,
                    Op::add, Op::subtract, Op::multiply, Op::add,    Op::multiply};
  for (int i = 0; i < size; ++i) {
    if (i % 300 == 0) builder.set_section({static_cast<Step>(1 + i / 300), -1});
    if (i % 50 == 0) builder.set_owner({OwnerKind::tree_body, i / 50 % 2});
    const Op op = ops[std::uniform_int_distribution<std::size_t>(0, std::size(ops) - 1)(random)];
    ValueId value = builder.append(op, recent(), arity(op) > 1 ? any() : kNoValue, arity(op) > 2 ? recent() : kNoValue);
    // Squashed, so that chains stay in range; by a quotient, since compilers know identities of composed functions.
    value =
        builder.append(Op::divide, value, builder.append(Op::add, builder.constant(1), builder.append(Op::abs, value)));
    if (i % 9 == 0) builder.label(value, "label " + std::to_string(i % 90));
    if (i % 5 == 0)
      value = builder.append(Op::multiply, value, builder.constant(i % 2 == 0 ? -0.1 * i : 1.0 / (1 + i)));
    values.push_back(value);
  }
  for (int o = 0; o < outputs; ++o) builder.output(Array::y, o, values[values.size() - 1 - 7 * o]);
  return builder.finish();
}

TEST_P(Emitted, computesWhatTheInterpreterComputes) {
  constexpr int kOutputs = 60;
  Example example = two_sliders();
  example.programs.outputs = random_program(3000, kOutputs);
  for (int o = 0; o < kOutputs; ++o) {
    Output output;
    output.name = std::string("y").append(std::to_string(o));
    example.model.outputs.push_back(output);
  }
  // No pass has contracted the program: compiled code has to agree to the last bit.
  const Loaded& loaded = load(example, GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int sample = 0; sample < 20; ++sample) {
    double state[5], derivative[2], y[kOutputs], energy[3];
    const double tau[] = {0, 0};
    for (double& value : state) value = number(random);
    for (double& value : derivative) value = number(random);
    std::vector<double> inputs;
    for (const Slot& slot : example.programs.outputs.inputs) {
      inputs.push_back(slot.group == Array::z    ? state[slot.index]
                       : slot.group == Array::zd ? state[2 + slot.index]
                                                 : derivative[slot.index]);
    }
    const std::vector<double> expected = interpret(example.programs.outputs, inputs);
    ASSERT_TRUE(loaded.table()->output_values(nullptr, nullptr, state, tau, derivative, y, energy).ok());
    for (std::size_t o = 0; o < expected.size(); ++o) {
      const double actual = y[example.programs.outputs.outputs[o].slot.index];
      EXPECT_TRUE(actual == expected[o] || (std::isnan(actual) && std::isnan(expected[o])))
          << sample << " " << o << ": " << actual << " " << expected[o];
    }
  }
}

TEST_P(Emitted, needsNothingButTheMathLibrary) {
  TemporaryDirectory directory;
  for (const Example& example : {bead_on_circle(), two_sliders(), pushed_slider(), driven_bead(), redundant_bead(0)}) {
    for (const EmittedFile& file : emit(example)) write(directory.path(), file);
    const std::string base = (directory.path() / "bead").string();
    for (const char* more : {"", " -march=native"}) {
      const Finished compilation = run(compile_command(GetParam()) + more + " -I" + directory.path().string() +
                                       " -c -o " + base + ".o " + base + ".cpp");
      ASSERT_EQ(compilation.code, 0) << compilation.text;
      EXPECT_EQ(foreign_symbols(base + ".o"), std::vector<std::string>{});
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Compilers, Emitted,
                         testing::Values(Compiler{"g++", CompilerFamily::gnu},
                                         Compiler{"clang++", CompilerFamily::clang}),
                         [](const auto& info) { return info.param.family == CompilerFamily::gnu ? "gnu" : "clang"; });

TEST(EmittedBuildFile, buildsAlone) {
  TemporaryDirectory directory;
  for (const EmittedFile& file : emit(bead_on_circle())) write(directory.path(), file);
  const std::string build = (directory.path() / "build").string();
  const Finished result = run("cmake -S " + directory.path().string() + " -B " + build + " && cmake --build " + build);
  EXPECT_EQ(result.code, 0) << result.text;
  EXPECT_TRUE(fs::exists(build + "/libbead.a"));
}

}  // namespace
}  // namespace mbgen::test
