#include "compiler/solver/programs.hpp"

namespace mbgen {

const char* name_of(Form form) { return form == Form::matrix ? "matrix" : "recursive"; }

std::array<Program*, 6> solver_programs(Programs& programs) {
  return {&programs.accelerations,        &programs.closure,     &programs.closure_terms,
          &programs.accelerations_chosen, &programs.multipliers, &programs.outputs};
}

std::vector<const Program*> all_programs(const Programs& programs) {
  std::vector<const Program*> list;
  for (const Program* program :
       {&programs.accelerations, &programs.closure, &programs.closure_terms, &programs.accelerations_chosen,
        &programs.multipliers, &programs.outputs, &programs.derived_constants}) {
    if (!program->outputs.empty()) list.push_back(program);
  }
  return list;
}

}  // namespace mbgen
