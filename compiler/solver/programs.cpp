#include "compiler/solver/programs.hpp"

namespace mbgen {
namespace {

/// The programs that a solver runs. P: Programs, const or not.
template <class P>
auto in_order(P& programs) {
  return std::array{&programs.accelerations,        &programs.closure,     &programs.closure_terms,
                    &programs.accelerations_chosen, &programs.multipliers, &programs.outputs};
}

}  // namespace

const char* name_of(Form form) { return form == Form::matrix ? "matrix" : "recursive"; }

Form other_form(Form form) { return form == Form::matrix ? Form::recursive : Form::matrix; }

std::array<Program*, 6> solver_programs(Programs& programs) { return in_order(programs); }

std::vector<const Program*> all_programs(const Programs& programs) {
  std::vector<const Program*> list;
  for (const Program* program : in_order(programs))
    if (!program->outputs.empty()) list.push_back(program);
  if (!programs.derived_constants.outputs.empty()) list.push_back(&programs.derived_constants);
  return list;
}

}  // namespace mbgen
