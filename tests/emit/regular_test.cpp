// A solver of regular positions alone beside the whole one.

#include "mbgen/solver/regular.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/emit/emit_support.hpp"
#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

class RegularOnly : public testing::TestWithParam<Compiler> {};

/// Results of all calls at an angle of the bead, and their codes; -7 where a call leaves a result untouched.
struct BeadCalls {
  std::vector<Code> codes;
  std::vector<double> results;
};

BeadCalls bead_calls(const SolverTable& table, double a, double h) {
  BeadCalls calls;
  const double w = 1.3, push = 1.5, tau[] = {0.4, -0.9};
  const double state[] = {std::cos(a), std::sin(a), -std::sin(a) * w, std::cos(a) * w, 0};
  const double* const p = table.default_parameters;
  double open[] = {state[0] + 0.01, state[1], state[2], state[3], 0};
  double stepped[] = {state[0], state[1], state[2], state[3], 0};
  const double known[] = {0.3, -0.2};
  double derivative[] = {-7, -7}, in_motion[] = {-7, -7}, lambda = -7, drive = -7, energy[] = {-7, -7, -7};
  double y[] = {-7, -7};
  calls.codes = {table.accelerations(p, &push, state, tau, derivative).code,
                 table.project(p, &push, open).code,
                 table.step_rk4(p, &push, stepped, h).code,
                 table.accelerations_in_motion(p, &push, state, h, in_motion).code,
                 table.multiplier_values(p, &push, state, tau, known, &lambda, &drive).code,
                 table.output_values(p, &push, state, tau, known, y, energy).code};
  calls.results = {derivative[0], derivative[1], open[0],      open[1],      open[2],  open[3], stepped[0],
                   stepped[1],    stepped[2],    stepped[3],   stepped[4],   lambda,   y[0],    y[1],
                   energy[0],     energy[1],     in_motion[0], in_motion[1], energy[2]};
  return calls;
}

TEST_P(RegularOnly, GivesTheSameBitsOrAsksForTheWholeSolver) {
  if (!is_installed(GetParam())) GTEST_SKIP() << GetParam().command << " is not installed";
  const Example example = bead_with_pull();
  std::vector<EmittedFile> files = emit(example, {.runtime_headers = false});
  files.push_back(emit_driver(example.model));
  const Loaded loaded(files, solver_name(example.model), GetParam());
  ASSERT_NE(loaded.table(), nullptr) << loaded.compilation().text;
  files = emit(example, {.runtime_headers = false, .sources_alone = true, .regular_only_from = 1});
  ASSERT_EQ(files.size(), 2u) << "the sources alone";
  files.push_back(emit_driver(example.model));
  const Loaded regular(files, solver_name(example.model), GetParam());
  ASSERT_NE(regular.table(), nullptr) << regular.compilation().text;
  EXPECT_FALSE(loaded.table()->regular_only);
  EXPECT_TRUE(regular.table()->regular_only);
  for (const double a : {0.0, 0.7, 1.2, 3.0, -2.0}) {
    const BeadCalls whole = bead_calls(*loaded.table(), a, 1e-3), own = bead_calls(*regular.table(), a, 1e-3);
    EXPECT_EQ(own.codes, std::vector<Code>(6, Code::ok)) << a;
    EXPECT_EQ(own.codes, whole.codes) << a;
    EXPECT_EQ(own.results, whole.results) << a;
  }
  // At the singular position of the frozen partition every call asks for the whole solver, and touches nothing.
  const double a = std::numbers::pi / 2;
  const BeadCalls own = bead_calls(*regular.table(), a, 1e-3);
  EXPECT_EQ(own.codes, std::vector<Code>(6, kNotRegular));
  const double x = std::cos(a), y = std::sin(a), xd = -1.3 * y, yd = 1.3 * x;
  const std::vector<double> untouched = {-7, -7, x + 0.01, y, xd, yd, x, y, xd, yd, 0, -7, -7, -7, -7, -7, -7, -7, -7};
  EXPECT_EQ(own.results, untouched);
  // A step whose way is to be watched is one for the whole solver.
  EXPECT_EQ(bead_calls(*loaded.table(), 0.7, 0.2).codes[2], Code::ok);
  EXPECT_EQ(bead_calls(*regular.table(), 0.7, 0.2).codes[2], kNotRegular);
}

INSTANTIATE_TEST_SUITE_P(Compilers, RegularOnly,
                         testing::Values(Compiler{"g++", CompilerFamily::gnu},
                                         Compiler{"clang++", CompilerFamily::clang}),
                         [](const auto& info) { return info.param.family == CompilerFamily::gnu ? "gnu" : "clang"; });

}  // namespace
}  // namespace mbgen::test
