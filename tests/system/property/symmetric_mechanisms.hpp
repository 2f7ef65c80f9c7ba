#pragma once
// Random mechanisms with a symmetry. Inside the property tests.

#include "tests/system/property/random_mechanism.hpp"

namespace mbgen::testing {

/// A base that keeps to the plane y = 0, a closed half of pins, slides and a rod on its left, the mirror image of that
/// on its right; half of the time a spring from one half to the other. Body 0 is the base; the images of
/// bodies 1 to n are n + 1 to 2n.
RandomMechanism random_mirror_halves(std::uint64_t seed);

/// One body of the second half has another mass, or its centre of mass elsewhere. Result of random_mirror_halves
/// required.
RandomMechanism with_one_other_number(RandomMechanism halves, std::uint64_t seed);

/// Three equal legs of pins on ground, and a platform on the balls of their feet.
RandomMechanism random_equal_legs(std::uint64_t seed);

/// Two to five equal planar four-bars side by side on a base that turns or slides, each with a body that hangs on its
/// coupler; half of the time springs from the base. Body 0 is the base, then a cell after another.
RandomMechanism random_equal_cells(std::uint64_t seed);

/// The same, but masses of all cells and the place of each one differ: other numbers in equal operations.
RandomMechanism random_alike_cells(std::uint64_t seed);

}  // namespace mbgen::testing
