// Numerical trouble at run time, one by one, on generated and generic solvers: every call ends, in a status that names
// the place, and what it was given stays as it was.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include "compiler/model/auxiliary_states.hpp"
#include "solvers.hpp"

namespace mbgen::trouble {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

const Compilation& model() {
  static const Compilation compilation = [] {
    Result<Compilation> read = compile(std::string(MBGEN_SOURCE_DIR "/tests/system/trouble/mechanism.json"));
    if (!read) throw std::runtime_error(to_text(read.problems()));
    return std::move(*read);
  }();
  return compilation;
}

const Solver& solver_of(const std::string& name) {
  static std::map<std::string, Solver> solvers;
  const auto known = solvers.find(name);
  if (known != solvers.end()) return known->second;
  return solvers[name] = name == "generic" ? generic_solver(model()) : generated_solver(model(), name);
}

int coordinate(const std::string& name) { return find_coordinate(model().topology, name); }

double& parameter(Case& at, const std::string& name) {
  const std::vector<Parameter>& all = model().model.parameters;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == name; });
  return at.parameters.at(static_cast<std::size_t>(found - all.begin()));
}

/// The defaults of the model, the crank turning at 12 rad/s; not yet closed.
Case at_defaults() {
  Case at;
  for (const Parameter& p : model().model.parameters) at.parameters.push_back(p.value);
  for (const Input& input : model().model.inputs) at.inputs.push_back(input.default_value);
  const auto n = static_cast<std::size_t>(model().topology.size());
  at.state.z.assign(n, 0);
  at.state.zd.assign(n, 0);
  at.state.x.assign(auxiliary_state_count(model().model), 0);
  at.tau.assign(n, 0);
  at.derivative = {std::vector<double>(n, 7), std::vector<double>(at.state.x.size(), 8)};
  at.state.zd[coordinate("crank_pin")] = 12;
  at.state.zd[coordinate("hub")] = 3;
  return at;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool same_results(const Case& a, const Case& b) {
  return same_bits(a.state.z, b.state.z) && same_bits(a.state.zd, b.state.zd) && same_bits(a.state.x, b.state.x) &&
         same_bits({a.state.t}, {b.state.t}) && same_bits(a.derivative.zdd, b.derivative.zdd) &&
         same_bits(a.derivative.xd, b.derivative.xd);
}

bool all_finite(const Case& at) {
  for (const auto* values : {&at.state.z, &at.state.zd, &at.state.x, &at.derivative.zdd, &at.derivative.xd}) {
    if (!std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); })) return false;
  }
  return std::isfinite(at.state.t);
}

struct NamedCall {
  const char* name;
  Solver::Call Solver::*call;
};
constexpr NamedCall kCalls[] = {{"accelerations", &Solver::accelerations},
                                {"project", &Solver::project},
                                {"step_rk4", &Solver::rk4},
                                {"step_abm4", &Solver::abm4}};

class Trouble : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!solver().project) GTEST_SKIP() << GetParam() << " is not installed";
    good_ = at_defaults();
    ASSERT_TRUE(solver().project(good_).ok());
  }
  const Solver& solver() const { return solver_of(GetParam()); }

  /// Calls, and expects this status and nothing changed.
  void expect_refusal(Solver::Call Solver::*call, const Case& at, const std::string& expected,
                      const std::string& where) const {
    Case tried = at;
    EXPECT_EQ(solver().describe((solver().*call)(tried)), expected) << where;
    EXPECT_TRUE(same_results(tried, at)) << where << " changed what it was given";
  }

  Case good_;  ///< a consistent state
};

/// One argument of a case, and what a status says of it.
struct Argument {
  std::function<double&(Case&)> number;
  std::string refusal;
};

std::vector<Argument> arguments() {
  std::vector<Argument> all;
  const std::size_t n = static_cast<std::size_t>(model().topology.size());
  for (std::size_t i = 0; i < n; ++i) {
    const std::string refusal = "not a number: " + model().topology.bodies[i].coordinate;
    all.push_back({[i](Case& at) -> double& { return at.state.z[i]; }, refusal});
    all.push_back({[i](Case& at) -> double& { return at.state.zd[i]; }, refusal});
  }
  const std::vector<std::string> auxiliary = auxiliary_state_names(model().model);
  for (std::size_t i = 0; i < auxiliary.size(); ++i) {
    all.push_back(
        {[i](Case& at) -> double& { return at.state.x[i]; }, "auxiliary state not a number: " + auxiliary[i]});
  }
  for (std::size_t i = 0; i < model().model.inputs.size(); ++i) {
    all.push_back(
        {[i](Case& at) -> double& { return at.inputs[i]; }, "input not a number: " + model().model.inputs[i].name});
  }
  for (std::size_t i = 0; i < model().model.parameters.size(); ++i) {
    all.push_back({[i](Case& at) -> double& { return at.parameters[i]; },
                   "parameter not a number: " + model().model.parameters[i].name});
  }
  all.push_back({[](Case& at) -> double& { return at.state.t; }, "time not a number"});
  return all;
}

TEST_P(Trouble, WhatIsNotFiniteIsNamed) {
  for (const Argument& argument : arguments()) {
    for (const double value : {kNan, kInfinity, -kInfinity}) {
      Case at = good_;
      argument.number(at) = value;
      for (const NamedCall& call : kCalls) expect_refusal(call.call, at, argument.refusal, call.name);
    }
  }
  for (std::size_t i = 0; i < good_.tau.size(); ++i) {
    Case at = good_;
    at.tau[i] = kNan;
    expect_refusal(&Solver::accelerations, at, "not a number: " + model().topology.bodies[i].coordinate, "tau");
  }
}

// The velocity and the acceleration of this motion are numbers, its position is not.
TEST_P(Trouble, AMotionWithoutPositionIsNamed) {
  Case at = good_;
  at.inputs[1] = -1;
  for (const NamedCall& call : kCalls) {
    if (call.call != &Solver::accelerations) expect_refusal(call.call, at, "not a number: swing", call.name);
  }
}

TEST_P(Trouble, ALoopThatCannotBeClosedIsNamed) {
  // Links of very different lengths have lost rank: the small ones cannot be seen in the Jacobian.
  for (const auto& [reach, refusal] : {std::pair{-3.0, "loop not closed: rocker_tip"},
                                       {5.0, "loop not closed: rocker_tip"},
                                       {1e12, "loop singular: rocker_tip"},
                                       {1e200, "loop singular: rocker_tip"}}) {
    Case at = good_;
    parameter(at, "reach") = reach;
    for (const NamedCall& call : kCalls) {
      if (call.call != &Solver::accelerations) expect_refusal(call.call, at, refusal, call.name);
    }
  }
}

// Assembly may go far; a step that would have to has lost its way.
TEST_P(Trouble, AStepDoesNotJump) {
  Case at = good_;
  parameter(at, "reach") = 0.3;
  expect_refusal(&Solver::rk4, at, "loop not closed: rocker_tip", "step_rk4");
  expect_refusal(&Solver::abm4, at, "loop not closed: rocker_tip", "step_abm4");
  EXPECT_TRUE(solver().project(at).ok());
  double moved = 0;
  for (std::size_t i = 0; i < at.state.z.size(); ++i) {
    moved = std::max(moved, std::abs(at.state.z[i] - good_.state.z[i]));
  }
  EXPECT_GT(moved, 0.2);
}

/// A parallelogram with its crank at an angle (rad) from where it falls flat.
Case parallelogram(double angle) {
  Case at = at_defaults();
  parameter(at, "crank") = parameter(at, "height") = 0.1;
  parameter(at, "reach") = parameter(at, "rocker") = 0.4;
  at.state.z[coordinate("crank_pin")] = at.state.z[coordinate("rocker_pin")] = std::numbers::pi / 2 + angle;
  at.state.z[coordinate("coupler_pin")] = -std::numbers::pi / 2 - angle;
  at.state.zd[coordinate("rocker_pin")] = 12;
  at.state.zd[coordinate("coupler_pin")] = -12;
  return at;
}

TEST_P(Trouble, ASingularPositionIsNamed) {
  const Case flat = parallelogram(0);
  expect_refusal(&Solver::accelerations, flat, "loop singular: rocker_tip", "accelerations");
  expect_refusal(&Solver::project, flat, "loop singular: rocker_tip", "project");
}

// From one side to the other the crank passes the flat position: notices name the loop, and the motion goes on.
TEST_P(Trouble, StepsNearASingularPositionSaySo) {
  for (const auto step : {&Solver::rk4, &Solver::abm4}) {
    Case at = parallelogram(-0.1);
    ASSERT_TRUE(solver().project(at).ok());
    bool was_near = false;
    for (int i = 0; i < 20; ++i) {
      const Status status = (solver().*step)(at);
      ASSERT_TRUE(status.ok()) << i << " " << solver().describe(status);
      if (status.code == Code::near_singular || status.code == Code::singular_met) {
        was_near = true;
        EXPECT_EQ(status.index, 0);
      }
      EXPECT_LT(solver().largest_residual(at), 1e-9);
    }
    EXPECT_TRUE(was_near);
    EXPECT_GT(at.state.z[coordinate("crank_pin")], std::numbers::pi / 2 + 0.1);
  }
}

TEST_P(Trouble, MissingInertiaNamesAJointOfTheMechanism) {
  for (const double load : {0.0, -1.0, -1e-300}) {
    Case at = good_;
    parameter(at, "load") = load;
    for (const NamedCall& call : kCalls) {
      if (call.call == &Solver::project) continue;
      Case tried = at;
      const Status status = (solver().*call.call)(tried);
      EXPECT_EQ(status.code, Code::no_inertia) << call.name << " " << load;
      const std::string name = solver().describe(status);
      EXPECT_TRUE(name.ends_with(": crank_pin") || name.ends_with(": coupler_pin") || name.ends_with(": rocker_pin"))
          << name;
      EXPECT_TRUE(same_results(tried, at));
    }
  }
}

TEST_P(Trouble, AStepThatIsNoneOrFarTooLargeIsRefused) {
  for (const double h : {0.0, -1e-3, kNan, kInfinity, -kInfinity}) {
    Case at = good_;
    at.h = h;
    expect_refusal(&Solver::rk4, at, "step invalid", "step_rk4");
    expect_refusal(&Solver::abm4, at, "step invalid", "step_abm4");
  }
  for (const double h : {10.0, 1e3, 1e10, 1e100, 1e300}) {
    for (const auto step : {&Solver::rk4, &Solver::abm4}) {
      Case at = good_;
      at.h = h;
      const Status status = (solver().*step)(at);
      EXPECT_FALSE(status.ok()) << h;
      EXPECT_NE(solver().describe(status).find(": "), std::string::npos) << h << " " << solver().describe(status);
      EXPECT_TRUE(same_results(at, good_));
    }
  }
}

// The steps between which others fail are those of a motion without failures, to the last bit.
TEST_P(Trouble, AStepThatFailsLeavesNoTrace) {
  Case at = good_, disturbed = good_;
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(solver().abm4(at).ok());
  for (int i = 0; i < 10; ++i) {
    Case spoiled = disturbed;
    spoiled.inputs[0] = kNan;
    EXPECT_FALSE(solver().abm4(spoiled).ok());
    spoiled = disturbed;
    parameter(spoiled, "load") = 0;
    EXPECT_FALSE(solver().abm4(spoiled).ok());
    ASSERT_TRUE(solver().abm4(disturbed).ok());
  }
  EXPECT_TRUE(same_results(at, disturbed));
}

// A spring that no step of this size can follow: the motion ends within a few steps, at the last good state.
TEST_P(Trouble, ExtremeStiffnessEndsTheMotion) {
  for (const double k : {1e12, 1e20, 1e100, 1e300}) {
    for (const auto step : {&Solver::rk4, &Solver::abm4}) {
      Case at = good_;
      parameter(at, "k") = k;
      Status status;
      for (int i = 0; i < 100 && status.ok(); ++i) {
        const Case before = at;
        status = (solver().*step)(at);
        EXPECT_TRUE(status.ok() || same_results(before, at));
      }
      EXPECT_FALSE(status.ok()) << k;
      EXPECT_NE(solver().describe(status).find(": "), std::string::npos) << k << " " << solver().describe(status);
      EXPECT_TRUE(all_finite(at));
    }
  }
}

/// A hundred steps, every one of which goes well.
void go_on(const Solver& solver, Solver::Call Solver::*step, Case& at) {
  for (int i = 0; i < 100; ++i) {
    const Status status = (solver.*step)(at);
    ASSERT_TRUE(status.ok()) << i << " " << solver.describe(status);
  }
  ASSERT_TRUE(solver.accelerations(at).ok());
}

/// Largest difference of the accelerations over the largest of them.
double difference(const Case& a, const Case& b) {
  double largest = 0, most = 0;
  for (std::size_t i = 0; i < a.derivative.zdd.size(); ++i) {
    largest = std::max(largest, std::abs(a.derivative.zdd[i]));
    most = std::max(most, std::abs(a.derivative.zdd[i] - b.derivative.zdd[i]));
  }
  return most / largest;
}

// An angle of 1e6 turns is known to 1e-9 rad, and accelerations of 1e2 1/s^2 change by 1e3 of them a radian at most.
TEST_P(Trouble, AMillionTurnsCostDigitsAlone) {
  for (const double turns : {1e6, -1e6}) {
    Case at = good_, turned = good_;
    for (const auto& [name, sign] :
         {std::pair{"crank_pin", 1.0}, {"coupler_pin", -1.0}, {"rocker_pin", 1.0}, {"bob", 1.0}, {"hub", -1.0}}) {
      turned.state.z[coordinate(name)] += sign * turns * 2 * std::numbers::pi;
    }
    const Case asked = turned;
    const Status projected = solver().project(turned);
    ASSERT_TRUE(projected.ok()) << solver().describe(projected);
    for (std::size_t i = 0; i < asked.state.z.size(); ++i) EXPECT_NEAR(turned.state.z[i], asked.state.z[i], 1e-8);
    for (const auto step : {&Solver::rk4, &Solver::abm4}) {
      go_on(solver(), step, turned);
      go_on(solver(), step, at);
      EXPECT_LT(difference(at, turned), 1e-6);
      EXPECT_LT(solver().largest_residual(turned), 1e-8);
    }
  }
}

// 1e6 s are 400 000 periods of the motion, and a time of 1e6 s is known to 1e-10 s.
TEST_P(Trouble, AMillionSecondsCostDigitsAlone) {
  Case at = good_, later = good_;
  later.state.t = 1e6;
  for (const auto step : {&Solver::rk4, &Solver::abm4}) {
    go_on(solver(), step, later);
    go_on(solver(), step, at);
    EXPECT_NEAR(later.state.t - 1e6, at.state.t, 1e-7);
    EXPECT_LT(difference(at, later), 1e-7);
  }
}

// Whatever the numbers are: calls end; what is ok is finite, what is not ok is unchanged.
TEST_P(Trouble, AnyNumbersAtAllEndInAStatus) {
  constexpr double kNumbers[] = {0,     -0.0,   1,     -1,     1e-3,  1e3,      -1e6,     6.3e6, 1e16,
                                 -1e16, 1e-300, 1e100, -1e150, 1e300, -1.7e308, 4.9e-324, kNan,  kInfinity};
  std::mt19937 random(5);
  const auto pick = [&random](std::size_t count) { return random() % count; };
  const std::vector<Argument> all = arguments();
  int ended_well = 0;
  for (int round = 0; round < 3000; ++round) {
    Case at = round % 2 == 0 ? good_ : at_defaults();
    for (std::size_t spoiled = 1 + pick(3); spoiled > 0; --spoiled) {
      all[pick(all.size())].number(at) = kNumbers[pick(std::size(kNumbers))];
    }
    if (pick(4) == 0) at.h = kNumbers[pick(std::size(kNumbers))];
    const NamedCall& call = kCalls[pick(std::size(kCalls))];
    const Case before = at;
    const Status status = (solver().*call.call)(at);
    if (status.ok()) {
      EXPECT_TRUE(all_finite(at)) << call.name << " of round " << round;
      ++ended_well;
    } else {
      EXPECT_TRUE(same_results(before, at)) << call.name << " of round " << round;
    }
  }
  EXPECT_GT(ended_well, 300);
}

INSTANTIATE_TEST_SUITE_P(Solvers, Trouble, ::testing::Values("generic", "g++", "clang++"), [](const auto& info) {
  const std::string name = info.param;
  return name == "generic" ? name : name == "g++" ? "gnu" : "clang";
});

}  // namespace
}  // namespace mbgen::trouble
