// Motions that a step does not resolve are told, and no others: energies that stay, turns, laws of time, modes; second
// rates of motions; periods and times that follow the step.

#include <cmath>
#include <complex>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Resolved : public CommandLine {
 protected:
  Json summary_of(const std::string& arguments, int exit_code = 0) {
    const Outcome run = mbgen("simulate " + arguments + " --engine generic --out o.csv --json");
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    err_ = run.err;
    return Json::parse(run.out, nullptr, false);
  }
  /// Takes what a run says, whatever comes of it.
  void hear(const std::string& arguments) {
    err_ = mbgen("simulate " + arguments + " --engine generic --out o.csv").err;
  }
  bool tells(const std::string& text) const { return err_.find(text) != std::string::npos; }
  std::string err_;
};

/// A mass between a weak spring and a strong damper.
constexpr const char* kOverdamped = R"({ "mbgen": 1, "name": "overdamped", "gravity": [0, 0, 0],
  "parameters": { "d": { "value": 1200 } },
  "bodies": { "ground": { "points": { "O": [0, 0, 0] } }, "m": { "mass": 0.8, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
  "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "m.O", "axis": "x" } },
  "joint_springs": { "s": { "joint": "x", "stiffness": 2, "damping": "d" } },
  "outputs": { "p": { "unit": "m", "joint": "x" } },
  "initial": { "positions": { "x": 0.5 } },
  "solver": { "integrator": "rosenbrock", "step": 0.01, "duration": 20 } })";

// Spring and damper are one element, and what one gives the other takes: the net exchange is nothing. Position by two
// exponentials (m x'' + d x' + k x = 0).
TEST_F(Resolved, WhatCancelsIsExchangedAllTheSame) {
  write("m.json", kOverdamped);
  const Json summary = summary_of("m.json");
  EXPECT_EQ(err_, "");
  EXPECT_EQ(summary["status"], "ok");
  EXPECT_NEAR(summary["outputs"]["p"]["last"].get<double>(), 0.48360856967360355, 1e-7);
  // 1 N/m (0.5^2 - 0.4836^2) / 2 m^2 by the spring, and the damper takes it: 0.0161 J beside an error of 1.6e-6 J.
  EXPECT_LT(std::abs(summary["relative_energy_error"].get<double>()), 2e-4);
  ASSERT_EQ(mbgen("sweep m.json --engine generic --vary d=1200,1300 --metric \"max(z.x)\" --out s.csv").exit_code, 0);
  const std::string table = read("s.csv");
  EXPECT_EQ(table.find("energy"), table.find("energy_error")) << table;
  EXPECT_NE(table.find(",ok"), std::string::npos) << table;
}

/// An undamped spring of 159 Hz on a carriage at `speed`.
std::string carried(double speed) {
  return fmt::format(R"({{ "mbgen": 1, "name": "carried", "gravity": [0, 0, 0],
    "bodies": {{ "ground": {{ "points": {{ "A": [0, 0, 0] }} }},
                 "car": {{ "mass": 1000, "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0] }} }},
                 "b": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0] }} }} }},
    "joints": {{ "drive": {{ "type": "prismatic", "from": "ground.A", "to": "car.A", "axis": "x" }},
                 "bounce": {{ "type": "prismatic", "from": "car.A", "to": "b.A", "axis": "z" }} }},
    "joint_springs": {{ "s": {{ "joint": "bounce", "stiffness": 1e6 }} }},
    "initial": {{ "positions": {{ "bounce": 0.01 }}, "velocities": {{ "drive": {} }} }} }})",
                     speed);
}

// The carriage's energy stays: it says nothing about the spring on it.
TEST_F(Resolved, EnergyThatStaysIsNoScale) {
  for (const double speed : {0.0, 10.0, 30.0}) {
    write("c.json", carried(speed));
    for (const char* integrator : {"rk4", "rosenbrock"}) {
      const std::string rest = fmt::format("c.json --integrator {} --duration 1 --step ", integrator);
      const Json lost = summary_of(rest + "1e-3", 1);
      EXPECT_TRUE(lost["status"].get<std::string>().starts_with("energy balance off by ")) << speed << lost;
      EXPECT_GT(std::abs(lost["relative_energy_error"].get<double>()), 0.3);
      const Json good = summary_of(rest + "2e-5");
      EXPECT_EQ(err_, "") << speed << integrator;
    }
  }
}

/// A rotor, `eccentricity` m out of balance, on a sprung frame; turning at `rate` rad/s.
std::string rotor(double eccentricity, double rate) {
  return fmt::format(R"({{ "mbgen": 1, "name": "rotor", "gravity": [0, 0, 0],
    "bodies": {{ "ground": {{ "points": {{ "A": [0, 0, 0] }} }},
                 "frame": {{ "mass": 10, "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0] }} }},
                 "rotor": {{ "mass": 1, "com": [{}, 0, 0], "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0] }} }} }},
    "joints": {{ "x": {{ "type": "prismatic", "from": "ground.A", "to": "frame.A", "axis": "x" }},
                 "r": {{ "type": "revolute", "from": "frame.A", "to": "rotor.A", "axis": "y" }} }},
    "joint_springs": {{ "s": {{ "joint": "x", "stiffness": 40000, "damping": 100 }} }},
    "outputs": {{ "way": {{ "unit": "m", "joint": "x" }} }},
    "initial": {{ "positions": {{ "x": 0.001 }}, "velocities": {{ "r": {} }} }} }})",
                     eccentricity, rate);
}

TEST_F(Resolved, TurnsWithinAStepAreTold) {
  for (const auto& [integrator, limit] :
       {std::pair("rk4", 0.5), std::pair("abm4", 0.3), std::pair("rosenbrock", 0.3)}) {
    const std::string rest = fmt::format("r.json --integrator {} --duration 0.2 --step 1e-3", integrator);
    write("r.json", rotor(0.001, 2000 * std::acos(-1.0)));
    hear(rest);
    EXPECT_TRUE(tells("r turns by 6.28 rad in a step of 0.001 s from t = 0 s on, and forces turn with it: ")) << err_;
    EXPECT_TRUE(tells(fmt::format("{} bears {:g} rad; --step ", integrator, limit))) << err_;
    // Balanced it turns as it likes; slowly too.
    write("r.json", rotor(0, 2000 * std::acos(-1.0)));
    EXPECT_EQ(summary_of(rest)["status"], "ok") << err_;
    write("r.json", rotor(0.001, 900 * limit));
    EXPECT_EQ(summary_of(rest)["status"], "ok") << err_;
  }
}

/// Distance of the steady motion of a frame that a rotor shakes from the closed form, as part of its amplitude: a fit
/// of sine and cosine to the table from 0.6 s on, where what the start left has decayed.
double distance_from_closed_form(const Table& motion, double rate) {
  const double mass = 11, damping = 400, stiffness = 40000, force = 0.001 * rate * rate;
  const std::complex<double> exact = force / std::complex<double>(stiffness - mass * rate * rate, damping * rate);
  double cc = 0, ss = 0, cs = 0, xc = 0, xs = 0;
  for (const std::vector<double>& row : motion.rows) {
    const double t = row[0], x = row[motion.column("z.x [m]")], c = std::cos(rate * t), s = -std::sin(rate * t);
    if (t <= 0.6) continue;
    cc += c * c, ss += s * s, cs += c * s, xc += c * x, xs += s * x;
  }
  const double determinant = cc * ss - cs * cs;
  const std::complex<double> found((xc * ss - xs * cs) / determinant, (xs * cc - xc * cs) / determinant);
  return std::abs(found - exact) / std::abs(exact);
}

// The table of docs/use/numerical_trouble.md: within the limit a shaken frame is right to 0.1 %.
TEST_F(Resolved, LimitsOfTurnsAreMeasured) {
  constexpr double kRate = 200;
  std::string model = rotor(0.001, kRate);
  model.replace(model.find("\"damping\": 100"), 14, "\"damping\": 400");
  const std::size_t body = model.rfind("\"inertia\": [1, 1, 1]");
  model.replace(body, 20, "\"inertia\": [1e6, 1e6, 1e6]");  // it keeps its rate
  write("r.json", model);
  const auto error_of = [&](const char* integrator, double turn) {
    const double h = turn / kRate;
    summary_of(fmt::format("r.json --integrator {} --step {} --duration {}", integrator, h, std::round(1 / h) * h));
    return distance_from_closed_form(table("o.csv"), kRate);
  };
  EXPECT_LT(error_of("rk4", 0.5), 1e-4);
  EXPECT_LT(error_of("abm4", 0.3), 1e-3);
  EXPECT_LT(error_of("rosenbrock", 0.3), 1e-3);
  EXPECT_GT(error_of("rk4", 1), 1e-3);
  EXPECT_GT(error_of("abm4", 0.4), 1e-3);
  EXPECT_GT(error_of("rosenbrock", 0.35), 1e-3);
}

// A step that "would do" does: nothing is said of it any more.
TEST_F(Resolved, HintedStepsAreGood) {
  write("rotor.json", rotor(0.001, 2000 * std::acos(-1.0)));
  write("carried.json", carried(30));
  for (const char* model : {"rotor", "carried"}) {
    for (const char* integrator : {"rk4", "abm4", "rosenbrock"}) {
      const std::string rest = fmt::format("{}.json --integrator {} --duration 0.2 --step ", model, integrator);
      const Json bad =
          Json::parse(mbgen("simulate " + rest + "1e-3 --engine generic --out o.csv --json").out, nullptr, false);
      ASSERT_TRUE(bad["fitting_step"].is_number()) << bad;
      EXPECT_EQ(summary_of(fmt::format("{}{}", rest, bad["fitting_step"].get<double>()))["status"], "ok")
          << rest << err_;
    }
  }
}

/// A ton that falls, and a kilogram on a spring of 159 Hz beside it, with half a thousandth of its energy.
constexpr const char* kFalling = R"({ "mbgen": 1, "name": "falling", "gravity": [0, 0, -9.81],
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
              "ton": { "mass": 1000, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } },
              "block": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "fall": { "type": "prismatic", "from": "ground.A", "to": "ton.A", "axis": "z" },
              "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "x" } },
  "joint_springs": { "s": { "joint": "slide", "stiffness": 1e6 } },
  "initial": { "positions": { "slide": 0.007 } } })";

TEST_F(Resolved, ModesThatTheMethodTakesAwayAreTold) {
  write("f.json", kFalling);
  const std::string rest = "f.json --duration 1 --step ";
  const Json summary = summary_of(rest + "1e-3");
  EXPECT_TRUE(
      tells("a mode of the start takes part that the method takes out of the motion, 159.2 Hz (slide +1.00): rk4 "
            "changes its energy by 100 % over the motion; --step "))
      << err_;
  EXPECT_EQ(summary["status"], "1 warning");
  EXPECT_EQ(summary_of(rest + "1e-4")["status"], "ok") << err_;
}

// Its energy is kept to 5 %, its phase is not: (w h)^5 / 120 a step.
TEST_F(Resolved, ModesWhoseTimeIsNotKeptAreTold) {
  std::string slower = kFalling;  // the ton swings, with a hundred times the energy
  slower.replace(slower.find("[0, 0, -9.81]"), 13, "[0, 0, 0]");
  slower.replace(slower.find("\"stiffness\": 1e6 }"), 18,
                 R"("stiffness": 4e4 }, "s2": { "joint": "fall", "stiffness": 4000 })");
  slower.replace(slower.find("\"positions\": {"), 14, R"("positions": { "fall": 0.22,)");
  write("f.json", slower);
  const std::string rest = "f.json --duration 60 --every 60 --step ";
  const Json summary = summary_of(rest + "1e-3");
  EXPECT_TRUE(
      tells("a mode of the start takes part whose time the method does not keep, 31.83 Hz (slide +1.00): rk4 "
            "turns it by 0.16 rad over the motion; --step 0.0002 would do"))
      << err_;
  EXPECT_EQ(summary["status"], "1 warning");
  // The phase itself: x = 0.007 cos(w t).
  const double x = table("o.csv").last("z.slide [m]"), w = 200;
  EXPECT_NEAR(x, 0.007 * std::cos(w * 60 - 0.16), 0.0003);
  EXPECT_GT(std::abs(x - 0.007 * std::cos(w * 60)), 0.0003);
  EXPECT_EQ(summary_of(rest + "5e-4")["status"], "ok") << err_;
}

/// A mass on a spring, pushed by a law of t and an input.
constexpr const char* kPushed = R"json({ "mbgen": 1, "name": "pushed", "gravity": [0, 0, 0],
  "parameters": { "w": { "value": 1 } }, "inputs": { "push": { "unit": "N" } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } }, "block": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "x" } },
  "joint_springs": { "s": { "joint": "slide", "stiffness": 100, "damping": 1 } },
  "joint_forces": { "f": { "joint": "slide", "force": "sin(w*t) + push" } },
  "outputs": { "told": { "expression": "sin(1e5*t)" } } })json";

TEST_F(Resolved, FastLawsAndInputsAreTold) {
  write("p.json", kPushed);
  const std::string rest = "p.json --duration 1 --step 1e-3 --set w=";
  EXPECT_EQ(summary_of(rest + "1")["status"], "ok") << err_;
  EXPECT_EQ(summary_of(rest + "400")["status"], "ok") << err_;
  for (const char* fast : {"700", "6300", "2e4"}) {
    hear(rest + fast);
    EXPECT_TRUE(
        tells("warning: laws of t change too fast for a step of 0.001 s: between its points the acceleration of "
              "slide is not what rk4 can know of it; take a shorter step"))
        << fast << err_;
  }
  const auto table = [&](double w) {
    std::string text = "t,push\n";
    for (int k = 0; k <= 4000; ++k) text += fmt::format("{},{}\n", k / 4000.0, std::sin(w * k / 4000.0));
    write("t.csv", text);
  };
  const std::string by_table = "p.json --duration 1 --step 1e-3 --input-table t.csv";
  table(3);
  EXPECT_EQ(summary_of(by_table)["status"], "ok") << err_;
  table(3000);
  hear(by_table);
  EXPECT_TRUE(tells("warning: input push changes too fast for a step of 0.001 s")) << err_;
}

/// A drive whose input has a rate, and as `named` says, an acceleration.
std::string driven(bool named) {
  return fmt::format(R"({{ "mbgen": 1, "name": "driven", "gravity": [0, 0, 0],
    "inputs": {{ "way": {{ "unit": "m", "derivative": "speed" }}, "speed": {{ "unit": "m/s"{} }}{} }},
    "bodies": {{ "ground": {{ "points": {{ "A": [0, 0, 0] }} }},
                 "cart": {{ "mass": 2, "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0] }} }} }},
    "joints": {{ "slide": {{ "type": "prismatic", "from": "ground.A", "to": "cart.A", "axis": "x" }} }},
    "motions": {{ "m": {{ "joint": "slide", "position": "way" }} }},
    "outputs": {{ "force": {{ "motion": "m" }} }} }})",
                     named ? R"(, "derivative": "gain")" : "", named ? R"(, "gain": { "unit": "m/s^2" })" : "");
}

// Force of the drive: mass times acceleration, whether the model names it or not.
TEST_F(Resolved, MotionsWithARateHaveInertia) {
  std::string table = "t,way\n";
  for (int k = 0; k <= 100; ++k) table += fmt::format("{},{}\n", k / 100.0, k * k * 1e-4);
  write("t.csv", table);
  std::vector<Table> tables;
  for (const bool named : {true, false}) {
    write("d.json", driven(named));
    EXPECT_EQ(summary_of("d.json --input-table t.csv --interpolation spline --duration 1 --step 1e-2")["status"], "ok")
        << err_;
    tables.push_back(this->table("o.csv"));
    EXPECT_NEAR(tables.back().at(50, "force [N]"), 4, 1e-6);
  }
  EXPECT_EQ(tables[0].rows, tables[1].rows);
  const Outcome check = mbgen("check d.json");
  EXPECT_NE(check.err.find("input \"speed\" moves a joint and has no derivative: its rate \"speed_rate\" is added"),
            std::string::npos)
      << check.out << check.err;
}

TEST_F(Resolved, LoadsWithoutAPeriodFollowTheStep) {
  write("f.json", R"({ "mbgen": 1, "name": "pressed", "parameters": { "mu": { "value": 1e-3 } },
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
                "bob": { "mass": 1, "com": [0, 0, -0.5], "inertia": [0.01, 0.01, 0.01], "points": { "A": [0, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.A", "to": "bob.A", "axis": "y" } },
    "frictions": { "rub": { "joint": "pin", "reaction": "pin", "coulomb": "mu", "velocity": 0.05 } },
    "initial": { "positions": { "pin": 1 } }, "solver": { "step": 1e-3, "duration": 0.5 } })");
  const auto last = [&](const std::string& step) {
    EXPECT_EQ(summary_of("f.json --step " + step)["status"], "ok") << err_;
    return table("o.csv").last("z.pin [rad]");
  };
  // No multiple of 1e-3 s was refused; the error is of first order in the period.
  const double coarse = last("2e-3"), fine = last("1e-3"), finer = last("5e-4");
  EXPECT_NEAR((coarse - fine) / (fine - finer), 2, 0.3);
  const Outcome sweep =
      mbgen("sweep f.json --engine generic --vary g=1,2 --metric \"max(z.pin)\" --step 2e-3 --out s.csv");
  EXPECT_EQ(sweep.err.find("is no multiple of the step"), std::string::npos) << sweep.err;
}

// Periods of 10 ms and 15 ms.
TEST_F(Resolved, AStepFitsAllPeriodsOrAFittingOneIsNamed) {
  const std::string slide = "simulate '" + kSource + "/tests/data/fmi/sampled_slide.json' --engine generic --out o.csv";
  const Outcome run = mbgen(slide + " --duration 0.06 --step 4e-3");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("hint: --step 0.0025, "), std::string::npos) << run.err;
  EXPECT_EQ(mbgen(slide + " --duration 0.06 --step 2.5e-3").exit_code, 0);
}

}  // namespace
}  // namespace mbgen::cli_test
