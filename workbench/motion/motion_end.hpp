#pragma once
// Why a motion ended before its time, in words.

#include <string>
#include <vector>

#include "workbench/motion/motion_judge.hpp"

namespace mbgen {

/// "stopped after t = 0.3 s: not a number: pin". Requires: a step of the motion failed.
std::string end_text(const Compilation& compilation, const JudgedMotion& motion);

/// Causes of such an end and next steps, a line each: findings of the judge, a drive that its loops cannot follow,
/// springs whose ends coincide.
std::vector<std::string> hints_of_end(const Compilation& compilation, const JudgedMotion& motion);

}  // namespace mbgen
