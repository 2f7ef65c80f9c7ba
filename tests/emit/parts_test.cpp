// Solvers that are compiled part by part.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/emit/emit_support.hpp"
#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

/// Everything that a solver answers at states on the circle and beside it.
std::vector<double> answers_of(const SolverTable& table) {
  std::vector<double> all;
  const double push = 1.5, tau[] = {0.4, -0.9};
  for (const double a : {0.0, 0.7, 1.5, 1.56, std::numbers::pi / 2, 3.0}) {
    const double state[] = {std::cos(a), std::sin(a), -std::sin(a), std::cos(a), 0};
    double derivative[2] = {}, lambda = 0, drive = 0, y[2] = {}, energy[3] = {}, guess[] = {state[0], 0.6, 7, 1, 0};
    const double* parameters = table.default_parameters;
    EXPECT_TRUE(table.accelerations(parameters, &push, state, tau, derivative).ok());
    EXPECT_TRUE(table.multiplier_values(parameters, &push, state, tau, derivative, &lambda, &drive).ok());
    EXPECT_TRUE(table.output_values(parameters, &push, state, tau, derivative, y, energy).ok());
    const int code = static_cast<int>(table.project(parameters, &push, guess).code);
    all.insert(all.end(), {derivative[0], derivative[1], lambda, y[0], y[1], energy[0], energy[1], energy[2], guess[0],
                           guess[1], guess[2], guess[3], static_cast<double>(code)});
  }
  return all;
}

class InParts : public testing::TestWithParam<Compiler> {};

TEST_P(InParts, hasTheBitsOfTheWhole) {
  if (!is_installed(GetParam())) GTEST_SKIP() << GetParam().command << " is not installed";
  const Example example = bead_with_pull();
  std::vector<EmittedFile> files = emit(example, {.runtime_headers = false, .file_part_values = 1});
  files.push_back(emit_driver(example.model));
  EXPECT_EQ(files[1].rare_parts, 4) << "multipliers, closure terms, accelerations and outputs";
  const Loaded divided(files, solver_name(example.model), GetParam(), "");
  ASSERT_NE(divided.table(), nullptr) << divided.compilation().text;
  for (EmittedFile& file : files) file.rare_parts = 0;  // the same text without MBGEN_PART
  std::string quick;                                    // as `simulate` compiles what it runs
  for (const std::string& flag : quick_compile_flags(GetParam().family)) quick += " " + flag;
  const Loaded whole(files, solver_name(example.model), GetParam(), quick);
  ASSERT_NE(whole.table(), nullptr) << whole.compilation().text;
  EXPECT_EQ(answers_of(*divided.table()), answers_of(*whole.table()));
}

INSTANTIATE_TEST_SUITE_P(Compilers, InParts,
                         testing::Values(Compiler{"g++", CompilerFamily::gnu},
                                         Compiler{"clang++", CompilerFamily::clang}),
                         [](const auto& info) { return info.param.family == CompilerFamily::gnu ? "gnu" : "clang"; });

TEST(FileParts, areCompiledSideBySideByTheCMakeFile) {
  const auto build_file = [](std::size_t values) {
    for (const EmittedFile& file : emit(bead_with_pull(), {.file_part_values = values}))
      if (file.path == "CMakeLists.txt") return file.text;
    return std::string();
  };
  const std::string divided = build_file(1), whole = build_file(100000);
  EXPECT_NE(divided.find("foreach(part RANGE 4)\n"), std::string::npos) << divided;
  EXPECT_NE(divided.find("PRIVATE MBGEN_PART=${part})\n"), std::string::npos) << divided;
  EXPECT_EQ(whole.find("MBGEN_PART"), std::string::npos) << whole;
}

TEST(FileParts, haveAtLeastTheValuesThatAreAskedFor) {
  const EmittedFile whole = emit(bead_on_circle())[1];
  EXPECT_EQ(whole.rare_parts, 0);
  EXPECT_EQ(whole.text.find("MBGEN_PART"), std::string::npos);
  const EmittedFile divided = emit(bead_on_circle(), {.file_part_values = 30})[1];
  EXPECT_EQ(divided.rare_parts, 2);
  EXPECT_NE(divided.text.find("MBGEN_IS_PART(2)"), std::string::npos);
  EXPECT_EQ(divided.text.find("MBGEN_IS_PART(3)"), std::string::npos);
}

}  // namespace
}  // namespace mbgen::test
