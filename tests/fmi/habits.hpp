#pragma once
// Habits of importers: steps are completed at output points alone, events are found by the signs of indicators or not
// at all, any status above OK ends a run, rates are kept until an event says that values have changed.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "adaptive.hpp"
#include "rod_ball.hpp"

/// The pair of Dormand and Prince between output points, where alone steps are completed. Events are those of
/// indicators, which are looked for by halves of the step, and those that completed steps ask for.
template <class Unit>
class OutputPoints {
 public:
  OutputPoints(const Case& of, double tolerance)
      : c_(of), unit_(of.library, of.description, true), tolerance_(tolerance), x_(of.description.derivatives.size()) {
    start(unit_);
    bool has_changed = false;
    require(unit_.update(has_changed) == kOk && unit_.enter_continuous() == kOk, "continuous time");
    require(unit_.states(x_) == kOk, "states");
    h_ = of.description.step;
  }

  /// Error: over the range of each column, at the end of the table.
  Work run(double width) {
    run_to(c_.description.step * static_cast<double>(c_.table.rows.size() - 1), width, [](int) {});
    const Row got = values(unit_, c_.columns);
    for (std::size_t k = 0; k < got.size(); ++k) {
      double range = 1e-3;
      for (const Row& row : c_.table.rows) range = std::max(range, std::abs(row[k]));
      work_.error = std::max(work_.error, std::abs(got[k] - c_.table.rows.back()[k]) / range);
    }
    return work_;
  }

  /// at_point: called at every output point, with its number from 1 on.
  Work run_to(double end, double width, const std::function<void(int)>& at_point) {
    const int points = static_cast<int>(std::lround(end / width));
    for (int i = 1; i <= points; ++i) {
      go_to(i * width);
      bool asks = false;
      require(unit_.set_time(t_) == kOk && unit_.set_states(x_) == kOk && unit_.completed(asks) == kOk,
              "a step completed at an output point");
      if (asks) pass_event();
      at_point(i);
    }
    return work_;
  }

  Unit& unit() { return unit_; }

 private:
  Row indicators(double t, const Row& x) {
    Row z(c_.description.indicators);
    require(unit_.set_time(t) == kOk && unit_.set_states(x) == kOk && unit_.indicators(z) == kOk,
            "indicators have values wherever they are asked for");
    return z;
  }
  static bool cross(const Row& from, const Row& to) {
    for (std::size_t i = 0; i < from.size(); ++i)
      if ((from[i] < 0) != (to[i] < 0)) return true;
    return false;
  }
  void go_to(double end) {
    while (t_ < end) {
      const double size = std::min(h_, end - t_);
      Row next;
      double error = 0;
      const bool has_values = try_step(unit_, t_, size, x_, tolerance_, work_, next, error);
      if (!has_values || error > 1) {
        ++work_.rejected;
        h_ = size * (has_values ? std::max(0.2, 0.9 * std::pow(error, -0.2)) : 0.25);
        require(h_ > 1e-12, "a step that can be made");
        continue;
      }
      const Row before = indicators(t_, x_);
      ++work_.steps;
      if (!cross(before, indicators(t_ + size, next))) {
        t_ = end - t_ - size < 1e-12 ? end : t_ + size;
        x_ = next;
        h_ = size * std::min(5.0, 0.9 * std::pow(std::max(error, 1e-5), -0.2));
        continue;
      }
      double least = 0, most = size;
      while (most - least > 1e-9) {
        const double middle = (least + most) / 2;
        if (try_step(unit_, t_, middle, x_, tolerance_, work_, next, error) &&
            !cross(before, indicators(t_ + middle, next))) {
          least = middle;
        } else {
          most = middle;
        }
      }
      require(try_step(unit_, t_, most, x_, tolerance_, work_, next, error), "the place of an event");
      x_ = next;
      t_ += most;
      require(unit_.set_time(t_) == kOk && unit_.set_states(x_) == kOk, "states");
      pass_event();
    }
  }
  void pass_event() {
    ++work_.events;
    require(go_through_event(c_, unit_, x_), "an event changes states");
  }

  const Case& c_;
  Unit unit_;
  double tolerance_, t_ = 0, h_ = 0;
  Row x_;
  Work work_;
};

/// How a run by Runge-Kutta steps ends, completed one by one or at output points alone, without a look at indicators.
struct Ending {
  double time = 0;    ///< s, of the last step that was completed
  double drift = 0;   ///< largest of the energy until then, over the kinetic energy at the start
  bool ended = true;  ///< whether the last answer was above OK
};

/// at_point: called where a step was completed, with the unit and the number of steps.
template <class Unit>
Ending step_blindly(
    const Case& c, double end, double h, int steps_a_point, bool takes_events,
    const std::function<void(Unit&, int)>& at_point = [](Unit&, int) {}) {
  Unit unit(c.library, c.description, true);
  start(unit);
  require(unit.enter_continuous() == kOk, "continuous time");
  const std::vector<unsigned> energies = {c.description.reference("energy.kinetic"),
                                          c.description.reference("energy.potential")};
  const Row first = values(unit, energies);
  Row x(c.description.derivatives.size()), at, rates[4];
  require(unit.states(x) == kOk, "states");
  Ending ending;
  const double part[] = {0, 0.5, 0.5, 1};
  for (int i = 0; (i + 1) * h <= end * (1 + 1e-12); ++i) {
    for (int stage = 0; stage < 4; ++stage) {
      at = x;
      for (std::size_t k = 0; k < x.size() && stage > 0; ++k) at[k] += part[stage] * h * rates[stage - 1][k];
      rates[stage].resize(x.size());
      if (unit.set_time((i + part[stage]) * h) != kOk || unit.set_states(at) != kOk ||
          unit.derivatives(rates[stage]) != kOk)
        return ending;
    }
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] += h / 6 * (rates[0][k] + 2 * rates[1][k] + 2 * rates[2][k] + rates[3][k]);
    bool asks = false;
    if (unit.set_time((i + 1) * h) != kOk || unit.set_states(x) != kOk) return ending;
    if ((i + 1) % steps_a_point == 0) {
      if (unit.completed(asks) != kOk) return ending;
      if (asks && takes_events) go_through_event(c, unit, x);
      const Row energy = values(unit, energies);
      ending.drift = std::max(ending.drift, std::abs(energy[0] + energy[1] - first[0] - first[1]) / first[0]);
      ending.time = (i + 1) * h;
      at_point(unit, i + 1);
    }
  }
  ending.ended = false;
  return ending;
}

/// The message of a way that was lost at this indicator.
inline std::string lost_way(const std::string& indicator) {
  return "\"" + indicator +
         "\" has fallen too far in this step: the loop may have passed a dead point of its states; take a smaller "
         "step, "
         "up to the event";
}

/// How far the tip of rod_ball, in m, and the sine of its second angle are from the motion by other equations.
template <class Unit>
double distance_from(const Case& c, Unit& unit, const std::array<double, 4>& row) {
  const Row got = values(unit, {c.description.output("x"), c.description.output("y"), c.description.output("z"),
                                c.description.output("pitch")});
  double distance = std::abs(std::sin(got[3]) - row[3]);
  for (int k = 0; k < 3; ++k) distance = std::max(distance, std::abs(got[k] - row[k]));
  return distance;
}

constexpr double kRodBallEnd = 3, kRodBallRow = 0.01;  // s

/// Rows of rod_ball from the start velocities that the unit has.
template <class Unit>
std::vector<std::array<double, 4>> rod_ball_rows(const Case& c) {
  Unit unit(c.library, c.description, true);
  start(unit);
  const Row rate = values(unit, {c.description.reference("zd.ball_rx"), c.description.reference("zd.ball_ry"),
                                 c.description.reference("zd.ball_rz")});
  return rod_ball::rows({rate[0], rate[1], rate[2]}, kRodBallRow, 300);
}

/// Poles of balls and dead points of their loop at large output steps. Of the model rod_ball, whose ball goes by its
/// pole once at 1570 rad/s of an angle.
template <class Unit>
void pass_poles_at_output_points(const Case& c) {
  const std::vector<std::array<double, 4>> rows = rod_ball_rows<Unit>(c);
  for (const double tolerance : {1e-6, 1e-7, 1e-8}) {
    for (const double width : {0.01, 0.05, 0.1}) {
      OutputPoints<Unit> importer(c, tolerance);
      double distance = 0;
      const Work work = importer.run_to(kRodBallEnd, width, [&](int point) {
        const auto row = static_cast<std::size_t>(std::lround(point * width / kRodBallRow));
        distance = std::max(distance, distance_from(c, importer.unit(), rows[row]));
      });
      std::printf("  output each %g s, tolerance %g: %d steps, %d rejected, %d evaluations, %d events, off by %.1e m\n",
                  width, tolerance, work.steps, work.rejected, work.evaluations, work.events, distance);
      require(work.events >= 30 && distance < 1e-5 + 2e4 * tolerance, "poles between output points");
    }
  }
}

/// The same by fixed steps of an importer that looks for nothing: the way is kept, or its loss is said.
template <class Unit>
void pass_poles_blindly(const Case& c) {
  const std::vector<std::array<double, 4>> rows = rod_ball_rows<Unit>(c);
  bool is_said = false;
  for (const double h : {5e-4, 1e-3, 2e-3, 5e-3}) {
    for (const int steps : {1, 5, 20}) {
      for (const bool takes_events : {true, false}) {
        double distance = 0;
        const Ending ending = step_blindly<Unit>(c, kRodBallEnd, h, steps, takes_events, [&](Unit& unit, int step) {
          const double row = step * h / kRodBallRow;
          if (std::abs(row - std::round(row)) > 1e-6) return;
          distance = std::max(distance, distance_from(c, unit, rows[static_cast<std::size_t>(std::lround(row))]));
        });
        std::printf("  Runge-Kutta, %g s, completed every %d, %s events: %s at %.3f s, energy %.1e, off by %.1e m\n", h,
                    steps, takes_events ? "with" : "without", ending.ended ? "ends" : "goes on", ending.time,
                    ending.drift, distance);
        is_said = is_said || says(lost_way("margin.rod"));
        require(ending.drift < 0.05, "a dead point that nobody looks for is said");
        require(h > 1e-3 || distance < 1e-2, "a motion that goes on is the right one");
        require(!(h <= 2e-3 && steps == 1 && takes_events) || !ending.ended, "steps that are small enough");
      }
    }
  }
  require(is_said, "the message of a lost way");
  require(step_blindly<Unit>(c, kRodBallEnd, 1e-2, 20, true).ended &&
              says("loop not closed: rod, on the way from the last completed step or event; take a smaller step, or "
                   "complete steps more often"),
          "the message of a step that leads nowhere");
}

/// Dead points at large output steps: found by indicators, or said, and never bounced back from.
template <class Unit>
void pass_at_output_points(const Case& c) {
  require(c.description.indicators == 1, "an indicator of the loop");
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    for (const double width : {0.01, 0.05, 0.1}) {
      const Work work = OutputPoints<Unit>(c, tolerance).run(width);
      std::printf("  output each %g s, tolerance %g: %d steps, %d rejected, %d evaluations, %d events, error %.1e\n",
                  width, tolerance, work.steps, work.rejected, work.evaluations, work.events, work.error);
      require(work.events >= 5 && work.error < 1e-5 + 300 * tolerance, "dead points between output points");
    }
  }
  const double end = c.description.step * static_cast<double>(c.table.rows.size() - 1);
  bool is_said = false;
  for (const double h : {5e-4, 2e-3, 5e-3, 1e-2}) {
    for (const int steps : {1, 5, 20}) {
      for (const bool takes_events : {true, false}) {
        const Ending ending = step_blindly<Unit>(c, end, h, steps, takes_events);
        std::printf("  Runge-Kutta, %g s, completed every %d, %s events: %s at %.3f s, energy %.1e\n", h, steps,
                    takes_events ? "with" : "without", ending.ended ? "ends" : "goes on", ending.time, ending.drift);
        is_said = is_said || says(lost_way("margin.rocker_tip"));
        require(ending.drift < 0.05, "a dead point that nobody looks for is said");
        require(!(h <= 2e-3 && steps == 1 && takes_events) || !ending.ended, "steps that are small enough");
      }
    }
  }
  require(is_said, "the message of a lost way");
}
