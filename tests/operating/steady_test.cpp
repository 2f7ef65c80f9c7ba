// Steady motions and rows of results as points of linearize.

#include <complex>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A single-track vehicle in the plane: side forces linear in the slip angles, drag of the square of the speed.
constexpr const char* kSingleTrack = R"json({ "mbgen": 1, "name": "single_track", "gravity": [0, 0, 0],
  "inputs": { "steer": { "unit": "rad" }, "drive": { "unit": "N" } },
  "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
    "car": { "mass": 1500, "inertia": [500, 2500, 2500],
             "points": { "C": [0, 0, 0], "F": [1.2, 0, 0], "R": [-1.5, 0, 0] } } },
  "joints": { "car": { "type": "planar", "from": "ground.O", "to": "car.C", "axis": "z" } },
  "forces": {
    "front": { "at": "car.F", "axes": "body", "force": [0, "80000*(steer - (cos(z.car_rz)*zd.car_ty - sin(z.car_rz)*zd.car_tx + 1.2*zd.car_rz)/(cos(z.car_rz)*zd.car_tx + sin(z.car_rz)*zd.car_ty))", 0] },
    "rear": { "at": "car.R", "axes": "body", "force": [0, "-90000*(cos(z.car_rz)*zd.car_ty - sin(z.car_rz)*zd.car_tx - 1.5*zd.car_rz)/(cos(z.car_rz)*zd.car_tx + sin(z.car_rz)*zd.car_ty)", 0] },
    "along": { "at": "car.C", "axes": "body", "force": ["drive - 0.4*(cos(z.car_rz)*zd.car_tx + sin(z.car_rz)*zd.car_ty)^2", 0, 0] } },
  "initial": { "velocities": { "car_tx": 25 } } })json";
constexpr double kMass = 1500, kInertia = 2500, kFront = 1.2, kRear = 1.5, kStiffFront = 80000, kStiffRear = 90000;
constexpr double kDrag = 0.4, kWheelbase = kFront + kRear;
constexpr double kUndersteer =
    kMass * (kRear * kStiffRear - kFront * kStiffFront) / (kStiffFront * kStiffRear * kWheelbase);

using Complex = std::complex<double>;

/// The eigenvalues of what is not neutral, of conjugate pairs one.
std::vector<Complex> eigenvalues(const Json& linear) {
  std::vector<Complex> values;
  for (const Json& mode : linear["modes"]) {
    if (!mode["neutral"].get<bool>()) values.emplace_back(mode["eigenvalue"][0], mode["eigenvalue"][1]);
  }
  return values;
}

/// |det(J - lambda)| of the equations of vx, vy and yaw rate in axes of the vehicle, over the size of its terms.
double equation_of_motion(const Json& linear, Complex lambda) {
  const double v = linear["velocities"]["car_tx"], u = linear["velocities"]["car_ty"],
               r = linear["velocities"]["car_rz"];
  const double slip_front = (u + kFront * r) / v, slip_rear = (u - kRear * r) / v;
  const double fx = kStiffFront * slip_front / v, rx = kStiffRear * slip_rear / v;  // d force / d vx
  const double moment = -kFront * kStiffFront + kRear * kStiffRear;
  const Complex j[3][3] = {
      {-2 * kDrag * v / kMass - lambda, r, u},
      {(fx + rx) / kMass - r, -(kStiffFront + kStiffRear) / (kMass * v) - lambda, moment / (kMass * v) - v},
      {(kFront * fx - kRear * rx) / kInertia, moment / (kInertia * v),
       -(kFront * kFront * kStiffFront + kRear * kRear * kStiffRear) / (kInertia * v) - lambda}};
  const Complex determinant = j[0][0] * (j[1][1] * j[2][2] - j[1][2] * j[2][1]) -
                              j[0][1] * (j[1][0] * j[2][2] - j[1][2] * j[2][0]) +
                              j[0][2] * (j[1][0] * j[2][1] - j[1][1] * j[2][0]);
  return std::abs(determinant);
}

// Source: M. Mitschke, H. Wallentowitz, "Dynamik der Kraftfahrzeuge": the linear single-track model.
TEST_F(CommandLine, SteadyDrivingHasTheModesOfTheSingleTrackModel) {
  write("car.json", kSingleTrack);
  for (const double v : {20.0, 40.0}) {
    const Json linear = json_of(fmt::format("linearize car.json --at steady --hold car_tx={} --solve drive --json", v));
    EXPECT_NEAR(linear["velocities"]["car_tx"].get<double>(), v, 1e-9);
    EXPECT_NEAR(linear["input_values"]["drive"].get<double>(), kDrag * v * v, 1e-4);
    EXPECT_EQ(linear["rigid_body"], Json({"car_tx", "car_ty", "car_rz"}));
    const double trace = -(kStiffFront + kStiffRear) / (kMass * v) -
                         (kFront * kFront * kStiffFront + kRear * kRear * kStiffRear) / (kInertia * v);
    const double determinant = kStiffFront * kStiffRear * (kWheelbase * kWheelbase + kWheelbase * kUndersteer * v * v) /
                               (kMass * kInertia * v * v);
    const Complex root = std::sqrt(Complex(trace * trace / 4 - determinant));
    const std::vector<Complex> found = eigenvalues(linear);
    ASSERT_EQ(found.size(), 2u) << v;
    EXPECT_LT(std::abs(found[0] - (trace / 2 + (root.imag() < 0 ? -root : root))), 1e-6) << v;
    EXPECT_LT(std::abs(found[1] - Complex(-2 * kDrag * v / kMass)), 1e-8) << v;
  }
}

TEST_F(CommandLine, SteadyCorneringHasTheUndersteerGradient) {
  write("car.json", kSingleTrack);
  for (const double turn : {0.05, 0.2}) {
    const double v = 30;
    const Json linear = json_of(fmt::format(
        "linearize car.json --at steady --hold car_tx={} --hold car_rz={} --solve drive --solve steer --json", v,
        turn));
    const double steer = turn * (kWheelbase + kUndersteer * v * v) / v;
    const double side = linear["velocities"]["car_ty"];
    EXPECT_NEAR(linear["input_values"]["steer"].get<double>(), steer, 1e-9);
    EXPECT_NEAR(linear["input_values"]["drive"].get<double>(), kDrag * v * v - kMass * turn * side, 1e-4);
    const std::vector<Complex> found = eigenvalues(linear);
    ASSERT_EQ(found.size(), 2u) << "of vx, vy and yaw rate, two of them a pair";
    for (const Complex lambda : found) EXPECT_LT(equation_of_motion(linear, lambda), 1e-7) << lambda.real();
    EXPECT_GT(equation_of_motion(linear, found[0] + 0.01), 1e-4) << "an equation that all would satisfy";
  }
}

TEST_F(CommandLine, SteadyMotionSaysWhatIsMissing) {
  write("car.json", kSingleTrack);
  const Outcome slows = mbgen("linearize car.json --at steady --hold car_tx=20");
  EXPECT_EQ(slows.exit_code, 1);
  EXPECT_TRUE(
      slows.err.starts_with("car.json: no steady motion found: car_tx goes on to accelerate at 0.107 m/s^2\n"
                            "  hint: the rate of car_tx needs a drive: --solve NAME finds an input"))
      << slows.err;
  EXPECT_EQ(mbgen("linearize car.json --at steady").exit_code, 1) << "it would come to rest";
  EXPECT_EQ(mbgen("linearize car.json --at steady --solve drif").err,
            "--solve: the model has no input \"drif\"; known: steer, drive\n");
  EXPECT_EQ(mbgen("linearize car.json --at steady --hold car_t=1").err,
            "--hold: \"car_t\" is no independent coordinate of the model; mbgen inspect lists them\n");
  EXPECT_EQ(mbgen("linearize car.json --solve drive").err, "--hold, --solve: these belong to --at steady\n");
  const Outcome done = mbgen("linearize car.json --at steady --solve drive");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.out.find("rigid body (3 eigenvalues): car_tx, car_ty, car_rz\n"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find(fmt::format("  {:<32}{:>16} N\n", "drive", 250)), std::string::npos) << done.out;
}

// At one position a spring's force is balanced; elsewhere it is another one.
TEST_F(CommandLine, MotionsThatAreSteadyForAnInstantAreTold) {
  write("slide.json", R"({ "mbgen": 1, "name": "slide", "gravity": [0, 0, 0], "inputs": { "F": { "unit": "N" } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "m": { "mass": 2, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "m.O", "axis": "x" } },
    "joint_springs": { "k": { "joint": "x", "stiffness": 50, "damping": 3 } },
    "joint_forces": { "F": { "joint": "x", "force": "F" } },
    "initial": { "positions": { "x": 0.1 }, "velocities": { "x": 1 } } })");
  const Outcome driven = mbgen("linearize slide.json --at steady --hold x=1 --solve F");
  EXPECT_EQ(driven.exit_code, 0);
  EXPECT_TRUE(
      driven.err.starts_with("slide.json: note: the motion is steady at this position alone: the acceleration "
                             "of x changes by 25 m/s^2 a second, so that no coordinate goes on at its rate\n"))
      << driven.err;
  EXPECT_EQ(mbgen("linearize slide.json --at steady --hold x=3").err,
            "slide.json: no steady motion found: x goes on to accelerate at 7 m/s^2\n"
            "  hint: the rate of x needs a drive: --solve NAME finds an input that drives or steers\n");
}

// The slider in its slot and a bob on it: rotations and translations each have their scale and sign.
TEST_F(CommandLine, ShapesHaveSignsAndTwoScales) {
  write("crane.json", R"({ "mbgen": 1, "name": "crane", "gravity": [0, 0, -10],
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
      "trolley": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } },
      "bob": { "mass": 1, "com": [0, 0, -0.5], "inertia": [0, 0, 0], "points": { "A": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "trolley.A", "axis": "x" },
                "pin": { "type": "revolute", "from": "trolley.A", "to": "bob.A", "axis": "y" } } })");
  const Outcome crane = mbgen("linearize crane.json --at equilibrium");
  EXPECT_EQ(crane.exit_code, 0) << crane.err;
  // w^2 = 3/2 g/l; the trolley goes against the bob by a third of its 0.5 m, and axis y turns a hanging bob to -x.
  EXPECT_NE(crane.out.find("5.4772 i             0.8717      0.0000   pin +1.00; 0.17 m/rad: slide +1.00\n"),
            std::string::npos)
      << crane.out;
  EXPECT_NE(crane.out.find(": slide\n"), std::string::npos) << crane.out;
}

TEST_F(CommandLine, LinearizeTakesARowOfAResult) {
  write("pendulum.json", kPendulum);
  ASSERT_EQ(mbgen("simulate pendulum.json --engine generic --duration 1 --step 1e-2 --out swing.csv").exit_code, 0);
  const Table swing = table("swing.csv");
  const Json linear = json_of("linearize pendulum.json --result swing.csv --time 0.4 --json");
  EXPECT_EQ(linear["positions"]["pin"].get<double>(), swing.at(40, "z.pin [rad]"));
  EXPECT_EQ(linear["velocities"]["pin"].get<double>(), swing.at(40, "zd.pin [rad/s]"));
  EXPECT_NEAR(linear["A"][1][0].get<double>(), -9.81 / 2 * std::cos(swing.at(40, "z.pin [rad]")), 1e-9);
  EXPECT_EQ(json_of("linearize pendulum.json --result swing.csv --row 41 --json")["positions"], linear["positions"]);
  EXPECT_EQ(mbgen("linearize pendulum.json --result swing.csv --row 500").err,
            "--row: swing.csv has rows 1 to 101, found 500\n");
  const Outcome beyond = mbgen("linearize pendulum.json --result swing.csv --time 3");
  EXPECT_EQ(beyond.err, "--time: swing.csv has times from 0 to 1 s, the nearest to 3 s is 1 s\n");
}

}  // namespace
}  // namespace mbgen::cli_test
