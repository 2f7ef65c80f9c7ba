// The patch of a tyre that turns about the road's normal: closed forms at rest, and the way to rolling.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mbgen/integrators.hpp"
#include "mbgen/tyres/tyre.hpp"
#include "tests/runtime/mf61_sets.hpp"
#include "tests/runtime/mirrored_tyre.hpp"

namespace mbgen {
namespace {

constexpr double kStiffness = 2500, kRadius = 0.06, kLoad = 4100;  // N m/rad, m, N

TyreProperties<double> parked_properties() {
  TyreProperties<double> tyre{0.317, 2.1e5, 50, 1, 0.01, 0.2, 0.4, 2, 1, 1, kNominalPressure};
  tyre.turn_stiffness = kStiffness;
  tyre.turn_radius = kRadius;
  tyre.turn_load = kLoad;
  tyre.turning = Turning::patch;
  return tyre;
}

TyreContact<double> standing(double load) { return {load / 2.1e5, 0, 0, 0, 0, 0, 0, 0}; }

double friction_under(double load) {
  const auto set = passenger_car();
  return magic::mf61_lateral<double>(set, magic::mf61_state<double>(set, load, kNominalPressure, 1, 1), 0, 0).friction;
}

/// A standing tyre that is turned at a steady rate, rad/s, by an angle, in equal steps of the classical Runge-Kutta
/// method. Result: the moments behind each step, as it holds there; the turn in `contact`.
std::vector<double> turned(const TyreProperties<double>& tyre, TyreContact<double>& contact, double rate, double by,
                           int steps) {
  const auto set = turning_car();
  const double step = std::abs(by / rate) / steps;
  contact.turn_rate = by > 0 ? std::abs(rate) : -std::abs(rate);
  std::vector<double> moments;
  const auto slope = [&](double turn) {
    TyreContact<double> at = contact;
    at.turn = turn;
    return tyre_forces(set, tyre, at).dturn;
  };
  for (int i = 0; i < steps; ++i) {
    const double k1 = slope(contact.turn), k2 = slope(contact.turn + step / 2 * k1);
    const double k3 = slope(contact.turn + step / 2 * k2), k4 = slope(contact.turn + step * k3);
    contact.turn += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    TyreContact<double> held = contact;
    held.turn_rate = 0;
    moments.push_back(tyre_forces(set, tyre, held).mz);
  }
  return moments;
}

constexpr double kRate = 0.1;  // rad/s

TEST(Parking, SlopeAndLargestMomentFollowTheLoad) {
  for (const double load : {1000.0, 4100.0, 7000.0}) {
    const double over = load / kLoad, stiffness = kStiffness * std::pow(over, 1.5);
    const double limit = kRadius * friction_under(load) * load * std::sqrt(over), angle = limit / stiffness;
    TyreContact<double> contact = standing(load);
    const TyreProperties<double> tyre = parked_properties();
    EXPECT_NEAR(turned(tyre, contact, kRate, 1e-6, 1)[0], -stiffness * 1e-6, 1e-5 * stiffness * 1e-6);
    contact.turn = 0;
    const double by = 0.8 * angle;
    EXPECT_NEAR(turned(tyre, contact, kRate, by, 200).back(), -limit * (1 - std::exp(-by / angle)), 1e-8 * limit);
    EXPECT_NEAR(turned(tyre, contact, kRate, 40 * angle, 4000).back(), -limit, 1e-8 * limit);
  }
}

TEST(Parking, ConvergesInTheFourthOrder) {
  const double angle = kRadius * friction_under(kLoad) * kLoad / kStiffness;
  const auto error = [&](int steps) {
    TyreContact<double> contact = standing(kLoad);
    turned(parked_properties(), contact, kRate, 2 * angle, steps);
    return std::abs(contact.turn + angle * (1 - std::exp(-2.0)));
  };
  for (const int steps : {4, 8, 16}) EXPECT_NEAR(std::log2(error(steps) / error(2 * steps)), 4, 0.35) << steps;
}

TEST(Parking, HysteresisIsClosedAndHasTheAreaOfItsClosedForm) {
  const TyreProperties<double> tyre = parked_properties();
  const double limit = kRadius * friction_under(kLoad) * kLoad, angle = limit / kStiffness, amplitude = 3 * angle;
  TyreContact<double> contact = standing(kLoad);
  constexpr int kSteps = 4000;
  turned(tyre, contact, kRate, amplitude, kSteps);
  for (int i = 0; i < 6; ++i) {
    turned(tyre, contact, kRate, -2 * amplitude, kSteps);
    turned(tyre, contact, kRate, 2 * amplitude, kSteps);
  }
  const double at_end = contact.turn;
  double work = 0;
  for (const double by : {-2 * amplitude, 2 * amplitude}) {
    contact.turn_rate = 0;
    double before = tyre_forces(turning_car(), tyre, contact).mz;
    for (const double moment : turned(tyre, contact, kRate, by, kSteps)) {
      work -= 0.5 * (before + moment) * by / kSteps;
      before = moment;
    }
  }
  EXPECT_NEAR(contact.turn, at_end, 1e-12 * angle) << "the loop is closed";
  // Dahl's loop between -A and A: share = 1 - (1 + tanh(a)) exp(-(psi + A) / angle), a = A / angle.
  const double a = amplitude / angle, area = 4 * limit * angle * (a - std::tanh(a));
  EXPECT_NEAR(work, area, 1e-5 * area);
}

TEST(Parking, HoldsAndGivesNoEnergyFromNothing) {
  const TyreProperties<double> tyre = parked_properties();
  TyreContact<double> contact = standing(kLoad);
  turned(tyre, contact, 0.3, 0.2, 2000);
  contact.turn_rate = 0;
  const TyreResult<double> held = tyre_forces(turning_car(), tyre, contact);
  EXPECT_LT(held.mz, -100);
  EXPECT_LT(std::abs(held.dturn), 1e-13) << "rad/s: nothing in 60 s";
  EXPECT_EQ(held.fx, 0);
  EXPECT_EQ(held.fy, 0);
  // Work of any way into the patch is never less than what its spring then holds.
  contact = standing(kLoad);
  double work = 0, angle = kRadius * friction_under(kLoad) * kLoad / kStiffness;
  const double step = 1e-5;
  for (int i = 0; i < 200000; ++i) {
    const double t = i * step;
    contact.turn_rate = 1.2 * std::sin(9 * t) * std::cos(40 * t * t) + 0.3 * std::sin(170 * t);
    const TyreResult<double> result = tyre_forces(turning_car(), tyre, contact);
    work -= result.mz * contact.turn_rate * step;
    contact.turn += step * result.dturn;
    const double held_energy = 0.5 * kStiffness * contact.turn * contact.turn;
    ASSERT_GT(work, held_energy - 2e-3) << t;
    ASSERT_LT(std::abs(contact.turn), angle);
  }
}

TEST(Parking, AReleasedWheelComesToRestWithoutRinging) {
  const TyreProperties<double> tyre = parked_properties();
  const double inertia = 1.2;  // kg m^2 about the kingpin
  TyreContact<double> contact = standing(kLoad);
  turned(tyre, contact, 0.3, 0.35, 4000);
  double angle = 0.35, rate = 0, largest = 0;
  const double step = 1e-4;
  for (int i = 0; i < 600000; ++i) {  // 60 s
    contact.turn_rate = rate;
    const TyreResult<double> result = tyre_forces(turning_car(), tyre, contact);
    rate += step * result.mz / inertia;
    angle += step * rate;
    contact.turn += step * result.dturn;
    if (i > 20000) largest = std::max(largest, std::abs(rate));
  }
  EXPECT_GT(angle, 0.2) << "it springs back by less than the patch had turned";
  EXPECT_LT(angle, 0.349);
  EXPECT_LT(largest, 1e-8) << "rad/s from 2 s on";
  EXPECT_NEAR(tyre_forces(turning_car(), tyre, contact).mz, 0, 1e-6);
}

TEST(Parking, ReverseIsMirroredAndSidesAgree) {
  for (const Turning turning : {Turning::patch, Turning::turn_slip}) {
    TyreProperties<double> tyre = parked_properties();
    tyre.turning = turning;
    TyreContact<double> contact{0.02, 0, 6, 0.1, 6 / 0.31, 0.03, 0.004, -0.02, 0.8, -0.01};
    const TyreResult<double> one = tyre_forces(turning_car(), tyre, contact);
    tyre.side = -1;
    for (double* flipped : {&contact.vy, &contact.camber, &contact.v, &contact.turn_rate, &contact.turn})
      *flipped = -*flipped;
    const TyreResult<double> mirrored = tyre_forces(turning_car(), tyre, contact);
    expect_mirrored(mirrored, one);
    EXPECT_EQ(mirrored.dturn, -one.dturn);
    // Backwards the moment of the patch stays against turning, the side force of the bend turns round.
    tyre.side = 1;
    const auto bend = [&](double vx) {
      TyreContact<double> c{0.02, 0, vx, 0, vx / 0.31, 0, 0, 0, 1.5, -0.004};
      return tyre_forces(symmetric_car(), tyre, c);
    };
    EXPECT_DOUBLE_EQ(bend(6).dturn, bend(-6).dturn);
    EXPECT_NEAR(bend(6).fy, -bend(-6).fy, 1e-9);
    EXPECT_EQ(bend(6).fy != 0, turning == Turning::turn_slip);
  }
}

TEST(Parking, IceTurnsEasily) {
  TyreProperties<double> tyre = parked_properties();
  const auto largest = [&] {
    TyreContact<double> contact = standing(kLoad);
    return turned(tyre, contact, kRate, 3, 4000).back();
  };
  const double dry = largest();
  tyre.friction = 0.1;
  EXPECT_NEAR(largest(), 0.1 * dry, 1e-6);
  TyreContact<double> contact = standing(kLoad);
  EXPECT_NEAR(turned(tyre, contact, kRate, 1e-6, 1)[0], -kStiffness * 1e-6, 1e-4 * kStiffness * 1e-6) << "as stiff";
  tyre.friction = 0;
  EXPECT_NEAR(largest(), 0, 1e-3);
  contact = standing(0);
  contact.deflection = -0.1;
  contact.turn_rate = 1;
  contact.turn = 0.01;
  const TyreResult<double> lifted = tyre_forces(turning_car(), tyre, contact);
  EXPECT_EQ(lifted.mz, 0);
  EXPECT_TRUE(std::isfinite(lifted.dturn));
}

}  // namespace
}  // namespace mbgen
