#pragma once
// The motion of an engine as a system of ordinary differential equations y' = f(t, y) in one array.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "workbench/engines/engine.hpp"
#include "workbench/motion/corners.hpp"
#include "workbench/motion/inputs_over_time.hpp"

namespace mbgen {

/// y: all coordinates, their velocities, auxiliary states. f closes the loops at y before it evaluates the rates, so
/// that it depends only on the closed state.
class ControlledMotion {
 public:
  /// magnitudes: of the auxiliary states, see magnitude_of. corners: none if laws have no corner handling. inputs:
  /// outlive the motion.
  ControlledMotion(Engine engine, const InputsOverTime& inputs, std::vector<double> magnitudes,
                   std::optional<Corners> corners)
      : engine_(std::move(engine)), inputs_(inputs), magnitudes_(std::move(magnitudes)), corners_(std::move(corners)) {}

  /// Continues from a closed state, whose balls keep their charts. Up to `end` (s) the inputs are their left limits
  /// there; later inputs are not used.
  void begin(const GenericState& state, double end);
  std::size_t size() const { return 2 * guess_.z.size() + guess_.x.size(); }
  void copy(const GenericState& state, double* y) const;
  /// The closed state at y.
  Status close(double t, const double* y, GenericState& state) const;
  /// Rates at y. Fails: like the engine; loop_not_closed if closing is a jump.
  Status rates(double t, const double* y, double* f) const;
  /// Derivatives of f by y, column by column; columns that closing cancels are zero. f: at y. scratch: of the same
  /// size. set(row, column, value) receives them.
  template <class Set>
  Status jacobian(double t, double* y, const double* f, double* scratch, const Set& set) const;
  /// Closing starts from this state from now on.
  void follow(const GenericState& closed) { guess_ = closed; }
  const GenericState& guess() const { return guess_; }
  const Engine& engine() const { return engine_; }
  const InputsOverTime& inputs() const { return inputs_; }
  /// Size of entry i of y that counts as much as 1 rad, 1 m or 1 per second.
  double size_of(std::size_t i) const {
    const std::size_t first = 2 * guess_.z.size();
    return i < first ? 1.0 : magnitudes_[i - first];
  }

  /// Corners of the laws; none while a ball is in its other chart.
  std::size_t corners() const { return corners_ ? corners_->count() : 0; }
  /// Conditions that choose the sides of the corners, at y.
  std::vector<double> conditions(double t, const double* y) const;
  /// Rates keep these sides of the corners from now on, each 1 or -1; 0 for the side of the state.
  void hold(std::vector<double> sides) { sides_ = std::move(sides); }
  const std::vector<double>& sides() const { return sides_; }
  /// Change of the rates at y by other sides in place of the held ones.
  GenericDerivative change_by(double t, const double* y, const std::vector<double>& sides) const;
  /// Evaluations so far.
  long evaluations() const { return evaluations_; }

 private:
  Status rates_of(const GenericState& closed, double* f) const;
  /// Corrects the rates to the held sides.
  void keep_sides(const GenericState& closed, GenericDerivative& rates) const;
  /// The state at y without closing, in the angles of the model.
  GenericState open(double t, const double* y) const;
  std::vector<double> inputs_at(double t) const;

  Engine engine_;
  const InputsOverTime& inputs_;
  std::vector<double> magnitudes_;
  std::optional<Corners> corners_;
  std::vector<double> sides_;
  GenericState guess_;  ///< for driven coordinates, charts
  double end_ = 0;
  mutable long evaluations_ = 0;
};

template <class Set>
Status ControlledMotion::jacobian(double t, double* y, const double* f, double* scratch, const Set& set) const {
  constexpr double kDifference = 1.5e-8;  // of a value, and of size_of at least
  constexpr double kTakenBack = 0.01;     // of the difference
  GenericState base, moved;
  Status status = close(t, y, base);
  std::vector<double> closed(size()), other(size());
  copy(base, closed.data());
  for (std::size_t j = 0; j < size() && status.ok(); ++j) {
    const double difference = kDifference * std::max(std::abs(y[j]), size_of(j));
    const double kept = y[j];
    y[j] += difference;
    status = close(t, y, moved);
    y[j] = kept;
    if (!status.ok()) break;
    copy(moved, other.data());
    double largest = 0;
    for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, std::abs(other[i] - closed[i]));
    const bool taken_back = largest < kTakenBack * difference;
    if (!taken_back) status = rates_of(moved, scratch);
    for (std::size_t i = 0; i < size() && status.ok(); ++i)
      set(i, j, taken_back ? 0.0 : (scratch[i] - f[i]) / difference);
  }
  return status;
}

}  // namespace mbgen
