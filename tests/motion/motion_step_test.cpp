// Laws of time that jump or have a corner, and held inputs, along a motion: against closed forms, at every step.

#include <cmath>
#include <functional>

#include "tests/support/cli_support.hpp"
#include "workbench/motion/simulation.hpp"

namespace mbgen::cli_test {
namespace {

using Integrator = SolverSettings::Integrator;

class MotionStep : public CommandLine {
 protected:
  /// A mass of 2 kg on a spring (N/m) under a force along x.
  Compilation carriage(const std::string& force, double stiffness) const {
    return *decide(write("carriage.json", fmt::format(R"({{ "mbgen": 1, "name": "carriage",
    "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }}, "mass": {{ "mass": 2, "inertia": [1, 1, 1], "points": {{ "O": [0, 0, 0] }} }} }},
    "inputs": {{ "push": {{ "unit": "N" }} }},
    "parameters": {{ "until": {{ "value": 0.3, "tunable": true }} }},
    "tables": {{ "ramp": {{ "table": [[0, 0], [0.125, 3], [0.25, 1]], "interpolation": "linear", "outside": "hold" }} }},
    "joints": {{ "x": {{ "type": "prismatic", "from": "ground.O", "to": "mass.O", "axis": "x" }} }},
    "joint_springs": {{ "x": {{ "joint": "x", "stiffness": {} }} }},
    "joint_forces": {{ "x": {{ "joint": "x", "force": "{}" }} }},
    "solver": {{ "step": 1e-3, "duration": 1 }} }})",
                                                      stiffness, force)));
  }
};

/// The place of the mass after 0.5 s in so many steps.
double place(const Compilation& c, Integrator integrator, long steps, const InputsOverTime& inputs,
             long* parted = nullptr) {
  EngineChoice choice;
  choice.integrator = integrator;
  const Engine engine = make_generic_engine(c, choice);
  SimulationSettings settings;
  settings.steps = steps;
  settings.step = 0.5 / static_cast<double>(steps);
  GenericState start;
  start.z = start.zd = {0};
  double last = 0;
  const SimulationSummary summary =
      simulate(engine, start, inputs, settings, [&](const Sample& sample) { last = sample.state.z[0]; });
  EXPECT_TRUE(summary.status.ok());
  if (parted) *parted = summary.parted_steps;
  return last;
}

double place(const Compilation& c, Integrator integrator, long steps, long* parted = nullptr) {
  return place(c, integrator, steps, inputs_over_time(c.model, {}, "", Interpolation::pchip), parted);
}

/// x(0.5) of 2 x'' + k x = F by its impulse response, F smooth between the given instants. Cost: Gauss' rule on each.
double by_convolution(double k, const std::vector<double>& instants, const std::function<double(double)>& force) {
  const double w = std::sqrt(k / 2), points[] = {-std::sqrt(0.6), 0, std::sqrt(0.6)},
               weights[] = {5. / 9, 8. / 9, 5. / 9};
  double sum = 0;
  for (std::size_t i = 0; i + 1 < instants.size(); ++i)
    for (int part = 0; part < 64; ++part)
      for (int p = 0; p < 3; ++p) {
        const double h = (instants[i + 1] - instants[i]) / 64, t = instants[i] + h * (part + (1 + points[p]) / 2);
        sum += weights[p] * h / 2 * force(t) * std::sin(w * (0.5 - t)) / (2 * w);
      }
  return sum;
}

double error(const Compilation& c, Integrator integrator, long steps, double exact) {
  return std::abs(place(c, integrator, steps) - exact);
}

TEST_F(MotionStep, AForceThatJumpsWithinAStepMovesAMassExactly) {
  const Compilation c = carriage("10*step(t - 0.10037) - 30*step(t - until)", 0);
  const auto moved = [](double force, double from) { return force / 4 * (0.5 - from) * (0.5 - from); };
  for (const Integrator integrator : {Integrator::rk4, Integrator::abm4, Integrator::rosenbrock})
    for (const long steps : {10, 50, 500}) {
      long parted = 0;
      EXPECT_NEAR(place(c, integrator, steps, &parted), moved(10, 0.10037) - moved(30, 0.3), 1e-11) << steps;
      EXPECT_EQ(parted, 3) << "one jump lies within a step, the other one between two";
    }
}

TEST_F(MotionStep, CornersInTimeKeepTheOrder) {
  const Compilation c = carriage("100*sin(20*t)*min(1, t/until)", 5000);
  const double exact =
      by_convolution(5000, {0, 0.3, 0.5}, [](double t) { return 100 * std::sin(20 * t) * std::min(1.0, t / 0.3); });
  for (const long steps : {160, 170}) {  // of 170 steps none begins at the corner
    EXPECT_GT(error(c, Integrator::rk4, steps, exact) / error(c, Integrator::rk4, 2 * steps, exact), 13) << steps;
    EXPECT_GT(error(c, Integrator::rosenbrock, steps, exact) / error(c, Integrator::rosenbrock, 2 * steps, exact), 6.5)
        << steps;
  }
}

TEST_F(MotionStep, PointsOfATableOverTimeAreInstants) {
  const Compilation c = carriage("table('ramp', t)", 0);
  const double exact = 3 * 0.125 / 2 * (0.5 - 0.125 * 2 / 3);  // of the first triangle, times mass
  const double second = 0.125 * 1 * (0.5 - 0.1875) + 2 * 0.125 / 2 * (0.5 - 0.125 - 0.125 / 3), third = 0.25 * 0.25 / 2;
  for (const long steps : {10, 37})
    EXPECT_NEAR(place(c, Integrator::rk4, steps), (exact + second + third) / 2, 1e-11) << steps;
}

// An expression of time is followed by every stage; an input without its derivative has the value of the middle.
TEST_F(MotionStep, ASineAsAnExpressionKeepsTheOrderAndFromATableHasTheSecond) {
  const Compilation law = carriage("100*sin(20*t)", 3000), given = carriage("push", 3000);
  const double exact = by_convolution(3000, {0, 0.5}, [](double t) { return 100 * std::sin(20 * t); });
  std::string rows = "t,push\n";
  for (int k = 0; k <= 200; ++k) rows += fmt::format("{},{:.17g}\n", k / 400., 100 * std::sin(20 * k / 400.));
  const InputTable table = parse_input_table(rows, "push.csv", given.model);
  const InputsOverTime inputs = inputs_over_time(given.model, {}, table, Interpolation::spline);
  const auto of_table = [&](long steps) { return std::abs(place(given, Integrator::rk4, steps, inputs) - exact); };
  EXPECT_GT(error(law, Integrator::rk4, 160, exact) / error(law, Integrator::rk4, 320, exact), 15);
  EXPECT_NEAR(of_table(320) / of_table(640), 4, 0.2);
}

TEST_F(MotionStep, AHeldInputJumpsAtItsRow) {
  const Compilation c = carriage("push", 0);
  const InputTable table = parse_input_table("t,push\n0,0\n0.10037,8\n0.2,8\n0.30011,-4\n", "push.csv", c.model);
  const InputsOverTime inputs = inputs_over_time(c.model, {}, table, Interpolation::hold);
  EXPECT_EQ(inputs.jumps, (std::vector<double>{0.10037, 0.30011}));
  const auto moved = [](double force, double from) { return force / 4 * (0.5 - from) * (0.5 - from); };
  for (const long steps : {10, 50})
    EXPECT_NEAR(place(c, Integrator::rk4, steps, inputs), moved(8, 0.10037) - moved(12, 0.30011), 1e-11) << steps;
}

}  // namespace
}  // namespace mbgen::cli_test
