#pragma once
// Programs run on numbers that are named by the groups of their slots.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Numbers by group, each at its index.
using Groups = std::map<std::string, std::vector<double>>;

/// The group of this name, with zeros for what it does not have.
std::vector<double> group_of(const Groups& groups, const std::string& name, int size);

/// Outputs of a program by their groups. Fails: std::out_of_range when an input is not among `inputs`.
Groups evaluate(const Program& program, const Groups& inputs);

/// A part of a direction: rates of change of a group of inputs.
struct DirectionGroup {
  std::string name;
  int size = 0;
};

/// Number of entries of a direction.
int direction_size(std::span<const DirectionGroup> groups);

/// The entries of a direction, group after group.
std::vector<double> joined(std::span<const DirectionGroup> groups, const Groups& direction);

/// Place in such a direction of each input of a program, -1 for those that have none: for `differentiate`.
std::vector<int> seeds_of(const Program& program, std::span<const DirectionGroup> groups);

}  // namespace mbgen
