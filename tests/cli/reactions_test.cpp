// evaluate --reactions: every engine gives the same forces and moments.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const char* const kEnginesWithReactions[] = {"generated", "generic", "augmented", "maggi"};

/// Largest difference of two numbers, or arrays or objects of numbers, of the same shape.
double largest_difference(const Json& one, const Json& other) {
  if (one.is_number()) return std::abs(one.get<double>() - other.get<double>());
  double largest = 0;
  EXPECT_EQ(one.size(), other.size());
  for (const auto& [key, value] : one.items()) {
    const Json& its = one.is_array() ? other.at(std::stoul(key)) : other.at(key);
    largest = std::max(largest, largest_difference(value, its));
  }
  return largest;
}

TEST_F(CommandLine, PendulumPullsAtItsPinAsInTheTextbook) {
  write("pendulum.json", kPendulum);
  write("states.json", R"({"states": [{"z": [0.3], "zd": [2.0]}, {"z": [null]}]})");
  const double pull = 3 * (2 * 2.0 * 2.0 + 9.81 * std::cos(0.3));  // across it falls freely
  const Json expected = {{"pin", {{"force", {pull * std::sin(0.3), 0, pull * std::cos(0.3)}}, {"moment", {0, 0, 0}}}}};
  for (const char* engine : kEnginesWithReactions) {
    const Json result =
        json_of(fmt::format("evaluate pendulum.json --states states.json --reactions --engine {}", engine));
    EXPECT_LT(largest_difference(expected, result["states"][0]["reactions"]), 1e-12) << engine;
    EXPECT_TRUE(result["states"][1]["reactions"].is_null());
  }
  EXPECT_FALSE(
      json_of("evaluate pendulum.json --states states.json --engine generic")["states"][0].contains("reactions"));
}

// A whole turn of the crank, through positions where the frozen partition is bad; every wrench of a plane linkage that
// lies in the plane is unique.
TEST_F(CommandLine, FourBarHasTheSameReactionsInEveryEngine) {
  write("four_bar.json", kFourBar);
  Json guesses, closed;
  for (int i = -30; i <= 30; ++i) guesses["states"].push_back({{"z", {0.1 * i, -0.1 * i, 0}}, {"zd", {2, 0, 0}}});
  write("guesses.json", guesses.dump());
  const Json projected = json_of("evaluate four_bar.json --states guesses.json --project --engine generic");
  for (const Json& state : projected["states"])
    if (state["status"] == "ok") closed["states"].push_back({{"z", state["z"]}, {"zd", state["zd"]}});
  ASSERT_GT(closed["states"].size(), 50u);
  write("closed.json", closed.dump());
  const auto evaluate = [&](const std::string& engine) {
    return json_of("evaluate four_bar.json --states closed.json --reactions --engine " + engine)["states"];
  };
  const Json expected = evaluate("generic");
  for (const std::string engine : {"generated", "augmented"}) {
    const Json states = evaluate(engine);
    for (std::size_t i = 0; i < states.size(); ++i) {
      ASSERT_EQ(states[i]["status"], "ok");
      double scale = 1;
      for (const Json& value : expected[i]["lambda"]) scale = std::max(scale, std::abs(value.get<double>()));
      EXPECT_LT(largest_difference(states[i]["lambda"], expected[i]["lambda"]), 1e-10 * scale) << engine << " " << i;
      EXPECT_LT(largest_difference(states[i]["reactions"], expected[i]["reactions"]), 1e-10 * scale)
          << engine << " " << i;
    }
  }
}

TEST_F(CommandLine, RodsAndJointsOfOneNameCannotBothStandInTheAnswer) {
  std::string text = kPendulum;
  text.insert(text.find("\"joint_forces\""), R"("rods": { "pin": { "from": "ground.O", "to": "bob.tip" } }, )");
  write("pendulum.json", text);
  write("states.json", R"({"states": [{"z": [0.3]}]})");
  const Outcome asked = mbgen("evaluate pendulum.json --states states.json --reactions --engine generic");
  EXPECT_EQ(asked.exit_code, 1);
  EXPECT_EQ(asked.err, "--reactions: \"pin\" is a joint and a rod; rename one of them\n");
}

TEST_F(CommandLine, DumpSaysWhatOutputsShow) {
  std::string text = kFourBar;
  text.insert(text.rfind('}'), R"(, "outputs": {
    "pull": { "reaction": "tip", "axis": "z" },
    "bend": { "reaction": "elbow", "quantity": "moment", "axis": "x", "frame": "body", "end": "from" },
    "lambda": { "multiplier": "tip", "equation": "axis_2" } })");
  write("four_bar.json", text);
  EXPECT_NE(mbgen("check four_bar.json --dump=model")
                .out.find("outputs\n"
                          "  pull [N]: force of joint tip on its to body, z, global axes\n"
                          "  bend [N m]: moment of joint elbow on its from body, x, body axes\n"
                          "  lambda [N m]: multiplier axis_2 of joint tip\n"),
            std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
