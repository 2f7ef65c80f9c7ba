#pragma once
// Forces of every kind of element: apply(work, element) adds them, add_tangents(work, element, elements) adds their
// derivatives, if any, stored_energy(work, element) integrates the elastic law.

#include "compiler/formulation/elements/air_spring.hpp"
#include "compiler/formulation/elements/applied_force.hpp"
#include "compiler/formulation/elements/bump_stop.hpp"
#include "compiler/formulation/elements/bushing.hpp"
#include "compiler/formulation/elements/contact.hpp"
#include "compiler/formulation/elements/friction.hpp"
#include "compiler/formulation/elements/joint_force.hpp"
#include "compiler/formulation/elements/joint_spring.hpp"
#include "compiler/formulation/elements/point_spring.hpp"
#include "compiler/formulation/elements/tyre_road.hpp"
