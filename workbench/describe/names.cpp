#include "workbench/describe/names.hpp"

namespace mbgen {

const char* name_of(SolverSettings::Integrator integrator) {
  using Integrator = SolverSettings::Integrator;
  return integrator == Integrator::rk4 ? "rk4" : integrator == Integrator::abm4 ? "abm4" : "rosenbrock";
}

const char* name_of(Stabilisation stabilisation) {
  return stabilisation == Stabilisation::projection ? "projection" : "baumgarte";
}

}  // namespace mbgen
