#pragma once
// Potential energy of all elements.

#include "compiler/formulation/elements/every_kind.hpp"

namespace mbgen {

/// J, of all elastic elements. The reader lets no law pass that is not integrated.
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
