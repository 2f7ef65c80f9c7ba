#pragma once
// Tyres on roads.

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

inline void apply(const AtWork& at, const Tyre& tyre, Forces& forces) {
  const std::size_t w = index_of(at, tyre);
  const PartTyre& part = at.c.parts.tyres[w];
  const double turn = tyre.parking ? at.x[static_cast<std::size_t>(turn_state(at.c.model, w))] : 0;
  const RoadWheel wheel =
      road_wheel(tyre, part, at.bodies[part.centre.body], {at.x[2 * w], at.x[2 * w + 1], turn}, at.value);
  forces.loads.push_back({part.centre.body, wheel.wrench});
  forces.xd[2 * w] = wheel.result.du;
  forces.xd[2 * w + 1] = wheel.result.dv;
  if (tyre.parking) forces.xd[static_cast<std::size_t>(turn_state(at.c.model, w))] = wheel.result.dturn;
  forces.tyres[w] = wheel.result;
}

inline double shown(const AtWork& at, const Forces& forces, const Tyre& tyre, int quantity, int) {
  const TyreResult<double>& result = forces.tyres[index_of(at, tyre)];
  const double values[] = {result.load, result.fx, result.fy, result.mz, result.kappa, result.alpha};
  return values[quantity];
}

}  // namespace mbgen::cartesian
