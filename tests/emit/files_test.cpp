// Emitted files: which they are, what they begin with, what they refuse.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "compiler/emit/texts.hpp"
#include "tests/emit/emit_support.hpp"

namespace mbgen::test {
namespace {

TEST(EmittedFiles, areTheSameBytesWhereverTheModelLies) {
  Example here = bead_on_circle(), there = bead_on_circle();
  there.model.file = "/some/other/place/bead.json";
  const std::vector<EmittedFile> first = emit(here), second = emit(there);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].path, second[i].path);
    EXPECT_EQ(first[i].text, second[i].text);
  }
  EXPECT_EQ(emit_driver(here.model).text, emit_driver(there.model).text);
}

TEST(EmittedFiles, areFiveAndTheHeadersTheyInclude) {
  const auto paths = [](const EmitOptions& options) {
    std::vector<std::string> result;
    for (const EmittedFile& file : emit(bead_on_circle(), options)) result.push_back(file.path);
    std::sort(result.begin(), result.end());
    return result;
  };
  EXPECT_EQ(paths({.runtime_headers = false}),
            (std::vector<std::string>{"CMakeLists.txt", "bead.cpp", "bead.hpp", "bead.json", "bead_cost.txt"}));
  EXPECT_EQ(paths({}), (std::vector<std::string>{"CMakeLists.txt",
                                                 "bead.cpp",
                                                 "bead.hpp",
                                                 "bead.json",
                                                 "bead_cost.txt",
                                                 "mbgen/blocks.hpp",
                                                 "mbgen/charts.hpp",
                                                 "mbgen/driver.hpp",
                                                 "mbgen/elementary.hpp",
                                                 "mbgen/fma.hpp",
                                                 "mbgen/integrators.hpp",
                                                 "mbgen/lanes/array_lanes.hpp",
                                                 "mbgen/math/arc_tangent.hpp",
                                                 "mbgen/math/exponential.hpp",
                                                 "mbgen/math/logarithm.hpp",
                                                 "mbgen/math/precision.hpp",
                                                 "mbgen/math/sincos.hpp",
                                                 "mbgen/math/single_precision.hpp",
                                                 "mbgen/math/vector_instructions.hpp",
                                                 "mbgen/motion.hpp",
                                                 "mbgen/number.hpp",
                                                 "mbgen/scalar.hpp",
                                                 "mbgen/solver.hpp",
                                                 "mbgen/solver/ball.hpp",
                                                 "mbgen/solver/block_solution.hpp",
                                                 "mbgen/solver/care.hpp",
                                                 "mbgen/solver/closure.hpp",
                                                 "mbgen/solver/corrections.hpp",
                                                 "mbgen/solver/fine.hpp",
                                                 "mbgen/solver/loop.hpp",
                                                 "mbgen/solver/newton.hpp",
                                                 "mbgen/solver/passage.hpp",
                                                 "mbgen/solver/passage_nodes.hpp",
                                                 "mbgen/solver/passing.hpp",
                                                 "mbgen/solver/regular.hpp",
                                                 "mbgen/solver/shortest.hpp",
                                                 "mbgen/solver/sides.hpp",
                                                 "mbgen/solver/singular_step.hpp",
                                                 "mbgen/solver/states.hpp",
                                                 "mbgen/solver/step_clock.hpp",
                                                 "mbgen/status.hpp",
                                                 "mbgen/turns.hpp"}));
}

TEST(EmittedFiles, beginWithTheirBanner) {
  const std::string banner = "// bead, content hash 0123456789abcdef\n// Made by `mbgen generate bead.json`, mbgen " +
                             std::string(kMbgenVersion) + ". Change the model, not this file.\n";
  const std::vector<EmittedFile> files = emit(bead_on_circle());
  for (const char* path : {"bead.hpp", "bead.cpp"}) EXPECT_EQ(text_of(files, path).substr(0, banner.size()), banner);
}

TEST(EmittedFiles, advanceInputsThatHaveDerivatives) {
  const std::vector<EmittedFile> files = emit(pushed_slider());
  EXPECT_NE(text_of(files, "bead.cpp")
                .find("Inputs advance_inputs(const Inputs& inputs, double dt) noexcept {\n"
                      "  Inputs later;\n"
                      "  later.jerk = inputs.jerk;\n"
                      "  later.push = inputs.push + dt * (inputs.rate + dt / 2.0 * inputs.jerk);\n"
                      "  later.rate = inputs.rate + dt * inputs.jerk;\n"
                      "  return later;\n"
                      "}\n"),
            std::string::npos);
  EXPECT_NE(text_of(files, "bead.hpp").find("go on as advance_inputs says"), std::string::npos);
  const std::vector<EmittedFile> constant = emit(bead_on_circle());
  for (const char* path : {"bead.hpp", "bead.cpp"}) {
    EXPECT_EQ(text_of(constant, path).find("advance"), std::string::npos) << path;
  }
}

TEST(EmittedFiles, makeRatesOfInputsThatShareNone) {
  Example example = pushed_slider();
  const std::string interface = text_of(emit(example), "bead.hpp");
  EXPECT_NE(interface.find("    {3, {&Inputs::push, &Inputs::rate, &Inputs::jerk}}};"), std::string::npos);
  EXPECT_NE(interface.find("using InputPaths = mbgen::InputPaths<Inputs, kInputRows>;"), std::string::npos);
  EXPECT_NE(interface.find("#include \"mbgen/input_paths.hpp\""), std::string::npos);
  Input other;
  other.name = "other";
  other.derivative = 2;
  example.model.inputs.push_back(other);
  EXPECT_EQ(text_of(emit(example), "bead.hpp").find("InputPaths"), std::string::npos);
  EXPECT_EQ(text_of(emit(bead_on_circle()), "bead.hpp").find("InputPaths"), std::string::npos);
}

TEST(EmittedFiles, knowTheStartThatTheyAreGiven) {
  const std::vector<EmittedFile> files =
      emit(bead_on_circle(), {.lanes = 4, .initial = InitialState{{1, 0.5}, {2, -4}, {}}});
  EXPECT_NE(text_of(files, "bead.cpp")
                .find("State initial_state() noexcept {\n"
                      "  static constexpr State start = {\n"
                      "      {1.0, 0.5},\n"
                      "      {2.0, -4.0},\n"
                      "      {0.0},\n"
                      "      0.0};\n"),
            std::string::npos);
  for (const char* path : {"bead.hpp", "bead_batch.hpp"}) {
    EXPECT_NE(text_of(files, path).find("State initial_state() noexcept;"), std::string::npos) << path;
    EXPECT_NE(text_of(files, path).find("Start from `State state = initial_state();`."), std::string::npos) << path;
  }
  const std::vector<EmittedFile> without = emit(bead_on_circle(), {.lanes = 4});
  for (const char* path : {"bead.hpp", "bead.cpp", "bead_batch.hpp", "bead_batch.cpp"}) {
    EXPECT_EQ(text_of(without, path).find("initial_state"), std::string::npos) << path;
  }
}

TEST(EmittedFiles, manifestCountsTheOperationsOfEverySection) {
  const auto manifest = nlohmann::json::parse(text_of(emit(bead_on_circle()), "bead.json"));
  EXPECT_EQ(manifest["namespace"], "bead");
  EXPECT_EQ(manifest["sizes"]["coordinates"], 2);
  EXPECT_EQ(manifest["sizes"]["closure_equations"], 1);
  EXPECT_EQ(manifest["parameters"], (std::vector<std::string>{"mass", "area"}));
  EXPECT_EQ(manifest["loop_blocks"][0]["loops"][0], "circle");
  const auto& program = manifest["programs"]["accelerations"];
  EXPECT_EQ(program["sections"].size(), 3u);
  EXPECT_EQ(program["sections"][0]["title"], "step 1: poses and axes b");
  long total = 0;
  for (const auto& section : program["sections"]) total += section["total"].get<long>();
  EXPECT_EQ(program["operations"]["total"], total);
  EXPECT_GT(total, 10);
}

TEST(Version, isThatOfTheProject) {
  std::ifstream file(MBGEN_SOURCE_DIR "/CMakeLists.txt");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("project(mbgen VERSION " + std::string(kMbgenVersion) + " "), std::string::npos);
}

}  // namespace
}  // namespace mbgen::test
