#pragma once
// Facts about single operations.

#include "compiler/program/program.hpp"

namespace mbgen {

/// Value of an operation on constants, by the same functions that emitted code calls.
double apply(Op op, double first, double second, double third);

/// Whether operands may be exchanged.
bool commutes(Op op);

}  // namespace mbgen
