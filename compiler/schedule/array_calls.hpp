#pragma once
// Elementary functions of many arguments, computed by one call in lanes.

#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Least number of arguments for an array call.
constexpr std::size_t kFewestInLanes = 4;
/// Largest number of arguments of a call; more are split, so that values stay in one part of the program.
constexpr int kMostInLanes = 64;

/// Function of an array call. Bounded: for angles from -pi to pi.
enum class ArrayFunction {
  sine_and_cosine,
  sine,
  cosine,
  bounded_sine,
  bounded_cosine,
  arc_tangent,
  exponential,
  hyperbolic_tangent,
  power
};

/// One call. Its values are consecutive in the order of the program.
struct ArrayCall {
  ArrayFunction function = ArrayFunction::sine_and_cosine;
  std::vector<ValueId> arguments;
  std::vector<ValueId> exponents;  ///< of powers
  int entries = 0;                 ///< numbers in the arguments: a pair counts as two
};

/// Position of a value in an array call.
struct ArrayPlace {
  int call = -1;     ///< index of the call, -1 without a call
  int argument = 0;  ///< index of its first number among those of the arguments
};

struct ArrayCalls {
  std::vector<ArrayCall> calls;
  std::vector<ArrayPlace> place;  ///< per value of the program
};

/// Functions combined in one call.
enum class Gathering {
  in_lanes,   ///< kFewestInLanes arguments or more: fewer are as fast individually
  of_vectors  ///< two or more independent vectors: a call is a loop, so that its text occurs once. Functions wait for
              ///< later ones of their kind unless needed before; sines without the cosine of the same angle, and
              ///< cosines without the sine, have calls of their own
};

/// Combines elementary functions of a section in `order` as far as they are independent: first the operands of the
/// first functions' arguments, then these functions, then the operands of functions of their results, and so on; last
/// the rest of the section. Before that, functions of inputs are gathered from the whole section, even if other
/// sections interrupt it. Groups with too few arguments stay in place. Example: wheels with sin(c*atan(slip)) each
/// become all slips, one call for the arc tangents, all products, one call for the sines.
ArrayCalls gather_calls(const Program& program, std::vector<ValueId>& order, Gathering gathering = Gathering::in_lanes);

}  // namespace mbgen
