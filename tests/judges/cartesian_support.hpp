#pragma once
// Equations (5) solved as they stand, by a method that minds neither massless bodies nor redundant equations.

#include <Eigen/Dense>
#include <limits>
#include <ostream>

#include "compiler/algebra/dense.hpp"
#include "runtime/judges/cartesian.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {

/// For names of tests.
inline void PrintTo(CartesianMethod method, std::ostream* out) {
  constexpr const char* kNames[] = {"augmented", "range_space", "null_space", "maggi"};
  *out << kNames[static_cast<int>(method)];
}

}  // namespace mbgen

namespace mbgen::testing {

inline constexpr CartesianMethod kMethods[] = {CartesianMethod::augmented, CartesianMethod::range_space,
                                               CartesianMethod::null_space, CartesianMethod::maggi};

struct Solution {
  Eigen::VectorXd qdd, lambda;  ///< lambda of minimum norm where it is not unique
};

/// A complete orthogonal decomposition of the whole matrix, once more for what the first solution leaves: rubber brings
/// forces that cancel in ten digits.
inline Solution solve(const CartesianTerms& terms) {
  const Eigen::Index n = terms.force.size(), m = terms.bias.size();
  const double scale = terms.mass.diagonal().maxCoeff();  // masses as large as the unit vectors of the constraints
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
  matrix.topLeftCorner(n, n) = terms.mass / scale;
  matrix.topRightCorner(n, m) = terms.jacobian.transpose();
  matrix.bottomLeftCorner(m, n) = terms.jacobian;
  Eigen::VectorXd right(n + m);
  right << terms.force / scale, terms.bias;
  const double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(n + m);
  Eigen::VectorXd x = least_squares(matrix, right, rounding);
  x += least_squares(matrix, right - matrix * x, rounding);
  return {x.head(n), scale * x.tail(m)};
}

inline double largest(const Eigen::VectorXd& values) { return values.size() == 0 ? 0 : values.cwiseAbs().maxCoeff(); }

}  // namespace mbgen::testing
