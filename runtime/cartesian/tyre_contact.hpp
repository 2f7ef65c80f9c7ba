#pragma once
// A wheel on a road: contact and motion in global axes, forces by the tyre law of the runtime.

#include "runtime/cartesian/rows.hpp"

namespace mbgen::cartesian {

struct RoadWheel {
  Vector6d wrench;        ///< on the wheel about its centre of mass, global axes
  double du = 0, dv = 0;  ///< rates of its deflection states, m/s
};

/// Forces of a tyre on its wheel. u, v: deflection states, m.
RoadWheel road_wheel(const Tyre& tyre, const PartTyre& part, const Moving& wheel, double u, double v,
                     const Values& value);

}  // namespace mbgen::cartesian
