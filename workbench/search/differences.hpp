#pragma once
// Central differences by unknowns between bounds.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "workbench/search/unknowns.hpp"

namespace mbgen {

/// Offsets in steps and weights of a difference formula of second order.
struct DifferenceFormula {
  double step = 0;
  std::vector<std::pair<double, double>> terms;
};

/// Differences of second order to one side: 1 to larger values, -1 to smaller.
inline DifferenceFormula one_sided_formula(double step, double side) {
  return {step, {{0, -1.5 * side}, {side, 2 * side}, {2 * side, -0.5 * side}}};
}

/// Formulas in the order in which they are tried: central differences, and differences to either side where the model
/// has no result on the other (a damping below 0, a loop that does not close); next to a bound differences to the
/// inside alone. The step is 1e-4 of the scale of the unknown, less between closer bounds: the errors of truncation and
/// rounding are near 1e-8.
inline std::vector<DifferenceFormula> difference_formulas(const Unknown& unknown, double value) {
  constexpr double kPartOfScale = 1e-4;
  const double step = std::min(kPartOfScale * unknown.scale, (unknown.upper - unknown.lower) / 3);
  if (value - step < unknown.lower) return {one_sided_formula(step, 1)};
  if (value + step > unknown.upper) return {one_sided_formula(step, -1)};
  std::vector<DifferenceFormula> list = {{step, {{-1, -0.5}, {1, 0.5}}}};
  if (value + 2 * step <= unknown.upper) list.push_back(one_sided_formula(step, 1));
  if (value - 2 * step >= unknown.lower) list.push_back(one_sided_formula(step, -1));
  return list;
}

/// Evaluates the derivatives of a list by their first formulas, and the failed ones by their next formulas, as long as
/// there are any. evaluate(places, attempt): computes the derivatives at these places by the formula of that
/// number; failure_of(place): the reason why one has none, "" where it has; formulas_of(place): the number of its
/// formulas. Result: the first reason of the first derivative that has none by any formula.
template <class Evaluate, class FailureOf, class FormulasOf>
std::string evaluate_by_formulas(std::size_t count, const Evaluate& evaluate, const FailureOf& failure_of,
                                 const FormulasOf& formulas_of) {
  std::vector<std::size_t> open(count);
  for (std::size_t place = 0; place < count; ++place) open[place] = place;
  std::vector<std::string> reasons(count);
  for (std::size_t attempt = 0; !open.empty(); ++attempt) {
    evaluate(open, attempt);
    std::vector<std::size_t> next;
    for (const std::size_t place : open) {
      const std::string failure = failure_of(place);
      if (failure.empty()) continue;
      if (attempt == 0) reasons[place] = failure;
      if (attempt + 1 >= formulas_of(place)) return reasons[place];
      next.push_back(place);
    }
    open = std::move(next);
  }
  return "";
}

}  // namespace mbgen
