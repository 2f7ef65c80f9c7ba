#pragma once
// Potential energy of springs, joint springs, bushings and bump stops in Cartesian coordinates.

#include "runtime/judges/mechanism.hpp"

namespace mbgen::cartesian {

/// J: the work of the elastic forces, by quadrature between the points of tables. x: all auxiliary states.
double stored_energy(const CartesianMechanism& mechanism, const StoredEnergyOutput& output,
                     const std::vector<Moving>& bodies, const std::vector<double>& x, const Values& values);

}  // namespace mbgen::cartesian
