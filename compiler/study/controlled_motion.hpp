#pragma once
// The motion of an engine as a system of ordinary differential equations y' = f(t, y) in one array.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compiler/engines/engine.hpp"
#include "compiler/study/inputs_over_time.hpp"

namespace mbgen {

/// y: all coordinates, their velocities, auxiliary states. f closes the loops at y before it evaluates the rates, so
/// that it depends on the closed state alone.
class ControlledMotion {
 public:
  ControlledMotion(const Engine& engine, const InputsOverTime& inputs) : engine_(engine), inputs_(inputs) {}

  /// The motion goes on from a closed state, whose balls keep their charts; up to `end` (s) the inputs are those just
  /// before it, and after that they are not asked for.
  void begin(const GenericState& state, double end);
  std::size_t size() const { return 2 * guess_.z.size() + guess_.x.size(); }
  void copy(const GenericState& state, double* y) const;
  /// The closed state at y.
  Status close(double t, const double* y, GenericState& state) const;
  /// Rates at y. Fails: as the engine; loop_not_closed where closing is a jump.
  Status rates(double t, const double* y, double* f) const;
  /// Derivatives of f by y, column by column; columns that closing takes back are zero. f: at y. scratch: of the same
  /// size. set(row, column, value) takes them.
  template <class Set>
  Status jacobian(double t, double* y, const double* f, double* scratch, const Set& set) const;
  /// Closing starts from this state from now on.
  void follow(const GenericState& closed) { guess_ = closed; }
  const GenericState& guess() const { return guess_; }
  const Engine& engine() const { return engine_; }
  /// Evaluations so far.
  long evaluations() const { return evaluations_; }

 private:
  Status rates_of(const GenericState& closed, double* f) const;

  const Engine& engine_;
  const InputsOverTime& inputs_;
  GenericState guess_;  ///< for driven coordinates, charts
  double end_ = 0;
  mutable long evaluations_ = 0;
};

template <class Set>
Status ControlledMotion::jacobian(double t, double* y, const double* f, double* scratch, const Set& set) const {
  constexpr double kDifference = 1.5e-8;      // of a value, and of 1 rad, 1 m or 1 per second at least
  constexpr double kOfAuxiliaryState = 1e-4;  // m, in place of 1
  constexpr double kTakenBack = 0.01;         // of the difference
  GenericState base, moved;
  Status status = close(t, y, base);
  std::vector<double> closed(size()), other(size());
  copy(base, closed.data());
  for (std::size_t j = 0; j < size() && status.ok(); ++j) {
    const double least = j < 2 * guess_.z.size() ? 1.0 : kOfAuxiliaryState;
    const double difference = kDifference * std::max(std::abs(y[j]), least);
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
