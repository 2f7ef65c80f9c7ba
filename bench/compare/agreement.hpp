#pragma once
// The states at which solvers are compared, and how far their answers are apart.

#include <string>
#include <vector>

#include "bench/compare/contestants.hpp"
#include "workbench/start/states_file.hpp"

namespace mbgen::compare {

/// Largest difference of exact solvers, relative to the largest acceleration of a state.
constexpr double kAgreement = 1e-9;

/// Whose answers the states bring.
struct StatesInUse {
  std::string source;  ///< for the table: a file, or how they were made
  std::vector<FileState> states;
};

/// The states of `file` with the accelerations that it expects there (of massless rods when `rods_are_massless`), or,
/// when `file` is "", random consistent ones as in `mbgen bench`, with the accelerations of `reference`.
/// Fails: UserError as read_states and random_states.
StatesInUse states_in_use(const Compilation& compilation, const std::string& file, bool rods_are_massless,
                          const Engine& projecting, const Contestant& reference);

/// Largest relative difference of a contestant from the states' accelerations. Infinite when it has no answer.
double deviation(const Contestant& contestant, const std::vector<FileState>& states);

}  // namespace mbgen::compare
