#pragma once
// The judges' elements, with independent laws: apply(at, element, forces) adds forces, shown(at, forces, element,
// quantity, axis) gives outputs by the table of the kind, energy_of(at, element) integrates the elastic law.

#include "runtime/judges/elements/air_spring.hpp"
#include "runtime/judges/elements/applied_force.hpp"
#include "runtime/judges/elements/bump_stop.hpp"
#include "runtime/judges/elements/bushing.hpp"
#include "runtime/judges/elements/contact.hpp"
#include "runtime/judges/elements/friction.hpp"
#include "runtime/judges/elements/joint_force.hpp"
#include "runtime/judges/elements/joint_spring.hpp"
#include "runtime/judges/elements/point_spring.hpp"
#include "runtime/judges/elements/tyre.hpp"
