#pragma once
// Runge-Kutta of order four on the poses of bodies, with attitudes as quaternions of arbitrary length.

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "mbgen/status.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {

/// Rates of a Cartesian state, except rates of poses, which follow from the state itself.
struct CartesianRates {
  Eigen::VectorXd qdd;     ///< 6 per body
  std::vector<double> xd;  ///< of the auxiliary states
};

/// Computes the rates at a state with unit quaternions.
using CartesianDerivative = std::function<Status(const CartesianState&, CartesianRates&)>;

/// One step of h seconds by the classical Runge-Kutta method. Quaternions are integrated by qdot = w q / 2 as four free
/// numbers and are normalised for every evaluation and at the end: order four for attitudes too. The state is unchanged
/// if an evaluation fails. Source: W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen",
/// 1901.
Status runge_kutta_step(const CartesianDerivative& derivative, CartesianState& state, double h);

}  // namespace mbgen
