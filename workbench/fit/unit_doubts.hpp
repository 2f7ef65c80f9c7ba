#pragma once
// Data that look as if they were in another unit than they say.

#include <string>
#include <vector>

#include "workbench/fit/fit_problem.hpp"

namespace mbgen::fit {

/// Notes on channels whose data follow the model at these values, correlated by 0.9 or more, but are larger or smaller
/// by a factor between usual units, or have the other sign. Cost: a motion for each file.
std::vector<std::string> unit_doubts(const FitProblem& problem, const std::vector<double>& values);

}  // namespace mbgen::fit
