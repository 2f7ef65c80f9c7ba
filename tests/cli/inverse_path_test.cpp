// `mbgen simulate --inverse --path`: forces of the actuators along a path.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class InversePath : public CommandLine {};

/// A path of the ankle's pitch and roll, from rest in both: half a second in 5 ms.
std::string path_of_ankle() {
  std::string text = "t [s],ankle_ry [rad],ankle_rx\n";
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.005 * i, share = 1 - std::cos(8 * t);
    text += fmt::format("{},{},{}\n", t, 0.1 * share, -0.06 * share * share);
  }
  return text;
}

TEST_F(InversePath, ForcesAlongAPathMoveTheModelAlongIt) {
  const std::string ankle = kSource + "/models/robots/parallel_ankle.json";
  write("path.csv", path_of_ankle());
  const Outcome run =
      mbgen("simulate '" + ankle + "' --inverse --path path.csv --step 1e-3 --engine generic --out forces.csv");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("ankle_b.power [W]"), std::string::npos) << run.out;
  const Table forces = table("forces.csv");
  ASSERT_EQ(forces.rows.size(), 501u);
  // A MAT file has the same numbers, bit for bit.
  ASSERT_EQ(mbgen("simulate '" + ankle + "' --inverse --path path.csv --step 1e-3 --engine generic --out forces.mat")
                .exit_code,
            0);
  const std::string mat = read("forces.mat");
  EXPECT_GE(mat.size(), 501 * forces.rows[0].size() * sizeof(double));
  for (const char* column : {"t [s]", "actuator.ankle_a.force [N m]", "actuator.ankle_b.power [W]"}) {
    const double number = forces.last(column);
    EXPECT_NE(mat.find(std::string(reinterpret_cast<const char*>(&number), sizeof number)), std::string::npos)
        << column;
  }
  std::string inputs = "t,ankle_a,ankle_b\n";
  for (std::size_t row = 0; row < forces.rows.size(); ++row) {
    const double force = forces.at(row, "actuator.ankle_a.force [N m]");
    inputs += fmt::format("{},{},{}\n", forces.at(row, "t [s]"), force, forces.at(row, "actuator.ankle_b.force [N m]"));
    EXPECT_NEAR(forces.at(row, "actuator.ankle_a.power [W]"), force * forces.at(row, "actuator.ankle_a.speed [rad/s]"),
                1e-12);
  }
  write("forces_in.csv", inputs);
  const Outcome forward = mbgen("simulate '" + ankle +
                                "' --engine generic --duration 0.5 --step 1e-3 --input-table forces_in.csv "
                                "--interpolation spline --out motion.csv");
  ASSERT_EQ(forward.exit_code, 0) << forward.err;
  const Table motion = table("motion.csv");
  // Curves between the rows of the path, and between those of the forces.
  EXPECT_NEAR(motion.last("pitch [rad]"), forces.last("ankle_ry [rad]"), 1e-5);
  EXPECT_NEAR(motion.last("roll [rad]"), forces.last("ankle_rx [rad]"), 1e-5);
}

/// A bristle, a state and a sampled value change along the path as they do in the motion by the forces found.
TEST_F(InversePath, StatesChangeAlongThePath) {
  const std::string arm = kSource + "/tests/data/models/actuated_arm.json";
  std::string path = "t,shoulder,elbow\n";
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.01 * i;
    path += fmt::format("{},{},{}\n", t, 0.5 * std::sin(2 * t), -0.1 * std::sin(4 * t));
  }
  write("path.csv", path);
  for (const std::string engine : {"generic", "generated"}) {
    const std::string options = "' --engine " + engine + " --step 1e-3 --out ";
    const Outcome run = mbgen("simulate '" + arm + options + "forces.csv --inverse --path path.csv");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Table forces = table("forces.csv");
    std::string inputs = "t,first,second\n";
    for (std::size_t row = 0; row < forces.rows.size(); ++row)
      inputs += fmt::format("{},{},{}\n", forces.at(row, "t [s]"), forces.at(row, "actuator.first.force [N m]"),
                            forces.at(row, "actuator.second.force [N m]"));
    write("in.csv", inputs);
    const Outcome forward =
        mbgen("simulate '" + arm + options + "motion.csv --duration 1 --input-table in.csv --interpolation spline");
    ASSERT_EQ(forward.exit_code, 0) << forward.err;
    const Table motion = table("motion.csv");
    // The spline of the forces rounds the jumps by which they answer the sampled value.
    for (const char* column : {"tip [m]", "bend [rad]"})
      for (const std::size_t row : {250u, 500u, 1000u})
        EXPECT_NEAR(motion.at(row, column), forces.at(row, column), 1.5e-3) << engine << " " << column << " " << row;
  }
}

/// Friction of an elastic law and of a contact, by their closed forms: both slide at their limit.
TEST_F(InversePath, ElasticFrictionSlidesAtItsLimit) {
  write("block.json", R"({ "mbgen": 1, "name": "block",
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "floor": [0, 0, -0.1] } },
                "b": { "mass": 2, "inertia": [0.1, 0.1, 0.1], "points": { "O": [0, 0, 0], "p": [0, 0, -0.05] } } },
    "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "b.O", "axis": "x" } },
    "contacts": { "c": { "from": "b.p", "radius": 0.0501, "to": "ground.floor", "axis": "z", "stiffness": 1e6,
                         "friction": 0.5 } },
    "frictions": { "seal": { "joint": "x", "law": "elasto_plastic", "coulomb": 3, "stiffness": 1e4, "damping": 1 } },
    "actuators": { "m": { "joint": "x" } },
    "motions": { "x": { "joint": "x", "position": "0.005*t", "actuated_by": ["m"] } } })");
  ASSERT_EQ(mbgen("simulate block.json --inverse --engine generic --duration 1 --out o.csv").exit_code, 0);
  EXPECT_NEAR(table("o.csv").last("actuator.m.force [N]"), 0.5 * 1e6 * 1e-4 + 3, 1e-3);
}

TEST_F(InversePath, RefusesPathsThatAreNone) {
  const auto refused = [&](const std::string& path, const std::string& options, const std::string& text) {
    write("path.csv", path);
    const Outcome run =
        mbgen("simulate '" + kSource + "/models/robots/parallel_ankle.json' --engine generic --out f.csv " + options);
    EXPECT_EQ(run.exit_code, 1) << text;
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(this->path("f.csv")));
  };
  const std::string rows = "\n0,0\n1,0.1\n2,0.2\n";
  refused("t,ankle_r" + rows, "--inverse --path path.csv", "the model has no coordinate \"ankle_r\"");
  refused("t,ankle_rx [m]" + rows, "--inverse --path path.csv", "column \"ankle_rx\" is in m, the coordinate in rad");
  refused("t,ankle_rx" + rows, "--inverse --path path.csv",
          "path.csv: the given accelerations leave others open at t = 0 s\n  hint: give those of");
  refused("t,ankle_rx\n0,0\n1,1\n", "--inverse --path path.csv", "a path has at least 3 rows, found 2");
  refused("t,ankle_ry,ankle_rx\n0,0,0\n1,0.8,0\n2,1.6,0\n", "--inverse --path path.csv",
          "path.csv: loop not closed: link_a, link_b at t = 1.52");
  refused("t,motor_a,motor_b\n0,0,0\n1,2,2\n2,4,4\n", "--inverse --path path.csv --step 1e-12", "take a longer step");
  refused("t [ms],motor_a,motor_b\n0,0,0\n1,0.1,0.1\n2,0.2,0.2\n", "--inverse --path path.csv",
          "column \"t\" is in ms");
  refused("t", "--inverse", "--path TABLE is required");
  refused("t", "--path path.csv", "--path is of --inverse");
  refused("t", "--inverse --path path.csv --tolerance 1e-3", "--tolerance is of a motion");
  refused("", "--inverse --path path.csv", "a path is a table");
}

// At 1.63 rad the foot turns back: its angles do not determine those of the motors, which move on.
TEST_F(InversePath, GoesOnWhereTheIndependentCoordinatesStandStill) {
  write("path.csv", "t,motor_a,motor_b\n0,1.5,1.5\n0.1,1.6,1.6\n0.2,1.7,1.7\n");
  std::vector<Table> found;
  for (const std::string engine : {"generic", "null-space"}) {
    const Outcome run =
        mbgen("simulate '" + kSource + "/models/robots/parallel_ankle.json' --inverse --path path.csv " +
              "--step 0.01 --engine " + engine + " --out forces.csv");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    found.push_back(table("forces.csv"));
  }
  for (std::size_t row = 0; row < found[0].rows.size(); ++row)
    EXPECT_NEAR(found[0].at(row, "actuator.ankle_a.force [N m]"), found[1].at(row, "actuator.ankle_a.force [N m]"),
                1e-12);
}

/// A crank whose slide is pushed, 1 rad before its dead centre.
constexpr const char* kPushedSlide = R"json({ "mbgen": 1, "name": "pushed", "gravity": [0, 0, 0],
  "bodies": { "ground": { "points": { "O": [0, 0, 0], "S": ["0.1*cos(1) + sqrt(0.16 - (0.1*sin(1))^2)", 0, 0] } },
    "crank": { "mass": 1, "com": [0, 0, 0], "inertia": [0.01, 0.01, 0.01],
               "points": { "O": [0, 0, 0], "A": ["0.1*cos(1)", 0, "-0.1*sin(1)"] } },
    "slide": { "mass": 2, "com": [0.44, 0, 0], "inertia": [0.01, 0.01, 0.01],
               "points": { "S": ["0.1*cos(1) + sqrt(0.16 - (0.1*sin(1))^2)", 0, 0] } } },
  "joints": { "crank": { "type": "revolute", "from": "ground.O", "to": "crank.O", "axis": "y" },
              "slide": { "type": "prismatic", "from": "ground.S", "to": "slide.S", "axis": "x" } },
  "rods": { "rod": { "from": "crank.A", "to": "slide.S" } },
  "actuators": { "motor": { "joint": "COORDINATE" } } })json";

std::string pushed_slide(const std::string& coordinate) {
  std::string text = kPushedSlide;
  return text.replace(text.find("COORDINATE"), 10, coordinate);
}

// No row of the table is near the dead centre. A motor on the crank passes it.
TEST_F(InversePath, ThroughADeadCentreIsRefusedBetweenItsRows) {
  write("path.csv", "t,crank\n0,0\n0.05,-1\n0.1,-2\n");
  write("short.csv", "t,crank\n0,0\n0.05,-0.4\n0.1,-0.8\n");
  const std::string options = " --step 0.04 --engine generic --out forces.csv";
  write("pushed.json", pushed_slide("slide"));
  EXPECT_EQ(mbgen("simulate pushed.json --inverse --path short.csv" + options).exit_code, 0);
  const Outcome run = mbgen("simulate pushed.json --inverse --path path.csv" + options);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("actuators pass a singular position between the row before and the one at t = 0.0666"),
            std::string::npos)
      << run.err;
  write("turned.json", pushed_slide("crank"));
  const Outcome turned = mbgen("simulate turned.json --inverse --path path.csv" + options);
  EXPECT_EQ(turned.exit_code, 0) << turned.err;
}

}  // namespace
}  // namespace mbgen::cli_test
