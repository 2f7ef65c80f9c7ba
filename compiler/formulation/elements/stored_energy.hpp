#pragma once
// Potential energy of all elements.

#include "compiler/formulation/elements/every_kind.hpp"

namespace mbgen {

/// Potential energy of all elastic elements, J. The reader refuses laws that are not integrated.
template <class T>
T stored_energy_of_all(const System<T>& system, const AppliedForces<T>& forces) {
  const detail::EnergyWork<T> work{system, forces};
  T sum(0.0);
  each_element(system.model, [&](const auto& element) {
    if constexpr (requires { stored_energy(work, element); }) sum = sum + stored_energy(work, element);
  });
  return sum;
}

}  // namespace mbgen
