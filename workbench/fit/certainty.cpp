#include "workbench/fit/certainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/algebra/dense.hpp"
#include "workbench/fit/reduction.hpp"

namespace mbgen::fit {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Singular values below this part of the largest are errors of differences.
constexpr double kErrorOfDifferences = 1e-7;
/// Part of a direction below which an unknown does not take part in it.
constexpr double kTakesPartInIt = 1e-3;
/// Relative difference of a coefficient from a parameter whose name stands for it.
constexpr double kSameNumber = 1e-4;

/// Reduces directions, rows of a matrix, so that each has an unknown of its own and few others.
void make_sparse(Eigen::MatrixXd& rows) {
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    Eigen::Index row = r, column = 0;
    rows.bottomRows(rows.rows() - r).cwiseAbs().maxCoeff(&row, &column);
    rows.row(r).swap(rows.row(r + row));
    rows.row(r) /= rows(r, column);
    for (Eigen::Index other = 0; other < rows.rows(); ++other)
      if (other != r) rows.row(other) -= rows(other, column) * rows.row(r);
  }
}

/// "k", where a parameter of the model has this value, else the number.
std::string coefficient_words(double value, const std::vector<Parameter>& parameters, std::string& explanation) {
  for (const Parameter& parameter : parameters) {
    if (!(std::abs(parameter.value - value) <= kSameNumber * std::abs(value)) || value == 1) continue;
    explanation = fmt::format(", with {} = {:.6g}", parameter.name, parameter.value);
    return parameter.name + " ";
  }
  return value == 1 ? "" : fmt::format("{:.6g} ", value);
}

std::string words_of(const Indifference& direction, const std::vector<Unknown>& unknowns,
                     const std::vector<Parameter>& parameters) {
  const auto name = [&](std::size_t k) { return unknowns[direction.unknowns[k]].name; };
  if (direction.unknowns.size() == 1) return fmt::format("{}: the data do not tell it", name(0));
  if (direction.unknowns.size() == 2) {
    // Where b moves by c for each unit of a, b - c a stays.
    const bool second_moves_more = std::abs(direction.parts[1]) >= std::abs(direction.parts[0]);
    const std::size_t a = second_moves_more ? 0 : 1, b = 1 - a;
    const double ratio = direction.parts[b] / direction.parts[a];
    std::string explanation;
    const std::string coefficient = coefficient_words(std::abs(ratio), parameters, explanation);
    return fmt::format("{} and {} only as {} {} {}{}{}", name(a), name(b), name(b), ratio > 0 ? "-" : "+", coefficient,
                       name(a), explanation);
  }
  std::string list, moves;
  for (std::size_t k = 0; k < direction.unknowns.size(); ++k) {
    const bool is_last = k + 1 == direction.unknowns.size();
    list += (k == 0 ? "" : is_last ? " and " : ", ") + name(k);
    moves += fmt::format("{}{} by {:.4g}", k == 0 ? "" : is_last ? " and " : ", ", name(k), direction.parts[k]);
  }
  return fmt::format("{} only together: the data are the same when they move as {}", list, moves);
}

/// Free unknowns and their scaled singular vectors.
struct Spectrum {
  std::vector<std::size_t> free;
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< columns
  Eigen::Index known = 0;   ///< number of identified directions, the first ones
};

Spectrum spectrum_of(const Eigen::MatrixXd& jacobian, const std::vector<Unknown>& unknowns,
                     const std::vector<int>& at_bound) {
  Spectrum spectrum;
  for (std::size_t u = 0; u < unknowns.size(); ++u)
    if (at_bound[u] == 0) spectrum.free.push_back(u);
  const auto size = static_cast<Eigen::Index>(spectrum.free.size());
  if (size == 0) return spectrum;
  Eigen::MatrixXd scaled(jacobian.rows(), size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const std::size_t u = spectrum.free[static_cast<std::size_t>(k)];
    scaled.col(k) = unknowns[u].scale * jacobian.col(static_cast<Eigen::Index>(u));
  }
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(size, size);
  const Eigen::MatrixXd factor = compressed(scaled);
  square.topRows(factor.rows()) = factor;
  SingularVectors vectors = right_singular_vectors(square);
  spectrum.values = std::move(vectors.values);
  spectrum.vectors = std::move(vectors.vectors);
  const double least = std::max(1.0, kErrorOfDifferences * spectrum.values[0]);
  while (spectrum.known < size && spectrum.values[spectrum.known] >= least) ++spectrum.known;
  return spectrum;
}

void add_indifferences(const Spectrum& spectrum, const std::vector<Unknown>& unknowns,
                       const std::vector<Parameter>& parameters, Certainty& certainty) {
  const Eigen::Index size = spectrum.values.size(), unseen = size - spectrum.known;
  if (unseen == 0) return;
  Eigen::MatrixXd rows = spectrum.vectors.rightCols(unseen).transpose();
  for (Eigen::Index k = 0; k < size; ++k)
    if (rows.col(k).norm() > kTakesPartInIt) certainty.identified[spectrum.free[static_cast<std::size_t>(k)]] = false;
  make_sparse(rows);
  for (Eigen::Index r = 0; r < unseen; ++r) {
    Indifference direction;
    for (Eigen::Index k = 0; k < size; ++k) {
      const std::size_t u = spectrum.free[static_cast<std::size_t>(k)];
      if (std::abs(rows(r, k)) <= kTakesPartInIt) continue;
      direction.unknowns.push_back(u);
      direction.parts.push_back(rows(r, k) * unknowns[u].scale);
    }
    direction.words = words_of(direction, unknowns, parameters);
    certainty.indifferences.push_back(std::move(direction));
  }
}

void add_covariance(const Spectrum& spectrum, const std::vector<Unknown>& unknowns, Certainty& certainty) {
  const auto covariance = [&](std::size_t i, std::size_t j) {
    double sum = 0;
    for (Eigen::Index k = 0; k < spectrum.known; ++k)
      sum += spectrum.vectors(static_cast<Eigen::Index>(i), k) * spectrum.vectors(static_cast<Eigen::Index>(j), k) /
             (spectrum.values[k] * spectrum.values[k]);
    return sum * unknowns[spectrum.free[i]].scale * unknowns[spectrum.free[j]].scale;
  };
  for (std::size_t i = 0; i < spectrum.free.size(); ++i)
    for (std::size_t j = 0; j < spectrum.free.size(); ++j) {
      const std::size_t u = spectrum.free[i], v = spectrum.free[j];
      if (!certainty.identified[u] || !certainty.identified[v]) continue;
      const auto row = static_cast<Eigen::Index>(u), column = static_cast<Eigen::Index>(v);
      certainty.covariance(row, column) = covariance(i, j);
      certainty.correlation(row, column) =
          i == j ? 1 : covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
      if (i == j) certainty.standard_errors[u] = std::sqrt(covariance(i, i));
    }
}

}  // namespace

Certainty certainty_of(const Eigen::MatrixXd& jacobian, const std::vector<Unknown>& unknowns,
                       const std::vector<double>& values, const std::vector<Parameter>& parameters) {
  Certainty certainty;
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  certainty.covariance.setConstant(size, size, kNone);
  certainty.correlation = certainty.covariance;
  certainty.standard_errors.assign(unknowns.size(), kNone);
  certainty.identified.assign(unknowns.size(), true);
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const double rounding = kAtBound * unknowns[u].scale;
    certainty.at_bound.push_back(values[u] <= unknowns[u].lower + rounding   ? -1
                                 : values[u] >= unknowns[u].upper - rounding ? 1
                                                                             : 0);
  }
  const Spectrum spectrum = spectrum_of(jacobian, unknowns, certainty.at_bound);
  for (const double value : spectrum.values) certainty.eigenvalues.push_back(value * value);
  add_indifferences(spectrum, unknowns, parameters, certainty);
  add_covariance(spectrum, unknowns, certainty);
  return certainty;
}

Whiteness whiteness_of(const std::vector<double>& residuals) {
  constexpr std::size_t kMostLags = 20, kRowsPerLag = 5;
  Whiteness whiteness;
  const std::size_t count = residuals.size();
  double squares = 0, steps = 0;
  for (std::size_t k = 0; k < count; ++k) {
    squares += residuals[k] * residuals[k];
    if (k > 0) steps += (residuals[k] - residuals[k - 1]) * (residuals[k] - residuals[k - 1]);
  }
  const std::size_t lags = std::min(kMostLags, count / kRowsPerLag);
  if (lags == 0 || squares == 0) return whiteness;
  whiteness.durbin_watson = steps / squares;
  whiteness.lags = static_cast<int>(lags);
  double sum = 0;
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    double products = 0;
    for (std::size_t k = lag; k < count; ++k) products += residuals[k] * residuals[k - lag];
    sum += products * products / (squares * squares) / static_cast<double>(count - lag);
  }
  const double n = static_cast<double>(count), m = static_cast<double>(lags);
  const double statistic = n * (n + 2) * sum;
  const double normal = (std::cbrt(statistic / m) - (1 - 2 / (9 * m))) / std::sqrt(2 / (9 * m));
  whiteness.probability = std::erfc(normal / std::sqrt(2.0)) / 2;
  return whiteness;
}

}  // namespace mbgen::fit
