// The cost sheet: what the manifest bounds, what --measure adds, and a budget kept or exceeded.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A row of `worst_case.calls`.
const Json& call_of(const Json& manifest, const std::string& function, const std::string& title) {
  for (const Json& call : manifest["worst_case"]["calls"]) {
    if (call["function"] == function && call["case"] == title) return call;
  }
  static const Json none;
  ADD_FAILURE() << "no " << function << ", " << title;
  return none;
}

TEST_F(CommandLine, ManifestBoundsLoopsAndCalls) {
  write("four_bar.json", kFourBar);
  ASSERT_EQ(mbgen("generate four_bar.json --out made --no-runtime").exit_code, 0);
  const Json manifest = Json::parse(read("made/four_bar.json"));
  const auto total = [&](const char* program) {
    return manifest["programs"][program]["operations"]["total"].get<long>();
  };
  const long closures = manifest["worst_case"]["newton_iterations"].get<long>() + 1;
  const Json step = call_of(manifest, "step_rk4", "regular");
  EXPECT_EQ(step["accelerations"], 4);
  EXPECT_EQ(step["closures"], closures);
  EXPECT_EQ(step["factorisations"], 0);
  EXPECT_EQ(step["operations"], 4 * total("accelerations") + closures * total("closure"));
  const Json projection = call_of(manifest, "assemble", "worst");
  EXPECT_EQ(projection["factorisations"], closures);
  EXPECT_EQ(projection["operations"], closures * (total("closure") + total("closure_terms")));
  const Json worst = call_of(manifest, "step_rk4", "worst");
  EXPECT_EQ(worst["closures"], manifest["worst_case"]["step_closures"]);
  EXPECT_EQ(worst["accelerations"], 2 * step["accelerations"].get<long>());
  EXPECT_GT(worst["operations"], step["operations"]);
  EXPECT_EQ(manifest["worst_case"]["factorisation"][0]["pivots"], 2);
  // The text has the same numbers.
  const std::string text = read("made/four_bar_cost.txt");
  EXPECT_NE(text.find(fmt::format("{:>15}\n", worst["operations"].get<long>())), std::string::npos) << text;
}

/// Every fallback of a step together costs at most four regular steps more.
TEST_F(CommandLine, TheWorstStepCostsAtMostFiveRegularOnes) {
  for (const char* model : {"coach", "truck", "four_bar", "slider_crank", "delta", "andrews_squeezer"}) {
    ASSERT_EQ(mbgen(fmt::format("generate {}/models/{}.json --out made --no-runtime", kSource, model)).exit_code, 0);
    const Json manifest = Json::parse(read(fmt::format("made/{}.json", model)));
    const double regular = call_of(manifest, "step_rk4", "regular")["operations"].get<double>();
    EXPECT_LE(call_of(manifest, "step_rk4", "worst")["operations"].get<double>(), 5 * regular) << model;
  }
}

TEST_F(CommandLine, WithoutClosuresNothingIsTakenAgain) {
  write("pendulum.json", kPendulum);
  ASSERT_EQ(mbgen("generate pendulum.json --out made --no-runtime").exit_code, 0);
  const Json manifest = Json::parse(read("made/pendulum.json"));
  EXPECT_FALSE(manifest["worst_case"].contains("newton_iterations"));
  for (const Json& call : manifest["worst_case"]["calls"]) {
    EXPECT_EQ(call["closures"], 0);
    EXPECT_NE(call["case"], "worst");
  }
}

TEST_F(CommandLine, MeasureWritesTwoFilesMoreAndChangesNoOther) {
  write("four_bar.json", kFourBar);
  ASSERT_EQ(mbgen("generate four_bar.json --out plain").exit_code, 0);
  const Json report = json_of("generate four_bar.json --out measured --measure --budget-us 1e9 --json");
  std::size_t plain = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path("plain"))) {
    if (!entry.is_regular_file()) continue;
    const std::string name = std::filesystem::relative(entry.path(), path("plain")).string();
    EXPECT_EQ(read("plain/" + name), read("measured/" + name)) << name;
    ++plain;
  }
  EXPECT_EQ(report["files"].size(), plain + 2);
  const Json measured = Json::parse(read("measured/four_bar_measured.json"));
  EXPECT_EQ(measured, report["measured"]);
  EXPECT_GT(measured["bytes"]["code"], 1000);
  EXPECT_GT(measured["bytes"]["read_only"], 0);
  EXPECT_EQ(measured["bytes"]["writable"], 0);
  const Json& step = measured["step"];
  EXPECT_GE(step["slowest_us"], step["median_us"]);
  EXPECT_GT(step["median_us"], 0);
  ASSERT_EQ(step["sections"].size(), 10);
  EXPECT_GT(measured["budget"]["margin_us"], 0);
  EXPECT_NE(read("measured/four_bar_measured.txt").find("under the budget"), std::string::npos);
}

TEST_F(CommandLine, StackIsThatOfTheDeepestPath) {
  write("four_bar.json", kFourBar);
  set("CXX", "g++");
  const Json measured = json_of("generate four_bar.json --c-api --out made --measure --json")["measured"];
  EXPECT_EQ(measured["stack"]["count"], "deepest call path");
  std::map<std::string, long> bytes;
  for (const Json& use : measured["stack"]["functions"]) {
    EXPECT_EQ(use["path"][0], use["function"]);
    bytes[use["function"]] = use["bytes"];
  }
  // A caller needs at least what it calls needs.
  ASSERT_TRUE(bytes.count("four_bar_step") && bytes.count("four_bar::step_rk4"));
  EXPECT_GT(bytes["four_bar_step"], bytes["four_bar::step_rk4"]);
  EXPECT_GT(bytes["four_bar::step_rk4"], bytes["four_bar::describe"]);
}

TEST_F(CommandLine, StackIsTheSumOfFramesWithoutACallGraph) {
  if (std::system("clang++ --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "clang++ is not installed";
  write("four_bar.json", kFourBar);
  set("CXX", "clang++");
  const Json stack = json_of("generate four_bar.json --out made --measure --json")["measured"]["stack"];
  EXPECT_EQ(stack["count"], "sum of all frames");
  ASSERT_EQ(stack["functions"].size(), 1);
  EXPECT_GT(stack["functions"][0]["bytes"], 1000);
}

TEST_F(CommandLine, BudgetFailsWhenItIsExceededAndSaysWhatLeads) {
  write("four_bar.json", kFourBar);
  const Outcome over = mbgen("generate four_bar.json --out made --measure --budget-us 0.000001");
  EXPECT_EQ(over.exit_code, 1);
  EXPECT_EQ(over.out, "");
  EXPECT_NE(over.err.find("over the budget of 1e-06 us"), std::string::npos) << over.err;
  const Json measured = Json::parse(read("made/four_bar_measured.json"));
  EXPECT_LT(measured["budget"]["margin_us"], 0);
  EXPECT_NE(over.err.find(measured["step"]["leading_section"].get<std::string>()), std::string::npos) << over.err;
  double largest = 0, leading = 0;
  for (const Json& section : measured["step"]["sections"]) {
    largest = std::max(largest, section["microseconds"].get<double>());
    if (section["title"] == measured["step"]["leading_section"]) leading = section["microseconds"];
  }
  EXPECT_EQ(leading, largest);

  const Outcome under = mbgen("generate four_bar.json --out made --measure --budget-us 1e9");
  EXPECT_EQ(under.exit_code, 0) << under.err;
  EXPECT_NE(under.out.find("under the budget of 1000000000 us"), std::string::npos) << under.out;
}

TEST_F(CommandLine, BudgetIsAPositiveNumberBesideMeasure) {
  write("four_bar.json", kFourBar);
  for (const char* options : {"--budget-us 10", "--measure --budget-us 0", "--measure --budget-us -1",
                              "--measure --budget-us nan", "--measure --budget-us inf", "--measure --budget-us ten"}) {
    const Outcome run = mbgen(fmt::format("generate four_bar.json --out made {}", options));
    EXPECT_EQ(run.exit_code, 1) << options;
    EXPECT_NE(run.err.find("--budget-us"), std::string::npos) << run.err;
  }
  EXPECT_EQ(leftovers(), (std::vector<std::string>{"four_bar.json"}));
}

TEST_F(CommandLine, MeasureWithoutACompilerWritesNothing) {
  write("four_bar.json", kFourBar);
  set("CXX", "/nowhere/c++");
  const Outcome run = mbgen("generate four_bar.json --out made --measure");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("no C++ compiler"), std::string::npos) << run.err;
  EXPECT_EQ(leftovers(), (std::vector<std::string>{"four_bar.json"}));
}

}  // namespace
}  // namespace mbgen::cli_test
