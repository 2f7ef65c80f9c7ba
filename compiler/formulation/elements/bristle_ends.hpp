#pragma once
// Bristles of frictions at a state: sliding speed, and deflection at which they slide.

#include <cmath>
#include <string>
#include <vector>

#include "compiler/formulation/elements/applied_forces.hpp"
#include "compiler/model/element_access.hpp"

namespace mbgen {

/// Bristles of one friction: rad or m for one on a coordinate, m along a spring.
struct BristleEnd {
  std::string name;      ///< of the friction
  double rate = 0;       ///< relative speed of the parts, per second
  double end = 0;        ///< deflection of steady sliding at this speed, 0 for a friction without limit
  double holds = 0;      ///< the same at rest: limit of stiction
  double stiffness = 0;  ///< N m/rad or N/m, per N of normal force
  double damping = 0;    ///< N m s/rad or N s/m, per N of normal force
  double lag = 0;        ///< s
  bool has_limit() const { return end > 0; }
  bool slides() const { return std::abs(rate) > kSlidingBristle; }
};

/// All bristles of a model, in the order of their states. Requires: `system` has the state's auxiliary states. Ensures:
/// states, lengths and outputs are set for expressions.
inline std::vector<BristleEnd> bristle_ends(System<double>& system, const Kinematics<double>& k,
                                            const Velocities<double>& v) {
  see_values(system, k, v);
  std::vector<BristleEnd> ends;
  const auto add = [&](const FrictionLaw& friction, const std::string& name, double rate) {
    const auto value = [&](const Quantity& q) { return value_of(system.model, q, system.environment); };
    const Bristles<double> bristles{value(friction.coulomb),           value(friction.stiction),
                                    value(friction.stribeck_velocity), value(friction.stiffness),
                                    value(friction.damping),           *friction.lag};
    const auto end_at = [&](double speed) {
      const double end = largest_deflection(bristles, speed);
      return end > kLeastBristle ? end : 0.0;
    };
    ends.push_back({name, rate, end_at(rate), end_at(0.0), bristles.stiffness, bristles.damping, bristles.lag});
  };
  each_friction(system.model, [&](const auto& friction) {
    if constexpr (requires { detail::sliding_rate(system, k, v, friction); })
      if (friction.has_bristle()) add(friction, friction.name, detail::sliding_rate(system, k, v, friction));
  });
  return ends;
}

/// The bristles of all elements at rest, of every kind that has some. Requires, ensures: as bristle_ends.
inline std::vector<BristleHold> bristle_holds(System<double>& system, const Kinematics<double>& k,
                                              const Velocities<double>& v) {
  std::vector<BristleHold> holds;
  std::size_t state = static_cast<std::size_t>(first_bristle(system.model));
  for (const BristleEnd& end : bristle_ends(system, k, v)) holds.push_back({state++, 1, end.holds, end.holds > 0});
  AppliedForces<double> none;
  const detail::ForceWork<double> work{system, k, v, none};
  each_element(system.model, [&](const auto& element) {
    if constexpr (requires { detail::bristle_hold(work, element); })
      if (const std::optional<BristleHold> own = detail::bristle_hold(work, element)) holds.push_back(*own);
  });
  return holds;
}

}  // namespace mbgen
