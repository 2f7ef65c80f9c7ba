#include "compiler/describe/names.hpp"

namespace mbgen {

const char* name_of(SolverSettings::Integrator integrator) {
  return integrator == SolverSettings::Integrator::rk4 ? "rk4" : "abm4";
}

const char* name_of(Stabilisation stabilisation) {
  return stabilisation == Stabilisation::projection ? "projection" : "baumgarte";
}

}  // namespace mbgen
