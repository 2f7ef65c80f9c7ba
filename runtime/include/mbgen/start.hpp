#pragma once
// The start of a model with its derivatives: the coordinates that the model gives are held, the others follow.

#include "mbgen/independent.hpp"

namespace mbgen {

/// Per coordinate, 1 where the start of a model gives its position or velocity, and where that is locked.
template <int N>
struct GivenCoordinates {
  unsigned char positions[N], locked_positions[N], velocities[N], locked_velocities[N];
};

namespace solver_detail {

/// Closes the loops while the given coordinates are held, or the locked ones alone where the given ones are too many.
template <class System>
Status project_from_given(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const unsigned char* given, const unsigned char* locked,
                          typename System::State& state) noexcept {
  const Status status = project_from_independent<System>(parameters, inputs, given, state);
  return status.code == Code::loop_singular ? project_from_independent<System>(parameters, inputs, locked, state)
                                            : status;
}

}  // namespace solver_detail

/// `initial`, whose values are closed, with the derivatives that parameters and inputs give it.
/// Fails: as project_from_independent; the state is then unchanged.
template <class System>
Status start_with_given(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                        const typename System::State& initial, const GivenCoordinates<System::kCoordinates>& given,
                        typename System::State& state) noexcept {
  using namespace solver_detail;
  typename System::State trial;
  copy_state<System>(initial, trial);
  Status status = project_from_given<System>(parameters, inputs, given.positions, given.locked_positions, trial);
  if (!status.ok()) return status;
  copy(initial.zd, trial.zd, System::kCoordinates);
  status = project_from_given<System>(parameters, inputs, given.velocities, given.locked_velocities, trial);
  if (!status.ok()) return status;
  copy_state<System>(trial, state);
  return {};
}

}  // namespace mbgen
