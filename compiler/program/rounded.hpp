#pragma once
// Values of a program with smooth functions, with bounds of what their roundings may have made of them.

#include <span>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

struct Rounded {
  double value = 0;
  double error = 0;  ///< about what all roundings up to here amount to, not below
};

/// One per node, of a program without pairs; for telling how well values are known. Functions that are in pieces (abs,
/// min, max, select, floor, sample) or have a branch (sqrt, atan2) stand aside for smooth ones, whose roundings do not
/// jump. inputs: exact, in the order of program.inputs.
std::vector<Rounded> rounded_values(const Program& program, std::span<const double> inputs);

/// Inputs of a state as models have them, random: small angles and lengths, rates about 1. Set `number`, the same on
/// every machine.
std::vector<double> ordinary_inputs(const Program& program, std::size_t number);

}  // namespace mbgen
