#pragma once
// Names for people: of methods, and of the parts of a topology.

#include "compiler/model/model.hpp"
#include "compiler/topology/names.hpp"
#include "runtime/judges/cartesian.hpp"

namespace mbgen {

const char* name_of(SolverSettings::Integrator integrator);
const char* name_of(Stabilisation stabilisation);

}  // namespace mbgen
