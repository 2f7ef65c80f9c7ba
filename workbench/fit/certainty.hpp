#pragma once
// How certain the unknowns of a fit are: standard errors, correlations, and combinations that the data do not see.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "compiler/expressions/parameter.hpp"
#include "workbench/search/unknowns.hpp"

namespace mbgen::fit {

/// A direction in which unknowns may move together and the data do not tell.
struct Indifference {
  std::vector<std::size_t> unknowns;  ///< that take part
  std::vector<double> parts;          ///< their movements, in their units; the first moves by its scale
  std::string words;                  ///< "L0 and pre only as pre - k L0, with k = 32203.2"
};

struct Certainty {
  Eigen::MatrixXd covariance, correlation;  ///< of all unknowns; NaN where one is at a bound or not identified
  std::vector<double> standard_errors;      ///< likewise
  std::vector<int> at_bound;                ///< -1 lower, 1 upper, 0 neither
  std::vector<bool> identified;             ///< whether the data determine it by itself
  std::vector<Indifference> indifferences;
  std::vector<double> eigenvalues;  ///< of the scaled information matrix, largest first; of unknowns at no bound
};

/// An unknown is at its bound within this part of its scale.
constexpr double kAtBound = 1e-7;

/// Certainty at the optimum. jacobian: of residuals in standard deviations, or compressed. The information J' J is
/// scaled by the unknowns' scales; a direction is not identified where its uncertainty exceeds one scale, or where its
/// singular value is below 1e-7 of the largest, the accuracy of differences. The covariance is inv(J' J), with
/// directions that are not identified left out. parameters: of the model at the optimum, whose names serve as
/// coefficients in words.
Certainty certainty_of(const Eigen::MatrixXd& jacobian, const std::vector<Unknown>& unknowns,
                       const std::vector<double>& values, const std::vector<Parameter>& parameters);

/// Whether residuals look like noise.
struct Whiteness {
  double durbin_watson = 2;  ///< 2 of white noise, near 0 where neighbours are alike
  int lags = 0;
  double probability = 1;  ///< of autocorrelations as large as these in white noise, by Ljung and Box
};

/// Source: J. Durbin, G. S. Watson, Biometrika 37, 1950; G. M. Ljung, G. E. P. Box, Biometrika 65, 1978, with the
/// distribution of chi squared by E. B. Wilson, M. M. Hilferty, PNAS 17, 1931.
Whiteness whiteness_of(const std::vector<double>& residuals);

}  // namespace mbgen::fit
