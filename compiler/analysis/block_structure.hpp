#pragma once
// Which loop blocks are alike, whatever their numbers are.

#include <string>
#include <vector>

#include "compiler/analysis/configuration.hpp"
#include "compiler/formulation/formulation.hpp"

namespace mbgen {

/// A text that is the same for blocks of one structure: joints and closures by kind and by what they are on, and which
/// of their numbers are 0, 1 or -1. Names and the other numbers do not count: programs of such blocks take as many
/// operations but for numbers that are equal by chance.
std::string structure_of(const System<double>& system, int block);

/// Per block the first one of its structure, itself where that is new.
std::vector<int> first_of_structure(NumericSystem& numbers);

}  // namespace mbgen
