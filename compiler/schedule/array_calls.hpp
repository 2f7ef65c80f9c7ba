#pragma once
// Elementary functions of many arguments that one call computes, in lanes.

#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Fewer arguments than this are left to calls of their own.
constexpr std::size_t kFewestInLanes = 4;
/// More arguments than this are split into several calls: their values stay in one part of the program.
constexpr int kMostInLanes = 64;

/// Function that a call computes of each argument. Bounded: of angles up to pi either way.
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

/// One call. Its values stand one after the other in the order of the program.
struct ArrayCall {
  ArrayFunction function = ArrayFunction::sine_and_cosine;
  std::vector<ValueId> arguments;
  std::vector<ValueId> exponents;  ///< of powers
  int entries = 0;                 ///< numbers among the arguments: a pair is two
};

/// A value that a call for many arguments computes.
struct ArrayPlace {
  int call = -1;     ///< index of the call, -1 for a value of none
  int argument = 0;  ///< index of its first number among those of the arguments
};

struct ArrayCalls {
  std::vector<ArrayCall> calls;
  std::vector<ArrayPlace> place;  ///< per value of the program
};

/// Which functions one call computes.
enum class Gathering {
  in_lanes,   ///< of kFewestInLanes arguments or more: fewer are as fast alone
  of_vectors  ///< of two or more, each a vector that needs no others: a call is a loop, so that its text stands there
              ///< once. Functions wait for later ones of their kind where nothing needs them before; sines whose
              ///< cosines nobody needs, and cosines likewise, are calls of their own
};

/// Brings elementary functions of a section together in `order`, as far as none needs another: first the operands of
/// the first functions' arguments, then these functions, then the operands of the functions that use their results, and
/// so on; last the rest of the section. Before that, functions of inputs are gathered from all of a section that values
/// of other sections interrupt. Groups of too few arguments stay where they are. Example: wheels that each have
/// sin(c*atan(slip)) in turn become all slips, one call for the arc tangents, all products, one call for the sines.
ArrayCalls gather_calls(const Program& program, std::vector<ValueId>& order, Gathering gathering = Gathering::in_lanes);

}  // namespace mbgen
