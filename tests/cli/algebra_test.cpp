// --linear-algebra and --factorisation of the generic engine.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const char* const kStates = R"({"states": [
  {"z": [0.3, -0.1, 0.1], "zd": [1, 0, 0], "tau": [0.5, 0, 0]},
  {"z": [-0.4, 0.2, 0], "zd": [-2, 1, 0], "tau": [0, 0.3, -0.2]}]})";

TEST_F(CommandLine, EveryLinearAlgebraGivesTheSameAccelerations) {
  write("four_bar.json", kFourBar);
  write("states.json", kStates);
  const Json projected = json_of("evaluate four_bar.json --states states.json --engine generic --project");
  Json closed;
  for (const Json& state : projected["states"])
    closed["states"].push_back({{"z", state["z"]}, {"zd", state["zd"]}, {"tau", {0.5, 0, 0}}});
  write("closed.json", closed.dump());
  const Json expected = json_of("evaluate four_bar.json --states closed.json --engine generic");
  for (const char* choice :
       {"--linear-algebra entries", "--linear-algebra eigen", "--linear-algebra blas", "--linear-algebra sparse",
        "--factorisation lu", "--factorisation qr", "--linear-algebra sparse --factorisation lu"}) {
    const Json result = json_of(fmt::format("evaluate four_bar.json --states closed.json --engine generic {}", choice));
    for (std::size_t s = 0; s < 2; ++s) {
      ASSERT_EQ(result["states"][s]["status"], "ok") << choice;
      for (std::size_t i = 0; i < 3; ++i) {
        const double zdd = expected["states"][s]["zdd"][i];
        EXPECT_NEAR(result["states"][s]["zdd"][i].get<double>(), zdd, 1e-12 * std::abs(zdd)) << choice;
      }
    }
  }
}

TEST_F(CommandLine, SimulatesWithEveryLinearAlgebra) {
  write("four_bar.json", kFourBar);
  // Each projects along its own dependent coordinates: the motions differ by the integrator's error, h^4.
  const std::string common = "simulate four_bar.json --duration 0.5 --step 2.5e-4 --engine generic --out table.csv ";
  std::vector<double> angles;
  for (const char* choice :
       {"", "--linear-algebra eigen", "--linear-algebra blas", "--linear-algebra sparse", "--factorisation qr"}) {
    ASSERT_EQ(mbgen(common + choice).exit_code, 0) << choice;
    angles.push_back(table("table.csv").last("z.crank_pin [rad]"));
    EXPECT_NEAR(angles.back(), angles.front(), 1e-10) << choice;
  }
}

TEST_F(CommandLine, RefusesAlgebraThatThereIsNot) {
  write("four_bar.json", kFourBar);
  write("states.json", kStates);
  const auto refusal = [&](const std::string& arguments) {
    const Outcome run = mbgen("evaluate four_bar.json --states states.json " + arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    return run.err;
  };
  EXPECT_EQ(refusal("--engine generic --linear-algebra mkl"),
            "--linear-algebra: no linear algebra \"mkl\"; there are: eigen, blas, sparse, entries\n");
  EXPECT_EQ(refusal("--engine generic --factorisation svd"),
            "--factorisation: no factorisation \"svd\"; there are: lu, qr\n");
  EXPECT_EQ(refusal("--engine generic --linear-algebra blas --factorisation qr"),
            "--factorisation: qr goes with --linear-algebra eigen only, found blas\n");
  EXPECT_EQ(refusal("--linear-algebra blas"),
            "--linear-algebra: engine \"generated\" has no such option; engines that have it: generic\n");
  EXPECT_EQ(refusal("--engine augmented --factorisation qr"),
            "--factorisation: engine \"augmented\" has no such option; engines that have it: generic\n");
}

TEST_F(CommandLine, HelpNamesTheLinearAlgebras) {
  for (const char* command : {"evaluate", "simulate"}) {
    const std::string help = mbgen(fmt::format("{} --help", command)).out;
    for (const char* word : {"--linear-algebra", "entries", "eigen", "blas", "sparse", "--factorisation", "lu", "qr"})
      EXPECT_NE(help.find(word), std::string::npos) << command << " " << word;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
