#pragma once
// Adjoint derivatives of FMI 3 beside directional ones.

#include <cmath>
#include <limits>

#include "case.hpp"

/// Adjoint derivatives of a weighted sum of unknowns are the weighted sums of directional ones; FMI 2 has none.
template <class Unit>
void weigh_unknowns(Unit& unit, const std::vector<unsigned>& unknowns, const std::vector<unsigned>& knowns) {
  if constexpr (Unit::kVersion == 3) {
    Row weights, found, rates;
    for (std::size_t u = 0; u < unknowns.size(); ++u) weights.push_back(1 - 0.3 * static_cast<double>(u));
    require(unit.adjoint(unknowns, knowns, weights, found) == kOk, "adjoint derivatives");
    bool any = false;
    for (std::size_t k = 0; k < knowns.size(); ++k) {
      require(unit.directional(unknowns, {knowns[k]}, {1.0}, rates) == kOk, "a directional derivative");
      double sum = 0, scale = 0;
      for (std::size_t u = 0; u < unknowns.size(); ++u) sum += weights[u] * rates[u];
      for (std::size_t u = 0; u < unknowns.size(); ++u) scale += std::abs(weights[u] * rates[u]);
      require(std::abs(found[k] - sum) <= 1e-12 * scale, "an adjoint derivative");
      any = any || sum != 0;
    }
    require(any, "adjoint derivatives are not all zero");
    weights[0] = std::numeric_limits<double>::quiet_NaN();
    require(unit.adjoint(unknowns, knowns, weights, found) == kError, "a weight that is no number");
  }
}
