#pragma once
// The value of every operation: the one table behind folding and interpretation. Inside the program room.

#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Value of `op` at its operands; operands beyond the arity are ignored. Requires: op is neither constant, input nor
/// sample.
double apply(Op op, double first, double second, double third);

/// The constant that an operation of constants becomes: as `apply`, sums and products as decimals (decimal.hpp).
double fold(Op op, double first, double second, double third);

/// Value of Op::sample: number `index` of a table, the first or last one outside, as mbgen/sample.hpp has it.
double sample_of(const std::vector<double>& samples, double index);

/// Operands may change places: add, multiply, min, max.
constexpr bool is_commutative(Op op) { return op == Op::add || op == Op::multiply || op == Op::min || op == Op::max; }

/// f(-x) = -f(x): sin, tan, asin, atan, tanh.
bool is_odd(Op op);

}  // namespace mbgen
