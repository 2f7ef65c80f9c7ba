#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "compiler/algebra/dense.hpp"
#include "compiler/linearisation/linearisation.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {
namespace {

/// Eigenvalue relative to the largest that counts as zero: a double zero, as position and velocity of an unconstrained
/// body, is computed with an error of the square root of rounding.
constexpr double kNeutral = 1e-6;
/// Growth relative to the largest eigenvalue that is rounding: a mode without damping does not grow.
constexpr double kGrowth = 1e-9;
constexpr double kStiffSystem = 1e8;          // 1/s^2, largest entry of A
constexpr double kFast = 1e4;                 // 1/s: faster modes do not raise what counts as zero
constexpr double kRoundingOfEntries = 1e-13;  // s: growth that the largest entry of a stiff A makes by rounding
/// Least amplitude named, relative to the largest of its kind.
constexpr double kNamed = 0.1;
constexpr std::size_t kMostNamed = 4, kMostOfOther = 2;
/// Least ratio of metres to radians, or the reverse, for which the other kind is named.
constexpr double kOtherKind = 0.01;
/// Phases this near to 0 or 180 degrees are shown as a sign.
constexpr double kInPhase = 15;  // degrees
/// Neutral states with a smaller difference in positions are the same position with different speeds.
constexpr double kSameShape = 1e-3;
/// Pivot relative to the largest that counts as zero.
constexpr double kNothing = 1e-11;

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
    const auto index = static_cast<std::size_t>(place);
    if (index < system.states.size() && system.states[index].kind == LinearState::Kind::auxiliary)
      mode.auxiliary = system.states[index].index;
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

/// Fast oscillations before slow ones, before modes that do not oscillate.
bool comes_before(const Mode& a, const Mode& b) {
  const auto key = [](const Mode& mode) {
    return std::pair(mode.is_neutral ? 0.0 : mode.eigenvalue.imag(), -mode.eigenvalue.real());
  };
  return key(a) > key(b);
}

/// Units of the states, powers of two, in which the column of A of an auxiliary state is as large as its row outside of
/// the diagonal: a pressure of 1e6 Pa beside an angle would hide zeros. Positions and velocities keep their units
/// unless the system is stiff: beside beams that stretch springs would look like zeros. Source: E. E. Osborne, "On
/// Pre-Conditioning of Matrices", Journal of the ACM 7(4), 1960.
Eigen::VectorXd balancing_units(const LinearSystem& system) {
  Eigen::MatrixXd a = system.A;
  Eigen::VectorXd units = Eigen::VectorXd::Ones(a.rows());
  constexpr int kSweeps = 20;
  const bool is_stiff = a.size() > 0 && a.cwiseAbs().maxCoeff() > kStiffSystem;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    bool changes = false;
    for (std::size_t s = 0; s < system.states.size(); ++s) {
      const auto i = static_cast<Eigen::Index>(s);
      const double own = std::abs(a(i, i)), column = a.col(i).cwiseAbs().sum() - own,
                   row = a.row(i).cwiseAbs().sum() - own;
      if ((system.states[s].kind != LinearState::Kind::auxiliary && !is_stiff) || !(column > 0) || !(row > 0)) continue;
      const double unit = std::exp2(std::round(std::log2(row / column) / 2));
      a.col(i) *= unit;
      a.row(i) /= unit;
      units[i] *= unit;
      changes = changes || unit != 1;
    }
    if (!changes) break;
  }
  return units;
}

/// An orthonormal basis of the states that are constant, or drift at a constant rate along constant ones, as position
/// for a constant heading: kernels of A, A^2, ...
Eigen::MatrixXd neutral_states(const LinearSystem& system) {
  const Eigen::VectorXd units = balancing_units(system);
  const Eigen::MatrixXd a = units.cwiseInverse().asDiagonal() * system.A * units.asDiagonal();
  Eigen::MatrixXd basis(a.rows(), 0);
  for (Eigen::Index size = -1; size < basis.cols() && basis.cols() < a.rows();) {
    size = basis.cols();
    const Eigen::MatrixXd beside = a - basis * (basis.transpose() * a);
    basis = indifferent_directions(beside, kNothing);
  }
  if (basis.cols() == 0 || units.isOnes()) return basis;
  const Eigen::MatrixXd in_own_units = units.asDiagonal() * basis;
  return right_singular_vectors(in_own_units.transpose()).vectors.leftCols(basis.cols());
}

/// The largest eigenvalue that is zero up to rounding: for a triple zero, as yaw rate, heading and position of a
/// rolling wheel, the error is the cube root of rounding.
double largest_zero(const LinearSystem& system, const Eigen::VectorXcd& values) {
  std::vector<double> sizes;
  for (const std::complex<double> value : values) sizes.push_back(std::abs(value));
  std::sort(sizes.begin(), sizes.end());
  const Eigen::Index still = neutral_states(system).cols();
  return still > 0 ? sizes[static_cast<std::size_t>(still - 1)] : 0.0;
}

/// A coordinate in a mode.
struct MovingCoordinate {
  std::size_t index = 0;
  std::complex<double> amplitude;
  bool is_independent = false;
};

bool is_translation(const TreeBody& body) { return body.kind == FreedomKind::prismatic; }

/// Keeps coordinates with amplitudes above a fraction of the largest: independent coordinates first, the largest first.
void leave_leading(std::vector<MovingCoordinate>& moving) {
  double largest = 0;
  for (const MovingCoordinate& one : moving) largest = std::max(largest, std::abs(one.amplitude));
  std::erase_if(moving, [&](const auto& one) { return largest == 0 || std::abs(one.amplitude) < kNamed * largest; });
  std::stable_sort(moving.begin(), moving.end(), [](const MovingCoordinate& a, const MovingCoordinate& b) {
    return std::pair(a.is_independent, std::abs(a.amplitude)) > std::pair(b.is_independent, std::abs(b.amplitude));
  });
}

/// Amplitude of the first one, 0 if there is none.
double size_of(const std::vector<MovingCoordinate>& moving) {
  return moving.empty() ? 0.0 : std::abs(moving.front().amplitude);
}

/// "name +1.00, other -0.52, third 0.40 at 87 deg": sizes over `scale`, phases from `reference`.
std::string shape_text(const Topology& topology, const std::vector<MovingCoordinate>& moving,
                       std::complex<double> reference, double scale, std::size_t most) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  std::string text;
  for (std::size_t i = 0; i < std::min(moving.size(), most); ++i) {
    const double size = std::abs(moving[i].amplitude) / scale;
    const double phase = std::arg(moving[i].amplitude / reference) / kDegree;
    const bool is_along = std::abs(phase) <= kInPhase, is_against = std::abs(phase) >= 180 - kInPhase;
    text += fmt::format("{}{} {}{:.2f}", i == 0 ? "" : ", ", topology.bodies[moving[i].index].coordinate,
                        is_along     ? "+"
                        : is_against ? "-"
                                     : "",
                        size);
    if (!is_along && !is_against) text += fmt::format(" at {:.0f} deg", phase);
  }
  return text;
}

}  // namespace

Eigen::Index position_count(const LinearSystem& system) {
  return std::count_if(system.states.begin(), system.states.end(),
                       [](const LinearState& state) { return state.kind == LinearState::Kind::position; });
}

std::vector<Mode> modes(const LinearSystem& system) {
  std::vector<Mode> result;
  if (system.A.rows() == 0) return result;
  const EigenVectors solutions = eigenvectors(system.A);
  const double largest = solutions.values.cwiseAbs().maxCoeff(), zero = largest_zero(system, solutions.values);
  const double growth = std::max(kGrowth * largest, kRoundingOfEntries * system.A.cwiseAbs().maxCoeff());
  for (Eigen::Index i = 0; i < solutions.values.size(); ++i) {
    const std::complex<double> eigenvalue = solutions.values[i];
    const bool is_neutral = std::abs(eigenvalue) <= std::max(zero, kNeutral * std::min(largest, kFast));
    if (eigenvalue.imag() < 0) continue;
    Mode mode = mode_of(system, eigenvalue, solutions.vectors.col(i));
    mode.is_neutral = is_neutral;
    mode.is_unstable = !is_neutral && eigenvalue.real() > growth;
    result.push_back(std::move(mode));
  }
  std::stable_sort(result.begin(), result.end(), comes_before);
  return result;
}

void put_slowest_first(std::vector<Mode>& list) {
  const auto key = [](const Mode& mode) {
    const bool oscillates = mode.oscillates();
    return std::tuple(mode.is_neutral, !oscillates,
                      oscillates ? mode.eigenvalue.imag() : std::abs(mode.eigenvalue.real()));
  };
  std::ranges::stable_sort(list, {}, key);
}

std::string leading_coordinates(const Model& model, const Topology& topology, const Analysis& analysis,
                                const Mode& mode) {
  std::vector<MovingCoordinate> moving[2];
  for (std::size_t i = 0; i < mode.coordinates.size(); ++i) {
    moving[is_translation(topology.bodies[i]) ? 1 : 0].push_back({i, mode.coordinates[i], false});
  }
  for (const int i : free_coordinates(topology, analysis)) {
    for (std::vector<MovingCoordinate>& kind : moving) {
      for (MovingCoordinate& one : kind) one.is_independent |= one.index == static_cast<std::size_t>(i);
    }
  }
  for (std::vector<MovingCoordinate>& kind : moving) leave_leading(kind);
  const double rotation = size_of(moving[0]), translation = size_of(moving[1]);
  if (rotation == 0 && translation == 0)
    return mode.auxiliary < 0 ? "" : "x." + auxiliary_state_names(model)[static_cast<std::size_t>(mode.auxiliary)];
  const int first = translation > rotation ? 1 : 0;
  const std::complex<double> reference = moving[first].front().amplitude;
  std::string text = shape_text(topology, moving[first], reference, std::abs(reference), kMostNamed);
  const double ratio = size_of(moving[1 - first]) / std::abs(reference);
  if (ratio < kOtherKind) return text;
  return fmt::format("{}; {:.2g} {}: {}", text, ratio, first == 0 ? "m/rad" : "rad/m",
                     shape_text(topology, moving[1 - first], reference, size_of(moving[1 - first]), kMostOfOther));
}

std::vector<std::string> neutral_coordinates(const Topology& topology, const LinearSystem& system) {
  const Eigen::MatrixXd still = neutral_states(system);
  std::vector<Eigen::Index> positions;
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    if (system.states[i].kind == LinearState::Kind::position) positions.push_back(static_cast<Eigen::Index>(i));
  }
  if (still.cols() == 0 || positions.empty()) return {};
  std::vector<int> chosen = leading_columns(still(positions, Eigen::all).transpose(), kSameShape);
  std::sort(chosen.begin(), chosen.end());
  std::vector<std::string> names;
  for (const int c : chosen) {
    const LinearState& state = system.states[static_cast<std::size_t>(positions[static_cast<std::size_t>(c)])];
    names.push_back(topology.bodies[static_cast<std::size_t>(state.index)].coordinate);
  }
  return names;
}

}  // namespace mbgen
