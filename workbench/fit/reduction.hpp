#pragma once
// Many residuals as the few rows that the method needs, with a loss that bounds the weight of outliers.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "workbench/fit/least_squares.hpp"

namespace mbgen::fit {

/// Loss of a residual r: r^2 / 2, or less where |r| exceeds `limit` standard deviations. Source: P. J. Huber, Robust
/// Statistics, 1981, for Huber's; W. J. J. Rey, Introduction to Robust and Quasi-Robust Statistical Methods, 1983, for
/// Cauchy's.
struct Loss {
  enum class Kind { squares, huber, cauchy };
  Kind kind = Kind::squares;
  double limit = 1;
};

/// "squares", "huber:1.5" or "cauchy:2". Fails: UserError.
Loss loss_of(const std::string& text);

/// Weight of a residual, 1 for least squares: derivative of the loss by r^2 / 2.
double weight_of(const Loss& loss, double residual);

/// Rows of a reduced problem with so many unknowns.
constexpr int reduced_rows(int unknowns) { return unknowns + 2; }

/// As few rows as columns with the same products of columns: S V' of rows = U S V'.
Eigen::MatrixXd compressed(const Eigen::MatrixXd& rows);

/// [J r], each row with the root of its weight, compressed, in place of J and r, and one row without derivatives for
/// the rest of the loss: the sum of squares, J' r and J' J stay. jacobian: without rows where only the sum is needed;
/// its columns are by the method's unknowns.
Reduced reduced(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian, const Loss& loss);

/// The fall of the sum of squares that its linear approximation promises along the free unknowns, in directions that
/// derivatives resolve, by steps of at most a tenth of the scales of the unknowns.
double promised_fall(const Reduced& at, const std::vector<int>& free);

}  // namespace mbgen::fit
