#pragma once
// Angles whose sines and cosines are computed together, in lanes.

#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Fewer angles of a section than this are left to scalar calls.
constexpr std::size_t kFewestInLanes = 4;
/// More angles than this are split into several calls: their values stay in one part of the program.
constexpr std::size_t kMostInLanes = 64;

/// Sines and cosines that one call computes. They stand one after the other in the order of the program.
struct AngleCall {
  std::vector<ValueId> angles;
};

/// A sine or cosine that a call for many angles computes.
struct AnglePlace {
  int call = -1;  ///< index of the call, -1 for a value of none
  int angle = 0;  ///< index of its angle in the call
};

struct AngleCalls {
  std::vector<AngleCall> calls;
  std::vector<AnglePlace> place;  ///< per value of the program
};

/// Moves sines and cosines to the beginning of their section in `order`, as far as their angles are known there:
/// inputs, values of earlier sections, and sums, differences and multiples of these, which are moved before them.
/// Example: add, sin(z[0]), multiply, cos(z[0] + z[1]), ... becomes z[0] + z[1]; sin(z[0]), cos(z[0] + z[1]); add, ...
AngleCalls gather_angles(const Program& program, std::vector<ValueId>& order);

}  // namespace mbgen
