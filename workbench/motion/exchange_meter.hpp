#pragma once
// Scale of an energy balance: the energy exchanged between the parts of a mechanism.

#include <limits>
#include <vector>

#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Smallest and largest of a value along a motion.
struct Span {
  double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
  void add(double value) {
    smallest = value < smallest ? value : smallest;
    largest = value > largest ? value : largest;
  }
  double width() const { return largest > smallest ? largest - smallest : 0; }
};

/// Work of each force element (spring and damper of one element separately), of gravity on each body and of the drives,
/// and kinetic energy of each body by translation and about each axis. The scale is the sum of the ranges of the works,
/// or of the kinetic energies if this is larger. It excludes constant energy, of a rotor or of a moving vehicle; a
/// spring and a damper, or a drive and a brake, do not cancel.
class ExchangeMeter {
 public:
  /// step: s, between samples.
  ExchangeMeter(const Compilation& compilation, double step);

  void add(const Sample& sample);
  /// J; 0 if no energy was exchanged.
  double scale() const;

 private:
  double step_;
  GenericSolver solver_;
  std::vector<double> powers_, works_;  ///< W of the last sample, J up to it
  std::vector<Span> ranges_;            ///< J, of the works, then of the kinetic energies
};

}  // namespace mbgen
