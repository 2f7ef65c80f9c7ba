#pragma once
// One operation as a C++ expression with as few parentheses as its meaning allows.

#include <string>

#include "compiler/program/program.hpp"

namespace mbgen {

/// How tightly the outermost operator of a text binds.
enum class Binding { sum, product, sign, primary };

struct Phrase {
  std::string text;
  Binding binding = Binding::primary;
};

/// A number or the name of one; negative ones in parentheses, so that they stand anywhere.
Phrase constant_phrase(const std::string& text);

/// The operation on its operands; those beyond its arity are ignored. Associativity is kept: a + (b + c) stays as it
/// is, since floating-point sums are not associative.
Phrase operation_phrase(Op op, const Phrase& first, const Phrase& second, const Phrase& third);

/// The same on values of a scalar type: on vectors by functions of mbgen/lanes.hpp.
Phrase operation_phrase(const std::string& scalar, Op op, const Phrase& first, const Phrase& second,
                        const Phrase& third);

/// Text of a phrase that stands alone, after `=`.
std::string standing_alone(const Phrase& phrase);

}  // namespace mbgen
