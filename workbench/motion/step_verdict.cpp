#include "workbench/motion/step_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/number.hpp"
#include "mbgen/solver/rosenbrock.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {
namespace {

/// Percentage with two digits, or all digits from 100 % on.
std::string percent_text(double share) {
  return share < 0.995 ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

using Integrator = SolverSettings::Integrator;

/// Speed, rad/s or m/s, of values that blew up: beyond all motions that mbgen models.
constexpr double kBlownUp = 1e6;
/// Share of a mode's energy that an acceptable step loses or gains over the motion.
constexpr double kFittingLoss = kEnergyWarning / 2;
constexpr int kMostTries = 60;

/// Eigenvalue times h, with growth of the motion itself set to zero.
std::complex<double> step_of(const Mode& mode, double h) {
  return {std::min(mode.eigenvalue.real(), 0.0) * h, mode.eigenvalue.imag() * h};
}

bool is_stable(Integrator integrator, const Mode& mode, double h, double duration) {
  return std::log(growth_of_step(integrator, step_of(mode, h))) * duration / h <= 1;
}

/// The longest stable step up to `longest`, which is unstable.
double stable_step(Integrator integrator, const Mode& mode, double longest, double duration) {
  double low = 0, high = longest;
  for (int k = 0; k < kMostTries; ++k) {
    const double middle = (low + high) / 2;
    (is_stable(integrator, mode, middle, duration) ? low : high) = middle;
  }
  return low;
}

/// Whether a step conserves energy and phase of a mode over the time in which the mode has energy.
bool fits(Integrator integrator, const Mode& mode, double h, double duration) {
  return robbed_share(integrator, mode, h, duration) <= kFittingLoss &&
         turned_phase(integrator, mode, h, duration) <= kTurnedPhase / 2;
}

/// The longest of 5, 2, 1 times a power of ten below `h`.
double next_shorter(double h) { return round_number_below(h * (1 - 1e-9)); }

/// A step below `h` that is acceptable for all modes.
double fitting_step(Integrator integrator, const std::vector<Mode>& modes, double h, double duration) {
  for (int k = 0; k < kMostTries; ++k) {
    h = next_shorter(h);
    const bool all =
        std::all_of(modes.begin(), modes.end(), [&](const Mode& mode) { return fits(integrator, mode, h, duration); });
    if (all) return h;
  }
  return 0;
}

/// The auxiliary state that changes most in a mode, in parts of its typical size, unless velocities do; "" for none,
/// and for slips of tyres.
std::string leading_state(const Compilation& compilation, const Mode& mode) {
  const std::vector<AuxiliaryState> states = auxiliary_states(compilation.model);
  const std::size_t first = mode.states.size() - states.size();
  const auto size_of = [](const std::complex<double>& value) { return std::abs(value); };
  const auto largest = std::ranges::max_element(mode.states, {}, size_of);
  const auto slips = static_cast<std::size_t>(first_bristle(compilation.model));
  const auto place = static_cast<std::size_t>(largest - mode.states.begin());
  return place < first + slips ? "" : "x." + states[place - first].name;
}

std::string mode_text(const Compilation& compilation, const Mode& mode) {
  const std::string moves = leading_coordinates(compilation.model, compilation.topology, compilation.analysis, mode),
                    state = leading_state(compilation, mode);
  const std::string rate = mode.oscillates() ? fmt::format("{:.4g} Hz", mode.undamped_frequency())
                                             : fmt::format("decay at {:.4g} 1/s", std::abs(mode.eigenvalue));
  return fmt::format("{} ({}{})", rate, state.empty() || state == moves ? "" : state + ", ",
                     moves.empty() ? "slips of tyres" : moves);
}

/// The verdict on one motion, piece by piece.
struct StepJudge {
  const Compilation& compilation;
  Integrator integrator;
  const SimulationSettings& settings;
  const SimulationSummary& summary;
  double turning_step = 0;  ///< s, the longest that bears the turns of bodies; 0 where this one does
  StepVerdict verdict = {};
  std::string of_mode = {};  ///< condition of a mode that the step does not meet
  bool is_unstable = false;  ///< the mode grows

  double duration() const { return static_cast<double>(settings.steps) * settings.step; }

  /// Finds the mode that needs the shortest step.
  void compare(const std::vector<Mode>& modes) {
    const Mode* worst = nullptr;
    for (const Mode& mode : modes) {
      if (mode.is_neutral || is_stable(integrator, mode, settings.step, duration())) continue;
      const double stable = stable_step(integrator, mode, settings.step, duration());
      if (worst != nullptr && stable >= verdict.stable_step) continue;
      worst = &mode;
      verdict.stable_step = stable;
    }
    if (worst == nullptr) return;
    is_unstable = true;
    verdict.fitting_step = fitting_step(integrator, modes, verdict.stable_step, duration());
    of_mode = fmt::format("the fastest mode at the start, {}, needs steps below {:.3g} s with {}",
                          mode_text(compilation, *worst), verdict.stable_step, name_of(integrator));
  }

  /// Step from the energy balance: its error is of fourth order.
  void shorten(double relative, const std::vector<Mode>& modes) {
    if (is_unstable) return;
    const auto misses = [&](const Mode& mode) {
      return !mode.is_neutral && !fits(integrator, mode, settings.step, duration());
    };
    const auto slower = [&](const Mode& a, const Mode& b) {
      return (misses(a) ? std::abs(a.eigenvalue) : 0) < (misses(b) ? std::abs(b.eigenvalue) : 0);
    };
    const auto worst = std::max_element(modes.begin(), modes.end(), slower);
    if (worst != modes.end() && misses(*worst)) {
      of_mode =
          fmt::format("the fastest mode at the start, {}, asks for a shorter one", mode_text(compilation, *worst));
    }
    const double wanted = settings.step * std::pow(kFittingLoss / relative, 0.25);
    const double of_modes = fitting_step(integrator, modes, settings.step, duration());
    verdict.fitting_step = next_shorter(std::min(wanted, of_modes > 0 ? of_modes : wanted));
    if (!(turning_step > 0)) return;
    if (of_mode.empty()) of_mode = "bodies turn far within it";
    verdict.fitting_step = std::min(verdict.fitting_step, next_shorter(turning_step));
  }

  std::string energy_text() const {
    return fmt::format("the energy balance is off by {} ({:.3g} J of {:.3g} J)",
                       percent_text(std::abs(summary.energy.relative_error())), std::abs(summary.energy.error()),
                       summary.energy.scale);
  }

  /// is_step: whether the step is known to be at fault.
  std::string advice(bool is_step = true) const {
    const std::string cause = of_mode.empty() ? "" : "; " + of_mode;
    if (!(verdict.fitting_step > 0)) return cause;
    return fmt::format("{}; {}--step {:.3g} would do", cause, is_step ? "" : "if it is the step, ",
                       verdict.fitting_step);
  }

  /// Judges a motion that reached its end.
  void judge_energy(const std::vector<Mode>& modes) {
    const EnergyBalance& energy = summary.energy;
    const double relative = std::abs(energy.relative_error());
    const bool is_rounding =
        std::abs(energy.error()) <= kRoundedEnergy * energy.level || summary.largest_velocity <= kAtRest;
    const bool is_off = !(relative <= kEnergyWarning) && !is_rounding;
    if (blew_up()) {
      shorten(std::max(relative, kEnergyFailure), modes);
      const auto fastest = static_cast<std::size_t>(std::max(summary.fastest, 0));
      verdict.failure =
          fmt::format("the values blew up, {} reached {:.3g} {}/s: {}, step {:.6g} s is too long{}",
                      compilation.topology.bodies[fastest].coordinate, summary.largest_velocity,
                      unit_of(compilation.topology.bodies[fastest].kind), energy_text(), settings.step, advice());
      verdict.outcome = "values blew up";
    } else if (is_off) {
      shorten(relative, modes);
      const bool is_step = !of_mode.empty();
      const std::string text =
          fmt::format("{}, step {:.6g} s {}{}", energy_text(), settings.step,
                      is_step ? "is too long" : "may be too long, or an input or a law jumps", advice(is_step));
      if (relative <= kEnergyFailure) return verdict.warnings.push_back(text);
      verdict.failure = text;
      verdict.outcome = "energy balance off by " + percent_text(relative);
    } else if (is_unstable) {
      verdict.warnings.push_back(fmt::format("step {:.6g} s is too long{}", settings.step, advice()));
    }
  }

  /// Warns of a mode that takes part and is damped or turned by the method.
  void judge_modes(const std::vector<Mode>& modes, const std::vector<double>& energies) {
    if (!verdict.failure.empty() || !verdict.warnings.empty()) return;  // the energy balance told it
    const Mode *robbed = nullptr, *turned = nullptr;
    double most = kRobbed, farthest = kTurnedPhase;
    for (std::size_t m = 0; m < energies.size(); ++m) {
      if (!(energies[m] > kTakesPart * summary.energy.scale)) continue;
      const double share = robbed_share(integrator, modes[m], settings.step, duration()),
                   turn = turned_phase(integrator, modes[m], settings.step, duration());
      if (share > most) most = share, robbed = &modes[m];
      if (turn > farthest) farthest = turn, turned = &modes[m];
    }
    const Mode* const worst = robbed != nullptr ? robbed : turned;
    if (worst == nullptr) return;
    verdict.fitting_step = fitting_step(integrator, {*worst}, settings.step, duration());
    const char* const when = worst->eigenvalue.real() < 0 ? "while it decays" : "over the motion";
    verdict.warnings.push_back(
        robbed != nullptr
            ? fmt::format("a mode of the start takes part that the method takes out of the motion, {}: {} changes its "
                          "energy by {} {}{}",
                          mode_text(compilation, *worst), name_of(integrator), percent_text(std::min(most, 1.0)), when,
                          advice())
            : fmt::format("a mode of the start takes part whose time the method does not keep, {}: {} turns it by "
                          "{:.2g} rad {}{}",
                          mode_text(compilation, *worst), name_of(integrator), farthest, when, advice()));
  }

  /// Values beyond all bounds and an energy error; one of them is enough if the step is known to be unstable.
  bool blew_up() const {
    const bool runs = !(summary.largest_velocity <= kBlownUp);
    const bool gains = !(std::abs(summary.energy.relative_error()) <= kEnergyFailure);
    return is_unstable ? runs || gains : runs && gains;
  }

  /// Judges a motion that stopped at a failed step.
  void judge_stop() {
    if (!is_unstable && summary.passable_step == 0) return;
    if (!is_unstable) verdict.fitting_step = summary.passable_step;
    verdict.failure = fmt::format("step {:.6g} s is too long{}", settings.step, advice());
  }
};

/// R(z) of ROS34PW2 with its matrix exact: the stages of mbgen/solver/rosenbrock.hpp for y' = z y and a step of 1.
std::complex<double> factor_of_rosenbrock(std::complex<double> z) {
  using namespace integrator_detail;
  const std::complex<double> reciprocal = 1.0 / (1.0 / kRosenbrockFactor - z);
  std::complex<double> change[4], last = 1.0;
  change[0] = z * reciprocal;
  const auto stage = [&](const auto& weights, const auto& coupling) {
    std::complex<double> state = 1.0, coupled = 0.0;
    for (std::size_t k = 0; k < std::size(weights); ++k) {
      state += weights[k] * change[k];
      coupled += coupling[k] * change[k];
    }
    change[std::size(weights)] = (z * state + coupled) * reciprocal;
    last = state;
  };
  stage(kStage2, kCoupling2);
  stage(kStage3, kCoupling3);
  stage(kStage4, kCoupling4);
  return last + change[3];
}

std::complex<double> factor_of_rk4(std::complex<double> z) {
  return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
}

/// A step of Adams-Bashforth-Moulton (PECE) from the last four values, the newest first:
/// y' = 9 (y + z/24 (55 y - 59 y1 + 37 y2 - 9 y3)) + 19 y - 5 y1 + y2, times z/24, plus y.
std::array<std::complex<double>, 4> weights_of_abm4(std::complex<double> z) {
  const std::complex<double> c = z / 24.0, corrected = 9.0 * c;
  return {1.0 + c * (9.0 + 19.0 + 55.0 * corrected), c * (-5.0 - 59.0 * corrected), c * (1.0 + 37.0 * corrected),
          c * (-9.0 * corrected)};
}

/// The principal root of its characteristic polynomial: by Newton's iteration from the exact factor.
std::complex<double> factor_of_abm4(std::complex<double> z) {
  const auto weights = weights_of_abm4(z);
  std::complex<double> root = std::exp(z);
  for (int k = 0; k < kMostTries; ++k) {
    std::complex<double> value = 1.0, slope = 0.0;
    for (const std::complex<double>& weight : weights) {
      slope = slope * root + value;
      value = value * root - weight;
    }
    const std::complex<double> change = value / slope;
    root -= change;
    if (!(std::abs(change) > 1e-15)) break;
  }
  return root;
}

std::complex<double> factor_of_step(Integrator integrator, std::complex<double> z) {
  return integrator == Integrator::rosenbrock ? factor_of_rosenbrock(z)
         : integrator == Integrator::rk4      ? factor_of_rk4(z)
                                              : factor_of_abm4(z);
}

/// Time in which a mode has energy, s.
double time_of(const Mode& mode, double duration) {
  return 1 / (1 / duration - 2 * std::min(mode.eigenvalue.real(), 0.0));
}

}  // namespace

double growth_of_step(Integrator integrator, std::complex<double> z) {
  if (integrator != Integrator::abm4) return std::abs(factor_of_step(integrator, z));
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(4, 4);
  const auto weights = weights_of_abm4(z);
  for (int i = 0; i < 4; ++i) companion(0, i) = weights[static_cast<std::size_t>(i)];
  for (int i = 0; i < 3; ++i) companion(i + 1, i) = 1;
  return spectral_radius(companion);
}

double turned_phase(Integrator integrator, const Mode& mode, double h, double duration) {
  const std::complex<double> z = step_of(mode, h);
  return std::abs(std::arg(factor_of_step(integrator, z) * std::exp(-z))) * time_of(mode, duration) / h;
}

double robbed_share(Integrator integrator, const Mode& mode, double h, double duration) {
  const std::complex<double> z = step_of(mode, h);
  const double growth = growth_of_step(integrator, z);
  return std::abs(growth * growth - std::exp(2 * z.real())) * time_of(mode, duration) / h;
}

IntegratorChoice choose_integrator(const Compilation& compilation, const SimulationSettings& settings,
                                   const std::vector<Mode>& modes) {
  if (modes.empty()) return {Integrator::rk4, "the modes at the start are not known"};
  const double duration = static_cast<double>(settings.steps) * settings.step;
  const Mode* worst = nullptr;
  double shortest = settings.step;
  for (const Mode& mode : modes) {
    if (mode.is_neutral || is_stable(Integrator::rk4, mode, settings.step, duration)) continue;
    const double stable = stable_step(Integrator::rk4, mode, settings.step, duration);
    if (worst != nullptr && stable >= shortest) continue;
    worst = &mode;
    shortest = stable;
  }
  if (worst == nullptr) return {Integrator::rk4, "it bears every mode at the start"};
  return {Integrator::rosenbrock, fmt::format("the fastest mode at the start, {}, needs steps below {:.3g} s with rk4",
                                              mode_text(compilation, *worst), shortest)};
}

StepVerdict judge_step(const Compilation& compilation, Integrator integrator, const SimulationSettings& settings,
                       const SimulationSummary& summary, const std::vector<Mode>& modes,
                       const std::vector<double>& energies, double turning_step) {
  StepJudge judge{compilation, integrator, settings, summary, turning_step};
  judge.compare(modes);
  if (summary.status.ok()) {
    judge.judge_energy(modes);
    judge.judge_modes(modes, energies);
  } else {
    judge.judge_stop();
  }
  return judge.verdict;
}

}  // namespace mbgen
