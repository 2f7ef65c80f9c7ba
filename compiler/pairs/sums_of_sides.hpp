#pragma once
// Sums over both sides of a mirror: their terms, those of left and right together.

#include <span>
#include <vector>

#include "compiler/pairs/mirror_images.hpp"

namespace mbgen {

/// A value and its image in one sum: `sign` times the value `first` of the pair, and `parity` times its image.
struct TermPair {
  ValueId first = kNoValue;
  int sign = 1;
  int parity = 1;  ///< 1 or -1
};

/// A value that sums left and right, and is in no pair itself.
struct SumOfSides {
  std::vector<SignedTerm> alone;
  std::vector<TermPair> pairs;
};

struct SumsOfSides {
  std::vector<SumOfSides> of;   ///< per value of the program; without pairs where it is no such sum
  std::vector<bool> is_inside;  ///< per value: part of such a sum and of nothing else
  bool is_sum(ValueId v) const { return !of[v].pairs.empty(); }
};

SumsOfSides sums_of_sides(const Program& program, std::span<const MirrorImage> images);

}  // namespace mbgen
