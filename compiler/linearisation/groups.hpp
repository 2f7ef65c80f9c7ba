#pragma once
// Numerical evaluation of programs, with numbers by groups of slots.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Numbers by group, each at its index.
using Groups = std::map<SlotGroup, std::vector<double>>;

/// A group, with zeros for missing values.
std::vector<double> group_of(const Groups& groups, SlotGroup group, int size);

/// Outputs of a program by their groups. Fails: std::out_of_range for an input that is not among `inputs`.
Groups evaluate(const Program& program, const Groups& inputs);

/// The same at several values of one group, in place of the group among `inputs`; with the same bits.
std::vector<Groups> evaluate(const Program& program, const Groups& inputs, SlotGroup varied,
                             const std::vector<std::vector<double>>& values);

/// Number of entries of a direction.
int direction_size(std::span<const DirectionGroup> groups);

/// The entries of a direction, group after group.
std::vector<double> joined(std::span<const DirectionGroup> groups, const Groups& direction);

}  // namespace mbgen
