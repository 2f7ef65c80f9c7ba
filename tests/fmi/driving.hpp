#pragma once
// Inputs of a driven coordinate with their rates, and without: of the model driven_cart.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "case.hpp"

enum class Rates { all, none, as_derivatives };

/// Angle of the pendulum over three seconds, while the cart goes to and fro.
template <class Unit>
std::vector<double> swing(const Case& c, Rates rates) {
  const unsigned way = c.description.reference("way"), speed = c.description.reference("speed"),
                 acceleration = c.description.reference("acceleration"), angle = c.description.reference("z.swing");
  Unit unit(c.library, c.description, false);
  start(unit);
  std::vector<double> angles;
  const double h = c.description.step, w = 5, size = 0.2;
  const int steps = static_cast<int>(3 / h);
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const double v = size * w * std::sin(w * t), a = size * w * w * std::cos(w * t);
    require(unit.set({way}, {size * (1 - std::cos(w * t))}) == kOk, "an input");
    if (rates == Rates::all) require(unit.set({speed, acceleration}, {v, a}) == kOk, "its rates");
    if constexpr (Unit::kVersion == 2) {
      if (rates == Rates::as_derivatives)
        require(unit.set_derivatives({way, way}, {1, 2}, {v, a}) == kOk, "its derivatives");
    }
    require(unit.step(t, h) == kOk, "step");
    angles.push_back(values(unit, {angle})[0]);
  }
  return angles;
}

/// Who leaves rates out gets them, and FMI 2 has another way to give them.
template <class Unit>
void drive_by_inputs(const Case& c) {
  const std::vector<double> given = swing<Unit>(c, Rates::all), made = swing<Unit>(c, Rates::none);
  double range = 0, error = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    range = std::max(range, std::abs(given[i]));
    error = std::max(error, std::abs(given[i] - made[i]));
  }
  std::printf("  rates left out change the swing by %.2f %% of its range\n", 100 * error / range);
  require(error < 0.02 * range, "rates are made");
  if constexpr (Unit::kVersion == 2)
    require(same_bits(swing<Unit>(c, Rates::as_derivatives), given), "derivatives of an input are its rates");
}
