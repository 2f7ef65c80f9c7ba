// mbgen linearize and equilibrium as a user meets them.

#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A mass of 2 kg on a spring of 50 N/m and a damper of 4 N s/m, which it stretches by 2 * 10 / 50 m.
constexpr const char* kOscillator = R"({ "mbgen": 1, "name": "oscillator", "gravity": [0, 0, -10],
  "inputs": { "force": { "unit": "N", "default": 0 } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "mass": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "mass.A", "axis": "z" } },
  "joint_springs": { "spring": { "joint": "slide", "stiffness": 50, "damping": 4 } },
  "forces": { "push": { "at": "mass.A", "force": [0, 0, "force"] } },
  "outputs": { "height": { "unit": "m", "point": "mass.A", "quantity": "position", "axis": "z" } } })";

TEST_F(CommandLine, LinearizePrintsModes) {
  write("oscillator.json", kOscillator);
  const Outcome outcome = mbgen("linearize oscillator.json --at equilibrium");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::string modes =
      "        eigenvalue [1/s]           frequency [Hz]   damping   moves most\n"
      "   1       -1.0000 +-4.8990 i             0.7797      0.2000   slide +1.00\n";
  EXPECT_EQ(outcome.out.substr(outcome.out.find("        eigenvalue")), modes);
  EXPECT_TRUE(outcome.out.starts_with("oscillator: 2 states, 1 inputs, 1 outputs\n"));
}

// Where crank and coupler are in line the rocker, which is independent elsewhere, leads nothing: its rate is zero, the
// coupler turns about its pin on it 0.3/0.25 times as fast as the crank, backwards, and a spring on the crank moves
// crank and coupler alone.
TEST_F(CommandLine, LinearizeChoosesOtherStatesWhereTheUsualOnesAreSingular) {
  write("dead_point.json", R"json({ "mbgen": 1, "include": [")json" + kSource +
                               R"json(/tests/data/fmi/triple_rocker.json"],
    "joint_springs": { "spring": { "joint": "crank_pin", "stiffness": 50, "free": "pi/3 - acos(10/11)" } },
    "initial": { "positions": { "crank_pin": "pi/3 - acos(10/11)" }, "velocities": { "crank_pin": 0 } } })json");
  const double crank = 0.007 + 0.9 * 0.15 * 0.15, coupler = 0.004 + 0.7 * 0.125 * 0.125;
  const double expected = 50 / (crank + 1.2 * 1.2 * coupler);
  const Json linear = json_of("linearize dead_point.json --json");
  ASSERT_EQ(linear["states"].size(), 2u);
  EXPECT_NEAR(linear["A"][0][1], 1, 1e-12);
  EXPECT_NEAR(linear["A"][1][0], -expected, 1e-6 * expected);
}

// 1 / (50 + 4 s + 2 s^2) at half a hertz: at w = pi rad/s.
TEST_F(CommandLine, LinearizeGivesFrequencyResponses) {
  write("oscillator.json", kOscillator);
  const std::string asked = "linearize oscillator.json --at equilibrium --bode force:height --frequencies ";
  const Json response = json_of(asked + "0.5:2:3 --bode-out bode.csv --bode-out bode.svg --json")["responses"][0];
  EXPECT_EQ(response["unit"], "m/N");
  EXPECT_EQ(response["frequency"], Json({0.5, 1.0, 2.0}));
  const double w = std::numbers::pi, real = 50 - 2 * w * w, imaginary = 4 * w;
  const double square = real * real + imaginary * imaginary;
  EXPECT_NEAR(response["response"][0][0], real / square, 1e-14);
  EXPECT_NEAR(response["response"][0][1], -imaginary / square, 1e-14);
  const std::string table = read("bode.csv");
  EXPECT_TRUE(table.starts_with("frequency [Hz],height/force [m/N],height/force phase [deg]\n0.5,")) << table;
  EXPECT_TRUE(read("bode.svg").starts_with("<svg"));
  EXPECT_EQ(mbgen(asked + "2:1:3").err,
            "--frequencies: \"2:1:3\" is no range of frequencies in Hz\n  hint: FIRST:LAST:COUNT, for example "
            "0.1:20:200, up to 100000 of them\n");
  EXPECT_EQ(mbgen("linearize oscillator.json --bode forse:height").err,
            "--bode: oscillator has no input \"forse\"\n  hint: did you mean \"force\"?\n");
  EXPECT_EQ(mbgen("linearize oscillator.json --bode force").err, "--bode: \"force\" is no INPUT:OUTPUT\n");
  EXPECT_EQ(mbgen("linearize oscillator.json -o a.csv --bode force:height --bode-out ./a.csv").err,
            "./a.csv: --out and --bode-out must be two files\n");
  EXPECT_EQ(mbgen("linearize oscillator.json --bode force:height --bode-out b.csv --bode-out b.csv").err,
            "b.csv: --bode-out and --bode-out must be two files\n");
  EXPECT_EQ(mbgen("linearize oscillator.json --bode force:height --bode force:height").err,
            "--bode: \"force:height\" stands twice\n");
  EXPECT_EQ(mbgen("linearize oscillator.json --bode force:height --bode-out bode.png").err,
            "--bode-out: \"bode.png\" is no .csv and no .svg file\n");
}

TEST_F(CommandLine, LinearizeGivesMatricesByName) {
  write("oscillator.json", kOscillator);
  const Json linear = json_of("linearize oscillator.json --json");
  EXPECT_EQ(linear["states"], Json({"z.slide", "zd.slide"}));
  EXPECT_EQ(linear["A"], Json({{0.0, 1.0}, {-25.0, -2.0}}));
  EXPECT_EQ(linear["B"], Json({{0.0}, {0.5}}));
  EXPECT_EQ(linear["C"], Json({{1.0, 0.0}}));
  EXPECT_EQ(linear["D"], Json({{0.0}}));
  EXPECT_EQ(linear["drift"], Json({0.0, -10.0}));
  EXPECT_EQ(linear["modes"][0]["shape"]["slide"], Json({1.0, 0.0}));
}

TEST_F(CommandLine, LinearizeTakesAStateOfAFile) {
  write("oscillator.json", kOscillator);
  write("states.json", R"({"states": [{"z": [0]}, {"z": [0.1], "inputs": {"force": 45}}]})");
  const Json linear = json_of("linearize oscillator.json --states states.json --index 2 --json");
  EXPECT_EQ(linear["positions"], Json({{"slide", 0.1}}));
  EXPECT_NEAR(linear["drift"][1].get<double>(), (45 - 20 - 5) / 2.0, 1e-12);
  const Outcome beyond = mbgen("linearize oscillator.json --states states.json --index 3");
  EXPECT_EQ(beyond.exit_code, 1);
  EXPECT_EQ(beyond.err, "--index: states.json has states 1 to 2, found 3\n");
  write("empty.json", R"({"states": []})");
  EXPECT_EQ(mbgen("linearize oscillator.json --states empty.json").err, "empty.json: /states: has no states\n");
}

TEST_F(CommandLine, InputsStandBeforeTheModelToo) {
  write("oscillator.json", kOscillator);
  const Json found = json_of("equilibrium --input force=5 oscillator.json --json");
  EXPECT_NEAR(found["positions"]["slide"].get<double>(), (5 - 20) / 50.0, 1e-10);
  EXPECT_NEAR(json_of("linearize --input force=5 oscillator.json --json")["drift"][1].get<double>(), (5 - 20) / 2.0,
              1e-12);
}

TEST_F(CommandLine, EquilibriumIsAStartToInclude) {
  write("oscillator.json", kOscillator);
  const Json found = json_of("equilibrium oscillator.json --input force=5 --out start.json --json");
  EXPECT_NEAR(found["positions"]["slide"].get<double>(), (5 - 20) / 50.0, 1e-10);
  EXPECT_NEAR(found["outputs"]["height"].get<double>(), (5 - 20) / 50.0, 1e-10);
  EXPECT_LT(found["largest_acceleration"].get<double>(), 1e-8);
  std::string model = kOscillator;
  write("held.json", model.insert(model.find("\"name\""), "\"include\": [\"start.json\"], "));
  EXPECT_NEAR(json_of("linearize held.json --input force=5 --json")["drift"][1].get<double>(), 0, 1e-8);
}

TEST_F(CommandLine, EquilibriumOfWhatFallsIsRefused) {
  write("falling.json", R"({ "mbgen": 1, "gravity": [0, 0, -10], "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "mass": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "mass.A", "axis": "z" } } })");
  const Outcome outcome = mbgen("equilibrium falling.json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("falling.json: there is no static equilibrium near the initial state: "))
      << outcome.err;
}

TEST_F(CommandLine, LinearizeWritesAPageOfItsModes) {
  write("oscillator.json", kOscillator);
  const std::string text = mbgen("linearize oscillator.json --at equilibrium").out;
  const Outcome outcome = mbgen("linearize oscillator.json --at equilibrium --report modes.html");
  if (outcome.err.find("built without reports") != std::string::npos) GTEST_SKIP() << outcome.err;
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, text);
  const std::string page = read("modes.html");
  const std::size_t data = page.find('{', page.find("<script id=\"data\""));
  const Json shown = Json::parse(page.substr(data, page.find("</script>", data) - data));
  EXPECT_EQ(shown["point"]["state"], "static equilibrium");
  EXPECT_EQ(shown["animations"][0]["eigenvalue"],
            json_of("linearize oscillator.json --at equilibrium --json")["modes"][0]["eigenvalue"]);

  EXPECT_EQ(mbgen("linearize oscillator.json --report oscillator.json").exit_code, 1);
  write("fixed.json", R"({ "mbgen": 1, "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "mass": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "mass.A", "axis": "z" } },
    "motions": { "hold": { "joint": "slide", "position": 0 } } })");
  const Outcome fixed = mbgen("linearize fixed.json --report fixed.html");
  EXPECT_EQ(fixed.exit_code, 1);
  EXPECT_EQ(fixed.err, "--report: fixed.json has no modes, nothing is free\n");
}

// Their real parts are rounding, of either sign.
TEST_F(CommandLine, ModesWithoutDampingAreNotUnstable) {
  const Outcome outcome =
      mbgen(fmt::format("linearize {}/models/double_pendulum.json --at equilibrium", MBGEN_SOURCE_DIR));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("unstable"), std::string::npos) << outcome.out;
}

TEST_F(CommandLine, LinearizeKeepsTheModel) {
  write("oscillator.json", kOscillator);
  for (const char* command : {"linearize", "equilibrium"}) {
    EXPECT_EQ(mbgen(fmt::format("{} oscillator.json --out oscillator.json", command)).exit_code, 1) << command;
  }
  EXPECT_EQ(json_of("linearize oscillator.json --json")["model"], "oscillator");
}

}  // namespace
}  // namespace mbgen::cli_test
