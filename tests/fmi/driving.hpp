#pragma once
// Inputs of a driven coordinate with their rates, and without: of the model driven_cart. Inputs between inner steps.

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

/// Model exchange, where no rates are made: who leaves them out is told so, once, by a message of a call that is OK:
/// some end a run at any status above. Result: the steps with a message.
template <class Unit>
int warned(const Case& c, bool with_rates) {
  const unsigned way = c.description.reference("way"), speed = c.description.reference("speed"),
                 acceleration = c.description.reference("acceleration");
  Unit unit(c.library, c.description, true);
  start(unit);
  require(unit.set({way}, {0.01}) == kOk && unit.enter_continuous() == kOk, "continuous time");
  int warnings = 0;
  for (int i = 1; i <= 5; ++i) {
    const double t = i * c.description.step;
    bool event = false;
    require(unit.set_time(t) == kOk && unit.set({way}, {0.01 + 0.5 * t * t}) == kOk, "an input");
    if (with_rates) require(unit.set({speed, acceleration}, {t, 1}) == kOk, "its rates");
    last_message.clear();
    require(unit.completed(event) == kOk, "a completed step");
    require(last_message.empty() || says("\"way\" moves, but its derivatives"), "the message");
    warnings += last_message.empty() ? 0 : 1;
  }
  return warnings;
}

template <class Unit>
void warn_of_rates(const Case& c) {
  require(warned<Unit>(c, false) == 1, "a warning of rates that are left out");
  require(warned<Unit>(c, true) == 0, "no warning where they are given");
}

/// Co-simulation with a value that moves and a rate of its own. Result: the step that gives a message, 0 for none; each
/// answers OK.
template <class Unit>
int contradicted(const Case& c, double factor) {
  const unsigned way = c.description.reference("way"), speed = c.description.reference("speed"),
                 acceleration = c.description.reference("acceleration");
  Unit unit(c.library, c.description, false);
  start(unit);
  int warned_at = 0;
  for (int i = 1; i <= 8; ++i) {
    const double t = (i - 1) * c.description.step;
    require(unit.set({way, speed, acceleration}, {0.01 + 0.5 * t * t, factor * t, factor}) == kOk, "inputs");
    last_message.clear();
    require(unit.step(t, c.description.step) == kOk, "a step with rates");
    if (last_message.empty()) continue;
    require(warned_at == 0 && says("\"way\" must change as its derivative says"), "the message");
    warned_at = i;
  }
  return warned_at;
}

template <class Unit>
void warn_of_contradictions(const Case& c) {
  require(contradicted<Unit>(c, 1) == 0, "no warning of rates that belong to their values");
  for (const double factor : {57.3, -1.0, 0.5}) require(contradicted<Unit>(c, factor) == 5, "a warning of wrong rates");
}

/// Calls that have no place within a communication step.
template <class Unit>
void call_between(const Case& c, Unit& unit, double t) {
  void* state = nullptr;
  require(unit.step(t, c.description.step) == kError && says("intermediate update mode"), "a step within a step");
  require(unit.save(state) == kError && unit.restore(&state) == kError && unit.reset() == kError &&
              unit.terminate() == kError,
          "the life of the unit within a step");
  for (const Variable& variable : c.description.variables) {
    if (variable.causality == "parameter")
      require(unit.set({variable.reference}, {1.0}) == kError && says("cannot be set in this mode"), "a parameter");
  }
}

/// One communication step whose inputs are set between the inner steps has the bits of as many communication steps.
template <class Unit>
void update_between(const Case& c) {
  const double h = c.description.step;
  std::vector<unsigned> inputs, exchanged = c.columns;
  for (const Variable& variable : c.description.variables) {
    if (variable.causality == "input") inputs.push_back(variable.reference);
  }
  exchanged.insert(exchanged.end(), inputs.begin(), inputs.end());
  const auto give = [&](Unit& unit, int point) {
    const double t = h * point, given[] = {0.5 * t * t, t, 1, 1e-3 * point};  // a row with two rates, and others
    for (std::size_t k = 0; k < inputs.size(); ++k)
      require(unit.set({inputs[k]}, {given[std::min<std::size_t>(k, 3)]}) == kOk, "an input");
  };
  constexpr int kCount = 7;
  Unit single(c.library, c.description, false);
  start(single);
  std::vector<Row> expected, got;
  for (int i = 0; i < kCount; ++i) {
    give(single, i);
    require(single.step(i * h, h) == kOk, "step");
    expected.push_back(values(single, exchanged));
  }
  int point = 0;
  Unit* self = nullptr;
  Unit unit(c.library, c.description, false, true, [&](double t, bool may_set) {
    ++point;
    require(std::abs(t - point * h) < 1e-9 * h && may_set == (point < kCount), "points of intermediate updates");
    got.push_back(values(*self, exchanged));
    if (may_set) give(*self, point);
    call_between(c, *self, t);
  });
  self = &unit;
  start(unit);
  give(unit, 0);
  require(unit.step(0, kCount * h) == kOk && got.size() == expected.size(), "a step with intermediate updates");
  for (std::size_t i = 0; i < got.size(); ++i) require(same_bits(got[i], expected[i]), "bits of an intermediate point");
  require(same_bits(values(unit, exchanged), expected.back()), "bits after intermediate updates");
  const char* token = c.description.token.c_str();
  require(single.instantiate_with(token, {exchanged[0]}) == nullptr && says("callback"), "no callback");
  require(unit.instantiate_with(token, {0}) == nullptr && says("inputs and outputs only"), "time between steps");
  require(unit.instantiate_with(token, {}, true) == nullptr && says("no event mode"), "event mode");
}
