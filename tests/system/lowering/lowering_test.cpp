// Programs of every model after each pass, against the programs as they were traced.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "compiler/compile.hpp"
#include "compiler/program/rounded.hpp"
#include "compiler/reader/read_model.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStates = 3;
constexpr double kRoundings = 1e-9;  // times the largest output

/// Values of the outputs at inputs that random numbers give, the same ones to the same input of every program.
std::vector<double> values_at(const Program& program, const Program& named_by, std::size_t state) {
  std::map<Slot, double> given;
  const std::vector<double> inputs = ordinary_inputs(named_by, state);
  for (std::size_t i = 0; i < inputs.size(); ++i) given.emplace(named_by.inputs[i], inputs[i]);
  std::vector<double> own;
  for (const Slot& slot : program.inputs) own.push_back(given.at(slot));
  return interpret(program, own);
}

void expect_values_of(const Program& expected, const Program& found, const std::string& what) {
  ASSERT_EQ(found.outputs.size(), expected.outputs.size()) << what;
  for (std::size_t state = 0; state < kStates; ++state) {
    const std::vector<double> right = values_at(expected, expected, state), now = values_at(found, expected, state);
    double largest = 1;
    for (std::size_t i = 0; i < right.size(); ++i) {
      ASSERT_EQ(found.outputs[i].slot, expected.outputs[i].slot) << what;
      if (std::isfinite(right[i])) largest = std::max(largest, std::abs(right[i]));
    }
    for (std::size_t i = 0; i < right.size(); ++i)
      EXPECT_TRUE(std::abs(now[i] - right[i]) <= kRoundings * largest || (std::isnan(right[i]) && std::isnan(now[i])))
          << what << ", " << expected.name << ", state " << state << ": output " << i << " is " << now[i] << ", not "
          << right[i];
  }
}

std::vector<std::string> models() {
  std::vector<std::string> paths;
  for (const char* folder : {"models", "models/axles", "models/iftomm", "models/published", "models/rides",
                             "models/starters", "tests/data/models"})
    for (const auto& entry : fs::directory_iterator(fs::path(MBGEN_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".json") paths.push_back(folder + ("/" + entry.path().filename().string()));
  std::ranges::sort(paths);
  return paths;
}

class Lowering : public testing::TestWithParam<std::string> {};

TEST_P(Lowering, KeepsTheValuesOfEveryProgram) {
  WholePrograms traced;
  const auto watch = [&](const Stage& stage) {
    const WholePrograms& whole = stage.so_far.whole;
    if (stage.name == "program") traced = whole;
    if (stage.name != "pairs-kept") return true;
    for (const ProgramSpec& spec : program_specs())
      if (!program_of(traced.programs, spec.role).outputs.empty())
        expect_values_of(program_of(traced.programs, spec.role), program_of(whole.programs, spec.role), "whole");
    const Program& around = traced.accelerations_of_text();
    if (whole.around_laws) expect_values_of(around, whole.around_laws->program, "around laws");
    if (whole.in_pairs) expect_values_of(around, whole.in_pairs->program, "in pairs");
    return false;
  };
  Result<Model> model = read_model_file(MBGEN_SOURCE_DIR "/" + GetParam());
  ASSERT_TRUE(model) << to_text(model.problems());
  const Result<Compilation> compiled = compile(std::move(*model), {.watch = watch});
  ASSERT_TRUE(compiled) << to_text(compiled.problems());
}

INSTANTIATE_TEST_SUITE_P(Models, Lowering, testing::ValuesIn(models()), [](const auto& info) {
  std::string name = info.param;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

}  // namespace
}  // namespace mbgen
