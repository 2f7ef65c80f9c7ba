#pragma once
// The equations of small motions about a state, by differences, and their modes.

#include <vector>

#include "compiler/linearisation/linearisation.hpp"
#include "workbench/motion/simulation.hpp"

namespace mbgen {

constexpr int kMostStatesForModes = 200;

/// A and coordinates of small motions about a state by central differences of its accelerations. Without states for a
/// model of more than kMostStatesForModes states or with rolling, at a singular position, and if the accelerations
/// cannot be computed. Auxiliary states are in parts of their magnitudes. engine: in relative coordinates; the inputs
/// of the model at that time become its own. Cost: two evaluations per state.
LinearSystem system_near(const Compilation& compilation, const Engine& engine, const GenericState& state,
                         const std::vector<double>& inputs);

/// The modes of system_near, by the generic engine.
std::vector<Mode> modes_near(const Compilation& compilation, const GenericState& state,
                             const std::vector<double>& inputs);

/// Deviations of the states of system_near.
std::vector<double> deviations_from(const Compilation& compilation, const GenericState& from, const GenericState& to);

}  // namespace mbgen
