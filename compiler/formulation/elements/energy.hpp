#pragma once
// Potential energy of elements: the integrals of their elastic laws.

#include "compiler/expressions/curve.hpp"
#include "compiler/formulation/elements/force_work.hpp"

namespace mbgen {
namespace detail {

/// State that energies of elements read: what its force elements have seen.
template <class T>
struct EnergyWork {
  const System<T>& system;
  const AppliedForces<T>& forces;
  T value(const Quantity& q) const { return value_of(system.model, q, system.environment); }
};

/// Integral of a characteristic from zero to the argument, J.
template <class T>
T work_of(const EnergyWork<T>& work, const std::optional<Law>& law, const T& argument) {
  if (!law) return T(0.0);
  if (const Quantity* factor = std::get_if<Quantity>(&*law))
    return T(0.5) * work.value(*factor) * (argument * argument);
  return integral_along(std::get<Table>(*law), argument);
}

}  // namespace detail
}  // namespace mbgen
