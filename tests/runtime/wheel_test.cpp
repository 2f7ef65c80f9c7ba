// A wheel on the road: contact law, steady slip, and the way from rest and to rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "mbgen/integrators.hpp"
#include "mbgen/tyres/tyre.hpp"
#include "tests/runtime/mirrored_tyre.hpp"

namespace mbgen {
namespace {

constexpr double kGravity = 9.81;

nlohmann::json coefficient_sets() {
  return nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/tyre_magic_formula.json"));
}

Pac2002<double> bus_tyre() {
  const nlohmann::json data = coefficient_sets();
  std::vector<double> values;
  for (const TyreField& field : kPac2002Fields) {
    values.push_back(data["citybus_315_80_R22.5"]["parameters"].value(field.name, field.default_value));
  }
  return Pac2002<double>::from_fields(values.data());
}

TyreProperties<double> bus_properties() { return {0.548, 1e6, 5000, 1, 0.007, 0.3, 0.6, 2}; }

/// A contact under 35 kN that rolls freely at vx.
TyreContact<double> rolling(double vx) {
  const double deflection = 0.035, radius = 0.548 - deflection / 3;
  return {deflection, 0, vx, 0, vx / radius, 0, 0, 0};
}

/// The contact with its deflections in steady rolling: their rates integrated until they stop.
TyreContact<double> settled(const Pac2002<double>& set, const TyreProperties<double>& tyre,
                            TyreContact<double> contact) {
  for (int i = 0; i < 40000; ++i) {
    const TyreResult<double> result = tyre_forces(set, tyre, contact);
    contact.u += 2e-4 * result.du;
    contact.v += 2e-4 * result.dv;
  }
  return contact;
}

TEST(TyreContactLaw, LoadNeverPullsAndGrowsFromZeroAtTouchdown) {
  const Pac2002<double> set = bus_tyre();
  const TyreProperties<double> tyre = bus_properties();
  const auto load = [&](double deflection, double rate) {
    TyreContact<double> contact = rolling(10);
    contact.deflection = deflection;
    contact.deflection_rate = rate;
    return tyre_forces(set, tyre, contact).load;
  };
  EXPECT_DOUBLE_EQ(load(0.03, 0.2), 31000);
  EXPECT_DOUBLE_EQ(load(0.03, -0.2), 29000);
  EXPECT_EQ(load(0.001, -5), 0);
  EXPECT_EQ(load(-0.01, 3), 0);
  EXPECT_NEAR(load(1e-6, 3), 0, 2.1);
}

TEST(TyreContactLaw, WithoutLoadEverythingIsZeroAndTheDeflectionsRelax) {
  TyreContact<double> contact = rolling(10);
  contact.deflection = -0.1;
  contact.vy = 2;
  contact.spin = 0;
  contact.u = 0.01;
  const TyreResult<double> result = tyre_forces(bus_tyre(), bus_properties(), contact);
  for (const double zero : {result.load, result.fx, result.fy, result.mx, result.my, result.mz}) EXPECT_EQ(zero, 0);
  EXPECT_TRUE(std::isfinite(result.du + result.dv));
}

TEST(TyreContactLaw, SteadySlipIsThatOfTheVelocities) {
  const Pac2002<double> set = bus_tyre();
  const TyreProperties<double> tyre = bus_properties();
  for (const double vx : {3.0, 20.0, -5.0}) {
    for (const double kappa : {-1.0, -0.3, -0.02, 0.0, 0.05, 0.8}) {
      for (const double tangent : {-0.5, -0.03, 0.0, 0.1}) {
        TyreContact<double> contact = rolling(vx);
        contact.spin *= 1 + kappa * (vx > 0 ? 1 : -1);
        contact.vy = tangent * std::abs(vx);
        contact = settled(set, tyre, contact);
        const TyreResult<double> result = tyre_forces(set, tyre, contact);
        EXPECT_NEAR(result.kappa, kappa, 1e-9) << vx << " " << kappa << " " << tangent;
        EXPECT_NEAR(result.alpha, std::atan(tangent), 1e-9) << vx << " " << kappa << " " << tangent;
        const TyreForces<double> formula = magic_formula_pac2002(set, 35000.0, kappa, std::atan(tangent), 0.0);
        EXPECT_NEAR(result.fx, formula.fx, 1e-4);
        EXPECT_NEAR(result.fy, formula.fy, 1e-4);
      }
    }
  }
}

TEST(TyreContactLaw, SmallSlipRelaxesOverTheRelaxationLength) {
  const Pac2002<double> set = bus_tyre();
  const TyreProperties<double> tyre = bus_properties();
  TyreContact<double> contact = rolling(20);
  contact.vy = 20 * 1e-4;
  const double step = 1e-5;
  int steps = 0;
  for (; steps * step * 20 < tyre.relaxation_y; ++steps) contact.v += step * tyre_forces(set, tyre, contact).dv;
  EXPECT_NEAR(tyre_forces(set, tyre, contact).alpha, 1e-4 * (1 - std::exp(-1.0)), 1e-7);
}

TEST(TyreContactLaw, ForcesOpposeSlipInEveryConventionAndDirection) {
  // Pac89 sets have the signs of SAE axes; on the road both forms push against the slip.
  const nlohmann::json data = coefficient_sets();
  std::vector<double> values;
  for (const char* group : {"a", "b", "c"}) {
    for (const double value : data["pac89_chrono_hmmwv_truck_characteristic"][group]) values.push_back(value);
  }
  const Pac89<double> pac89 = Pac89<double>::from_fields(values.data());
  const Pac2002<double> pac2002 = bus_tyre();
  for (const double vx : {15.0, -15.0}) {
    TyreContact<double> contact = rolling(vx);
    contact.v = -0.03;  // sliding to the left
    contact.u = 0.01;   // driving
    for (const TyreResult<double>& result :
         {tyre_forces(pac89, bus_properties(), contact), tyre_forces(pac2002, bus_properties(), contact)}) {
      EXPECT_GT(result.alpha, 0);
      EXPECT_LT(result.fy, -1000);
      EXPECT_GT(result.kappa, 0);
      EXPECT_GT(result.fx, 1000);
    }
    contact.u = 0;
    for (const TyreResult<double>& result :
         {tyre_forces(pac89, bus_properties(), contact), tyre_forces(pac2002, bus_properties(), contact)}) {
      EXPECT_GT(result.mz * vx, 0) << "turns the wheel towards its velocity";
    }
  }
}

TEST(TyreContactLaw, MirroredTyreGivesMirroredForcesAndTwinsGiveTwice) {
  const Pac2002<double> set = bus_tyre();
  TyreProperties<double> tyre = bus_properties();
  TyreContact<double> contact = rolling(15);
  contact.u = -0.004;
  contact.v = 0.01;
  contact.camber = 0.03;
  const TyreResult<double> one = tyre_forces(set, tyre, contact);
  tyre.side = -1;
  contact.v = -0.01;
  contact.camber = -0.03;
  const TyreResult<double> mirrored = tyre_forces(set, tyre, contact);
  expect_mirrored(mirrored, one);
  tyre.count = 2;
  const TyreResult<double> twin = tyre_forces(set, tyre, contact);
  EXPECT_EQ(twin.load, 2 * one.load);
  EXPECT_EQ(twin.fx, 2 * one.fx);
  EXPECT_EQ(twin.fy, -2 * one.fy);
  EXPECT_EQ(twin.my, 2 * one.my);
}

TEST(TyreContactLaw, RollingResistanceAndTheArmOfTheForce) {
  TyreProperties<double> tyre = bus_properties();
  TyreContact<double> contact = rolling(20);
  contact.u = 0.005;
  const Pac2002<double> set = bus_tyre();
  const TyreResult<double> with = tyre_forces(set, tyre, contact);
  tyre.rolling_resistance = 0;
  const TyreResult<double> without = tyre_forces(set, tyre, contact);
  const double rolling_speed = 20;
  EXPECT_NEAR(with.my - without.my, -0.007 * 35000 * 0.548 * std::tanh(rolling_speed / 2), 1e-9);
  // Two thirds of the deflection lie between the contact point and the rolling radius.
  EXPECT_NEAR(without.my, -without.fx * 2.0 / 3.0 * 0.035, 1e-9);
}

/// A quarter of a bus on one wheel: travel, side travel, spin; optionally on a slope, its wheel free or locked.
struct QuarterBus {
  struct State {
    double z[3], zd[3], x[2], t;
  };
  struct Derivative {
    double zdd[3], xd[2];
  };
  Pac2002<double> set = bus_tyre();
  TyreProperties<double> properties = bus_properties();
  double mass = 3500, inertia = 10;
  double drive = 0, brake = 0;  ///< N m
  double slope = 0;             ///< 1
  bool locked = false;

  double deflection() const { return mass * kGravity / properties.stiffness; }
  TyreResult<double> tyre(const State& s) const {
    return tyre_forces(set, properties, {deflection(), 0, s.zd[0], s.zd[1], s.zd[2], 0, s.x[0], s.x[1]});
  }
  Status derivative(const State& s, Derivative& rates) const noexcept {
    const TyreResult<double> result = tyre(s);
    const double torque = drive - brake * std::tanh(s.zd[2] / 0.5) - result.fx * (properties.radius - deflection());
    rates.zdd[0] = result.fx / mass - kGravity * slope;
    rates.zdd[1] = result.fy / mass;
    rates.zdd[2] = locked ? 0 : (torque + result.my) / inertia;
    rates.xd[0] = result.du;
    rates.xd[1] = result.dv;
    return {};
  }
  Status project(State&) const noexcept { return {}; }
  Status project_nearest(State&) const noexcept { return {}; }
};

constexpr double kBusStep = 5e-4;

/// Runs on and calls observe(state) after each step.
template <class Observe>
QuarterBus::State run(const QuarterBus& bus, QuarterBus::State state, double duration, const Observe& observe) {
  const int steps = static_cast<int>(std::lround(duration / kBusStep));
  for (int i = 0; i < steps; ++i) {
    EXPECT_TRUE(step_rk4(bus, state, kBusStep).ok());
    observe(state);
  }
  return state;
}

QuarterBus::State run(const QuarterBus& bus, const QuarterBus::State& state, double duration) {
  return run(bus, state, duration, [](const QuarterBus::State&) {});
}

QuarterBus::State moving(double vx, double vy, double spin) { return {{}, {vx, vy, spin}, {}, 0}; }

void expect_at_rest(const QuarterBus::State& s) {
  EXPECT_NEAR(s.zd[0], 0, 1e-3);
  EXPECT_NEAR(s.zd[1], 0, 1e-3);
  EXPECT_NEAR(s.zd[2], 0, 1e-3);
}

TEST(WheelAtRest, StaysExactlyAtRest) {
  const QuarterBus::State s = run(QuarterBus{}, {}, 1);
  EXPECT_EQ(s.z[0], 0);
  EXPECT_EQ(s.z[1], 0);
  EXPECT_EQ(s.zd[2], 0);
}

TEST(WheelAtRest, StartsUnderTorqueWithoutOscillation) {
  QuarterBus bus;
  bus.drive = 2000;
  // Rolling without slip: (drive - rolling resistance) over the rolling radius moves mass and rotating inertia.
  const double radius = 0.548 - bus.deflection() / 3;
  const double ideal = bus.drive / radius / (bus.mass + bus.inertia / (radius * radius));
  double previous = 0;
  run(bus, {}, 3, [&](const QuarterBus::State& s) {
    const double acceleration = bus.tyre(s).fx / bus.mass;
    EXPECT_GE(s.zd[0], previous) << "moves off steadily, at " << s.t;
    previous = s.zd[0];
    if (s.t < 0.25) return;
    EXPECT_LT(acceleration, ideal) << s.t;
    EXPECT_GT(acceleration, 0.93 * ideal) << s.t;  // rolling resistance takes up to 0.069 m/s^2 of 1.04
  });
}

TEST(WheelAtRest, StandsOnASlopeWithItsBrakeLocked) {
  QuarterBus bus;
  bus.locked = true;
  bus.slope = 0.1;
  const QuarterBus::State early = run(bus, {}, 4);
  expect_at_rest(early);
  EXPECT_NEAR(bus.tyre(early).fx, bus.mass * kGravity * bus.slope, 1);
  const QuarterBus::State late = run(bus, early, 20);
  EXPECT_NEAR(late.z[0], early.z[0], 1e-6) << "it does not creep";
  EXPECT_GT(early.z[0], -0.01);
}

TEST(WheelComesToRest, UnderBrakingWithTheWheelTurning) {
  QuarterBus bus;
  bus.brake = 8000;
  const double radius = 0.548 - bus.deflection() / 3;
  double slowest = 1;
  const QuarterBus::State end = run(bus, moving(10, 0, 10 / radius), 5, [&](const QuarterBus::State& s) {
    slowest = std::min(slowest, s.zd[0]);
    if (s.t > 4) {
      EXPECT_LT(std::abs(bus.tyre(s).fx), 20) << s.t;
    }
  });
  expect_at_rest(end);
  EXPECT_GT(slowest, -0.05);
  const double stop = 10 * 10 / 2.0 / (bus.brake / radius / (bus.mass + bus.inertia / (radius * radius)));
  EXPECT_NEAR(end.z[0], stop, 0.05 * stop);
}

TEST(WheelComesToRest, SlidingWithALockedWheelThenRocksAndStands) {
  QuarterBus bus;
  bus.locked = true;
  double furthest_back = 1, largest_deflection = 0, late_speed = 0;
  const QuarterBus::State end = run(bus, moving(10, 1, 0), 5, [&](const QuarterBus::State& s) {
    furthest_back = std::min(furthest_back, s.zd[0]);
    largest_deflection = std::max(largest_deflection, std::hypot(s.x[0] / 0.3, s.x[1] / 0.6));
    if (s.t > 3.5) late_speed = std::max(late_speed, std::abs(s.zd[0]));
  });
  expect_at_rest(end);
  EXPECT_LT(largest_deflection, 0.5) << "over the relaxation length";
  EXPECT_GT(furthest_back, -0.5) << "springs back no faster than the tyre's own deflection can push";
  EXPECT_LT(late_speed, 0.005) << "the rocking dies out";
}

TEST(WheelComesToRest, SlidingSideways) {
  QuarterBus bus;
  bus.locked = true;
  double late_speed = 0;
  const QuarterBus::State end = run(bus, moving(0, 3, 0), 5, [&](const QuarterBus::State& s) {
    if (s.t > 4) late_speed = std::max(late_speed, std::abs(s.zd[1]));
  });
  expect_at_rest(end);
  EXPECT_LT(late_speed, 0.002);
  EXPECT_GT(end.z[1], 0.3);
  EXPECT_LT(end.z[1], 0.9) << "3 m/s against a friction of 0.6 to 0.8";
}

TEST(WheelSpin, GoesUpAndComesBackWithoutWindingUp) {
  QuarterBus bus;
  bus.drive = 30000;
  double largest = 0;
  const auto watch = [&](const QuarterBus::State& s) {
    largest = std::max(largest, std::abs(s.x[0]));
    ASSERT_TRUE(std::isfinite(s.x[0]));
  };
  const QuarterBus::State spinning = run(bus, {}, 0.15, watch);
  EXPECT_GT(spinning.zd[2], 100);
  EXPECT_LE(largest, 0.5 * 0.3 * (1 + 1e-9));
  bus.drive = 0;
  bus.brake = 8000;
  expect_at_rest(run(bus, spinning, 5, watch));
}

TEST(Slip, OnlyTakesEnergyFromABusThatRolls) {
  QuarterBus bus;
  bus.properties.rolling_resistance = 0;
  const double radius = 0.548 - bus.deflection() / 3;
  for (const double spin : {8 / radius, 14 / radius, 10 / radius}) {
    const auto energy = [&](const QuarterBus::State& s) {
      return 0.5 * bus.mass * (s.zd[0] * s.zd[0] + s.zd[1] * s.zd[1]) + 0.5 * bus.inertia * s.zd[2] * s.zd[2];
    };
    const QuarterBus::State start = moving(10, 1, spin);
    const QuarterBus::State settled = run(bus, start, 2);
    EXPECT_LT(energy(settled), energy(start));
    EXPECT_LT(energy(run(bus, settled, 2)), energy(settled));
  }
}

}  // namespace
}  // namespace mbgen
