#pragma once
// The start of a model with its derivatives: the coordinates that the model gives are held, the others follow.

#include "mbgen/independent.hpp"

namespace mbgen {

/// Per coordinate, 1 where the start holds its position or velocity.
template <int N>
struct HeldCoordinates {
  unsigned char positions[N], velocities[N];
};

/// `initial`, whose values are closed, with the derivatives that parameters and inputs give it.
/// Fails: as project_from_independent; the state is then unchanged.
template <class System>
Status start_with_held(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const typename System::State& initial, const HeldCoordinates<System::kCoordinates>& held,
                       typename System::State& state) noexcept {
  using namespace solver_detail;
  typename System::State trial;
  copy_state<System>(initial, trial);
  Status status = project_from_independent<System>(parameters, inputs, held.positions, trial);
  if (!status.ok()) return status;
  copy(initial.zd, trial.zd, System::kCoordinates);
  status = project_from_independent<System>(parameters, inputs, held.velocities, trial);
  if (!status.ok()) return status;
  copy_state<System>(trial, state);
  return {};
}

}  // namespace mbgen
