#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "compiler/linearisation/linearisation.hpp"

namespace mbgen {
namespace {

/// An eigenvalue this much smaller than the largest is zero: those of a chain of two, as position and velocity of a
/// body that nothing holds are, come out at the square root of the rounding.
constexpr double kNeutral = 1e-6;
/// Growth this much smaller than the largest eigenvalue is rounding: what has no damping does not grow.
constexpr double kGrowth = 1e-9;
/// A coordinate that moves less than this part of the one that moves most is not named.
constexpr double kNamed = 0.1;
constexpr std::size_t kMostNamed = 4;

Mode mode_of(const LinearSystem& system, std::complex<double> eigenvalue, const Eigen::VectorXcd& vector) {
  Mode mode;
  mode.eigenvalue = eigenvalue;
  const Eigen::VectorXcd coordinates = system.coordinates * vector;
  Eigen::Index place = 0;
  const double largest = coordinates.size() > 0 ? coordinates.cwiseAbs().maxCoeff(&place) : 0.0;
  std::complex<double> scale = largest > 0 ? coordinates[place] : 0.0;
  if (largest == 0) {  // only auxiliary states
    vector.cwiseAbs().maxCoeff(&place);
    scale = vector[place];
  }
  const auto scaled = [&](const Eigen::VectorXcd& values) {
    std::vector<std::complex<double>> result;
    for (const std::complex<double> value : values) result.push_back(value / scale);
    return result;
  };
  mode.states = scaled(vector);
  mode.coordinates = scaled(coordinates);
  return mode;
}

/// Fast oscillations before slow ones, before what does not oscillate.
bool comes_before(const Mode& a, const Mode& b) {
  const auto key = [](const Mode& mode) {
    return std::pair(mode.is_neutral ? 0.0 : mode.eigenvalue.imag(), -mode.eigenvalue.real());
  };
  return key(a) > key(b);
}

}  // namespace

std::vector<Mode> modes(const LinearSystem& system) {
  std::vector<Mode> result;
  if (system.A.rows() == 0) return result;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(system.A);
  const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < solver.eigenvalues().size(); ++i) {
    const std::complex<double> eigenvalue = solver.eigenvalues()[i];
    const bool is_neutral = std::abs(eigenvalue) <= kNeutral * largest;
    if (eigenvalue.imag() < 0) continue;
    Mode mode = mode_of(system, eigenvalue, solver.eigenvectors().col(i));
    mode.is_neutral = is_neutral;
    mode.is_unstable = !is_neutral && eigenvalue.real() > kGrowth * largest;
    result.push_back(std::move(mode));
  }
  std::stable_sort(result.begin(), result.end(), comes_before);
  return result;
}

std::string leading_coordinates(const Topology& topology, const Mode& mode) {
  std::vector<std::size_t> order(mode.coordinates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(mode.coordinates[a]) > std::abs(mode.coordinates[b]);
  });
  std::string text;
  for (std::size_t i = 0; i < std::min(order.size(), kMostNamed); ++i) {
    const double size = std::abs(mode.coordinates[order[i]]);
    if (!(size >= kNamed)) break;
    text += fmt::format("{}{} {:.2f}", i == 0 ? "" : ", ", topology.bodies[order[i]].coordinate, size);
  }
  return text;
}

}  // namespace mbgen
