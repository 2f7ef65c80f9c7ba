#pragma once
// States, rates and results of any model, as every engine that runs without generated code gives them.

#include <vector>

namespace mbgen {

/// State of any model: all coordinates, all velocities, auxiliary states, time.
struct GenericState {
  std::vector<double> z, zd, x;
  double t = 0;
};

struct GenericDerivative {
  std::vector<double> zdd, xd;
};

/// What a model's outputs function gives.
struct GenericOutputs {
  std::vector<double> y;
  double kinetic_energy = 0, potential_energy = 0, applied_power = 0;
};

}  // namespace mbgen
