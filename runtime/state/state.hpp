#pragma once
// States, rates and results of any model, as every engine that runs without generated code gives them.

#include <algorithm>
#include <cmath>
#include <vector>

#include "mbgen/charts.hpp"
#include "mbgen/status.hpp"

namespace mbgen {

/// State of any model: all coordinates, all velocities, auxiliary states, time.
struct GenericState {
  std::vector<double> z, zd, x;
  double t = 0;
  std::vector<double> charts = {};  ///< per ball of the topology, 0 or 1 (mbgen/charts.hpp); empty: all 0
};

struct GenericDerivative {
  std::vector<double> zdd, xd;
};

/// Results of a model's outputs function.
struct GenericOutputs {
  std::vector<double> y;
  double kinetic_energy = 0, potential_energy = 0, applied_power = 0;
};

/// The exchanges of energy at a state, for the scale of an energy balance.
struct GenericExchanges {
  std::vector<double> powers;   ///< W, of force elements in parts that do not cancel, and of gravity on bodies
  double applied = 0;           ///< W, of all force elements, without drives
  std::vector<double> kinetic;  ///< J, of bodies by translation and about each of their axes
};

/// Whether a ball should be in its other chart.
inline bool leaves_charts(const std::vector<Ball>& balls, const GenericState& state) {
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (leaves_chart(balls[b], state.charts.empty() ? 0.0 : state.charts[b], state.z.data())) return true;
  }
  return false;
}

/// Puts every ball into the chart that suits its position. Result: whether one was changed.
inline bool settle_charts(const std::vector<Ball>& balls, GenericState& state) {
  std::vector<double> charts = state.charts;
  charts.resize(balls.size(), 0.0);
  const int count = static_cast<int>(balls.size());
  if (!settle_balls(balls.data(), count, charts.data(), state.z.data(), state.zd.data())) return false;
  state.charts = std::move(charts);
  return true;
}

/// Takes positions, rates and accelerations from the charts of one state to those of another.
inline void change_charts(const std::vector<Ball>& balls, const GenericState& from, const GenericState& to,
                          std::vector<double>& z, std::vector<double>& zd, std::vector<double>& zdd) {
  std::vector<double> charts_from = from.charts, charts_to = to.charts;
  charts_from.resize(balls.size(), 0.0);
  charts_to.resize(balls.size(), 0.0);
  change_charts(balls.data(), static_cast<int>(balls.size()), charts_from.data(), charts_to.data(), z.data(), zd.data(),
                zdd.data());
}

/// The state as the model counts its coordinates: every ball in chart 0.
inline GenericState in_users_angles(const std::vector<Ball>& balls, GenericState state) {
  if (state.charts.empty()) return state;
  to_users_angles<double>(balls.data(), static_cast<int>(balls.size()), state.charts.data(), state.z.data(),
                          state.zd.data(), nullptr);
  state.charts.clear();
  return state;
}

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

/// Names the first place at which an element does not hold. hold: per place, negative or NaN there.
inline Status check_holds(const std::vector<double>& hold) {
  return status_of_holds(hold.data(), static_cast<int>(hold.size()));
}

/// Names rates that are not finite.
inline Status check_finite(const GenericDerivative& derivative) {
  if (const int i = first_not_finite(derivative.zdd); i >= 0) return {Code::not_a_number, i};
  if (const int i = first_not_finite(derivative.xd); i >= 0) return {Code::auxiliary_not_a_number, i};
  return {};
}

}  // namespace mbgen
