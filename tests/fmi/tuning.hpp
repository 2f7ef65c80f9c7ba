#pragma once
// Parameters set between steps, and switches of messages.

#include <cmath>
#include <utility>

#include "case.hpp"

/// Messages of a wrong call and of one that cannot be answered now, with these switches.
template <class Unit>
int told(Unit& unit, int& count) {
  count = 0;
  Row one(1);
  require(unit.get({100000}, one) == kError, "unknown reference");
  return count;
}

/// FMI 3 switches a category by itself, FMI 2 tells those that are named alone; all of them where none is named.
template <class Unit>
void switch_messages(const Case& c, int& count) {
  Unit unit(c.library, c.description, false);
  start(unit);
  const char *discards = "logStatusDiscard", *errors = "logStatusError";
  require(told(unit, count) == 1, "messages from the start");
  const int kept = Unit::kVersion == 2 ? 0 : 1;  // off is off
  require(unit.log(false, {discards}) == kOk && told(unit, count) == kept, "the other category");
  require(unit.log(false, {errors}) == kOk && told(unit, count) == 0, "a category that is off");
  require(unit.log(true, {discards}) == kOk && told(unit, count) == 0, "the other category is still off");
  require(unit.log(true, {errors}) == kOk && told(unit, count) == 1, "a category that is on again");
  const int left = Unit::kVersion == 2 ? 0 : 1;
  require(unit.log(true, {discards}) == kOk && told(unit, count) == left, "one that is on, and the other");
  require(unit.log(false, {"logStatusWarning"}) == kOk && unit.log(false, {"none"}) == kError, "names of categories");
  require(unit.log(false, {}) == kOk && told(unit, count) == 0, "all off");
  require(unit.log(true, {}) == kOk && told(unit, count) == 1, "all on");
}

/// Lengths and places set between steps: the loop is closed with them, and what cannot be closed is refused. Of the
/// model tuned_rod.
template <class Unit>
void tune_lengths(const Case& c) {
  const unsigned length = c.description.reference("length"), reach = c.description.reference("reach"),
                 gauge = c.description.reference("gauge");
  unsigned independent = 0;
  for (const Variable& variable : c.description.variables) {
    if (variable.name.rfind("z.", 0) == 0 && variable.initial == "exact") independent = variable.reference;
  }
  Unit unit(c.library, c.description, false);
  start(unit);
  const double h = c.description.step;
  const auto misfit = [&] { return std::abs(values(unit, {gauge})[0] - values(unit, {length})[0]); };
  require(unit.step(0, h) == kOk && misfit() < 1e-9, "a closed loop");
  int steps = 1;
  for (const auto& [parameter, value] : {std::pair{length, 0.45}, {reach, 0.34}, {length, 0.52}}) {
    const double before = values(unit, {independent})[0];
    require(unit.set({parameter}, {value}) == kOk && misfit() < 1e-9, "the loop closes at once");
    require(std::abs(values(unit, {independent})[0] - before) < 1e-9, "independent coordinates stay");
    require(unit.step(steps++ * h, h) == kOk && misfit() < 1e-9, "and after the next step");
  }
  const Row before = values(unit, {independent});
  require(unit.set({length}, {5.0}) == kOk, "a rod that is too long");
  Row out;
  require(unit.step(steps * h, h) == kDiscard && unit.get({gauge}, out) == kDiscard, "is refused");
  require(unit.set({length}, {0.52}) == kOk && same_bits(values(unit, {independent}), before), "nothing has moved");
  require(unit.step(steps * h, h) == kOk && misfit() < 1e-9, "and the run goes on");

  Unit other(c.library, c.description, true);
  start(other);
  bool has_changed = true;
  require(other.set({length}, {0.45}) == kOk && other.update(has_changed) == kOk && !has_changed, "an event");
  require(other.enter_continuous() == kOk, "continuous time");
  require(std::abs(values(other, {gauge})[0] - 0.45) < 1e-9, "model exchange closes the loop, too");
}

/// Tunable parameters and inputs matter, and a parameter set between steps acts from then on.
template <class Unit>
void tune(const Case& c) {
  Unit unit(c.library, c.description, false);
  start(unit);
  run_on(c, unit, 0, 2);
  int tuned = 0;
  for (const Variable& variable : c.description.variables) {
    if (variable.variability != "tunable") continue;
    void* state = nullptr;
    require(unit.save(state) == kOk, "save");
    const double value = values(unit, {variable.reference})[0];
    require(unit.set({variable.reference}, {1.1 * value}) == kOk, "set " + variable.name);
    require(!same_bits(run_on(c, unit, 2, 1)[0], c.table.rows[3]), variable.name + " matters");
    require(unit.restore(state) == kOk && values(unit, {variable.reference})[0] == value, "parameter after a rollback");
    require(same_bits(run_on(c, unit, 2, 1)[0], c.table.rows[3]), "bits after a rollback");
    require(unit.restore(state) == kOk && unit.forget(state) == kOk, "forget");
    ++tuned;
  }
  std::printf("  %d tunable parameters\n", tuned);
}
