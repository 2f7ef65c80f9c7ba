#pragma once
// The trade-off curve of two goals by bounds on one of them: V. Chankong, Y. Y. Haimes, Multiobjective Decision Making,
// 1983, ch. 6, the epsilon-constraint method.

#include <vector>

#include "workbench/optimise/design_search.hpp"

namespace mbgen::optimise {

/// So many points, from the best of goal `one` to the best of goal `other`: between them `one` is minimised with
/// `other` bounded at values of equal distance, each from its neighbour's design. A search that fails is left out; a
/// point that another one beats in both goals has that as its status.
std::vector<SearchedDesign> trade_off(const DesignProblem& problem, std::size_t one, std::size_t other, int points,
                                      const std::vector<double>& start, Designs& designs);

}  // namespace mbgen::optimise
