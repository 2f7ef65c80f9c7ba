#pragma once
// Modes that the step does not resolve, and their part in a motion.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "workbench/motion/nearby.hpp"

namespace mbgen {

/// Oscillations of the modes of the start along a motion: of modes that lose more than kRobbed of their energy to the
/// method, or are turned by more than kTurnedPhase.
class ModeWatch {
 public:
  /// engine: of the motion, in relative coordinates, before its first step; inputs: of the model, at the start;
  /// settings: of the motion.
  ModeWatch(const Compilation& compilation, const Engine& engine, const GenericState& start,
            const std::vector<double>& inputs, SolverSettings::Integrator integrator,
            const SimulationSettings& settings);

  void add(const Sample& sample);
  const std::vector<Mode>& modes() const { return modes_; }
  /// Largest oscillating energy of each mode, J; 0 for modes that are not monitored.
  const std::vector<double>& energies() const { return energies_; }

 private:
  struct Watched {
    std::size_t mode;
    Eigen::VectorXcd left;              ///< its product with deviations of the states is the mode's share
    double energy;                      ///< J, of a share of 1
    double gain;                        ///< of the second difference of a share that oscillates
    std::complex<double> last[2] = {};  ///< shares of the last samples, the newest first
  };
  const Compilation& compilation_;
  GenericState start_;
  std::vector<Mode> modes_;
  std::vector<double> energies_;
  std::vector<Watched> watched_;
  long samples_ = 0;
};

}  // namespace mbgen
