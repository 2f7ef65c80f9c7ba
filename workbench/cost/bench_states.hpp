#pragma once
// States for timing the engines, and the errors of the engines at them.

#include <vector>

#include "workbench/engines/engine.hpp"
#include "workbench/start/states_file.hpp"

namespace mbgen {

/// Consistent random states around the initial one, the same on every machine.
/// engine: closes the loops. Fails: UserError when none closes.
std::vector<FileState> random_states(const Compilation& compilation, const Engine& engine,
                                     const std::vector<double>& inputs);

/// Fills in the accelerations to compare with, where a state has none. Fails: UserError when the engine has none.
void complete(std::vector<FileState>& states, const Engine& reference, const Compilation& compilation);

/// States at which engines are timed: the given ones, repeated from the first on until they fill batches of `lanes`;
/// partly filled batches would be timed as slow ones. lanes: 0 for none.
std::vector<LoadedState> timed_states(const std::vector<FileState>& states, int lanes);

/// Largest error of any acceleration over the largest acceleration of its state.
/// Fails: UserError when the engine has no accelerations at a state.
double largest_error(const Engine& engine, const Compilation& compilation, const std::vector<FileState>& states);

}  // namespace mbgen
