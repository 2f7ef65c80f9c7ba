#pragma once
// An importer that chooses its steps: the pair of J. R. Dormand and P. J. Prince, "A family of embedded Runge-Kutta
// formulae", 1980, orders 5 and 4. Its cost, its events, its distance from a table.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "case.hpp"

struct Work {
  int evaluations = 0, steps = 0, rejected = 0, events = 0;
  double error = 0;  ///< largest of a column at the end, over its range
  double drift = 0;  ///< of the kinetic energy, over itself
};

/// Goes through an event. Result: whether it has changed states, which are then those that it says it may change.
template <class Unit>
bool go_through_event(const Case& c, Unit& unit, Row& x) {
  const Row before = x;
  bool has_changed = false;
  require(unit.enter_event() == kOk && unit.update(has_changed) == kOk && unit.enter_continuous() == kOk, "an event");
  require(unit.states(x) == kOk && (has_changed || same_bits(x, before)), "states after an event");
  const std::vector<unsigned> states = c.description.states();
  for (std::size_t i = 0; i < x.size(); ++i)
    require(x[i] == before[i] || c.description.variables[states[i]].reinit, "a state that may not change at events");
  return has_changed;
}

/// One step: the result of order five, and the difference from that of order four over the tolerance.
/// Result: false where the unit cannot be evaluated there.
template <class Unit>
bool try_step(Unit& unit, double t, double h, const Row& x, double tolerance, Work& work, Row& result, double& error) {
  static constexpr double kTimes[] = {0, 0.2, 0.3, 0.8, 8.0 / 9, 1, 1};
  static constexpr double kWeights[7][6] = {{},
                                            {1.0 / 5},
                                            {3.0 / 40, 9.0 / 40},
                                            {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                            {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                            {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                            {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static constexpr double kDifference[] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                           -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
  Row rates[7];
  for (int stage = 0; stage < 7; ++stage) {
    result = x;
    for (int k = 0; k < stage; ++k) {
      for (std::size_t i = 0; i < x.size(); ++i) result[i] += h * kWeights[stage][k] * rates[k][i];
    }
    rates[stage].resize(x.size());
    require(unit.set_time(t + kTimes[stage] * h) == kOk && unit.set_states(result) == kOk, "states");
    const int status = unit.derivatives(rates[stage]);
    require(status == kOk || status == kDiscard, "derivatives");
    ++work.evaluations;
    if (status == kDiscard) return false;
  }
  error = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double difference = 0;
    for (int stage = 0; stage < 7; ++stage) difference += h * kDifference[stage] * rates[stage][i];
    error = std::max(error, std::abs(difference) / (tolerance * (1 + std::abs(x[i]))));
  }
  return true;
}

/// Over the whole table, by steps that keep the tolerance, which is relative to one and to each state.
template <class Unit>
Work integrate_adaptively(const Case& c, double tolerance) {
  Unit unit(c.library, c.description, true);
  start(unit);
  require(unit.enter_continuous() == kOk, "continuous time");
  const double end = c.description.step * static_cast<double>(c.table.rows.size() - 1);
  Row x(c.description.derivatives.size()), next;
  require(unit.states(x) == kOk, "states");
  Work work;
  const unsigned energy = c.description.reference("energy.kinetic");
  const double first = values(unit, {energy})[0];
  double t = 0, h = c.description.step, error = 0;
  while (t < end) {
    const bool is_last = t + h >= end * (1 - 1e-12);
    const double size = is_last ? end - t : h;
    const bool has_values = try_step(unit, t, size, x, tolerance, work, next, error);
    if (!has_values || error > 1) {
      ++work.rejected;
      h = size * (has_values ? std::max(0.2, 0.9 * std::pow(error, -0.2)) : 0.25);
      require(h > 1e-9, "a step that can be made");
      continue;
    }
    t = is_last ? end : t + size;
    x = next;
    ++work.steps;
    h = size * std::min(5.0, 0.9 * std::pow(std::max(error, 1e-5), -0.2));
    bool event = false;
    require(unit.set_time(t) == kOk && unit.set_states(x) == kOk && unit.completed(event) == kOk, "completed step");
    if (!event) continue;
    ++work.events;
    require(go_through_event(c, unit, x), "an event that is asked for changes states");
  }
  work.drift = std::abs(values(unit, {energy})[0] / first - 1);
  const Row got = values(unit, c.columns);
  for (std::size_t k = 0; k < got.size(); ++k) {
    double range = 1e-3;
    for (const Row& row : c.table.rows) range = std::max(range, std::abs(row[k]));
    work.error = std::max(work.error, std::abs(got[k] - c.table.rows.back()[k]) / range);
  }
  return work;
}

/// A loop of which every coordinate has dead points, without forces: states change at events, as often whatever the
/// tolerance is, motion and kinetic energy follow the tolerance. Of the model triple_rocker.
template <class Unit>
void pass_dead_points(const Case& c) {
  Work coarser;
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const Work work = integrate_adaptively<Unit>(c, tolerance);
    std::printf("  tolerance %g: %d steps, %d rejected, %d evaluations, %d events, error %.1e, energy %.1e\n",
                tolerance, work.steps, work.rejected, work.evaluations, work.events, work.error, work.drift);
    require(work.events >= 5 && (coarser.events == 0 || work.events == coarser.events), "events at dead points");
    require(work.drift < 100 * tolerance && work.error < 1e-5 + 300 * tolerance, "accuracy beyond dead points");
    require(coarser.events == 0 || work.evaluations > coarser.evaluations, "evaluations");
    coarser = work;
  }
}
