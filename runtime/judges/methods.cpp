#include "runtime/judges/methods.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"

namespace mbgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kPerBody = 6;
/// Root of the kinetic energy of a motion over what it would be if no body were massless: what is not larger is none.
constexpr double kNoInertia = 1e-8;
/// Smallest pivot of a body's inertia relative to the largest; below is rounding of an exact zero.
constexpr double kNoMass = 1e-13;

/// M times `factor`, body by body.
MatrixXd times_mass(const MatrixXd& mass, const MatrixXd& factor) {
  MatrixXd product(factor.rows(), factor.cols());
  for (Index first = 0; first < mass.rows(); first += kPerBody)
    product.middleRows(first, kPerBody).noalias() =
        mass.block<kPerBody, kPerBody>(first, first) * factor.middleRows(first, kPerBody);
  return product;
}

/// G times `factor`, body by body, with G' G = M.
MatrixXd times_root_of_mass(const MatrixXd& mass, const MatrixXd& factor) {
  using Block = Eigen::Matrix<double, kPerBody, kPerBody>;
  MatrixXd product(factor.rows(), factor.cols());
  for (Index first = 0; first < mass.rows(); first += kPerBody) {
    const Eigen::LDLT<Block> root(mass.block<kPerBody, kPerBody>(first, first));
    const Eigen::Matrix<double, kPerBody, 1> pivots = root.vectorD();
    const double least = kNoMass * pivots.cwiseAbs().maxCoeff();
    Block lower = root.matrixL();
    for (Index k = 0; k < kPerBody; ++k) lower.col(k) *= pivots[k] > least ? std::sqrt(pivots[k]) : 0.0;
    product.middleRows(first, kPerBody) =
        lower.transpose() * (root.transpositionsP() * factor.middleRows(first, kPerBody));
  }
  return product;
}

/// Diagonal of M, zeros replaced by the mean of the others: a size of inertia for every coordinate.
VectorXd typical_inertia(const MatrixXd& mass) {
  VectorXd inertia = mass.diagonal();
  const auto massive = static_cast<double>((inertia.array() > 0).count());
  const double mean = massive > 0 ? inertia.sum() / massive : 1.0;
  return (inertia.array() > 0).select(inertia, mean);
}

/// Inertia that a unit acceleration of each reduced equation meets, roughly: what makes its rows as large as those
/// of M.
VectorXd equation_scale(const CartesianEquations& e) {
  return (e.factors.reduced().array().square().matrix() * typical_inertia(e.mass).cwiseInverse()).cwiseInverse();
}

CartesianSolution with_multipliers(const CartesianEquations& e, VectorXd qdd, const VectorXd& reduced_multipliers) {
  return {std::move(qdd), e.factors.multipliers(reduced_multipliers)};
}

/// lambda of (28).
CartesianSolution with_multipliers(const CartesianEquations& e, VectorXd qdd) {
  const VectorXd unbalanced = e.force - times_mass(e.mass, qdd);
  return with_multipliers(e, std::move(qdd), e.factors.reduced_multipliers(unbalanced));
}

/// The matrix of (15), its equations multiplied by their scale so that pivots of both halves compare.
CartesianSolution augmented(const CartesianEquations& e) {
  const MatrixXd& reduced = e.factors.reduced();
  const Index n = e.mass.rows(), r = reduced.rows();
  const VectorXd scale = equation_scale(e);
  MatrixXd matrix = MatrixXd::Zero(n + r, n + r);
  matrix.topLeftCorner(n, n) = e.mass;
  matrix.bottomLeftCorner(r, n) = scale.asDiagonal() * reduced;
  matrix.topRightCorner(n, r) = matrix.bottomLeftCorner(r, n).transpose();
  VectorXd right_hand_side(n + r);
  right_hand_side << e.force, scale.cwiseProduct(e.bias.kept);
  const VectorXd x = solved(matrix, right_hand_side);
  return with_multipliers(e, x.head(n), scale.cwiseProduct(x.tail(r)));
}

/// (16)-(20) with M* = M + U' W U and F* = F + U' W c in place of M and F. Where U qdd = c both give the same
/// equations with the same multipliers, and M* is positive definite exactly when (9) holds, massless bodies or not.
CartesianSolution range_space(const CartesianEquations& e) {
  const MatrixXd& reduced = e.factors.reduced();
  const VectorXd weight = equation_scale(e);
  const MatrixXd weighted = weight.asDiagonal() * reduced;
  MatrixXd mass = e.mass;
  mass.noalias() += reduced.transpose() * weighted;
  const VectorXd force = e.force + weighted.transpose() * e.bias.kept;
  const Eigen::LLT<MatrixXd> first(mass);
  if (reduced.rows() == 0) return with_multipliers(e, first.solve(force), VectorXd());
  const VectorXd x = first.matrixL().solve(force);
  const MatrixXd transposed_21 = first.matrixL().solve(reduced.transpose());
  const Eigen::LLT<MatrixXd> second(transposed_21.transpose() * transposed_21);
  // (18) has (18)'s signs: -lambda is what L2 L2' meets
  const VectorXd lambda = -second.solve(e.bias.kept - transposed_21.transpose() * x);
  return with_multipliers(e, first.matrixU().solve(x - transposed_21 * lambda), lambda);
}

/// (27), every row of R' M divided by its largest entry.
CartesianSolution null_space(const CartesianEquations& e) {
  const MatrixXd& basis = e.factors.null_basis();
  const Index n = e.mass.rows(), f = basis.cols();
  MatrixXd matrix(n, n);
  VectorXd right_hand_side(n);
  matrix.topRows(f) = times_mass(e.mass, basis).transpose();
  right_hand_side.head(f) = basis.transpose() * e.force;
  for (Index k = 0; k < f; ++k) {
    const double largest = matrix.row(k).cwiseAbs().maxCoeff();
    matrix.row(k) /= largest;
    right_hand_side[k] /= largest;
  }
  matrix.bottomRows(n - f) = e.factors.reduced();
  right_hand_side.tail(n - f) = e.bias.kept;
  return with_multipliers(e, solved(matrix, right_hand_side));
}

/// qdd = R zdd + S c with R' M R zdd = R' (F - M S c) (29), (30).
VectorXd maggi_accelerations(const MatrixXd& mass, const VectorXd& force, const ConstraintFactors& factors,
                             const VectorXd& bias) {
  const MatrixXd& basis = factors.null_basis();
  const VectorXd particular = factors.particular(bias);
  if (basis.cols() == 0) return particular;
  const MatrixXd reduced_mass = basis.transpose() * times_mass(mass, basis);
  const VectorXd scale = reduced_mass.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LLT<MatrixXd> cholesky(scale.asDiagonal() * reduced_mass * scale.asDiagonal());
  const VectorXd right_hand_side = basis.transpose() * (force - times_mass(mass, particular));
  return particular + basis * scale.cwiseProduct(cholesky.solve(scale.cwiseProduct(right_hand_side)));
}

}  // namespace

CartesianSolution solve(CartesianMethod method, const CartesianEquations& equations) {
  switch (method) {
    case CartesianMethod::augmented:
      return augmented(equations);
    case CartesianMethod::range_space:
      return range_space(equations);
    case CartesianMethod::null_space:
      return null_space(equations);
    case CartesianMethod::maggi:
      break;
  }
  return with_multipliers(equations,
                          maggi_accelerations(equations.mass, equations.force, equations.factors, equations.bias.kept));
}

std::optional<VectorXd> motion_without_inertia(const MatrixXd& mass, const ConstraintFactors& factors) {
  const MatrixXd& basis = factors.null_basis();
  if (basis.cols() == 0) return std::nullopt;
  const VectorXd as_if_massive = typical_inertia(mass).cwiseSqrt();
  const VectorXd scale = (as_if_massive.asDiagonal() * basis).colwise().norm().cwiseInverse();
  const Eigen::ColPivHouseholderQR<MatrixXd> weighed(times_root_of_mass(mass, basis) * scale.asDiagonal());
  const VectorXd pivots = weighed.matrixQR().diagonal().cwiseAbs();
  const Index rank = (pivots.array() > kNoInertia).count();
  if (rank == basis.cols()) return std::nullopt;
  VectorXd motion = VectorXd::Zero(basis.cols());
  motion[rank] = 1;
  motion.head(rank) = -weighed.matrixQR()
                           .topLeftCorner(rank, rank)
                           .triangularView<Eigen::Upper>()
                           .solve(weighed.matrixQR().col(rank).head(rank));
  return basis * scale.cwiseProduct(weighed.colsPermutation() * motion);
}

VectorXd mass_orthogonal_correction(const MatrixXd& mass, const ConstraintFactors& factors, const VectorXd& c) {
  return maggi_accelerations(mass, VectorXd::Zero(mass.rows()), factors, factors.reduce(c).kept);
}

}  // namespace mbgen
