#pragma once
// Directional derivatives of a brake: open it is no spring, and closing it acts against the motion. Of the model
// flywheel, with an inertia of 2 kg m^2, 2e4 N m/rad and 60 N m s/rad in its bristle, whose lag is the step of 1 ms.

#include <cmath>

#include "case.hpp"

/// d(unknown)/d(known) in this order: acceleration by angle, rate, bristle, brake; rate of the bristle by the same.
template <class Unit>
Row slopes(const Case& c, double turning, double brake) {
  Unit unit(c.library, c.description, true);
  require(unit.set({c.description.reference("turning"), c.description.reference("brake")}, {turning, brake}) == kOk,
          "the start");
  start(unit);
  require(unit.enter_continuous() == kOk, "continuous time");
  Row result;
  for (const char* unknown : {"zdd.hub", "xd.brake_bristle"}) {
    for (const char* known : {"z.hub", "zd.hub", "x.brake_bristle", "brake"}) {
      Row rates;
      require(unit.directional({c.description.reference(unknown)}, {c.description.reference(known)}, {1}, rates) == kOk,
              "a directional derivative");
      result.push_back(rates[0]);
    }
  }
  return result;
}

template <class Unit>
void brake_by_derivatives(const Case& c) {
  const auto are = [](const Row& found, const Row& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (!(std::abs(found[i] - expected[i]) <= 1e-9 * (1 + std::abs(expected[i])))) return false;
    return true;
  };
  require(are(slopes<Unit>(c, 0, 0), {0, 0, 0, 0, 0, 0, -1000, 0}), "an open brake on a wheel that stands");
  require(are(slopes<Unit>(c, 5, 0), {0, 0, 0, -0.5, 0, 0, -1000, 0}), "closing a brake on a wheel that turns");
  require(are(slopes<Unit>(c, -5, 0), {0, 0, 0, 0.5, 0, 0, -1000, 0}), "the same the other way round");
  require(are(slopes<Unit>(c, 0, 100), {0, -30, -1e4, 0, 0, 1, 0, 0}), "a brake that holds");
  // Straight as it starts it bends with its lag: 100 N m over 2e4 N m/rad in 1 ms.
  require(are(slopes<Unit>(c, 50, 100), {0, 0, -1e4, -30 * 0.05, 0, 0, 0, 0.05}), "a brake that bends at its lag");
}
