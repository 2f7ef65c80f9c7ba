#pragma once
// Numbers of a model where it starts: outputs, and its oscillations.

#include <vector>

#include "workbench/search/free_model.hpp"
#include "workbench/search/measure.hpp"

namespace mbgen {

/// The measures of kinds `start` and `mode` among these, in their order. Fails: UserError where there are none.
std::vector<double> start_values(const FreeModel& model, const std::vector<Measure>& measures,
                                 const std::vector<Unknown>& unknowns, const std::vector<double>& values);

}  // namespace mbgen
