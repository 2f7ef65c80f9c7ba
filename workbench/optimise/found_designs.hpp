#pragma once
// Searched designs in the words of the result.

#include <vector>

#include "workbench/optimise/design_search.hpp"
#include "workbench/optimise/optimise_result.hpp"

namespace mbgen::optimise {

/// start: the design at the start values; before: the responses there.
FoundDesign found_design(const DesignProblem& problem, const Design& start, const SearchedDesign& found,
                         const std::vector<Response>& before);

/// Curves of rigs before and after.
std::vector<FoundCurve> found_curves(const DesignProblem& problem, const std::vector<Response>& before,
                                     const std::vector<Response>& after);

}  // namespace mbgen::optimise
