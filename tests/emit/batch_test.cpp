// The batch interface against the scalar solver, compiled by both compilers; see batch/check.cpp.

#include <gtest/gtest.h>

#include "compiler/compile.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/emit/emit_support.hpp"
#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

/// A start with another number in every place; its loops need not be closed.
InitialState some_start(const Compilation& compilation) {
  InitialState start;
  for (int i = 0; i < compilation.topology.size(); ++i) {
    start.z.push_back(0.01 * (i + 1));
    start.zd.push_back(-0.1 * (i + 1));
  }
  start.x.assign(auxiliary_state_names(compilation.model).size(), 0.0);
  return start;
}

/// Files of a model of the project with a batch interface. is_implicit: it asks for the implicit integrator.
std::vector<EmittedFile> files_of(const std::string& path, int lanes, bool is_implicit) {
  Result<Model> model = read_model_file(std::string(MBGEN_SOURCE_DIR "/") + path);
  if (!model) throw std::runtime_error(to_text(model.problems()));
  if (is_implicit) model->solver.integrator = SolverSettings::Integrator::rosenbrock;
  Result<Compilation> compilation = compile(std::move(*model));
  if (!compilation) throw std::runtime_error(to_text(compilation.problems()));
  return emit(*compilation, {.runtime_headers = false, .lanes = lanes, .initial = some_start(*compilation)});
}

struct Case {
  const char* model;
  const char* name;
  Compiler compiler;
  int lanes;
  const char* more_flags;
  bool is_implicit = false;
};

void PrintTo(const Case& which, std::ostream* out) {
  *out << which.compiler.command << ", " << which.lanes << " lanes";
}

class Batch : public testing::TestWithParam<Case> {};

/// Compiles one source with the flags of solvers in lanes, every warning an error.
Finished compile_source(const Case& which, const fs::path& directory, const std::string& source) {
  std::string command = which.compiler.command;
  std::vector<std::string> flags = solver_compile_flags(which.compiler.family);
#if defined(__x86_64__)
  if (which.compiler.family == CompilerFamily::gnu) {
    for (const std::string& flag : lane_flags_of_gnu_on_x86()) flags.push_back(flag);
  }
#endif
  for (const std::string& flag : flags) command += " " + flag;
  const std::string base = (directory / source).string();
  return run(command + " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror " +
             which.more_flags + " -I" + directory.string() + " -I" MBGEN_SOURCE_DIR "/runtime/include -c " + base +
             ".cpp -o " + base + ".o");
}

TEST_P(Batch, hasTheBitsAndStatusesOfTheScalarSolver) {
  const Case& which = GetParam();
  if (!is_installed(which.compiler)) GTEST_SKIP() << which.compiler.command << " is not installed";
  const TemporaryDirectory directory;
  for (const EmittedFile& file : files_of(which.model, which.lanes, which.is_implicit)) write(directory.path(), file);
  const std::string name = which.name, batch = name + "_batch";
  for (const std::string& source : {name, batch}) {
    const Finished compilation = compile_source(which, directory.path(), source);
    ASSERT_EQ(compilation.code, 0) << compilation.text;
  }
  // Nothing but libm and the scalar solver: no heap, no copies by the C library.
  for (const std::string& symbol : foreign_symbols(directory.path() / (batch + ".o"))) {
    const std::string member = std::to_string(name.size()) + name;
    EXPECT_TRUE(symbol.starts_with("_ZN" + member) || symbol.starts_with("_ZNK" + member)) << symbol;
  }
  const std::string base = (directory.path() / name).string(), check = (directory.path() / "check").string();
  const Finished linked =
      run(std::string(which.compiler.command) + " -std=c++17 -O1 " + (which.is_implicit ? "-DIMPLICIT " : "") +
          "-DSOLVER=" + name + " -DINTERFACE='\"" + batch + ".hpp\"' -I" + directory.path().string() +
          " -I" MBGEN_SOURCE_DIR "/runtime/include " MBGEN_SOURCE_DIR "/tests/system/batch/check.cpp " MBGEN_SOURCE_DIR
          "/tests/support/heap.cpp " +
          base + ".o " + base + "_batch.o -o " + check);
  ASSERT_EQ(linked.code, 0) << linked.text;
  const Finished checked = run(check);
  EXPECT_EQ(checked.code, 0) << checked.text;
}

constexpr Compiler kGnu{"g++", CompilerFamily::gnu};
constexpr Compiler kClang{"clang++", CompilerFamily::clang};

std::string name_of_case(const testing::TestParamInfo<Case>& info) {
  return std::string(info.param.name) + "_" + std::to_string(info.param.lanes) +
         (info.param.compiler.family == CompilerFamily::gnu ? "_gnu" : "_clang");
}

INSTANTIATE_TEST_SUITE_P(
    Models, Batch,
    testing::Values(Case{"models/four_bar.json", "four_bar", kGnu, 8, "-march=native"},
                    Case{"models/agile_eye.json", "agile_eye", kClang, 4, ""},
                    Case{"tests/data/models/three_wheeler.json", "three_wheeler", kGnu, 8, "-march=native"},
                    Case{"tests/data/models/states.json", "states", kClang, 4, "", true},
                    Case{"tests/data/models/pressed.json", "pressed", kClang, 4, "", true},
                    Case{"tests/data/models/actuated_arm.json", "actuated_arm", kClang, 4, ""},
                    Case{"tests/data/models/hung_ball.json", "hung_ball", kClang, 4, "", true},
                    Case{"tests/data/models/all_elements.json", "all_elements", kGnu, 4, "-march=native"},
                    Case{"tests/data/models/all_elements.json", "all_elements", kClang, 4, "-march=native", true}),
    name_of_case);

// Elements that all_elements has too, and more lanes and compilers of the same model: tests/run.sh --long.
INSTANTIATE_TEST_SUITE_P(
    MoreModels, Batch,
    testing::Values(Case{"models/four_bar.json", "four_bar", kClang, 4, "-march=native"},
                    Case{"tests/data/models/driven_five_bar.json", "driven_five_bar", kClang, 8, ""},
                    Case{"tests/data/models/turning_three_wheeler.json", "turning_three_wheeler", kGnu, 4, ""},
                    Case{"tests/data/models/closed_track.json", "closed_track", kGnu, 4, ""},
                    Case{"models/four_bar.json", "four_bar", kGnu, 4, ""},
                    Case{"tests/data/models/slewing_jib.json", "slewing_jib", kGnu, 4, ""},
                    Case{"models/rolling_disc.json", "rolling_disc", kClang, 4, ""},
                    Case{"tests/data/models/mf61_three_wheeler.json", "mf61_three_wheeler", kClang, 4, ""},
                    Case{"tests/data/models/parked_wheels.json", "parked_wheels", kClang, 4, "", true},
                    Case{"tests/data/models/wheel_outputs.json", "wheel_outputs", kClang, 4, ""},
                    Case{"tests/data/models/mapped.json", "mapped", kClang, 4, ""},
                    Case{"tests/data/models/bushings.json", "bushings", kClang, 4, ""}),
    name_of_case);

TEST(BatchFiles, leaveTheOthersAsTheyAre) {
  Result<Compilation> compilation = compile(std::string(MBGEN_SOURCE_DIR "/models/four_bar.json"));
  ASSERT_TRUE(compilation);
  const std::vector<EmittedFile> plain = emit(*compilation, {.runtime_headers = false});
  const std::vector<EmittedFile> both = emit(*compilation, {.runtime_headers = false, .lanes = 8});
  ASSERT_EQ(both.size(), plain.size() + 2);
  EXPECT_EQ(text_of(both, "four_bar.hpp"), text_of(plain, "four_bar.hpp"));
  EXPECT_EQ(text_of(both, "four_bar.cpp"), text_of(plain, "four_bar.cpp"));
  EXPECT_NE(text_of(both, "four_bar_batch.hpp").find("constexpr int kLanes = 8;"), std::string::npos);
  EXPECT_NE(text_of(both, "CMakeLists.txt").find("four_bar.cpp four_bar_batch.cpp"), std::string::npos);
}

}  // namespace
}  // namespace mbgen::test
