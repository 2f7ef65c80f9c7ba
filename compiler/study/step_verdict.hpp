#pragma once
// Whether the step of a motion was short enough for its fastest modes.

#include <string>
#include <vector>

#include "compiler/linearisation/linearisation.hpp"
#include "compiler/study/simulation.hpp"

namespace mbgen {

/// The modes of small motions about a state by central differences of its accelerations, see modes(); none for a model
/// of more than kMostStatesForModes states or with rolling, at a singular position, and where no acceleration is to be
/// had. inputs: of the model, at that time. Cost: two evaluations of the generic runtime a state.
std::vector<Mode> modes_near(const Compilation& compilation, const GenericState& state,
                             const std::vector<double>& inputs);
constexpr int kMostStatesForModes = 200;

/// Findings about the step of a motion.
struct StepVerdict {
  std::vector<std::string> warnings;  ///< the result is there, and not to be trusted in digits
  std::string failure;                ///< the result is wrong, or ends early for its step; empty where neither
  std::string outcome;                ///< the failure of a motion that came to its end, in a few words
  double stable_step = 0;             ///< s, of the mode that asks for the shortest; 0 where none is known
  double fitting_step = 0;            ///< s, one that would do, 0 where the step does or none is known
};

/// An integrator for a motion, and why.
struct IntegratorChoice {
  SolverSettings::Integrator integrator = SolverSettings::Integrator::rk4;
  std::string reason;
};

/// Runge-Kutta where it lets no mode of the start grow at this step, else the implicit method. modes: see modes_near.
IntegratorChoice choose_integrator(const Compilation& compilation, const SimulationSettings& settings,
                                   const std::vector<Mode>& modes);

/// Compares the step with the modes (a mode that the integrator lets grow e-fold over the motion is not stable) and
/// judges the energy balance: off by more than kEnergyWarning it is a warning, by more than kEnergyFailure a failure.
StepVerdict judge_step(const Compilation& compilation, SolverSettings::Integrator integrator,
                       const SimulationSettings& settings, const SimulationSummary& summary,
                       const std::vector<Mode>& modes);
constexpr double kEnergyWarning = 1e-3, kEnergyFailure = 0.1;  // of the energies that were exchanged

/// Growth of a mode in one step, z = eigenvalue times step: |R(z)| of Runge-Kutta, of Adams-Bashforth-Moulton (PECE)
/// the largest root of its characteristic polynomial.
double growth_of_step(SolverSettings::Integrator integrator, std::complex<double> z);

}  // namespace mbgen
