#pragma once
// The problem of a fit from its arguments: channels, data, unknowns, sizes.

#include <vector>

#include "workbench/fit/fit_arguments.hpp"
#include "workbench/fit/fit_problem.hpp"

namespace mbgen::fit {

/// Reads data and targets, and prepares the model for the unknowns. Notes go to standard error. Fails: UserError.
FitProblem read_problem(const FitArguments& arguments, FreeModel& model);

double deviation_of(const std::vector<double>& values);

/// Size of a channel's data: the largest standard deviation of a file, or 1 where nothing moves.
double size_of(const std::vector<MeasuredFile>& files, int channel);

}  // namespace mbgen::fit
