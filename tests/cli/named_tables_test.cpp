// Tables and maps in expressions, by every engine: the motion is that of the formula that they are points of.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class NamedTables : public CommandLine {
 protected:
  /// A sled with a state, a driven follower and a regulator.
  static std::string sled(const std::string& tables, const std::string& push, const std::string& heat,
                          const std::string& lift, const std::string& held) {
    return R"({ "mbgen": 1, "name": "sled", )" + tables + R"(
  "bodies": {
    "ground": { "points": { "A": [0, 0, 0], "B": [0, 1, 0] } },
    "sled": { "mass": 2, "inertia": [0, 0, 0], "points": { "A": [0, 0, 0] } },
    "follower": { "mass": 1, "inertia": [0, 0, 0], "points": { "B": [0, 1, 0] } } },
  "joints": {
    "slide": { "type": "prismatic", "from": "ground.A", "to": "sled.A", "axis": "x" },
    "lift": { "type": "prismatic", "from": "ground.B", "to": "follower.B", "axis": "z" } },
  "states": { "heat": { "derivative": ")" +
           heat + R"(" } },
  "sampled": { "held": { "value": ")" +
           held +
           R"(", "period": 0.01 } },
  "joint_forces": { "push": { "joint": "slide", "force": ")" +
           push + R"( + held" } },
  "motions": { "lifted": { "joint": "lift", "position": ")" +
           lift + R"(" } },
  "outputs": { "heat": { "expression": "heat", "unit": "J" }, "x": { "joint": "slide" }, "a": { "joint": "lift", "quantity": "acceleration" } },
  "initial": { "positions": { "slide": 0.3 }, "velocities": { "slide": 1 } } })";
  }

  Table motion(const std::string& words) {
    const Outcome run = mbgen("simulate " + words + " --duration 1 --every 20 --out o.csv");
    EXPECT_EQ(run.exit_code, 0) << words << run.err;
    return table("o.csv");
  }
};

// Bilinear functions are drawn by linear maps, inside the grid and beyond it.
TEST_F(NamedTables, MoveAsTheFormulasOfTheirPointsInEveryEngine) {
  // force(x, v) = -8 x - 0.7 v + 0.5 x v, lift(t, s) = 0.1 + 0.2 t - 0.3 s + 0.4 t s with s = 2 t
  write("map.csv", "x\\v,-1,0.2,0.4\n# comment\n-0.5,4.2,3.81,3.62\n0,0.7,-0.14,-0.28\n0.25,-1.425,-2.115,-2.23\n");
  const std::string tables = R"(
  "tables": { "flow": { "table": [[-1, -3], [0.5, 1.5]] } },
  "maps": { "push": { "csv": "map.csv" },
            "lift": { "x": [0, 0.5], "y": [0, 1], "z": [[0.1, -0.2], [0.2, 0.1]] } },)";
  write("closed.json", sled("", "-8*z.slide - 0.7*zd.slide + 0.5*z.slide*zd.slide", "3*zd.slide - heat",
                            "0.1 + 0.2*t - 0.3*(2*t) + 0.4*t*(2*t)", "3*z.slide"));
  write("tabled.json", sled(tables, "table('push', z.slide, zd.slide)", "table('flow', zd.slide) - heat",
                            "table('lift', t, 2*t)", "table('flow', z.slide)"));
  const Table expected = motion("closed.json --step 1e-3 --engine generic");
  for (const char* engine : {"generated", "generic", "augmented", "maggi"})
    expect_same_motion(motion(fmt::format("tabled.json --step 1e-3 --engine {}", engine)), expected, 1e-11);
  for (const char* engine : kEngines) {
    const auto of = [&](const char* model) {
      return motion(fmt::format("{} --step 1e-3 --integrator rosenbrock --engine {}", model, engine));
    };
    expect_same_motion(of("tabled.json"), of("closed.json"), 1e-11);
  }
}

// Smooth maps, held tables and a periodic one: engines of their own agree, steps converge with order four.
TEST_F(NamedTables, OfEveryKindAreThoseOfTheJudges) {
  const std::string model = std::string(MBGEN_SOURCE_DIR) + "/tests/data/models/mapped.json";
  const Table expected = motion(model + " --step 1e-3 --engine generic");
  for (const char* engine : {"generated", "augmented", "maggi"})
    expect_same_motion(motion(fmt::format("{} --step 1e-3 --engine {}", model, engine)), expected, 1e-7);
}

// The sled leaves -1 to 0.5 of the table: told once for its argument, and not where the model says how it goes on.
TEST_F(NamedTables, AreToldWhereTheyAreReadBeyondTheirPoints) {
  for (const char* outside : {"", R"(, "outside": "straight")", R"(, "outside": "hold")"}) {
    write("left.json", sled(fmt::format(R"("tables": {{ "flow": {{ "table": [[-1, -3], [0.5, 1.5]]{} }} }},)", outside),
                            "2*table('flow', z.slide) - table('flow', z.slide)", "0", "0", "0"));
    const Outcome run = mbgen("simulate left.json --engine generic --step 1e-3 --duration 0.5 --out o.csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::string told = "table \"flow\" is read beyond its points, x = ";
    const std::size_t at = run.err.find(told);
    EXPECT_EQ(at != std::string::npos, outside[0] == 0) << outside << run.err;
    if (at == std::string::npos) continue;
    EXPECT_NE(run.err.find(" at t = 0.5 s, where they reach from -1 to 0.5: it goes on straight"), std::string::npos)
        << run.err;
    EXPECT_EQ(run.err.find(told, at + 1), std::string::npos) << run.err;
  }
}

TEST_F(NamedTables, AreNotedWhereTheyMoveACoordinateWithKinks) {
  for (const char* interpolation : {"linear", "monotone_cubic"}) {
    write("kinks.json", sled(fmt::format(R"("tables": {{ "lift": {{ "table": [[0, 0], [1, 1], [2, 0]],
      "interpolation": "{}" }} }},)",
                                         interpolation),
                             "0", "0", "table('lift', t)", "0"));
    const Outcome run = mbgen("check kinks.json");
    const bool is_noted = (run.out + run.err).find("a linear table has kinks") != std::string::npos;
    EXPECT_EQ(is_noted, interpolation == std::string("linear")) << run.out << run.err;
  }
}

TEST_F(NamedTables, OfPartsBelongToThePart) {
  write("part.json", R"json({ "mbgen": 1, "tables": { "law": { "table": [[0, 0], [1, 2]] } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
              "sled": { "mass": 1, "inertia": [0, 0, 0], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "sled.A", "axis": "x" } },
  "joint_forces": { "push": { "joint": "slide", "force": "table('law', t) + table('common', t)" } } })json");
  write("two.json", R"({ "mbgen": 1, "tables": { "common": { "table": [[0, 1], [1, 4]] } },
  "instances": { "a": { "file": "part.json", "prefix": "a_" }, "b": { "file": "part.json", "prefix": "b_" } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } } },
  "outputs": { "x": { "joint": "b_slide" } } })");
  // x'' = 2 t + 1 + 3 t: x(1) = 5/6 + 1/2.
  const Table moved = motion("two.json --step 1e-3 --engine generic");
  EXPECT_NEAR(moved.last("x [m]"), 5.0 / 6 + 0.5, 1e-12);
}

}  // namespace
}  // namespace mbgen::cli_test
