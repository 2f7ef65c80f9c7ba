// A small importer: loads an FMU and drives it through its whole life, both interfaces, with rollback and wrong calls.
// Co-simulation must give the bits of `mbgen simulate`, model exchange its accuracy.
//   importer 2|3 LIBRARY modelDescription.xml TABLE.csv [NAME=VALUE], a parameter that the table was made with

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include "adaptive.hpp"
#include "adversary.hpp"
#include "braking.hpp"
#include "case.hpp"
#include "driving.hpp"
#include "fmi2_unit.hpp"
#include "fmi3_unit.hpp"
#include "habits.hpp"
#include "sampling.hpp"
#include "tuning.hpp"
#include "turning.hpp"
#include "weighing.hpp"

namespace {

/// Every row of the table by steps of `stride` rows; memory from the importer or not.
template <class Unit>
void co_simulate(const Case& c, std::size_t stride, bool gives_memory) {
  Unit unit(c.library, c.description, false, gives_memory);
  if (!c.set.empty()) require(unit.set({c.description.reference(c.set)}, {c.value}) == kOk, "set " + c.set);
  start(unit);
  const double h = c.description.step;
  for (std::size_t i = 0;; i += stride) {
    require(same_row(c, values(unit, c.columns), c.table.rows[i]), "bits of row " + std::to_string(i));
    if (i + stride >= c.table.rows.size()) break;
    require(unit.step(static_cast<double>(i) * h, static_cast<double>(stride) * h) == kOk, "step");
  }
  require(unit.terminate() == kOk && values(unit, c.columns).size() == c.columns.size(), "values after the end");
  require(unit.reset() == kOk, "reset");
  if (!c.set.empty()) return;
  start(unit);
  require(same_bits(values(unit, c.columns), c.table.rows[0]), "bits after a reset");
}

template <class Unit>
void roll_back(const Case& c) {
  Unit unit(c.library, c.description, false), other(c.library, c.description, false);
  start(unit);
  run_on(c, unit, 0, 3);
  void* state = nullptr;
  std::vector<char> bytes;
  require(unit.save(state) == kOk && unit.serialise(state, bytes) == kOk, "save");
  const std::vector<Row> first = run_on(c, unit, 3, 5);
  require(unit.restore(state) == kOk, "restore");
  const std::vector<Row> second = run_on(c, unit, 3, 5);
  void* copy = nullptr;
  require(other.deserialise(bytes, copy) == kOk && other.restore(copy) == kOk, "restore from bytes");
  const std::vector<Row> third = run_on(c, other, 3, 5);
  for (std::size_t i = 0; i < first.size(); ++i)
    require(same_bits(first[i], second[i]) && same_bits(first[i], third[i]), "bits after a rollback");
  bytes[0] ^= 1;
  void* broken = nullptr;
  require(other.deserialise(bytes, broken) == kError && broken == nullptr && says("another FMU"),
          "foreign bytes are refused");
  bytes[0] ^= 1;
  bytes[bytes.size() / 2] ^= 4;
  require(other.deserialise(bytes, broken) == kError && broken == nullptr && says("damaged"),
          "damaged bytes are refused");
  require(unit.forget(state) == kOk && state == nullptr && other.forget(copy) == kOk, "forget");
}

/// Events that FMUs have asked for.
int events = 0;

/// The classical Runge-Kutta method of an importer, with the same step as the solver's.
template <class Unit>
void integrate(const Case& c, Unit& unit, double t, double h, Row& x) {
  const auto rates = [&](double time, const Row& at) {
    Row result(x.size());
    require(unit.set_time(time) == kOk && unit.set_states(at) == kOk && unit.derivatives(result) == kOk, "derivatives");
    return result;
  };
  const auto moved = [&](const Row& by, double weight) {
    Row at = x;
    for (std::size_t i = 0; i < at.size(); ++i) at[i] += weight * by[i];
    return at;
  };
  const Row a = rates(t, x), b = rates(t + h / 2, moved(a, h / 2)), d = rates(t + h / 2, moved(b, h / 2)),
            e = rates(t + h, moved(d, h));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * d[i] + e[i]);
  require(unit.set_time(t + h) == kOk && unit.set_states(x) == kOk, "states");
  bool event = false;
  require(unit.completed(event) == kOk, "completed step");
  if (!event) return;
  const bool has_changed = go_through_event(c, unit, x);
  require(has_changed || unit.next_event < HUGE_VAL, "an event that is asked for changes states, or is an instant");
  events += has_changed && unit.next_event == HUGE_VAL ? 1 : 0;
}

template <class Unit>
void exchange(const Case& c) {
  Unit unit(c.library, c.description, true);
  start(unit);
  bool has_changed = true;
  require(unit.update(has_changed) == kOk && unit.enter_continuous() == kOk, "continuous time");
  require(!has_changed || unit.next_event < HUGE_VAL, "nothing changes at the start but by sampled values");
  Row x(c.description.derivatives.size());
  require(unit.states(x) == kOk, "states");
  require(same_bits(x, values(unit, c.description.states())), "states are the variables that the derivatives name");
  Row rates(x.size());
  std::vector<unsigned> references;
  for (const Unknown& unknown : c.description.derivatives) references.push_back(unknown.reference);
  require(unit.derivatives(rates) == kOk && same_bits(rates, values(unit, references)), "derivatives are variables");
  require(unit.set(c.description.states(), x) == kOk, "states are set as variables, too");
  require(unit.enter_event() == kOk, "event mode");
  require(unit.set(c.description.states(), x) == (Unit::kVersion == 2 ? kError : kOk), "states are set at an event");
  require(unit.update(has_changed) == kOk && !has_changed && unit.enter_continuous() == kOk, "back from the event");
  events = 0;
  void* state = nullptr;
  const bool is_timed = unit.next_event < HUGE_VAL;  // a row at an instant has what held before
  const std::size_t steps = std::min<std::size_t>(c.table.rows.size() - 1, 200) - (is_timed ? 1 : 0);
  const double h = c.description.step;
  Row kept;
  for (std::size_t i = 0; i < steps; ++i) {
    if (i == steps / 2) {
      require(unit.save(state) == kOk, "save");
      kept = x;
    }
    integrate(c, unit, static_cast<double>(i) * h, h, x);
  }
  const Row end = values(unit, c.columns), last = x;
  for (std::size_t k = 0; k < end.size(); ++k) {
    double scale = 1e-3;
    for (const Row& row : c.table.rows) scale = std::max(scale, std::abs(row[k]));
    require(std::abs(end[k] - c.table.rows[steps][k]) < 1e-5 * scale, "accuracy of " + c.table.names[k]);
  }
  require(unit.restore(state) == kOk && unit.states(x) == kOk && same_bits(x, kept), "states after a rollback");
  for (std::size_t i = steps / 2; i < steps; ++i) integrate(c, unit, static_cast<double>(i) * h, h, x);
  require(same_bits(x, last) && same_bits(end, values(unit, c.columns)), "bits after a rollback");
  require(unit.forget(state) == kOk && unit.terminate() == kOk, "end");
  // Changes of charts in the second half are met twice.
  require(events <= (changes_charts(c) ? 3 : 2), "events without need");
}

/// Directional derivatives against central differences of the FMU itself; what is no dependency must not matter.
template <class Unit>
void differentiate(const Case& c) {
  Unit unit(c.library, c.description, true);
  start(unit);
  bool has_changed = false;
  require(unit.update(has_changed) == kOk && unit.enter_continuous() == kOk, "continuous time");
  const std::vector<unsigned> states = c.description.states();
  Row x(states.size());
  require(unit.states(x) == kOk, "states");
  // Away from the start, where much is zero.
  for (int i = 0; i < 20; ++i) integrate(c, unit, i * c.description.step, c.description.step, x);
  const Knowns given = knowns_of(c.description, Unit::kVersion == 3);
  const std::vector<unsigned>& knowns = given.all;
  const auto set = [&](std::size_t k, double value) {
    Row y = x;
    if (k < states.size()) {
      y[k] = value;
      require(unit.set_states(y) == kOk, "states");
      return;
    }
    const bool is_tuned = given.parameters.count(knowns[k]) != 0;
    require(!is_tuned || unit.enter_event() == kOk, "event mode");
    require(unit.set({knowns[k]}, {value}) == kOk, "a known");
    require(!is_tuned || unit.enter_continuous() == kOk, "continuous time");
  };
  const std::vector<Unknown> all = unknowns_of(c.description);
  const std::vector<unsigned> unknowns = references_of(all);
  const Row here = values(unit, unknowns);
  int zeros = 0, others = 0;
  weigh_unknowns(unit, unknowns, knowns);
  for (std::size_t k = 0; k < knowns.size(); ++k) {
    Row rates, at[2];
    last_message.clear();
    require(unit.directional(unknowns, {knowns[k]}, {1.0}, rates) == kOk, "directional derivative");
    require(last_message.empty(), "a derivative that exists is told about: " + last_message);
    const double value = values(unit, {knowns[k]})[0], delta = 1e-6 * std::max(1.0, std::abs(value));
    for (int side = 0; side < 2; ++side) {
      set(k, value + (side == 0 ? -delta : delta));
      at[side] = values(unit, unknowns);
    }
    set(k, value);
    for (std::size_t u = 0; u < all.size(); ++u) {
      const double difference = (at[1][u] - at[0][u]) / (2 * delta);
      const std::string what =
          c.description.variables[unknowns[u]].name + " by " + c.description.variables[knowns[k]].name;
      if (all[u].dependencies.count(knowns[k]) == 0) {
        ++zeros;
        // The closures are solved to 1e-12 from another guess: that is all that may differ.
        require(rates[u] == 0 && std::abs(at[1][u] - at[0][u]) <= 1e-8 * (1 + std::abs(here[u])),
                "no dependency: " + what);
      } else {
        ++others;
        const double rounding = 1e-13 * (1 + std::abs(here[u])) / delta;
        require(std::abs(rates[u] - difference) <= 2e-4 * (std::abs(rates[u]) + std::abs(difference)) + 1e3 * rounding,
                what + ": " + std::to_string(rates[u]) + ", by differences " + std::to_string(difference));
      }
    }
  }
  std::printf("  %d derivatives equal differences, %d are zero as the dependencies say\n", others, zeros);
}

/// Calls out of order, with wrong arguments or of the other interface: each is refused and changes nothing.
template <class Unit>
void call_wrongly(const Case& c) {
  Unit unit(c.library, c.description, false);
  Row one(1), x(c.description.derivatives.size());
  const double h = c.description.step, nan = std::numeric_limits<double>::quiet_NaN();
  const unsigned output = c.description.outputs[0].reference;
  require(unit.get({output}, one) == kError, "get before the initialisation");
  require(unit.get(c.description.states(), x) == (Unit::kVersion == 2 ? kError : kOk), "start values");
  require(unit.step(0, h) == kError, "step before the initialisation");
  require(unit.leave() == kError && unit.terminate() == kError, "end of what has not begun");
  require(unit.setup(nan, 0) == kError, "start at NaN");
  require(unit.setup(0, 5 * h) == kOk, "setup");
  require(unit.setup(0, 5 * h) == kError, "setup twice");
  require(unit.leave() == kOk, "end of the initialisation");
  require(unit.set({output}, {1.0}) == kError && says(c.description.variables[output].name + "\" is computed"),
          "set an output");
  require(unit.get({100000}, one) == kError && says("100000 does not exist"), "unknown reference");
  require(unit.step(0, -h) == kError && unit.step(0, 0) == kError && unit.step(0, nan) == kError, "step sizes");
  require(unit.step(3 * h, h) == kError && says("communication point"), "another communication point");
  require(unit.step(0.5 * h, h) == kError && unit.step(0.4 * h, h) == kError, "half a step off");
  require(unit.step(0, 6 * h) == kError, "beyond the stop time");
  require(unit.set_time(1) == kError && unit.set_states(x) == kError && unit.derivatives(x) == kError &&
              unit.enter_event() == kError && unit.enter_continuous() == kError,
          "functions of the other interface");
  require(unit.restore(nullptr) == kError, "no state");
  unit.refusals();
  require(unit.instantiate_with("another") == nullptr, "another token");
  for (const Variable& variable : c.description.variables) {
    if (variable.causality == "input" || variable.causality == "parameter")
      require(unit.set({variable.reference}, {nan}) == kError, "NaN");
  }
  require(same_bits(values(unit, c.columns), c.table.rows[0]), "wrong calls have changed nothing");
  require(unit.step(0, h) == kOk && same_bits(values(unit, c.columns), c.table.rows[1]), "and the run goes on");

  Unit other(c.library, c.description, true);
  require(other.setup(0, 0) == kOk && other.set_states(x) == kError, "states during the initialisation");
  require(other.leave() == kOk && other.step(0, h) == kError && other.set_states(x) == kError, "states in event mode");
  require(other.enter_continuous() == kOk && other.enter_continuous() == kError, "continuous time twice");
  x.assign(x.size() + 1, 0);
  require(other.derivatives(x) == kError && other.states(x) != kOk, "number of states");
}

/// Nominal values of the states are those of the description, and sizes.
template <class Unit>
void weigh(const Case& c) {
  Unit unit(c.library, c.description, true);
  start(unit);
  const std::vector<unsigned> states = c.description.states();
  std::vector<double> nominals(states.size());
  require(unit.nominals(nominals) == kOk, "nominal values");
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Variable& state = c.description.variables[states[i]];
    require(nominals[i] > 0 && nominals[i] == state.nominal, "the nominal value of " + state.name);
  }
}

/// As many instances as memory has room for, each with a state of its own.
template <class Unit>
void crowd(const Case& c) {
  std::vector<std::unique_ptr<Unit>> units;
  for (int i = 0; i < 100; ++i) {
    units.push_back(std::make_unique<Unit>(c.library, c.description, false, false));
    start(*units.back());
  }
  require(units[0]->step(0, c.description.step) == kOk, "step");
  require(same_bits(values(*units[0], c.columns), c.table.rows[1]), "bits of the first instance");
  require(same_bits(values(*units[99], c.columns), c.table.rows[0]), "bits of the last instance");
}

/// Values out of their range, and parameters of the start once it is over, are refused by name.
template <class Unit>
void exceed(const Case& c) {
  Unit unit(c.library, c.description, false);
  for (const Variable& variable : c.description.variables) {
    if (!variable.has_range) continue;
    require(unit.set({variable.reference}, {1e9}) == kError && says("\"" + variable.name + "\" must be at most"),
            variable.name + " out of its range");
  }
  start(unit);
  for (const Variable& variable : c.description.variables) {
    if (variable.variability != "fixed") continue;
    const double value = values(unit, {variable.reference})[0];
    require(unit.set({variable.reference}, {value}) == kError && says(variable.name + "\" cannot be set in"),
            variable.name + " after the start");
  }
}

/// Bodies that roll have no states that an importer may integrate: the other interface and derivatives are refused.
template <class Unit>
void drive_alone(const Case& c) {
  co_simulate<Unit>(c, 1, true);
  co_simulate<Unit>(c, 3, false);
  roll_back<Unit>(c);
  tune<Unit>(c);
  crowd<Unit>(c);
  exceed<Unit>(c);
  bool is_refused = false;
  try {
    const Unit exchanged(c.library, c.description, true);
  } catch (const std::exception&) {
    is_refused = says("co-simulation alone");
  }
  require(is_refused, "model exchange is refused");
  Unit unit(c.library, c.description, false);
  start(unit);
  Row rates;
  const unsigned output = c.description.outputs[0].reference;
  require(unit.directional({output}, {output}, {1.0}, rates) == kError && says("no directional derivatives"),
          "directional derivatives are refused");
}

template <class Unit>
void drive(const Case& c) {
  if (c.description.derivatives.empty()) return drive_alone<Unit>(c);
  // Differences would bend its bristle beyond a limit of 0.
  if (c.description.identifier == "flywheel") return brake_by_derivatives<Unit>(c);
  if (c.description.identifier == "rotor") {
    turn_inside<Unit>(c);
    turn_outside<Unit>(c);
    return;
  }
  co_simulate<Unit>(c, 1, true);
  co_simulate<Unit>(c, 3, false);
  roll_back<Unit>(c);
  exchange<Unit>(c);
  differentiate<Unit>(c);
  call_wrongly<Unit>(c);
  tune<Unit>(c);
  weigh<Unit>(c);
  crowd<Unit>(c);
  exceed<Unit>(c);
  switch_messages<Unit>(c, Unit::kVersion == 2 ? messages : messages_3);
  if (c.description.identifier == "tuned_rod") tune_lengths<Unit>(c);
  if (c.description.identifier == "driven_cart") {
    drive_by_inputs<Unit>(c);
    warn_of_rates<Unit>(c);
    warn_of_contradictions<Unit>(c);
  }
  if (c.description.identifier == "sampled_slide") {
    communicate_sampled<Unit>(c);
    meet_sampled<Unit>(c);
    start_between_instants<Unit>(c);
  }
  if constexpr (Unit::kVersion == 3) update_between<Unit>(c);
  attack_all<Unit>(c);
  name_the_cause<Unit>(c);
  if (c.description.identifier == "rod_ball") {
    pass_poles_at_output_points<Unit>(c);
    pass_poles_blindly<Unit>(c);
  }
  if (c.description.identifier == "triple_rocker") {
    pass_dead_points<Unit>(c);
    pass_at_output_points<Unit>(c);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) return 2;
  try {
    const Library library(arguments[2]);
    const Description description = read_description(arguments[3]);
    const Table table = read_table(arguments[4]);
    Case c{library, description, table, {}};
    for (const std::string& name : table.names) c.columns.push_back(description.output(name));
    const bool is_two = std::string(arguments[1]) == "2";
    if (count > 5) {
      const std::string text = arguments[5];
      c.set = text.substr(0, text.find('='));
      c.value = std::strtod(text.c_str() + text.find('=') + 1, nullptr);
      is_two ? co_simulate<Unit2>(c, 1, true) : co_simulate<Unit3>(c, 1, true);
    } else {
      is_two ? drive<Unit2>(c) : drive<Unit3>(c);
    }
  } catch (const std::exception& error) {
    std::printf("importer: %s: %s\n", arguments[2], error.what());
    return 1;
  }
  std::printf("  FMI %s: %d checks passed\n", arguments[1], checks);
}
