#pragma once
// Shared laws: a struct of the numbers that a law and the program around it exchange, and the function of the law.

#include <string>

#include "compiler/emit/shapes.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen {

/// Text of all shared laws, to be placed before the program around them; empty without any. Doubles are computed in
/// vectors, one element per lane; other numbers element by element: floats, which have no vector functions, and vectors
/// of a batch, whose lanes are instances. scalar: type of the program around them. constants: as in a shape.
std::string law_texts(const EmitContext& context, Scalar scalar, ConstantNames* constants);

/// The same of law k with the slopes that its derivatives need, and its derivatives in a struct of their own.
/// law, along: their shapes. apart: of its program.
std::string law_with_slopes_text(const EmitContext& context, std::size_t k, const DerivativesApart& apart,
                                 const LawShape& law, const LawShape& along, ConstantNames* constants);

}  // namespace mbgen
