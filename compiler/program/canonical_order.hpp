#pragma once
// One order of the values of a traced program, whatever order the operands of one C++ expression were evaluated in.

#include <cstdint>
#include <span>

#include "compiler/program/program.hpp"

namespace mbgen {

/// The same values in an order that depends on their expressions only. moments: per node, never descending, how many
/// statements of the trace (a section, block, name or output) came before it; the order of the moments stays. Within
/// one it is depth first from the named values, and commuted operands are ordered anew.
Program in_canonical_order(Program program, std::span<const std::uint32_t> moments);

}  // namespace mbgen
