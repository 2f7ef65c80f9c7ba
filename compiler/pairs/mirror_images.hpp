#pragma once
// Left and right among the values of a program: which value is another one's image in a mirror of the mechanism.

#include <array>
#include <span>
#include <vector>

#include "compiler/solver/programs.hpp"

namespace mbgen {

/// Mirror image of a value. "At the image" means: with inputs as the mirror makes them.
struct MirrorImage {
  enum class Kind : std::uint8_t {
    unknown,  ///< no other value is its image, and an input that it needs has none
    lone,     ///< no other value is its image; the same operations at the image give it
    shared,   ///< at the image it is `sign` times itself; constants too
    paired    ///< it is `sign` times the value `first`, at the image when it is crossed
  };
  Kind kind = Kind::unknown;
  int sign = 1;
  bool is_crossed = false;
  ValueId first = kNoValue;  ///< of its pair, the earliest; kNoValue of all but paired values
};

/// A value with its sign.
struct SignedTerm {
  ValueId value = kNoValue;
  int sign = 1;
};

/// Values that pairs may be made of.
struct PairedValues {
  std::vector<MirrorImage> images;  ///< one per value
  /// Twins, where there are no mirror images: per value that is the earlier twin, the operands of the other one, each
  /// beside the value's own that it shares a pair with. That pair may hold twins, two constants, one value twice or any
  /// two numbers. kNoValue of inputs and of values without a twin.
  std::vector<std::array<SignedTerm, 3>> beside = {};

  bool are_twins() const { return !beside.empty(); }
  /// Whether the pair of a value holds the other term.
  bool are_one_pair(ValueId a, const SignedTerm& b) const {
    const MirrorImage &one = images[a], &other = images[b.value];
    return one.kind == MirrorImage::Kind::paired && other.kind == MirrorImage::Kind::paired &&
           one.first == other.first && one.is_crossed != other.is_crossed && one.sign * other.sign == b.sign;
  }
};

/// One per value; pairs are unknown. Decided by algebra, as the identities are (identities.hpp): how the two sides are
/// spelled does not matter, and nothing is an image because it is near. Any mirror is sound: one that the mechanism
/// does not have leaves no value paired.
std::vector<MirrorImage> mirror_images(const Program& program, std::span<const MirroredInput> mirror);

}  // namespace mbgen
