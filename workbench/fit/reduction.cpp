#include "workbench/fit/reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen::fit {
namespace {

/// Twice the loss.
double doubled_loss(const Loss& loss, double residual) {
  const double square = residual * residual, limit = loss.limit;
  if (loss.kind == Loss::Kind::huber && std::abs(residual) > limit)
    return 2 * limit * std::abs(residual) - limit * limit;
  if (loss.kind == Loss::Kind::cauchy) return limit * limit * std::log1p(square / (limit * limit));
  return square;
}

}  // namespace

Eigen::MatrixXd compressed(const Eigen::MatrixXd& rows) {
  const SingularVectors factors = right_singular_vectors(rows);
  return factors.values.asDiagonal() * factors.vectors.leftCols(factors.values.size()).transpose();
}

Loss loss_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  if (text.empty() || text == "squares") return {};
  if (colon == std::string::npos || (name != "huber" && name != "cauchy"))
    throw UserError(fmt::format("--loss: must be squares, huber:LIMIT or cauchy:LIMIT, found \"{}\"\n", text));
  const double limit = parse_number(text.substr(colon + 1), "--loss " + name);
  if (!(limit > 0)) throw UserError(fmt::format("--loss {}: the limit must be above 0, found {}\n", name, limit));
  return {name == "huber" ? Loss::Kind::huber : Loss::Kind::cauchy, limit};
}

double weight_of(const Loss& loss, double residual) {
  const double size = std::abs(residual);
  if (loss.kind == Loss::Kind::huber && size > loss.limit) return loss.limit / size;
  if (loss.kind == Loss::Kind::cauchy) return 1 / (1 + size * size / (loss.limit * loss.limit));
  return 1;
}

Reduced reduced(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian, const Loss& loss) {
  const int unknowns = static_cast<int>(jacobian.cols());
  double total = 0, weighted_squares = 0;
  Eigen::VectorXd roots(residuals.size());
  for (Eigen::Index k = 0; k < residuals.size(); ++k) {
    total += doubled_loss(loss, residuals[k]);
    const double weight = weight_of(loss, residuals[k]);
    weighted_squares += weight * residuals[k] * residuals[k];
    roots[k] = std::sqrt(weight);
  }
  Reduced result;
  result.residuals.setZero(reduced_rows(unknowns));
  if (jacobian.rows() == 0) {
    result.residuals[0] = std::sqrt(total);
    return result;
  }
  Eigen::MatrixXd all(residuals.size(), unknowns + 1);
  all.leftCols(unknowns) = roots.asDiagonal() * jacobian;
  all.col(unknowns) = roots.cwiseProduct(residuals);
  const Eigen::MatrixXd factor = compressed(all);
  const Eigen::Index rows = factor.rows();
  result.jacobian.setZero(reduced_rows(unknowns), unknowns);
  result.jacobian.topRows(rows) = factor.leftCols(unknowns);
  result.residuals.head(rows) = factor.col(unknowns);
  result.residuals[unknowns + 1] = std::sqrt(std::max(0.0, total - weighted_squares));
  return result;
}

double promised_fall(const Reduced& at, const std::vector<int>& free) {
  constexpr double kResolved = 1e-7;  // of the largest singular value, as errors of differences
  constexpr double kLongest = 0.1;    // of the scale of an unknown: beyond, a linear approximation promises nothing
  if (free.empty()) return 0;
  const Eigen::MatrixXd columns = at.jacobian(Eigen::all, free);
  const SingularVectors vectors = right_singular_vectors(columns);
  const Eigen::VectorXd gradient = columns.transpose() * at.residuals;
  double fall = 0;
  for (Eigen::Index k = 0; k < vectors.values.size(); ++k) {
    if (!(vectors.values[k] > kResolved * vectors.values[0])) break;
    const double slope = std::abs(vectors.vectors.col(k).dot(gradient));
    const double step = std::min(kLongest, slope / (vectors.values[k] * vectors.values[k]));
    fall += step * (2 * slope - step * vectors.values[k] * vectors.values[k]);
  }
  return fall;
}

}  // namespace mbgen::fit
