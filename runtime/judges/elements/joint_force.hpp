#pragma once
// Generalised forces on coordinates.

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

inline void apply(const AtWork& at, const JointForce& force, Forces& forces) {
  add_on_coordinate(at, force.joint, at.value(force.force), forces);
}

}  // namespace mbgen::cartesian
