#pragma once
// States, rates and results of any model, as every engine that runs without generated code gives them.

#include <algorithm>
#include <cmath>
#include <vector>

#include "mbgen/status.hpp"

namespace mbgen {

/// State of any model: all coordinates, all velocities, auxiliary states, time.
struct GenericState {
  std::vector<double> z, zd, x;
  double t = 0;
};

struct GenericDerivative {
  std::vector<double> zdd, xd;
};

/// Results of a model's outputs function.
struct GenericOutputs {
  std::vector<double> y;
  double kinetic_energy = 0, potential_energy = 0, applied_power = 0;
};

/// Place of the first value that is not finite, or -1.
inline int first_not_finite(const std::vector<double>& values) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
  return bad == values.end() ? -1 : static_cast<int>(bad - values.begin());
}

/// Largest absolute value, NaN when there is one, 0 for none.
inline double largest_absolute(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) {
    if (std::isnan(value)) return value;
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// Names arguments of a call that are not finite. tau: per coordinate, may be empty; inputs: all of the model.
inline Status check_finite(const GenericState& state, const std::vector<double>& tau,
                           const std::vector<double>& inputs) {
  for (const std::vector<double>* values : {&state.z, &state.zd, &tau}) {
    if (const int i = first_not_finite(*values); i >= 0) return {Code::not_a_number, i};
  }
  if (!std::isfinite(state.t)) return {Code::time_not_a_number, -1};
  if (const int i = first_not_finite(state.x); i >= 0) return {Code::auxiliary_not_a_number, i};
  if (const int i = first_not_finite(inputs); i >= 0) return {Code::input_not_a_number, i};
  return {};
}

/// Names rates that are not finite.
inline Status check_finite(const GenericDerivative& derivative) {
  if (const int i = first_not_finite(derivative.zdd); i >= 0) return {Code::not_a_number, i};
  if (const int i = first_not_finite(derivative.xd); i >= 0) return {Code::auxiliary_not_a_number, i};
  return {};
}

}  // namespace mbgen
