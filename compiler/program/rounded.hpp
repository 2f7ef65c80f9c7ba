#pragma once
// Values of a program with smooth functions, with bounds of what their roundings may have made of them.

#include <span>
#include <utility>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

struct Rounded {
  double value = 0;
  double error = 0;  ///< about what all roundings up to here amount to, not below
};

/// Of a value, of both lanes of a pair.
struct RoundedLanes {
  Rounded first, second;  ///< the same of a number
  bool is_pair = false;
};

/// The values of a program one after the other, while it is written. Functions that are in pieces (abs, min, max,
/// select, floor, sample) or have a branch (sqrt, atan2) stand aside for smooth ones, whose roundings do not jump.
class RoundedValues {
 public:
  /// inputs: in the order of Program::inputs.
  explicit RoundedValues(std::vector<Rounded> inputs) : inputs_(std::move(inputs)) {}
  /// The next value. Requires: its operands are earlier ones.
  void append(const Node& node);
  std::size_t size() const { return all_.size(); }
  const RoundedLanes& operator[](ValueId value) const { return all_[value]; }

 private:
  RoundedLanes lanes_of(const Node& node) const;
  std::vector<Rounded> inputs_;
  std::vector<RoundedLanes> all_;
};

/// One per node, of a program without pairs; for telling how well values are known. inputs: exact.
std::vector<Rounded> rounded_values(const Program& program, std::span<const double> inputs);

/// Inputs of a state as models have them, random: small angles and lengths, rates about 1. Set `number`, the same on
/// every machine.
std::vector<double> ordinary_inputs(const Program& program, std::size_t number);

}  // namespace mbgen
