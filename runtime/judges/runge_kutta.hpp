#pragma once
// Runge-Kutta of order four on the poses of bodies: attitudes as quaternions whose length carries no meaning.

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "mbgen/status.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {

/// Rates of a Cartesian state; those of the bodies' poses follow from the state itself.
struct CartesianRates {
  Eigen::VectorXd qdd;     ///< 6 per body
  std::vector<double> xd;  ///< of the auxiliary states
};

/// Gives the rates at a state with unit quaternions.
using CartesianDerivative = std::function<Status(const CartesianState&, CartesianRates&)>;

/// One step of h seconds by the classical Runge-Kutta method. Quaternions move by qdot = w q / 2 as four free numbers
/// and are made unit for every evaluation and at the end: order four for attitudes too.
/// The state is unchanged when an evaluation fails.
/// Source: W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", 1901.
Status runge_kutta_step(const CartesianDerivative& derivative, CartesianState& state, double h);

}  // namespace mbgen
