#include "compiler/solver/programs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

namespace mbgen {
namespace {

constexpr Program Programs::*kMembers[] = {&Programs::accelerations,    &Programs::closure,
                                           &Programs::closure_terms,    &Programs::accelerations_chosen,
                                           &Programs::multipliers,      &Programs::outputs,
                                           &Programs::sampled,          &Programs::ground_places,
                                           &Programs::tangents,         &Programs::changes,
                                           &Programs::inverse_dynamics, &Programs::actuators,
                                           &Programs::required_forces,  &Programs::derived_constants};

void verify_slot(const ProgramSpec& spec, const std::vector<Array>& allowed, const Slot& slot) {
  if (std::ranges::find(allowed, slot.group.array) == allowed.end())
    throw std::logic_error(fmt::format("program {}: {} is not in its spec", spec.name, text_of(slot)));
}

void verify(const ProgramSpec& spec, const Program& program) {
  for (const Slot& slot : program.inputs) verify_slot(spec, spec.inputs, slot);
  for (const OutputValue& output : program.outputs) verify_slot(spec, spec.outputs, output.slot);
}

}  // namespace

Programs::Programs() = default;
Programs::Programs(const Programs& other) = default;
Programs::Programs(Programs&& other) noexcept = default;
Programs& Programs::operator=(const Programs& other) = default;
Programs& Programs::operator=(Programs&& other) noexcept = default;
Programs::~Programs() = default;

const char* name_of(Form form) { return form == Form::matrix ? "matrix" : "recursive"; }

Form other_form(Form form) { return form == Form::matrix ? Form::recursive : Form::matrix; }

const std::vector<ProgramSpec>& program_specs() {
  using enum Array;
  static const std::vector<ProgramSpec> kSpecs = {
      {Role::accelerations,
       "accelerations",
       {z, zd, x, t, tau, in, par, derived, law_result},
       {zdd, xd, hold, pivot, inertia, law_argument}},
      {Role::closure, "closure", {z, zd, t, in, par, derived}, {residual, dz, zd, pivot, Rz}},
      {Role::closure_terms,
       "closure_terms",
       {z, zd, t, in, par, derived, charts},
       {Phi, Jz, rate, c, driven_acceleration}},
      {Role::accelerations_chosen,
       "accelerations_chosen",
       {z, zd, x, t, tau, in, par, derived, charts, Rz, zdd_star},
       {zdd, xd, hold, inertia}},
      {Role::multipliers,
       "multipliers",
       {z, zd, x, t, tau, in, par, derived, charts, zdd},
       {lambda, drive, missing, pivot}},
      {Role::outputs, "outputs", {z, zd, x, t, tau, in, par, derived, charts, zdd, lambda, drive}, {y, energy, power}},
      {Role::sampled, "sampled", {z, zd, x, t, in, par, derived, charts, zdd, lambda, due}, {held}},
      {Role::ground_places, "ground_places", {z, t, in, par, derived, charts}, {place}},
      {Role::tangents,
       "tangents",
       {z, zd, x, t, step, in, par, derived, charts},
       {tangent, pivot, inertia, state_pivot}},
      {Role::changes, "changes", {zd, zdd, xd, step, tangent}, {zdd, xd}},
      {Role::inverse_dynamics,
       "inverse_dynamics",
       {z, zd, x, t, tau, in, par, derived, charts, zdd},
       {zdd, force, pivot, actuation}},
      {Role::actuators, "actuators", {z, zd, x, t, in, par, derived, charts}, {position, direction, drift}},
      {Role::required_forces, "required_forces", {z, zd, x, t, tau, in, par, derived, charts, zdd}, {required}},
      {Role::derived_constants, "derived_constants", {par}, {derived}}};
  return kSpecs;
}

const ProgramSpec& spec_of(Role role) { return program_specs()[static_cast<std::size_t>(role)]; }

const char* name_of(Role role) { return spec_of(role).name; }

Program& program_of(Programs& programs, Role role) { return programs.*kMembers[static_cast<std::size_t>(role)]; }

const Program& program_of(const Programs& programs, Role role) {
  return programs.*kMembers[static_cast<std::size_t>(role)];
}

std::vector<Program*> solver_programs(Programs& programs) {
  return {&programs.accelerations,  &programs.closure, &programs.closure_terms,    &programs.accelerations_chosen,
          &programs.multipliers,    &programs.outputs, &programs.sampled,          &programs.ground_places,
          &programs.tangents,       &programs.changes, &programs.inverse_dynamics, &programs.actuators,
          &programs.required_forces};
}

std::vector<Program*> solver_programs(WholePrograms& whole) {
  std::vector<Program*> list = solver_programs(whole.programs);
  if (whole.in_pairs) list.push_back(&whole.in_pairs->program);
  if (!whole.around_laws) return list;
  list.push_back(&whole.around_laws->program);
  for (SharedLaw& law : whole.around_laws->laws) list.push_back(&law.program);
  return list;
}

std::vector<Program*> solver_programs(WrittenPrograms& written) {
  std::vector<Program*> list = solver_programs(written.programs);
  if (written.in_pairs) list.front() = &written.in_pairs->program;
  for (SharedLaw& law : written.laws) list.push_back(&law.program);
  return list;
}

int argument_place(const SharedLaw& law, std::size_t argument, std::size_t element) {
  std::size_t place = 0;
  for (const LawArgument& before : std::span(law.arguments).first(argument))
    if (before.numbers.empty()) place += before.is_common ? 1 : law.tyres.size();
  return static_cast<int>(place + (law.arguments[argument].is_common ? 0 : element));
}

WrittenPrograms written(const WholePrograms& whole) {
  WrittenPrograms text{whole.programs, {}, whole.in_pairs};
  text.programs.accelerations = whole.accelerations_of_text();
  if (whole.around_laws) text.laws = whole.around_laws->laws;
  return text;
}

WrittenPrograms with_numbers_of_pairs(WrittenPrograms written) {
  if (written.in_pairs) written.programs.accelerations = unfolded(written.in_pairs->program);
  return written;
}

std::vector<const Program*> all_programs(const Programs& programs, const std::vector<SharedLaw>& laws) {
  std::vector<const Program*> list;
  for (const ProgramSpec& spec : program_specs()) {
    const Program& program = program_of(programs, spec.role);
    if (!program.outputs.empty()) list.push_back(&program);
  }
  for (const SharedLaw& law : laws) list.push_back(&law.program);
  return list;
}

std::vector<const Program*> all_programs(const WholePrograms& whole) {
  return whole.around_laws ? all_programs(whole.programs, whole.around_laws->laws) : all_programs(whole.programs);
}

std::vector<const Program*> all_programs(const WrittenPrograms& written) {
  return all_programs(written.programs, written.laws);
}

WrittenPrograms verified(WrittenPrograms written) {
  for (const ProgramSpec& spec : program_specs()) verify(spec, program_of(written.programs, spec.role));
  if (written.in_pairs) verify(spec_of(Role::accelerations), written.in_pairs->program);
  for (const SharedLaw& law : written.laws)
    verify({Role::accelerations, law.program.name.c_str(), {Array::law_argument}, {Array::law_result}}, law.program);
  return written;
}

}  // namespace mbgen
