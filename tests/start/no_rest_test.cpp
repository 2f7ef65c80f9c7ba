// Cars with one mistake each: the message of the equilibrium that they do not find names it, with its place.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class NoRest : public CommandLine {
 protected:
  /// The four-wheeler with some of its text replaced.
  void write_car(const std::vector<std::pair<std::string, std::string>>& changes) {
    std::ifstream file(kSource + "/tests/data/models/four_wheeler.json");
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (const auto& [from, to] : changes) {
      ASSERT_NE(text.find(from), std::string::npos) << from;
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    }
    write("car.json", text);
  }

  /// The hints of each command that looks for the equilibrium: the same of all.
  std::string hints() {
    std::string found;
    for (const char* command :
         {"equilibrium car.json", "check car.json", "simulate car.json --engine generic --out o.csv",
          "linearize car.json --at equilibrium"}) {
      const Outcome run = mbgen(command);
      EXPECT_EQ(run.exit_code, 1) << command << run.out;
      EXPECT_NE(run.err.find("car.json: there is no static equilibrium near the initial state"), std::string::npos)
          << run.err;
      const std::size_t message = std::min(run.err.size(), run.err.find("there is no static equilibrium"));
      const std::string these = run.err.substr(std::min(run.err.size(), run.err.find("\n  hint: ", message) + 1));
      if (!found.empty()) {
        EXPECT_EQ(these, found) << command;
      }
      found = these;
    }
    return found;
  }
};

TEST_F(NoRest, AForgottenMirror) {
  write_car({{"1.1, -0.75, 0.3]", "1.1, 0.75, 0.3]"}, {"-1.5, -0.75, 0.3]", "-1.5, 0.75, 0.3]"}});
  EXPECT_EQ(
      hints(),
      "  hint: tyre \"fl\" (car.json:46:5) and tyre \"fr\" (car.json:47:5) are at one place: is a \"mirror\" of an "
      "instance forgotten, or of another plane?\n"
      "  hint: tyre \"rl\" (car.json:48:5) and tyre \"rr\" (car.json:49:5) are at one place: is a \"mirror\" of an "
      "instance forgotten, or of another plane?\n");
}

TEST_F(NoRest, ARadiusInMillimetres) {
  write_car({{"\"UNLOADED_RADIUS\": 0.3", "\"UNLOADED_RADIUS\": 300"}});
  EXPECT_EQ(hints(),
            "  hint: radius of tyre \"fl\" (car.json:46:5) is 300 m: is it in millimetres? see LENGTH in [UNITS] of a "
            ".tir file (and 3 more like it)\n");
}

TEST_F(NoRest, AStiffnessPerMillimetre) {
  write_car({{"\"stiffness\": 2e5", "\"stiffness\": 200"}});
  EXPECT_EQ(hints(),
            "  hint: stiffness of tyre \"fl\" (car.json:46:5) is 200 N/m, too little for 2953 N, its share of the "
            "weight: is it in N/mm? (and 3 more like it)\n");
}

TEST_F(NoRest, SwappedAxes) {
  write_car({{"0.75, 0.3]", "0.3, 0.75]"}, {"-0.3, 0.75]", "0.3, -0.75]"}});
  EXPECT_EQ(
      hints(),
      "  hint: tyre \"fl\" (car.json:46:5) is 1.5 m above tyre \"fr\" (car.json:47:5): z is up, are axes swapped?\n");
  write_car({{"\"name\": \"four_wheeler\"", "\"gravity\": [0, -9.81, 0], \"name\": \"four_wheeler\""}});
  EXPECT_EQ(hints(), "  hint: gravity is [0, -9.81, 0] m/s^2, and roads are level along x and y: are axes swapped?\n");
}

TEST_F(NoRest, ABodyWithoutSupport) {
  write_car({{"\"ground\": {", "\"box\": { \"mass\": 50, \"inertia\": [1, 1, 1] },\n    \"ground\": {"},
             {"\"car\": { \"type\": \"free\"",
              "\"box\": { \"type\": \"prismatic\", \"from\": \"car.fl\", \"to\": \"box.fl\", \"axis\": \"z\" },\n"
              "    \"car\": { \"type\": \"free\""}});
  EXPECT_EQ(hints(),
            "  hint: nothing holds box of joint \"box\" (car.json:26:5): a spring, a tyre or a joint may be missing\n");
}

TEST_F(NoRest, ABrakeThatIsTooWeak) {
  write_car({{"\"name\": \"four_wheeler\"",
              "\"gravity\": [\"-sin(atan(0.1))*9.81\", 0, \"-cos(atan(0.1))*9.81\"], \"name\": \"four_wheeler\""},
             {"\"speed\": { \"value\": 15", "\"speed\": { \"value\": 0"},
             {"\"brake\": { \"unit\": \"N m\" }", "\"brake\": { \"unit\": \"N m\", \"default\": 100 }"}});
  EXPECT_NE(hints().find("holds 25 N m at most\n"), std::string::npos) << hints();
  ASSERT_EQ(mbgen("equilibrium car.json --input brake=2000").exit_code, 0);
}

TEST_F(NoRest, ASpringWithoutADirection) {
  write("car.json", R"({ "mbgen": 1, "name": "coin", "bodies": { "ground": { "points": { "a": [0, 0, 0] } },
    "m": { "mass": 1, "inertia": [1, 1, 1], "points": { "a": [0, 0, 0], "b": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.a", "to": "m.a", "axis": "z" } },
    "springs": { "s": { "from": "ground.a", "to": "m.b", "stiffness": 100, "free_length": 0.1 } },
    "initial": { "equilibrium": true } })");
  EXPECT_EQ(hints(), "  hint: the ends of spring \"s\" (car.json:4:18) coincide: it has no direction there\n");
  std::string text = read("car.json");
  write("car.json", text.replace(text.find("\"equilibrium\": true"), 19, ""));
  const Outcome run = mbgen("simulate car.json --engine generic --out o.csv");
  EXPECT_NE(run.err.find("  hint: the ends of spring \"s\" (car.json:4:18) coincide: it has no direction there\n"),
            std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace mbgen::cli_test
