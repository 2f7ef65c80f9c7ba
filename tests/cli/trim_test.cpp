// Steady motions of a vehicle: against the single-track model, long simulations, steady circles and sines of steering.

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const std::string kTrimmedCar = kSource + "/tests/data/models/four_wheeler.json";

class Trims : public CommandLine {
 protected:
  Json trim(const std::string& arguments) const { return linear(arguments)["trim"]; }
  Json linear(const std::string& arguments) const {
    return json_of("linearize " + kTrimmedCar + " --speed " + arguments + " --json");
  }
  Table drive(const std::string& manoeuvre, const std::string& more) const {
    write("m.json", manoeuvre);
    const Outcome run =
        mbgen("simulate " + kTrimmedCar + " --engine generic --step 2e-3 --manoeuvre m.json --out m.csv " + more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return table("m.csv");
  }
};

// Source of the stiffness: H. B. Pacejka, "Tire and Vehicle Dynamics", 4.E25: K = PKY1 Fz0 sin(2 atan(Fz/(PKY2 Fz0))).
// The front wheels' drag D = M / r (rolling resistance M, as the loads) turns with them: delta (1 - D/C) = l/R + K a.
TEST_F(Trims, StraightOnHasTheUndersteerOfTheSingleTrackModel) {
  const double wheelbase = 2.6, mass = 1204.02, ahead = (2 * 0.01 * 1.1 + 2 * 1.1 - 2 * 1.5) / mass;
  const double front = 1.1 - ahead, rear = 1.5 + ahead;
  const auto stiffness = [](double load) { return 15 * 3000 * std::sin(2 * std::atan(load / (1.5 * 3000))); };
  for (const double speed : {10.0, 20.0, 35.0}) {
    const Json found = trim(fmt::format("{}", speed));
    const double c_front = 2 * stiffness(found["load_fl"]), c_rear = 2 * stiffness(found["load_rl"]);
    const double single_track = mass / wheelbase * (rear / c_front - front / c_rear);
    const double load = found["load_fl"].get<double>(), all = load + found["load_rl"].get<double>();
    const double drag = found["drive"].get<double>() * load / all / (0.3 - load / 2e5 / 3);
    const double steer =
        (wheelbase / (speed * speed) + single_track) / (1 - drag / c_front);  // over lateral acceleration
    EXPECT_NEAR(found["understeer_gradient"].get<double>(), steer - wheelbase / (speed * speed), 4e-3 * single_track);
    EXPECT_NEAR(found["yaw_rate_gain"].get<double>(), 1 / (speed * steer), 2e-3 / (speed * steer)) << speed;
    // Sideslip of the reference point, which is `ahead` behind the centre of mass: rear/R - m front/(l C_r) a.
    const double sideslip = (rear - ahead) / (speed * speed) - mass * front / (wheelbase * c_rear);
    EXPECT_NEAR(found["sideslip_gain"].get<double>(), sideslip / steer, 4e-3) << speed;
    EXPECT_LT(std::abs(found["steer"].get<double>()), 1e-9);
  }
}

TEST_F(Trims, ABendIsWhereALongSimulationEnds) {
  const Table motion = drive(R"({ "mbgen_manoeuvre": 1, "type": "events", "speed": 20, "duration": 30,
                                  "events": [ { "at": 0, "steer": 0.02, "over": 1 } ] })",
                             "--every 100");
  const double vx = motion.last("vehicle_vx [m/s]"), vy = motion.last("vehicle_vy [m/s]");
  const double speed = std::hypot(vx, vy), turn = motion.last("vehicle_yaw_rate [rad/s]");
  const double sideslip =
      std::remainder(std::atan2(vy, vx) - motion.last("vehicle_heading [rad]"), 2 * std::numbers::pi);
  const Json found = trim(fmt::format("{} --lateral-acceleration {}", speed, speed * turn));
  EXPECT_NEAR(found["steer"].get<double>(), 0.02, 1e-9);
  EXPECT_NEAR(found["sideslip"].get<double>(), sideslip, 1e-9);
  EXPECT_NEAR(found["roll"].get<double>(), motion.last("vehicle_roll [rad]"), 1e-9);
  for (const char* wheel : {"fl", "fr", "rl", "rr"})
    EXPECT_NEAR(found[fmt::format("load_{}", wheel)].get<double>(),
                motion.last(fmt::format("vehicle_load_{} [N]", wheel)), 1e-3);
}

TEST_F(Trims, GainsAreSlopesBetweenBends) {
  const double turn = 2.0 / 20, by = 1e-3;
  const Json here = trim("20 --lateral-acceleration 2"),
             more = trim(fmt::format("20 --lateral-acceleration {}", 2 + by)),
             less = trim(fmt::format("20 --lateral-acceleration {}", 2 - by));
  const auto slope = [&](const char* name) { return (more[name].get<double>() - less[name].get<double>()) / (2 * by); };
  EXPECT_NEAR(here["yaw_rate"].get<double>(), turn, 1e-12);
  EXPECT_NEAR(here["yaw_rate_gain"].get<double>(), 1 / (20 * slope("steer")), 1e-5);
  EXPECT_NEAR(here["sideslip_gain"].get<double>(), slope("sideslip") / slope("steer"), 1e-5);
  EXPECT_NEAR(here["roll_gradient"].get<double>(), slope("roll"), 1e-9);
  EXPECT_NEAR(here["understeer_gradient"].get<double>(), slope("steer") - 2.6 / 400, 1e-8);
}

TEST_F(Trims, ABendToTheRightIsTheMirrorImage) {
  const Json left = trim("20 --radius 150"), right = trim("20 --radius -150");
  EXPECT_NEAR(left["lateral_acceleration"].get<double>(), 400.0 / 150, 1e-9);
  for (const char* name : {"steer", "sideslip", "roll", "yaw_rate"})
    EXPECT_NEAR(left[name].get<double>(), -right[name].get<double>(), 1e-8) << name;
  EXPECT_NEAR(left["load_fl"].get<double>(), right["load_fr"].get<double>(), 1e-3);
}

// Headings of half a turn change from pi to -pi.
TEST_F(Trims, AVehicleThatHeadsBackwardsIsTheSame) {
  std::string text = read(kTrimmedCar);
  const auto put = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  put("\"velocities\": {", "\"positions\": { \"car_rz\": { \"deg\": 180 } }, \"velocities\": {");
  put("\"car_tx\": \"speed\"", "\"car_tx\": \"-speed\"");
  write("turned.json", text);
  for (const char* radius : {"150", "-150"}) {
    const std::string way = fmt::format("20 --radius {}", radius);
    const Json there = trim(way), back = json_of("linearize turned.json --speed " + way + " --json")["trim"];
    for (const char* name : {"steer", "sideslip", "roll", "yaw_rate", "understeer_gradient"})
      EXPECT_NEAR(there[name].get<double>(), back[name].get<double>(), 1e-7) << name;
  }
  write("learns.json", R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 15, "driver": { "learns": true } })");
  const auto learned = [&](const std::string& model) {
    const Outcome run = mbgen("simulate " + model + " --engine generic --step 2e-3 --duration 0.1 " +
                              "--manoeuvre learns.json --out l.csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err.find("steer_ratio"), std::string::npos) << run.err;
    return Json::parse(read("l.csv.run.json"))["manoeuvre"]["learned"]["understeer"].get<double>();
  };
  EXPECT_NEAR(learned("turned.json"), learned(kTrimmedCar), 1e-7);
}

// Uphill the rear wheels push m g sin(angle) at their rolling radius (docs/use/tyres.md: R0 less a third of the
// deflection); the tyres carry m g cos(angle).
TEST_F(Trims, AGradeAsksForTheForceOfGravity) {
  const double mass = 1204.02, gravity = 9.81, angle = std::atan(0.1);
  const Json level = trim("20"), up = trim("20 --grade 0.1"), down = trim("20 --grade -0.1");
  double loads = 0;
  for (const char* wheel : {"load_fl", "load_fr", "load_rl", "load_rr"}) loads += up[wheel].get<double>();
  EXPECT_NEAR(loads, mass * gravity * std::cos(angle), 1e-3);
  const double radius = 0.3 - up["load_rl"].get<double>() / 2e5 / 3, push = mass * gravity * std::sin(angle);
  const double more = up["drive"].get<double>() - level["drive"].get<double>();
  EXPECT_NEAR(more, push * radius, 2e-3 * push * radius);
  EXPECT_LT(down["drive"].get<double>(), 0);
  EXPECT_FALSE(up.contains("yaw_rate_gain")) << "bends on a grade are not steady";
}

// ISO 4138: the slope of a slow run at constant speed.
TEST_F(Trims, UndersteerIsThatOfTheSteadyCircle) {
  write("m.json", R"({ "mbgen_manoeuvre": 1, "type": "steady_circle", "method": "constant_speed", "speed": 20,
                       "steer": 0.02, "duration": 30 })");
  const Json run = json_of("simulate " + kTrimmedCar +
                           " --engine generic --step 2e-3 --manoeuvre m.json --every 100 --out m.csv --json");
  EXPECT_DOUBLE_EQ(run["inputs"]["steer"]["last"].get<double>(), 0.02);
  const auto metric = [&](const char* name) {
    for (const Json& one : run["metrics"])
      if (one["name"] == name) return one["value"].get<double>();
    return std::nan("");
  };
  // The slope of a fitted line is the mean of the slopes with weights a (a_most - a).
  const double most = metric("largest_lateral_acceleration"), driven = metric("understeer_gradient");
  const Json rows = json_of(fmt::format("linearize {} --speed 20 --lateral-acceleration {}:{}:3 --json", kTrimmedCar,
                                        most / 4, 3 * most / 4))["trims"];
  const double weights[] = {0.3, 0.4, 0.3};
  double mean = 0;
  for (std::size_t i = 0; i < 3; ++i) mean += weights[i] * rows[i]["understeer_gradient"].get<double>();
  EXPECT_NEAR(driven, mean, 0.01 * mean);
}

// A sine of 1 Hz about straight on: amplitude and phase of the nonlinear motion, by its Fourier coefficient.
TEST_F(Trims, AFrequencyResponseIsThatOfASineOfSteering) {
  const Table motion = drive(R"({ "mbgen_manoeuvre": 1, "type": "events", "speed": 20, "duration": 7,
                                  "events": [ { "at": 1, "steer": 0.004, "frequency": 1, "cycles": 7 } ] })",
                             "--every 5");
  const std::complex<double> i(0, 1);
  std::complex<double> sum = 0;
  int count = 0;
  for (std::size_t row = 0; row < motion.rows.size(); ++row) {
    const double t = motion.rows[row][0];
    if (t < 5 - 1e-6 || t > 7 - 1e-6) continue;
    sum += motion.at(row, "vehicle_yaw_rate [rad/s]") * std::exp(-i * (2 * std::numbers::pi * (t - 1)));
    ++count;
  }
  const std::complex<double> driven = i * sum * (2.0 / count) / 0.004;
  const Json response = linear("20 --bode steer:vehicle_yaw_rate --frequencies 1:2:2")["responses"][0]["response"][0];
  const std::complex<double> linear(response[0], response[1]);
  EXPECT_LT(std::abs(driven - linear), 0.01 * std::abs(linear)) << std::abs(driven) << " " << std::abs(linear);
  EXPECT_GT(std::abs(std::arg(linear)), 0.5) << "a frequency without dynamics";
}

TEST_F(Trims, ARangeEndsWhereTyresGiveNoMore) {
  const Outcome run =
      mbgen("linearize " + kTrimmedCar + " --speed 20 --lateral-acceleration 0:14:8 --handling-out t.csv");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("no steady motion at 20 m/s with a lateral acceleration of"), std::string::npos) << run.err;
  const Table found = table("t.csv");
  EXPECT_GE(found.rows.size(), 3u);
  EXPECT_LT(found.last("lateral_acceleration [m/s^2]"), 9.81) << "the tyres' friction is at most 1.1";
  const Outcome single = mbgen("linearize " + kTrimmedCar + " --speed 20 --lateral-acceleration 14");
  EXPECT_EQ(single.exit_code, 1);
  EXPECT_NE(
      single.err.find("four_wheeler.json: no steady motion at 20 m/s with a lateral acceleration of 14 m/s^2: the "
                      "search came to"),
      std::string::npos)
      << single.err;
}

TEST_F(Trims, OutputsMayBeHeld) {
  write("car.json", fmt::format(R"({{ "mbgen": 1, "name": "car", "include": ["{}"],
      "outputs": {{ "turn": {{ "joint": "car_rz", "quantity": "velocity" }} }} }})",
                                kTrimmedCar));
  const Json found =
      json_of("linearize car.json --at steady --hold car_tx=15 --hold out.turn=0.1 --solve steer --solve drive --json");
  EXPECT_NEAR(found["velocities"]["car_rz"].get<double>(), 0.1, 1e-7);
  const auto error = [&](const std::string& held) {
    const std::string text = mbgen("linearize car.json --at steady --solve steer --hold " + held).err;
    return text.substr(text.find("--hold"));
  };
  EXPECT_EQ(error("out.turm=0.1"), "--hold: the model has no output \"turm\"; did you mean \"turn\"?\n");
  EXPECT_EQ(error("out.turn"), "--hold: output \"turn\" needs a value: out.turn=VALUE\n");
}

// A damper with two slopes is at rest in steady motion: rounding chooses its side.
TEST_F(Trims, CornersOfLawsAtRestAreNoted) {
  const std::string words = "note: parts at rest are at corners of their force laws";
  for (const char* law : {"\"damping\": 800", R"json("force": "select(rate, 1200*rate, 500*rate)")json"}) {
    write("car.json", fmt::format(R"({{ "mbgen": 1, "name": "car", "include": ["{}"],
        "bodies": {{ "seat": {{ "mass": 60, "inertia": [1, 1, 1] }} }},
        "hardpoints": {{ "seat": [0, 0, 0.4], "floor": [0, 0, 0.02] }},
        "joints": {{ "seat": {{ "type": "prismatic", "from": "car.seat", "to": "seat.seat", "axis": "z" }} }},
        "springs": {{ "seat": {{ "from": "car.floor", "to": "seat.seat", "stiffness": 2e4, {} }} }} }})",
                                  kTrimmedCar, law));
    const bool has_corner = std::string(law).find("select") != std::string::npos;
    const Outcome run = mbgen("linearize car.json --speed 20 --lateral-acceleration 1");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err.find(words) != std::string::npos, has_corner) << run.err;
  }
}

TEST_F(Trims, ArgumentsThatExcludeEachOtherAreNamed) {
  const auto error = [&](const std::string& arguments) {
    return mbgen("linearize " + kTrimmedCar + " " + arguments).err;
  };
  EXPECT_EQ(error("--speed 20 --radius 100 --lateral-acceleration 2"),
            "--radius, --lateral-acceleration: a bend is asked by one of the two\n");
  EXPECT_EQ(error("--speed 0"), "--speed: 0 m/s; a steady motion needs a speed above 0\n");
  EXPECT_EQ(
      error("--speed 10:20"),
      "--speed: \"10:20\" is no number and no range\n  hint: FIRST:LAST:COUNT, for example 10:40:7, up to 1000 of "
      "them\n");
  EXPECT_EQ(error("--speed 20 --grade 0.1 --radius 100"),
            "--grade: a bend on a grade is not steady; leave out --radius and --lateral-acceleration\n");
  EXPECT_EQ(error("--radius 100"),
            "--lateral-acceleration, --radius, --grade, --handling-out: these belong to a steady motion of a vehicle, "
            "--speed\n");
  write("pendulum.json", kPendulum);
  EXPECT_NE(mbgen("linearize pendulum.json --speed 20").err.find("pendulum.json: the model has no vehicle\n"),
            std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
