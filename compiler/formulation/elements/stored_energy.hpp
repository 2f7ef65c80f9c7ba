#pragma once
// Potential energy of springs, joint springs, bushings and bump stops: the integrals of their elastic laws.

#include "compiler/formulation/elements/applied_forces.hpp"

namespace mbgen::detail {

/// Values of a model's elements from what its force elements have seen.
template <class T>
struct StoredEnergies {
  const System<T>& system;
  const AppliedForces<T>& forces;

  T value(const Quantity& q) const { return value_of(system.model, q, system.environment); }

  /// Integral of a characteristic from zero to the argument, J.
  T work_of(const std::optional<Law>& law, const T& argument) const {
    if (!law) return T(0.0);
    if (const Quantity* factor = std::get_if<Quantity>(&*law)) return T(0.5) * value(*factor) * (argument * argument);
    return integral_along(std::get<Table>(*law), argument);
  }

  T of_spring(int index) const {
    const PointSpring& spring = system.model.springs[index];
    const Place<T> from = place_of(system, spring.from), to = place_of(system, spring.to);
    const T natural = spring.free_length
                          ? value(*spring.free_length)
                          : reference_distance(system.topology, system.constants, spring.to, to, spring.from, from);
    const T extension = forces.springs[index].length - natural;
    return work_of(spring.stiffness, extension) + value(spring.preload) * extension;
  }

  T of_joint_spring(int index) const {
    const JointSpring& spring = system.model.joint_springs[index];
    const T deflection = joint_deflection(system, spring).position - value(spring.free);
    return work_of(spring.stiffness, deflection) + value(spring.preload) * deflection;
  }

  /// Springs of Maxwell branches too.
  T of_bushing(int index) const {
    const Bushing& bushing = system.model.bushings[index];
    const BushingState<T>& state = forces.bushings[index];
    auto branch = static_cast<std::size_t>(first_extension(system.model, static_cast<std::size_t>(index)));
    const auto deflection = [&](int i) { return component(i < 3 ? state.deflection : state.rotation, i % 3); };
    T energy(0.0);
    for (int i = 0; i < kBushingFreedoms; ++i) {
      const T q = deflection(i);
      for (int j = i; j < kBushingFreedoms; ++j)
        if (bushing_couples(bushing.stiffness, i, j))
          energy = energy +
                   T(i == j ? 0.5 : 1.0) * value((*bushing.stiffness)[kBushingFreedoms * i + j]) * (q * deflection(j));
      const std::optional<BushingFreedom>& own = bushing.freedoms[i];
      if (!own) continue;
      energy = energy + work_of(own->stiffness, q) + value(own->preload) * q;
      if (own->maxwell_stiffness) {
        const T& extension = system.x[branch++];
        energy = energy + T(0.5) * value(*own->maxwell_stiffness) * (extension * extension);
      }
    }
    return energy;
  }

  T of_bump_stop(int index) const {
    using mbgen::max;
    const BumpStop& stop = system.model.bump_stops[index];
    const T zero(0.0), depth = max(forces.bump_stops[index].penetration, zero);
    const Quantity* factor = std::get_if<Quantity>(&*stop.stiffness);
    if (!factor) return work_of(stop.stiffness, depth);
    const double power = stop.exponent + 1;
    return max(value(*factor), zero) * power_by_constant(depth, power) / T(power);
  }
};

/// J. The reader lets no law pass that is not integrated.
template <class T>
T stored_energy_output(const System<T>& system, const AppliedForces<T>& forces, const StoredEnergyOutput& output) {
  using Of = StoredEnergyOutput::Of;
  const StoredEnergies<T> energies{system, forces};
  const Model& model = system.model;
  T sum(0.0);
  const auto add = [&](Of of, const auto& elements, T (StoredEnergies<T>::*energy)(int) const) {
    if (output.of == of) sum = (energies.*energy)(output.element);
    for (std::size_t i = 0; output.of == Of::all && i < elements.size(); ++i)
      sum = sum + (energies.*energy)(static_cast<int>(i));
  };
  add(Of::spring, model.springs, &StoredEnergies<T>::of_spring);
  add(Of::joint_spring, model.joint_springs, &StoredEnergies<T>::of_joint_spring);
  add(Of::bushing, model.bushings, &StoredEnergies<T>::of_bushing);
  add(Of::bump_stop, model.bump_stops, &StoredEnergies<T>::of_bump_stop);
  return sum;
}

}  // namespace mbgen::detail
