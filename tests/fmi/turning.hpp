#pragma once
// A body that turns farther in a step than its method bears, forces that turn with it: a step inside of the unit, or
// one of the importer's integrator, of which the unit sees the evaluations alone. Of the model rotor, a turn a
// millisecond.

#include <cmath>
#include <cstdio>

#include "habits.hpp"

/// Messages that a unit gives while `run` goes on, of the category that warnings have.
template <class Unit, class Run>
int messages_of(const Run& run) {
  int& count = Unit::kVersion == 2 ? messages : messages_3;
  const int before = count;
  last_message.clear();
  last_category.clear();
  run();
  require(count == before || last_category == "logStatusWarning", "the category of a message");
  return count - before;
}

/// Co-simulation: a warning, once, with its answer.
template <class Unit>
void turn_inside(const Case& c) {
  for (const double offset : {1e-3, 0.0}) {
    Unit unit(c.library, c.description, false);
    require(unit.set({c.description.reference("offset")}, {offset}) == kOk, "the offset");
    start(unit);
    const double h = c.description.step;
    const int told = messages_of<Unit>([&] {
      for (int i = 0; i < 20; ++i)
        require(unit.step(i * h, h) == (i == 0 && offset != 0 ? kWarning : kOk), "a step with a turn");
    });
    require(told == (offset != 0 ? 1 : 0), "a warning where forces turn with the rotor, and nowhere else");
    require(offset == 0 || last_message ==
                               (Unit::kVersion == 2 ? "fmi2DoStep" : "fmi3DoStep") +
                                   std::string(": \"z.shaft\" turns too far within a step inside, and forces turn with "
                                               "it; give the model a shorter step: the method bears, in rad, 0.5, got "
                                               "6.283185307"),
            "the warning of a turn");
  }
}

/// Messages of fixed steps: Runge-Kutta of order 4, or Euler's; every answer is OK.
template <class Unit>
int turn_by(const Case& c, double offset, double h, int stages, int steps_a_point) {
  Unit unit(c.library, c.description, true);
  require(unit.set({c.description.reference("offset")}, {offset}) == kOk, "the offset");
  start(unit);
  require(unit.enter_continuous() == kOk, "continuous time");
  Row x(c.description.derivatives.size()), at, rates[4];
  require(unit.states(x) == kOk, "states");
  const double part[] = {0, 0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
  return messages_of<Unit>([&] {
    for (int i = 0; i < 100; ++i) {
      const Row from = x;
      for (int stage = 0; stage < stages; ++stage) {
        at = from;
        for (std::size_t k = 0; k < x.size() && stage > 0; ++k) at[k] += part[stage] * h * rates[stage - 1][k];
        rates[stage].resize(x.size());
        require(unit.set_time((i + part[stage]) * h) == kOk && unit.set_states(at) == kOk &&
                    unit.derivatives(rates[stage]) == kOk,
                "derivatives");
        for (std::size_t k = 0; k < x.size(); ++k) x[k] += (stages == 1 ? 1 : weight[stage] / 6) * h * rates[stage][k];
      }
      bool asks = false;
      require(unit.set_time((i + 1) * h) == kOk && unit.set_states(x) == kOk, "states");
      if ((i + 1) % steps_a_point == 0) require(unit.completed(asks) == kOk && !asks, "a completed step");
    }
  });
}

/// Model exchange: gaps between evaluations, and their mean, wherever steps are completed; none of an importer with
/// steps that vary.
template <class Unit>
void turn_outside(const Case& c) {
  const std::string message = (Unit::kVersion == 2 ? "fmi2CompletedIntegratorStep" : "fmi3CompletedIntegratorStep") +
                              std::string(
                                  ": \"z.shaft\" turns too far between two evaluations of a completed step, and "
                                  "forces turn with it; take shorter steps: methods of integration bear less "
                                  "than, in rad, 1.5, got ");
  require(turn_by<Unit>(c, 1e-3, 1e-3, 4, 1) == 1 && last_message == message + "3.141592654", "Runge-Kutta, a turn");
  require(turn_by<Unit>(c, 1e-3, 1e-3, 4, 20) == 1 && says("\"z.shaft\" turns too far"), "completed at output points");
  require(turn_by<Unit>(c, 1e-3, 3e-4, 1, 1) == 1 && last_message == message + "1.884955592", "Euler, 0.3 of a turn");
  require(turn_by<Unit>(c, 0, 1e-3, 4, 1) == 0, "no forces turn with the rotor");
  // About the measured limits: Runge-Kutta in steps of 1.26 and 0.44 rad, Euler in steps of 0.63 and 0.19 rad.
  const std::string in_mean = "turns far from one evaluation of a completed step to the next, in the mean";
  require(turn_by<Unit>(c, 1e-3, 2e-4, 4, 1) == 1 && says(in_mean) &&
              says("methods with so few bear, in rad, 0.25, got 0.6283185307"),
          "Runge-Kutta, 0.2 of a turn");
  require(turn_by<Unit>(c, 1e-3, 1e-4, 1, 1) == 1 && says(in_mean) &&
              says("methods with so few bear, in rad, 0.3, got 0.6283185307"),
          "Euler, 0.1 of a turn");
  require(turn_by<Unit>(c, 1e-3, 2e-4, 4, 20) == 1 && says(in_mean), "completed at output points");
  require(turn_by<Unit>(c, 0, 2e-4, 4, 1) == 0, "no forces turn with the rotor");
  require(turn_by<Unit>(c, 1e-3, 7e-5, 4, 1) == 0 && turn_by<Unit>(c, 1e-3, 3e-5, 1, 1) == 0 &&
              turn_by<Unit>(c, 1e-3, 5e-5, 4, 20) == 0,
          "steps that are small");
  for (const auto& [width, tolerance] : {std::pair{0.01, 1e-8}, {0.1, 1e-8}, {0.1, 1e-4}}) {
    Work work;
    const int told = messages_of<Unit>([&, width = width, tolerance = tolerance] {
      OutputPoints<Unit> importer(c, tolerance);
      work = importer.run_to(0.2, width, [](int) {});
    });
    std::printf("  output each %g s, tolerance %g: %d steps, %d rejected, %d messages\n", width, tolerance, work.steps,
                work.rejected, told);
    // At the loose tolerance its steps turn the rotor by 1.8 rad, more than 0.3 rad from one evaluation to the next.
    require(told == (tolerance < 1e-6 ? 0 : 1) && work.rejected > 0,
            "steps that vary, some refused, and output points far apart");
  }
}
