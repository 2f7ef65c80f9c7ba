#pragma once
// Whether the step of a motion was short enough for its fastest modes.

#include <string>
#include <vector>

#include "workbench/motion/nearby.hpp"

namespace mbgen {

/// Findings about the step of a motion.
struct StepVerdict {
  std::vector<std::string> warnings;  ///< the result is there, and not to be trusted in digits
  std::string failure;                ///< the result is wrong, or ends early for its step; empty where neither
  std::string outcome;                ///< the failure of a motion that came to its end, in a few words
  double stable_step = 0;             ///< s, of the mode that asks for the shortest; 0 where none is known
  double fitting_step = 0;            ///< s, one that would do, 0 where the step does or none is known
};

/// An integrator for a motion, and the reason.
struct IntegratorChoice {
  SolverSettings::Integrator integrator = SolverSettings::Integrator::rk4;
  std::string reason;
};

/// Runge-Kutta if all modes of the start are stable at this step, else the implicit method. modes: see modes_near.
IntegratorChoice choose_integrator(const Compilation& compilation, const SimulationSettings& settings,
                                   const std::vector<Mode>& modes);

/// Compares the step with the modes (a mode that grows e-fold over the motion by the integrator is unstable) and judges
/// the energy balance: an error above kEnergyWarning is a warning, above kEnergyFailure a failure. energies: J, largest
/// oscillating energy of each mode, or empty. A warning names a mode with more than kTakesPart of the scale of the
/// balance that loses more than kRobbed of its energy to the method, or is turned by more than kTurnedPhase, over the
/// time in which it has energy. turning_step: s, the longest step that allows the rotations of bodies, 0 if this one
/// does.
StepVerdict judge_step(const Compilation& compilation, SolverSettings::Integrator integrator,
                       const SimulationSettings& settings, const SimulationSummary& summary,
                       const std::vector<Mode>& modes, const std::vector<double>& energies = {},
                       double turning_step = 0);
constexpr double kTakesPart = 1e-4, kRobbed = 0.1;
constexpr double kTurnedPhase = 0.1;                           ///< rad, likewise: a tenth of the mode's amplitude
constexpr double kEnergyWarning = 1e-3, kEnergyFailure = 0.1;  // of the energies that were exchanged

/// Growth of a mode in one step, z = eigenvalue times step: |R(z)| of Runge-Kutta; for Adams-Bashforth-Moulton (PECE)
/// the largest root of its characteristic polynomial.
double growth_of_step(SolverSettings::Integrator integrator, std::complex<double> z);

/// Share of its energy that a mode loses or gains by the method, in the time in which it has energy; duration: s.
double robbed_share(SolverSettings::Integrator integrator, const Mode& mode, double h, double duration);

/// Phase error of an oscillating mode by the method, rad, in the time in which it has energy; duration: s. For
/// Adams-Bashforth-Moulton the phase of the principal root. Requires: less than half a turn per step.
double turned_phase(SolverSettings::Integrator integrator, const Mode& mode, double h, double duration);

}  // namespace mbgen
