#pragma once
// Instants at which laws of a model that depend on time alone jump or have a corner: a switch by step(t - 1), the end
// of a ramp min(1, t), a point of a table with straight pieces.

#include <array>
#include <memory>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// A part of a step, s.
struct StepPart {
  double start = 0, end = 0;
};

/// The branches of laws of time, and the instants at which they change.
class LawInstants {
 public:
  LawInstants() = default;
  /// Of all expressions of the model, at the values of its parameters.
  explicit LawInstants(const Model& model);

  bool is_empty() const { return conditions_.empty(); }
  /// Parts of a step on each of which all laws keep their branch: they end just before an instant and begin just after
  /// it, also where the step itself begins or ends there. None if no branch changes, or if too many do. jumps: further
  /// instants, ascending, s.
  std::vector<StepPart> parts(double start, double end, const std::vector<double>& jumps) const;

 private:
  /// The choice of a branch: by the sign of a value, by its whole part, or by the piece of a table in which it lies.
  struct Condition {
    Expression value;
    bool is_whole = false;
    std::shared_ptr<const NamedTable> table = nullptr;
  };
  void add(const Expression& expression, const std::vector<bool>& of_time);
  double side(const Condition& condition, double t) const;
  std::vector<double> sides(double t) const;
  /// Whether a law has another branch at one of these times than at the first.
  bool changes(const std::array<double, 4>& times) const;

  std::vector<Condition> conditions_;
  std::vector<double> parameters_;  ///< in the order of the model
};

}  // namespace mbgen
