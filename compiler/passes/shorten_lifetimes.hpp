#pragma once

#include "compiler/program/program.hpp"

namespace mbgen {

/// Orders values so that few are alive at a time: a term joins its sum as soon as both are known, and a value whose
/// operands live on anyway is computed where it is first used. A value that moves goes to the section and block of its
/// new neighbours. Ensures: the same operations, outputs bit for bit.
Program shorten_lifetimes(const Program& program);

}  // namespace mbgen
