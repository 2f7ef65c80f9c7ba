#pragma once
// Calls at random, in any mode and with any arguments: whatever an FMU refuses leaves it as it was, and whatever it
// answers is finite.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "case.hpp"

/// D. H. Lehmer's generator: the same numbers everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t count) {
    state_ = state_ * 48271 % 2147483647;
    return static_cast<std::size_t>(state_ % count);
  }
  double any() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kValues[] = {
        0,   1e-3, -1e-3, 0.1,    0.5,    -0.7,      1,          -3,
        100, -1e6, 1e300, -1e300, 1e-320, kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
    return kValues[below(sizeof(kValues) / sizeof(kValues[0]))];
  }
  /// Mostly what does not overthrow a model at once.
  double value() { return below(4) == 0 ? any() : 0.02 * (static_cast<double>(below(101)) - 50); }

 private:
  std::uint64_t state_;
};

/// Bytes of the whole run.
template <class Unit>
std::vector<char> bytes_of(Unit& unit) {
  void* state = nullptr;
  std::vector<char> bytes;
  require(unit.save(state) == kOk && unit.serialise(state, bytes) == kOk && unit.forget(state) == kOk, "bytes");
  return bytes;
}

template <class Unit>
struct Attack {
  const Case& c;
  Unit& unit;
  bool is_exchange;
  Dice& dice;
  void* saved = nullptr;
  double t = 0;

  std::vector<unsigned> references() {
    std::vector<unsigned> list(dice.below(4));
    // One in a while is none.
    for (unsigned& one : list) one = static_cast<unsigned>(dice.below(c.description.variables.size() + 1));
    return list;
  }
  Row row(std::size_t size) {
    Row values(size);
    for (double& value : values) value = dice.value();
    return values;
  }
  Row states() {
    Row x(c.description.derivatives.size() + (dice.below(10) == 0 ? 1 : 0));
    if (dice.below(2) == 0) unit.states(x);
    for (double& value : x) value = std::isfinite(value) ? value + 0.01 * dice.value() : 0;
    return x;
  }
  int get() {
    Row values;
    const std::vector<unsigned> list = references();
    const int answer = unit.get(list, values);
    for (std::size_t i = 0; i < list.size() && answer == kOk; ++i)
      require(std::isfinite(values[i]), "\"" + c.description.variables[list[i]].name + "\" is not finite");
    return answer;
  }
  int set() {
    const std::vector<unsigned> list = references();
    return unit.set(list, row(list.size()));
  }
  int step() {
    constexpr double kSizes[] = {1, 1, 1, 2, 3.5, 0.3};
    const double h = c.description.step;
    const double size = dice.below(5) == 0 ? dice.any() * h : h * kSizes[dice.below(6)];
    if (size > 1e3 * h && size < 1e10 * h) return kOk;  // long, and nothing else
    Row now;
    const double point = unit.get({0}, now) == kOk && dice.below(8) > 0 ? now[0] : dice.any();
    return unit.step(point, size);
  }
  int derivatives() {
    Row x(c.description.derivatives.size() + (dice.below(10) == 0 ? 1 : 0));
    const int answer = unit.derivatives(x);
    for (const double value : x) require(answer != kOk || std::isfinite(value), "a rate that is not finite");
    return answer;
  }
  int directional() {
    Row rates;
    const std::vector<unsigned> knowns = references();
    return unit.directional(references(), knowns, row(knowns.size()), rates);
  }
  int restore() { return saved == nullptr ? kOk : unit.restore(saved); }
  int time() {
    Row now;
    const bool goes_on = unit.get({0}, now) == kOk && dice.below(4) > 0;
    return unit.set_time(goes_on ? now[0] + c.description.step : dice.any());
  }
  int call(std::size_t which) {
    bool truth = false;
    switch (which) {
      case 0:
        return unit.setup(dice.below(4) == 0 ? dice.any() : 0, dice.below(2) == 0 ? 0 : dice.any());
      case 1:
        return unit.leave();
      case 2:
        return dice.below(20) == 0 ? unit.terminate() : kOk;
      case 3:
        return dice.below(20) == 0 ? unit.reset() : kOk;
      case 4:
        return unit.enter_event();
      case 5:
        return unit.enter_continuous();
      case 6:
        return unit.update(truth);
      case 7:
        return unit.completed(truth);
      case 8:
        return unit.set_states(states());
      case 9:
        return derivatives();
      case 10:
        return directional();
      case 11:
        return time();
      case 12:
        return unit.save(saved);
      case 13:
        return dice.below(4) == 0 ? restore() : kOk;
      case 14:
      case 15:
        return get();
      case 16:
      case 17:
        return set();
      default:
        return step();
    }
  }
};

/// Result: how many calls were refused.
template <class Unit>
int attack(const Case& c, bool is_exchange, std::uint64_t seed, int calls) {
  Unit unit(c.library, c.description, is_exchange);
  Dice dice(seed);
  Attack<Unit> attack{c, unit, is_exchange, dice};
  int refused = 0;
  if (dice.below(2) == 0) start(unit);
  for (int i = 0; i < calls; ++i) {
    const std::vector<char> before = bytes_of(unit);
    const std::size_t which = dice.below(22);
    const int answer = attack.call(which);
    require(answer >= kOk && answer <= kError, "an answer of the standard");
    if (answer != kDiscard && answer != kError) continue;
    ++refused;
    require(bytes_of(unit) == before, "call " + std::to_string(which) + " is refused with " + std::to_string(answer) +
                                          ", but has changed the unit: " + last_message);
  }
  require(unit.forget(attack.saved) == kOk, "forget");
  return refused;
}

template <class Unit>
void attack_all(const Case& c) {
  int refused = 0;
  constexpr int kRuns = 20, kCalls = 150;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    for (const bool is_exchange : {false, true}) refused += attack<Unit>(c, is_exchange, 7919 * seed, kCalls);
  }
  std::printf("  %d calls at random, %d refused, none of which has changed anything\n", 2 * kRuns * kCalls, refused);
  Unit one(c.library, c.description, false), other(c.library, c.description, false);
  start(one);
  start(other);
  require(bytes_of(one) == bytes_of(other), "the same run has the same bytes");
}

/// The message of a wrong call says what is wrong with it.
template <class Unit>
void name_the_cause(const Case& c) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Unit stepped(c.library, c.description, false), exchanged(c.library, c.description, true);
  start(stepped);
  start(exchanged);
  void *state = nullptr, *foreign = nullptr;
  std::vector<char> bytes;
  require(stepped.save(state) == kOk && stepped.serialise(state, bytes) == kOk, "save");
  require(exchanged.restore(state) == kError && says("none of this instance's"), "a state of another instance");
  require(exchanged.serialise(state, bytes) == kError && exchanged.forget(state) == kError, "nor is it read or freed");
  require(exchanged.save(state) == kError && says("none of this instance's"), "nor written over");
  require(exchanged.deserialise(bytes, foreign) == kError, "no bytes were written");
  require(stepped.serialise(state, bytes) == kOk && exchanged.deserialise(bytes, foreign) == kOk, "bytes of a state");
  require(exchanged.restore(foreign) == kError && says("of the other interface"), "a state of the other interface");
  void* freed = state;
  require(stepped.forget(state) == kOk && stepped.restore(freed) == kError && says("was freed"),
          "a state that was freed");
  // One that is not freed goes with its instance.
  const unsigned output = c.description.outputs[0].reference, known = c.description.states()[0];
  Row rates;
  require(exchanged.directional({0}, {known}, {1}, rates) == kError && says("\"time\" is no unknown"), "an unknown");
  require(exchanged.directional({output}, {output}, {1}, rates) == kError && says("is no known"), "a known");
  require(exchanged.directional({output}, {known}, {kNan}, rates) == kError && says("a finite rate"), "a seed");
  require(exchanged.set_time(kNan) == kError && says("the time must be finite"), "a time");
  Unit timed(c.library, c.description, true);
  const double h = c.description.step;
  require(timed.setup(h, 5 * h) == kOk && timed.leave() == kOk, "a start and a stop");
  require(timed.set_time(0) == kError && says("must not go back beyond the last completed step or event"), "back");
  require(timed.set_time(6 * h) == kError && says("must not be after the stop time"), "beyond the stop time");
  require(timed.set_time(5 * h) == kOk && timed.set_time(h) == kOk, "times that were not accepted may be left again");
  require(exchanged.enter_continuous() == kOk, "continuous time");
  require(
      exchanged.set_states(Row(c.description.derivatives.size(), kNan)) == kDiscard && says("a state is not finite"),
      "states");
  require(stepped.step(0, 1e300) == kError && says("step size must be at most"), "a step that never ends");
  if constexpr (Unit::kVersion == 2)
    require(stepped.set_derivatives({output}, {1}, {1}) == kError && says("is no input"), "a derivative of no input");
}
