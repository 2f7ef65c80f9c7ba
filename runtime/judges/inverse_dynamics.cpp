#include "runtime/judges/inverse_dynamics.hpp"

#include <cmath>

#include "compiler/algebra/dense.hpp"

namespace mbgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values below this share of the largest are rounding.
constexpr double kNothing = 1e-11;

/// The forces are linear in the inputs: large ones leave no rounding of the others.
constexpr double kLargeInput = 1 << 20;

VectorXd coordinates_of(const std::vector<double>& values, const std::vector<int>& chosen) {
  VectorXd result(static_cast<Index>(chosen.size()));
  for (std::size_t i = 0; i < chosen.size(); ++i)
    result[static_cast<Index>(i)] = values[static_cast<std::size_t>(chosen[i])];
  return result;
}

}  // namespace

VectorXd accelerations_of(const CartesianSystem& system, const PlacedState& at, const Evaluation& evaluation,
                          const std::vector<int>& independent, const std::vector<double>& zdd) {
  const ConstraintFactors& factors = *evaluation.factors;
  const MatrixXd& basis = factors.null_basis();
  VectorXd qdd = factors.particular(factors.reduce(evaluation.terms.bias).kept);
  const auto seen = [&](const VectorXd& accelerations) {
    return coordinates_of(system.joint_accelerations(at.bodies, at.z, accelerations), independent);
  };
  const VectorXd start = seen(qdd);
  MatrixXd matrix(static_cast<Index>(independent.size()), basis.cols());
  for (Index k = 0; k < basis.cols(); ++k) matrix.col(k) = seen(qdd + basis.col(k)) - start;
  return qdd + basis * least_squares(matrix, coordinates_of(zdd, independent) - start, kNothing);
}

MatrixXd actuator_columns(CartesianSystem& system, const PlacedState& at, const std::vector<double>& inputs) {
  const Model& model = system.model();
  const std::vector<double> none(at.z.z.size(), 0.0);
  MatrixXd columns(system.coordinates(), static_cast<Index>(model.actuators.size()));
  for (std::size_t i = 0; i < model.actuators.size(); ++i) {
    std::vector<double> pushed = inputs;
    const auto force = [&](double value) {
      if (model.actuators[i].input >= 0) pushed[static_cast<std::size_t>(model.actuators[i].input)] = value;
      system.set_inputs(pushed);
      return system.terms(at.bodies, at.z, none).force;
    };
    columns.col(static_cast<Index>(i)) = (force(kLargeInput) - force(-kLargeInput)) / (2 * kLargeInput);
  }
  system.set_inputs(inputs);
  return columns;
}

bool least_forces(const Model& model, const MatrixXd& actuation, const VectorXd& required, std::vector<double>& force) {
  VectorXd scale(actuation.cols());
  for (Index i = 0; i < actuation.cols(); ++i)
    scale[i] = 1 / std::sqrt(model.actuators[static_cast<std::size_t>(i)].weight);
  const MatrixXd weighted = actuation * scale.asDiagonal();
  if (actuation.rows() > 0) {
    if (actuation.cols() < actuation.rows()) return false;
    const VectorXd values = singular_values(weighted);
    if (!(values[actuation.rows() - 1] > kNothing * values[0])) return false;
  }
  const VectorXd found = scale.asDiagonal() * least_squares(weighted, required, kNothing);
  force.assign(found.data(), found.data() + found.size());
  return true;
}

}  // namespace mbgen
