#pragma once
// Left and right among the values of a program: which value is another one's image in a mirror of the mechanism.

#include <span>
#include <vector>

#include "compiler/solver/programs.hpp"

namespace mbgen {

/// What the mirror makes of a value. "At the image" means: with inputs as the mirror makes them.
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

/// One per value of a program without pairs. Decided by values alone, at random states and their images, within what
/// roundings amount to: how the two sides are spelled does not matter. Any mirror is sound: one that the mechanism does
/// not have leaves no value paired.
std::vector<MirrorImage> mirror_images(const Program& program, std::span<const MirroredInput> mirror);

}  // namespace mbgen
