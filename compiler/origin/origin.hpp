#pragma once
// Where a value of the equations comes from: a step of the paper, and a part of the mechanism.

#include <compare>
#include <cstdint>

namespace mbgen {

/// The nine steps of the paper's tables 1 and 2, in order; after them what programs at given accelerations do as the
/// last.
enum class Step : std::uint8_t {
  none,
  inertias,
  jacobian,
  projection,
  velocities,
  forces,
  closure_bias,
  accelerations,
  reduced_system,
  solution,
  multipliers,
  outputs,
  tangents
};

/// Number of a step in the paper: 9 too for what programs at given accelerations do last, 0 for none.
constexpr int number_of(Step step) { return static_cast<int>(step < Step::solution ? step : Step::solution); }

/// A step, of one loop block where each is taken through it by itself.
struct Section {
  Step step = Step::none;
  int block = -1;  ///< index of the loop block, -1 for the whole mechanism
  auto operator<=>(const Section&) const = default;
};

/// Kinds of parts of a mechanism that values belong to.
enum class OwnerKind : std::uint8_t {
  none,
  tree_body,  ///< a body of the tree with its coordinate
  loop,
  loop_block,
  body,  ///< of the model, as the next
  joint,
  motion,
  output,
  state,
  sampled,
  element  ///< of the first kind in the model's list; those of the next kinds follow, see owner_of_kind
};

/// Elements of the kind at a place of the model's list, which nobody below the model knows.
constexpr OwnerKind owner_of_kind(int place) {
  return static_cast<OwnerKind>(static_cast<int>(OwnerKind::element) + place);
}

/// Place of the kind in the model's list; negative for owners that are no elements.
constexpr int place_of_kind(OwnerKind kind) { return static_cast<int>(kind) - static_cast<int>(OwnerKind::element); }

/// A part of the mechanism.
struct Owner {
  OwnerKind kind = OwnerKind::none;
  int index = -1;  ///< in the list of the topology or the model
  auto operator<=>(const Owner&) const = default;
};

}  // namespace mbgen
