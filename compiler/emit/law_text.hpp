#pragma once
// Laws that elements share: a struct of the numbers that a law and the program around it pass each other, and the
// function of the law.

#include <string>

#include "compiler/emit/shapes.hpp"

namespace mbgen {

/// The text of every shared law, to stand before the program around them; empty where there is none. Doubles go in
/// vectors, an element in each lane; other numbers element by element: floats, which have no functions of vectors, and
/// vectors of a batch, whose lanes are instances. scalar: type of the program around them. constants: as those of a
/// shape.
std::string law_texts(const EmitContext& context, Scalar scalar, ConstantNames* constants);

}  // namespace mbgen
