#pragma once
// One operation as a C++ expression with as few parentheses as its meaning allows.

#include <string>

#include "compiler/emit/scalar.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// How tightly the outermost operator of a text binds.
enum class Binding { sum, product, sign, primary };

struct Phrase {
  std::string text;
  Binding binding = Binding::primary;
};

/// A number or the name of one; a negative one binds as its sign does.
Phrase constant_phrase(const std::string& text);

/// The operation on its operands, values of a scalar type; those beyond its arity are ignored. Associativity is kept:
/// a + (b + c) stays as it is, since floating-point sums are not associative. Vectors have functions of
/// mbgen/lanes.hpp.
Phrase operation_phrase(Scalar scalar, Op op, const Phrase& first, const Phrase& second, const Phrase& third);

}  // namespace mbgen
