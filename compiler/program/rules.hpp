#pragma once
// The rewrite rules that ProgramBuilder applies while appending. Inside the program room.

#include "compiler/program/program.hpp"

namespace mbgen {

/// Puts the operands of a commutative operation in order: constants first, then by value.
void order_operands(const std::vector<Node>& nodes, Op op, ValueId (&operands)[3]);

/// The value that `op` of these operands already is, or is rewritten to (its parts are appended), or kNoValue when no
/// rule applies. Requires: operands of commutative operations in order, constants first; not all operands constant.
ValueId simplify(ProgramBuilder& builder, Op op, ValueId first, ValueId second, ValueId third);

}  // namespace mbgen
