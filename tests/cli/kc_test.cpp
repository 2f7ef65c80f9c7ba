// mbgen kc on the command line: several axles, variants, measured points, compliance.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// Two swing axles with springs of a parameter's stiffness.
constexpr const char* kTwoAxles = R"({ "mbgen": 1, "name": "two", "gravity": [0, 0, 0],
  "parameters": { "rate": { "value": 40000, "unit": "N/m" } },
  "bodies": {
    "ground": { "points": { "fp": [1, 0.1, 0.4], "fs": [1, 0.4, 0.9], "rp": [-1, 0.1, 0.4], "rs": [-1, 0.4, 0.9] } },
    "f": { "mass": 20, "com": [1, 0.5, 0.35], "inertia": [1, 1, 1],
      "points": { "p": [1, 0.1, 0.4], "s": [1, 0.4, 0.4], "hub": [1, 0.7, 0.4] } },
    "r": { "mass": 20, "com": [-1, 0.5, 0.35], "inertia": [1, 1, 1],
      "points": { "p": [-1, 0.1, 0.4], "s": [-1, 0.4, 0.4], "hub": [-1, 0.7, 0.4] } } },
  "joints": { "f": { "type": "revolute", "from": "ground.fp", "to": "f.p", "axis": "x" },
    "r": { "type": "revolute", "from": "ground.rp", "to": "r.p", "axis": "x" } },
  "springs": { "f": { "from": "ground.fs", "to": "f.s", "stiffness": "rate" },
    "r": { "from": "ground.rs", "to": "r.s", "stiffness": "2*rate" } },
  "axles": { "front": { "left": { "centre": "f.hub", "radius": 0.3 } },
    "rear": { "left": { "centre": "r.hub", "radius": 0.3 }, "end": "rear" } } })";

class Kc : public CommandLine {
 protected:
  Kc() { write("two.json", kTwoAxles); }
  Outcome kc(const std::string& words) const { return mbgen("kc two.json --points 3 --travel 0.02 " + words); }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
};

TEST_F(Kc, WithoutANameRunsAllAxles) {
  const Outcome run = kc("-o all");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.find("two: axle front\n"), 0u);
  EXPECT_NE(run.out.find("\n\ntwo: axle rear\n"), std::string::npos) << run.out;
  for (const char* name : {"all/front.html", "all/rear.html", "all/index.html", "all/rear_parallel_travel.csv"})
    EXPECT_TRUE(exists(name)) << name;
  // The arm's lever of 0.5: a quarter of the spring's stiffness, at the rear twice as much.
  const Json all = Json::parse(kc("--json").out);
  EXPECT_EQ(all["model"], "two");
  EXPECT_NEAR(all["axles"]["front"]["figures"]["wheel_rate"]["values"][0].get<double>(), 10000, 1e-5);
  EXPECT_NEAR(all["axles"]["rear"]["figures"]["wheel_rate"]["values"][0].get<double>(), 20000, 1e-5);
  // One axle is as before: nothing around it, and no overview.
  const Json one = Json::parse(kc("rear --json -o one").out);
  EXPECT_EQ(one["axle"], "rear");
  EXPECT_FALSE(exists("one/index.html"));
  EXPECT_EQ(kc("rear front").out.find("two: axle rear\n"), 0u) << "in the order of the names";
  EXPECT_EQ(kc("middle").err, "two.json: unknown axle \"middle\"; known: front, rear\n");
}

TEST_F(Kc, DrawsVariantsAndMeasuredPointsOfTheirAxle) {
  write("rear_parallel_travel.csv", "travel [mm],load_left [kN]\n-20,-0.4\n0,0.01\n20,0.4\n");
  const Outcome unit = kc("--measured rear_parallel_travel.csv");
  EXPECT_EQ(unit.err, "rear_parallel_travel.csv:1:1: load_left: its unit must be N, found kN\n");
  write("rear_parallel_travel.csv", "travel [mm],load_left [N]\n-20,-400\n0,10\n20,400\n");
  const Outcome run = kc("--measured rear_parallel_travel.csv --with 'rate=50e3' -o both");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::size_t rear = run.out.find("two: axle rear");
  const std::string of_front = run.out.substr(0, rear), of_rear = run.out.substr(rear);
  EXPECT_NE(of_front.find("rate=50e3: at the start, and the difference\n"), std::string::npos) << run.out;
  EXPECT_NE(of_front.find("  wheel_rate                                12.5           2.5 N/mm\n"), std::string::npos);
  EXPECT_EQ(of_front.find("rear_parallel_travel.csv"), std::string::npos);
  EXPECT_NE(of_rear.find("  parallel_travel load_left                   10            10      "), std::string::npos);
  EXPECT_NE(read("both/rear_parallel_travel.svg").find("load_left, rear_parallel_travel.csv"), std::string::npos);
  EXPECT_EQ(read("both/front_parallel_travel.svg").find("load_left, rear_parallel_travel.csv"), std::string::npos);
  // Another file of a model.
  std::string stiff = kTwoAxles;
  stiff.replace(stiff.find("40000"), 5, "80000");
  write("stiff.json", stiff);
  EXPECT_NE(
      kc("front --with stiff.json").out.find("  wheel_rate                                  20            10 N/mm\n"),
      std::string::npos);
}

TEST_F(Kc, SaysWhatItCannotCompare) {
  EXPECT_EQ(kc("front --with rat=1").err, "--with: the model has no parameter \"rat\"; did you mean \"rate\"?\n");
  write("points.csv", "travel,toe_lft\n0,0\n");
  EXPECT_EQ(
      kc("--measured points.csv -o none").err,
      "--measured: the name of points.csv begins with no axle\n  hint: name the axle after the model, or call the "
      "file like its table: front_CURVE.csv\n");
  const Outcome unknown = kc("front --measured parallel_travel=points.csv -o none");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_EQ(
      unknown.err.find("points.csv:1:1: parallel_travel of axle front has no column \"toe_lft\"; known: travel, "), 0u)
      << unknown.err;
  EXPECT_FALSE(exists("none")) << "nothing is written";
  write("bytes.csv", std::string("travel\x01"));
  EXPECT_EQ(kc("front --measured bytes.csv").err,
            "bytes.csv:1:7: must be text, found a byte 0x01\n  hint: measured points are a table of numbers\n");
  EXPECT_EQ(kc("front --steer nan").err, "--steer: must be a number above 0, got nan\n");
  EXPECT_EQ(kc("front --force -500").err, "--force: must be a number above 0, got -500\n");
  EXPECT_NE(kc("front --compliance contact").out.find("Compliance: loads at the contact centre, wheel centres free\n"),
            std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
