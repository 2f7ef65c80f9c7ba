#pragma once
// Relations between coordinates of random mechanisms. Inside the property tests.

#include <string>
#include <vector>

#include "tests/system/property/workshop.hpp"

namespace mbgen::testing {

/// A relation between some coordinates of joints: gears and differentials, cams and quadratic ones.
void add_relation(Workshop& shop, std::vector<std::string> joints, const std::vector<std::string>& coordinates);

/// A tree with a joint of several coordinates on its way, and relations between any coordinate of one of these and one
/// or two others; each relation has a coordinate of its own.
void add_coupled_joints(Workshop& shop);

}  // namespace mbgen::testing
