#pragma once
// Times of all contestants in turns: whatever else the machine does meets all of them.

#include <vector>

#include "bench/compare/contestants.hpp"

namespace mbgen::compare {

/// Figures over all rounds.
struct Spread {
  double least = 0, median = 0, most = 0;
};

struct Timing {
  Spread microseconds;  ///< processor time of one evaluation
  Spread ratio;         ///< to the first contestant in the same round
  int evaluations = 0;  ///< in all rounds
};

/// Every round gives each contestant about `seconds` at the states, one after the other, after one unmeasured round.
/// Result: per contestant; of those that are absent all zero. Requires: the first one is there.
std::vector<Timing> time_in_turns(const std::vector<Contestant>& contestants, const std::vector<LoadedState>& states,
                                  int rounds, double seconds);

}  // namespace mbgen::compare
