#pragma once
// Sampled values, of the model sampled_slide: at communication steps that no period is a multiple of, and at the time
// events of model exchange, against the difference equation of controller and held plant (the inverse z-transform).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "case.hpp"

/// The slide under its controller. The force holds between instants, so that the way is a parabola.
class SampledSlide {
 public:
  /// position, velocity, force, seen: before the values of this time are set.
  std::array<double, 4> at(double time) {
    while (next() < time - kSame) {
      pass(next());
      set();
    }
    pass(time);
    return {z_, v_, force_, seen_};
  }

 private:
  static constexpr double kSame = 1e-9;
  double next() const { return std::min(0.01 * controls_, 0.015 * sights_); }
  void pass(double time) {
    const double dt = time - t_, a = force_ / 2;
    z_ += v_ * dt + a * dt * dt / 2;
    v_ += a * dt;
    t_ = time;
  }
  void set() {
    if (std::abs(t_ - 0.01 * controls_) < kSame) {
      const double error = 1 - z_;
      sum_ += 0.01 * error;
      force_ = waiting_;
      waiting_ = 60 * error + 20 * sum_ + 18 * (error - last_) / 0.01;
      last_ = error;
      ++controls_;
    }
    if (std::abs(t_ - 0.015 * sights_) < kSame) {
      seen_ = z_ + t_;
      ++sights_;
    }
  }
  double t_ = 0, z_ = 0, v_ = 0, force_ = 3, waiting_ = 3, sum_ = 0, last_ = 0, seen_ = 0;
  int controls_ = 0, sights_ = 0;
};

inline std::vector<unsigned> sampled_columns(const Case& c) {
  std::vector<unsigned> columns;
  for (const char* name : {"z.slide", "zd.slide", "x.force", "x.seen"})
    columns.push_back(c.description.reference(name));
  return columns;
}

inline void require_sampled(const Row& got, SampledSlide& slide, double t) {
  const std::array<double, 4> expected = slide.at(t);
  for (std::size_t k = 0; k < expected.size(); ++k)
    require(std::abs(got[k] - expected[k]) < 1e-9 * (1 + std::abs(expected[k])), "sampled at " + std::to_string(t));
}

/// Communication steps cut at the instants; inner points are shown to importers of FMI 3 as others are.
template <class Unit>
void communicate_sampled(const Case& c) {
  for (const double size : {0.0037, 0.017, 0.05}) {
    Unit unit(c.library, c.description, false);
    start(unit);
    SampledSlide slide;
    for (int i = 0; i * size < 0.6; ++i) {
      require_sampled(values(unit, sampled_columns(c)), slide, i * size);
      require(unit.step(i * size, size) == kOk, "a step over instants");
    }
  }
}

/// Model exchange by the importer's own steps, which end at events: the Runge-Kutta method is exact on a parabola.
template <class Unit>
void meet_sampled(const Case& c) {
  Unit unit(c.library, c.description, true);
  start(unit);
  const unsigned force = c.description.reference("x.force");
  require(c.description.variables[force].variability == "discrete", "variability of a sampled value");
  SampledSlide slide;
  Row x(2), rates(2);
  double t = 0;
  int met = 0;
  bool has_changed = false, asks = false;
  require(unit.update(has_changed) == kOk && !has_changed && unit.next_event == 0.01, "the first instant, t = 0");
  require(unit.enter_continuous() == kOk && unit.states(x) == kOk && unit.derivatives(rates) == kOk, "states");
  require(unit.set({force}, {1.0}) == kError, "a sampled value is set by its own clock");
  while (t < 0.6) {
    const double h = std::min(0.0043, unit.next_event - t);
    t = h < 0.0043 ? unit.next_event : t + h;
    // Kept from step to step: a parabola has one acceleration until an event says that values have changed.
    if (has_changed) require(unit.derivatives(rates) == kOk, "derivatives");
    x[0] += h * (x[1] + h * rates[1] / 2);
    x[1] += h * rates[1];
    require(unit.set_time(t) == kOk && unit.set_states(x) == kOk && unit.completed(asks) == kOk, "a completed step");
    require(asks == (t == unit.next_event), "events at instants, and nowhere else");
    require_sampled(values(unit, sampled_columns(c)), slide, t);
    if (!asks) continue;
    ++met;
    const double force_before = values(unit, {force})[0];
    require(unit.enter_event() == kOk && unit.update(has_changed) == kOk, "an instant");
    require(has_changed == (values(unit, {force})[0] != force_before), "a jump of what acts on rates is said");
    const double next = unit.next_event;
    bool again = true;
    require(next > t && unit.update(again) == kOk && !again && unit.next_event == next, "an instant is passed once");
    require(unit.enter_continuous() == kOk, "continuous time");
  }
  require(met == 80, "60 instants of the one and 40 of the other, of which 20 are the same");
  require(unit.set_time(unit.next_event + 1e-3) == kOk && unit.completed(asks) == kError &&
              says("must not go beyond the next event"),
          "an instant that an importer leaves out");
}

/// Starting values of sampled values hold until the first instant; instants are those of the time, whatever it starts
/// at.
template <class Unit>
void start_between_instants(const Case& c) {
  Unit unit(c.library, c.description, false);
  const std::vector<unsigned> columns = sampled_columns(c);
  require(unit.setup(0.004, 0) == kOk && unit.set({columns[2]}, {5.0}) == kOk && unit.leave() == kOk, "a late start");
  require(unit.step(0.004, 0.006) == kOk, "up to the first instant");
  Row row = values(unit, columns);
  const double z = 5.0 / 4 * 0.006 * 0.006;
  require(std::abs(row[0] - z) < 1e-14 && row[2] == 5 && row[3] == 0, "what holds before the first instant");
  require(unit.step(0.01, 0.007) == kOk, "over two instants");
  row = values(unit, columns);
  const double seen = z + 5 * 0.006 / 2 * 0.005 + 3.0 / 4 * 0.005 * 0.005 + 0.015;
  require(row[2] == 3 && std::abs(row[3] - seen) < 1e-12, "what was set at 10 ms and at 15 ms");
}
