#pragma once
// A wheel on a road: contact and motion in global axes, forces by the tyre law of the runtime.

#include "mbgen/tyres/tyre.hpp"
#include "runtime/judges/rows.hpp"

namespace mbgen::cartesian {

struct RoadWheel {
  Vector6d wrench;            ///< on the wheel about its centre of mass, global axes
  TyreResult<double> result;  ///< from the tyre law, in the axes of the contact
};

/// Deflection states of a tyre.
struct TyreStates {
  double u, v;      ///< m
  double turn = 0;  ///< rad, of a tyre with turning
};

/// Forces of a tyre on its wheel.
RoadWheel road_wheel(const Tyre& tyre, const PartTyre& part, const Moving& wheel, const TyreStates& states,
                     const Values& value);

}  // namespace mbgen::cartesian
