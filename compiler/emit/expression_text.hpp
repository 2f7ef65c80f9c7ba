#pragma once
// One operation as a C++ expression with as few parentheses as its meaning allows.

#include <string>

#include "compiler/emit/scalar.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// Binding strength of the outermost operator of a text.
enum class Binding { sum, product, sign, primary };

struct Phrase {
  std::string text;
  Binding binding = Binding::primary;
};

/// A number or its name; a negative one binds like its sign.
Phrase constant_phrase(const std::string& text);

/// The operation on its operands, values of a scalar type; operands beyond its arity are ignored. Associativity is
/// kept: a + (b + c) remains, since floating-point sums are not associative. Vectors use functions of mbgen/lanes.hpp.
Phrase operation_phrase(Scalar scalar, Op op, const Phrase& first, const Phrase& second, const Phrase& third);

/// The same for people, with one sign a term: a - (-b*c) as a + b*c, -a*b + c as c - a*b, a*(-b) as -a*b. Equal bits.
Phrase phrase_for_people(Scalar scalar, Op op, Phrase first, Phrase second, const Phrase& third);

}  // namespace mbgen
