// Contacts against closed forms, through the command line. Source of the figures: the project's reference data
// contacts_driveline.json: closed forms of Hertz, of Hunt and Crossley, of Coulomb and Housner, by 30 digits.

#include <array>
#include <cmath>
#include <tuple>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Contacts : public CommandLine {
 protected:
  Table run(const std::string& model, const std::string& more, const std::string& engine = "generic") const {
    const Outcome done = mbgen("simulate " + model + " --engine " + engine + " --out m.csv " + more);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return table("m.csv");
  }
};

/// A mass that meets a wall at the reference at the speed v.
std::string sled(double mass, double v, const std::string& law) {
  return fmt::format(R"({{ "mbgen": 1, "name": "sled", "gravity": [0, 0, 0],
    "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0], "wall": [1, 0, 0] }} }},
      "mass": {{ "mass": {}, "inertia": [1, 1, 1], "points": {{ "O": [0, 0, 0], "nose": [0.9, 0, 0] }} }} }},
    "joints": {{ "slide": {{ "type": "prismatic", "from": "ground.O", "to": "mass.O", "axis": "x" }} }},
    "contacts": {{ "c": {{ "from": "mass.nose", "radius": 0.1, "to": "ground.wall", "axis": "-x", {} }} }},
    "initial": {{ "velocities": {{ "slide": {} }} }},
    "outputs": {{ "p": {{ "contact": "c", "quantity": "deflection" }},
      "f": {{ "contact": "c", "quantity": "load" }} }} }})",
                     mass, law, v);
}

/// Largest penetration, duration and rebound of one impact; the largest value by a parabola through three rows.
struct Impact {
  double deepest = 0, duration = 0, rebound = 0;
};

Impact impact_in(const Table& motion) {
  Impact impact;
  const auto p = [&](std::size_t row) { return motion.at(row, "p [m]"); };
  std::size_t top = 1;
  while (p(top + 1) > p(top)) ++top;
  const double rise = p(top + 1) - p(top - 1);
  impact.deepest = p(top) + rise * rise / (8 * (2 * p(top) - p(top - 1) - p(top + 1)));
  std::size_t after = top;
  while (p(after) > 0) {
    EXPECT_GE(motion.at(after, "f [N]"), 0);
    ++after;
  }
  const double share = p(after - 1) / (p(after - 1) - p(after));
  impact.duration = motion.rows[after - 1][0] + share * (motion.rows[after][0] - motion.rows[after - 1][0]);
  impact.rebound = -motion.last("zd.slide [m/s]");
  return impact;
}

/// Steps that divide the time of an impact by 500 and by 1000, and some more to see its end.
std::string steps_of(double duration, int number) {
  return fmt::format("--step {:.17g} --duration {:.17g}", duration / number, 1.1 * duration);
}

// k x^n without loss: 1/2 m v^2 = k d^(n+1)/(n+1), duration 2 d/v sqrt(pi) Gamma(1+1/(n+1))/Gamma(1/2+1/(n+1)).
TEST_F(Contacts, PowerLawHasItsDepthAndDuration) {
  const double cases[][6] = {{1, 1e5, 2, 1, 0.004472135954999579, 0.01404962946208145},
                             {1.5, 1e8, 0.5, 0.3, 0.0001995487495696479, 0.001957756275571232},
                             {1.5, 1e9, 1, 2, 0.0004781762498950185, 0.0007037021450247283},
                             {2, 1e7, 3, 0.5, 0.004827446923028149, 0.02707583875951398}};
  for (const auto& [n, k, m, v, depth, duration] : cases) {
    write("sled.json", sled(m, v, fmt::format(R"("stiffness": {}, "exponent": {})", k, n)));
    std::array<double, 2> error{};
    for (const int finer : {0, 1}) {
      const Impact impact = impact_in(run("sled.json", steps_of(duration, finer == 0 ? 500 : 1000)));
      const auto at = static_cast<std::size_t>(finer);
      error[at] = std::max({std::abs(impact.deepest / depth - 1), std::abs(impact.duration / duration - 1),
                            std::abs(impact.rebound / v - 1)});
    }
    EXPECT_LT(error[1], 1e-6) << n;
    EXPECT_LT(error[1], std::max(0.6 * error[0], 1e-9)) << n;
  }
}

// A linear damper beside a linear spring is no contact of ours, but a force by an expression: it jumps at the touch,
// and ends where it would pull. Closed forms of the damped oscillator.
TEST_F(Contacts, LinearForceWithoutPullReboundsAsTheOscillatorSays) {
  const double cases[][4] = {{50, 0.00410846694792167, 0.01357058931592263, 0.8439750331082401},
                             {200, 0.00328457434505726, 0.01234516274244257, 0.5394214314104164},
                             {600, 0.002100434750176416, 0.01007629052774101, 0.2205913069874332}};
  for (const auto& [c, depth, duration, rebound] : cases) {
    std::string text = sled(2, 1, R"("stiffness": 0)");
    text.pop_back();
    write("sled.json", text + fmt::format(R"x(, "joint_forces": {{ "stop": {{ "joint": "slide",
      "force": "-max(0, 1e5*z.slide + {}*zd.slide)" }} }} }})x",
                                          c));
    const Table motion = run("sled.json", steps_of(duration, 400));
    std::size_t top = 1;
    while (motion.at(top + 1, "z.slide [m]") > motion.at(top, "z.slide [m]")) ++top;
    EXPECT_NEAR(motion.at(top, "z.slide [m]"), depth, 2e-5 * depth) << c;
    EXPECT_NEAR(-motion.last("zd.slide [m/s]"), rebound, 1e-6) << c;
  }
}

// The law of Hunt and Crossley: u - ln(1 + u) is equal at b v and at -b v_out, for any n, k and m.
TEST_F(Contacts, DampingTakesTheEnergyOfHuntAndCrossley) {
  const double cases[][7] = {{1, 1e5, 2, 1, 0.2, 0.004204574081407696, 0.8821899862473064},
                             {1.5, 1e8, 0.5, 0.3, 1, 0.0001857822286696241, 0.2498609376796805},
                             {1.5, 1e7, 5, 1.5, 0.1, 0.004393908745388865, 1.363523612023803},
                             {2, 1e7, 3, 0.5, 2, 0.004102395672566415, 0.29681213002002}};
  const double durations[] = {0.014070335, 0.00200000859, 0.0090462735, 0.030278235};
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    const auto& [n, k, m, v, b, depth, rebound] = cases[i];
    const std::string law = fmt::format(R"("stiffness": {}, "exponent": {}, "damping": {})", k, n, b);
    write("sled.json", sled(m, v, law));
    for (const char* engine : {"generic", "augmented"}) {
      const Impact impact = impact_in(run("sled.json", steps_of(durations[i], 500), engine));
      EXPECT_NEAR(impact.deepest / depth, 1, 1e-6) << n << engine;
      EXPECT_NEAR(impact.duration / durations[i], 1, 1e-6) << n << engine;
      EXPECT_NEAR(impact.rebound / rebound, 1, 1e-6) << n << engine;
    }
  }
  const double restitution[][2] = {{0.01, 0.9933774543987673}, {0.05, 0.9677385785309325}, {0.1, 0.937475579949905},
                                   {0.2, 0.8821899862473064},  {0.5, 0.7484349315974342},  {1, 0.5936242600400401},
                                   {2, 0.4107196860610394}};
  for (const auto& [b_v, ratio] : restitution) {
    write("sled.json", sled(2, b_v / 0.4, R"("stiffness": 1e6, "exponent": 1.5, "damping": 0.4)"));
    const Impact impact = impact_in(run("sled.json", "--step 2e-5 --duration 0.04"));
    EXPECT_NEAR(impact.rebound / (b_v / 0.4), ratio, 1e-6 * ratio) << b_v;
  }
}

// Six bounces of a ball from 0.5 m, by DOP853 with events at 1e-13: touch, speed in, leave, speed out.
TEST_F(Contacts, BallBouncesSixTimes) {
  write("ball.json", R"({ "mbgen": 1, "name": "ball",
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "C": [0, 0, 0.6] } },
      "ball": { "mass": 1, "com": [0, 0, 0.6], "inertia": [0.004, 0.004, 0.004], "points": { "C": [0, 0, 0.6] } } },
    "joints": { "ball": { "type": "free", "from": "ground.C", "to": "ball.C" } },
    "contacts": { "c": { "from": "ball.C", "radius": 0.1, "to": "ground.O",
      "stiffness": 1e6, "exponent": 1.5, "damping": 0.2 } },
    "outputs": { "p": { "contact": "c", "quantity": "deflection" }, "v": { "contact": "c", "quantity": "rate" } } })");
  const double bounces[][4] = {{0.31927542841, 3.1320919527, 0.33002731586, 2.1789380095},
                               {0.77425524848, 2.1789380095, 0.78567099178, 1.6669575521},
                               {1.1255196263, 1.6669575521, 1.1374988194, 1.3463236011},
                               {1.4119786565, 1.3463236011, 1.4244525492, 1.1262820544},
                               {1.6540717245, 1.1262820544, 1.6669911203, 0.96573465322},
                               {1.8638789191, 0.96573465322, 1.8772072226, 0.84332045262}};
  const auto error_of = [&](const std::string& steps) {
    const Table motion = run("ball.json", "--duration 1.9 " + steps);
    double error = 0;
    std::size_t met = 0;
    for (std::size_t row = 1; row < motion.rows.size() && met < 12; ++row) {
      const bool touches = motion.at(row, "p [m]") > 0;
      if (touches == (motion.at(row - 1, "p [m]") > 0)) continue;
      // The flight beside the contact is known: from the row before its begin, or back from the row behind its end.
      const std::size_t flight = touches ? row - 1 : row;
      const double p = motion.at(flight, "p [m]"), v = motion.at(flight, "v [m/s]");
      double time = 0;
      for (int k = 0; k < 20; ++k) time -= (p + time * (v + 9.81 / 2 * time)) / (v + 9.81 * time);
      const auto& bounce = bounces[met / 2];
      const std::size_t side = touches ? 0 : 2;
      error = std::max({error, std::abs((motion.rows[flight][0] + time) / bounce[side] - 1),
                        std::abs(std::abs(v + 9.81 * time) / bounce[side + 1] - 1)});
      ++met;
    }
    EXPECT_EQ(met, 12u);
    return error;
  };
  EXPECT_LT(error_of("--integrator cvode --tolerance 1e-10 --step 1e-3"), 1e-6);
  const double coarse = error_of("--step 1e-4 --every 10"), fine = error_of("--step 2.5e-5 --every 40");
  EXPECT_LT(fine, 1e-5);
  EXPECT_LT(fine, coarse / 4);
}

/// A body of revolution, pushed without spin over a plane of friction 0.3 with a bristle of so many metres.
std::string roller(double c, double bristle) {
  constexpr double kSunk = 9.81 / 1e8;
  return fmt::format(R"({{ "mbgen": 1, "name": "roller",
    "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0], "C": [0, 0, {0:.17g}] }} }},
      "ball": {{ "mass": 1, "com": [0, 0, {0:.17g}], "inertia": [{1}, {1}, {1}], "points": {{ "C": [0, 0, {0:.17g}] }} }} }},
    "joints": {{ "ball": {{ "type": "free", "from": "ground.C", "to": "ball.C" }} }},
    "contacts": {{ "c": {{ "from": "ball.C", "radius": 0.1, "to": "ground.O", "stiffness": 1e8, "damping": 10,
      "friction": 0.3, "bristle": {2}, "lag": {3} }} }},
    "initial": {{ "velocities": {{ "ball_tx": 4, "ball_ty": 3 }} }},
    "outputs": {{ "slip": {{ "contact": "c", "quantity": "velocity" }},
      "fx": {{ "contact": "c", "quantity": "force", "axis": "x" }} }} }})",
                     0.1 - kSunk, 0.01 * c, bristle, 10 * bristle);
}

// Coulomb: a sphere, shell, disc and hoop at 5 m/s slide until they roll at 5/(1 + c) m/s. The sinking of the ball by
// 0.1 um and the bristle of 5 um leave the remaining differences.
TEST_F(Contacts, SlidingBodiesComeToRoll) {
  const double cases[][4] = {{0.4, 0.48541332945002674, 3.5714285714285716, 2.080342840500114},
                             {0.6666666666666666, 0.6795786612300373, 3.0, 2.718314644920149},
                             {0.5, 0.5663155510250312, 3.3333333333333335, 2.3596481292709632},
                             {1, 0.8494733265375467, 2.5, 3.1855249745158005}};
  for (const auto& [c, time, speed, way] : cases) {
    write("roller.json", roller(c, 5e-6));
    const Table motion =
        run("roller.json", fmt::format("--step 2e-5 --every 50 --duration {:.3f}", std::ceil(1.5 * time * 1e3) / 1e3));
    const auto speed_at = [&](std::size_t row) {
      return std::hypot(motion.at(row, "zd.ball_tx [m/s]"), motion.at(row, "zd.ball_ty [m/s]"));
    };
    EXPECT_NEAR(speed_at(motion.rows.size() - 1) / speed, 1, 1e-6) << c;
    EXPECT_NEAR(motion.last("zd.ball_ty [m/s]") / motion.last("zd.ball_tx [m/s]"), 0.75, 1e-9) << c;
    EXPECT_LT(motion.last("slip [m/s]"), 1e-6) << c;
    const std::size_t early = 100, late = 200;
    EXPECT_NEAR(motion.at(late, "fx [N]"), -0.8 * 0.3 * 9.81, 1e-8) << c;
    const double deceleration = (speed_at(early) - speed_at(late)) / (motion.rows[late][0] - motion.rows[early][0]);
    EXPECT_NEAR(deceleration, 0.3 * 9.81, 1e-9) << c;
    EXPECT_NEAR(motion.rows[late][0] + (speed_at(late) - speed) / deceleration, time, 2e-5 * time) << c;
    const double gone = std::hypot(motion.last("z.ball_tx [m]"), motion.last("z.ball_ty [m]"));
    EXPECT_NEAR((gone - speed * (motion.rows.back()[0] - time)) / way, 1, 1e-5) << c;
  }
}

/// A box with spheres at its corners, thrown over a floor and against a post.
std::string thrown(const std::string& law) {
  std::string points, contacts;
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](int bit) { return (corner >> bit & 1) != 0 ? 1 : -1; };
    points += fmt::format(R"(, "c{}": [{}, {}, {}])", corner, 0.08 * side(0), 0.13 * side(1), 0.6 + 0.18 * side(2));
    contacts += fmt::format(
        R"("f{0}": {{ "from": "box.c{0}", "radius": 0.02, "to": "ground.O", {1} }},
      "p{0}": {{ "from": "box.c{0}", "radius": 0.02, "shape": "cylinder", "to": "ground.post", "to_radius": 0.1,
        "length": 0.8, {1} }}{2})",
        corner, law, corner < 7 ? "," : "");
  }
  return R"({ "mbgen": 1, "name": "thrown",
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "C": [0, 0, 0.6], "post": [0.8, 0, 0.4] } },
      "box": { "mass": 2, "com": [0, 0, 0.6], "inertia": [0.035, 0.027, 0.017], "points": { "C": [0, 0, 0.6])" +
         points + R"( } } },
    "joints": { "box": { "type": "free", "from": "ground.C", "to": "box.C" } },
    "contacts": { )" +
         contacts + R"( },
    "initial": { "velocities": { "box_tx": 2, "box_ty": 0.1, "box_rx": 3, "box_ry": 5, "box_rz": 2 } },
    "outputs": { "kinetic": { "bodies": "all", "quantity": "kinetic_energy" },
      "gravity": { "bodies": "all", "quantity": "potential_energy" },
      "stored": { "elements": "all", "quantity": "potential_energy" } } })";
}

// A body that tumbles, slides and comes to rest gains no energy but what its bristles give back, at most the friction
// times half of their way; without friction and damping it keeps all of it.
TEST_F(Contacts, EnergyNeverGrows) {
  const auto energy = [](const Table& motion, std::size_t row) {
    return motion.at(row, "kinetic [J]") + motion.at(row, "gravity [J]") + motion.at(row, "stored [J]");
  };
  write("smooth.json", thrown(R"("stiffness": 2e6, "exponent": 1.5)"));
  const Table smooth = run("smooth.json", "--step 1e-4 --every 10 --duration 0.6");
  for (std::size_t row = 0; row < smooth.rows.size(); ++row)
    EXPECT_NEAR(energy(smooth, row), energy(smooth, 0), 1e-4 * energy(smooth, 0)) << smooth.rows[row][0];
  write("rough.json", thrown(R"("stiffness": 2e6, "exponent": 1.5, "damping": 0.2, "friction": 0.6, "bristle": 5e-5)"));
  const Table rough = run("rough.json", "--step 1e-4 --every 20 --duration 2.5");
  double least = energy(rough, 0);
  for (std::size_t row = 0; row < rough.rows.size(); ++row) {
    EXPECT_LT(energy(rough, row), least + 0.01) << rough.rows[row][0];
    least = std::min(least, energy(rough, row));
  }
  EXPECT_LT(rough.last("kinetic [J]"), 0.05);
  EXPECT_GT(rough.last("gravity [J]"), 0);
}

// A block stands on a slope of 0.3 rad by friction above tan 0.3 = 0.309, and on none below it.
TEST_F(Contacts, BlockRestsOnASlopeByFriction) {
  const auto block = [](double friction) {
    std::string points, contacts;
    for (int corner = 0; corner < 4; ++corner) {
      points += fmt::format(R"("c{}": [{}, {}, 0], )", corner, corner < 2 ? 0.1 : -0.1, corner % 2 == 0 ? 0.1 : -0.1);
      contacts += fmt::format(
          R"({0}"c{1}": {{ "from": "block.c{1}", "to": "ground.O", "stiffness": 1e5, "damping": 1, "friction": {2} }})",
          corner == 0 ? "" : ", ", corner, friction);
    }
    return fmt::format(R"({{ "mbgen": 1, "name": "slope", "gravity": [{}, 0, {}],
      "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
        "block": {{ "mass": 4, "com": [0, 0, 0.05], "inertia": [0.02, 0.02, 0.03], "points": {{ {} "O": [0, 0, 0] }} }} }},
      "joints": {{ "block": {{ "type": "free", "from": "ground.O", "to": "block.O" }} }},
      "contacts": {{ {} }}, "initial": {{ "positions": {{ "block_tz": -5e-5 }} }} }})",
                       9.81 * std::sin(0.3), -9.81 * std::cos(0.3), points, contacts);
  };
  write("holds.json", block(0.4));
  const Outcome holds = mbgen("equilibrium holds.json");
  EXPECT_EQ(holds.exit_code, 0) << holds.err;
  write("slides.json", block(0.25));
  EXPECT_EQ(mbgen("equilibrium slides.json").exit_code, 1);
}

TEST_F(Contacts, ModelsStandOnThem) {
  const std::string models = kSource + "/models/contacts/";
  const Table coach = run(models + "coach_on_roof.json", "--duration 9 --every 100");
  EXPECT_NEAR(coach.last("turn [rad]"), M_PI, 0.02);
  EXPECT_LT(std::abs(coach.last("zd.chassis_rx [rad/s]")), 0.05);
  const Table robot = run(models + "legged_robot.json", "--every 100");
  double load = 0;
  for (const char* foot : {"front_left", "front_right", "rear_left", "rear_right"})
    load += robot.last(fmt::format("foot_{} [N]", foot));
  EXPECT_NEAR(load, 29.6 * 9.81, 0.01 * load);
  const Table arm = run(models + "arm_on_wall.json", "--every 10");
  bool sticks = false, slides = false;
  for (std::size_t row = 400; row < arm.rows.size(); ++row) {
    const double push = arm.at(row, "push [N]"), slip = arm.at(row, "slip [m/s]");
    EXPECT_LE(std::abs(arm.at(row, "rub [N]")), 0.2 * push * (1 + 1e-9));
    sticks = sticks || (push > 100 && slip < 1e-3);
    slides = slides || (push > 100 && slip > 0.05);
  }
  EXPECT_TRUE(sticks);
  EXPECT_TRUE(slides);
}

// Four times the step of the model: bristles take the step of the motion as their lag. With the shorter one of the
// model they went past their ends, and the energy was off by a half.
TEST_F(Contacts, BearLongImplicitSteps) {
  const Outcome done = mbgen("simulate " + kSource +
                             "/models/contacts/arm_on_wall.json --engine generic --integrator rosenbrock --step 2e-3 "
                             "--every 100 --out m.csv");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err.find("warning"), std::string::npos) << done.err;
}

// A block of 2 kg with little damping falls by 1 mm on a corner beside a pendulum of 100 kg, in whose energy the
// block's is lost: its touches last 2 steps of 1 ms, and the load of a corner is off by a third. Halved from 1e-5 s on,
// the load changes by 1e-3.
TEST_F(Contacts, TouchesOfTooFewStepsAreTold) {
  std::string points, contacts, comma;
  for (const auto& [name, x, y] : {std::tuple{"a", 0.1, 0.1}, {"b", -0.1, 0.1}, {"c", -0.1, -0.1}, {"d", 0.1, -0.1}}) {
    points += fmt::format(R"(, "{}": [{}, {}, 0])", name, x, y);
    contacts += fmt::format(R"({}"{}": {{ "from": "block.{}", "to": "ground.O", "stiffness": 1e6, "damping": 0.01,
      "friction": 0.5 }})",
                            comma, name, name);
    comma = ", ";
  }
  write("block.json", fmt::format(R"({{ "mbgen": 1, "name": "block",
    "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0], "C": [0, 0, 0.05], "P": [0, 1, 2] }} }},
      "block": {{ "mass": 2, "com": [0, 0, 0.05], "inertia": [8e-3, 8e-3, 1.1e-2], "points": {{ "C": [0, 0, 0.05]{} }} }},
      "bob": {{ "mass": 100, "com": [1, 1, 2], "inertia": [0.01, 0.01, 0.01], "points": {{ "P": [0, 1, 2] }} }} }},
    "joints": {{ "block": {{ "type": "free", "from": "ground.C", "to": "block.C" }},
      "bob": {{ "type": "revolute", "from": "ground.P", "to": "bob.P", "axis": "y" }} }},
    "contacts": {{ {} }}, "initial": {{ "positions": {{ "block_tz": 1e-3, "block_rx": 2e-3 }} }},
    "outputs": {{ "load": {{ "contact": "a", "quantity": "load" }} }} }})",
                                  points, contacts));
  const std::string command = "simulate block.json --engine generic --duration 0.05 --every 1000 --out m.csv --json ";
  for (const char* integrator : {"rk4", "rosenbrock"}) {
    const Json coarse = json_of(command + "--step 1e-3 --integrator " + integrator);
    EXPECT_NE(coarse["status"], "ok") << integrator;
    EXPECT_NE(coarse["warnings"].dump().find("lets go after touches of too few steps"), std::string::npos)
        << coarse["warnings"];
    EXPECT_LE(coarse["fitting_step"].get<double>(), 1e-4);
  }
  const Json fine = json_of(command + "--step 5e-5");
  EXPECT_EQ(fine["status"], "ok") << fine["warnings"];
}

}  // namespace
}  // namespace mbgen::cli_test
