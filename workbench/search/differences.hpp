#pragma once
// Central differences by unknowns between bounds.

#include <utility>
#include <vector>

#include "workbench/search/unknowns.hpp"

namespace mbgen {

/// Offsets in steps and weights of a difference formula of second order.
struct DifferenceFormula {
  double step = 0;
  std::vector<std::pair<double, double>> terms;
};

/// Central differences; next to a bound differences to the inside. The step is 1e-4 of the scale of the unknown: the
/// errors of truncation and rounding are near 1e-8.
inline DifferenceFormula difference_formula(const Unknown& unknown, double value) {
  constexpr double kPartOfScale = 1e-4;
  const double step = kPartOfScale * unknown.scale;
  if (value - step >= unknown.lower && value + step <= unknown.upper) return {step, {{-1, -0.5}, {1, 0.5}}};
  const double inside = value - step < unknown.lower ? 1 : -1;
  return {step, {{0, -1.5 * inside}, {inside, 2 * inside}, {2 * inside, -0.5 * inside}}};
}

}  // namespace mbgen
