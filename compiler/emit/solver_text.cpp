#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "compiler/analysis/held_start.hpp"
#include "compiler/emit/context_values.hpp"
#include "compiler/emit/law_text.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/quantity_ranges.hpp"
#include "compiler/emit/system_values.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/model/inputs.hpp"
#include "compiler/program/in_threads.hpp"

namespace mbgen {
namespace {

bool runs_rarely(Role role) {
  return role == Role::multipliers || role == Role::closure_terms || role == Role::accelerations_chosen ||
         role == Role::outputs || role == Role::inverse_dynamics || role == Role::actuators ||
         role == Role::required_forces;
}

/// Assigns rarely used programs to the parts 1, 2, ... of the file, each with at least so many values; the rest of the
/// file is part 0. A file with fewer such values is not divided. Result: the number of parts beside part 0.
int divide_file(std::vector<ShapedProgram>& programs, std::size_t least_values) {
  std::vector<ShapedProgram*> rare;
  std::size_t left = 0;
  for (ShapedProgram& program : programs) {
    if (!runs_rarely(program.role)) continue;
    rare.push_back(&program);
    left += program.program->nodes.size();
  }
  if (left < least_values) return 0;
  int part = 1;
  std::size_t values = 0;
  for (ShapedProgram* program : rare) {
    program->shape.file_part = part;
    values += program->program->nodes.size();
    left -= program->program->nodes.size();
    if (values < least_values || left < least_values) continue;
    ++part;
    values = 0;
  }
  return part;
}

/// The arrays of initial_state(). They are copied number by number, since a bare target may have no memcpy.
FrameRows start_rows(const InitialState& initial, Scalar scalar) {
  return mapped(std::array{initial.z, initial.zd, initial.x}, [&](const std::vector<double>& values) {
    std::vector<std::string> items = number_texts(values, scalar);
    if (items.empty()) items.push_back(number_text(0, scalar));
    constexpr std::size_t kIndent = 7;  // after the brace
    return FrameValues{{"numbers", "{" + wrapped_list(items, kIndent).substr(kIndent) + "}"}};
  });
}

/// Charts of balls that start in their other chart, after the time; "" if there are none.
std::string start_charts(const InitialState& initial, Scalar scalar) {
  if (initial.charts.empty()) return "";
  return fmt::format(", {{{}}}", fmt::join(number_texts(initial.charts, scalar), ", "));
}

/// The coordinates that a start with derivatives holds, for mbgen/start.hpp; "" for a solver without such a start.
std::string held_table(const EmitContext& context) {
  if (!starts_with_derivatives(context)) return "";
  const Initial& initial = context.model.initial;
  std::vector<std::string> items;
  for (const std::vector<InitialValue>* given : {&initial.positions, &initial.velocities}) {
    const auto held = held_at_start(context.topology, context.analysis, *given);
    items.push_back("{" + joined(mapped(*held, [](unsigned char flag) { return std::to_string(flag); }), ", ") + "}");
  }
  return braced_list("  static constexpr mbgen::HeldCoordinates<kCoordinates> kHeld = ", items, ";");
}

/// The functions of the programs. constants: afterwards with the uses of all texts.
std::vector<std::string> texts_of(const EmitContext& context, std::vector<ShapedProgram>& programs,
                                  ConstantNames& constants) {
  std::vector<std::string> texts(programs.size());
  const auto write = [&](std::size_t i, ConstantNames& names) {
    ProgramShape& shape = programs[i].shape;
    shape.constants = &names;
    const bool is_apart = programs[i].role == Role::accelerations && context.options.scalar == Scalar::tangents;
    texts[i] = is_apart ? accelerations_apart_text(context, programs[i])
                        : (shape.laws.empty() ? "" : law_texts(context, shape.scalar, &names)) +
                              program_text(*programs[i].program, programs[i].schedule, shape);
  };
  if (context.options.spelling == Spelling::reading) {  // folds get their names in the order of the texts
    for (std::size_t i = 0; i < programs.size(); ++i) write(i, constants);
    return texts;
  }
  std::vector<ConstantNames> own(programs.size(), constants);
  in_threads(programs.size(), [&](std::size_t i) { write(i, own[i]); });
  for (const ConstantNames& names : own) constants.add_uses(names);
  return texts;
}

}  // namespace

std::string turning_table(const EmitContext& context, Scalar scalar) {
  std::vector<double> turning(context.topology.bodies.size(), 0.0);
  bool any = false;
  for (const Program* program : {&context.programs.accelerations, &context.programs.closure}) {
    for (const Slot& slot : program->inputs) {
      if (slot.group.array != Array::z) continue;
      const auto i = static_cast<std::size_t>(slot.index);
      if (context.topology.bodies[i].kind != FreedomKind::revolute) continue;
      turning[i] = 1;
      any = true;
    }
  }
  if (!any) return "";
  const std::string head = fmt::format("constexpr {} kTurning", name_of(plain(scalar)));
  return array_text(head, number_texts(turning, scalar), "");
}

EmittedFile solver_file(const EmitContext& context, std::vector<ShapedProgram> programs, bool for_importers) {
  const std::string& solver = context.names.solver;
  FrameRows hot, rare, members;
  const bool is_for_reading = context.options.spelling == Spelling::reading;
  const int rare_parts = is_for_reading ? 0 : divide_file(programs, context.options.file_part_values);
  ConstantNames constants(context.written);
  const std::vector<std::string> texts = texts_of(context, programs, constants);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const ShapedProgram& shaped = programs[i];
    FrameRows& part = shaped.shape.file_part > 0 ? rare : hot;
    part.push_back({{"program", texts[i]}});
    // Dynamics::sample and take_ground call these.
    if (shaped.role != Role::sampled && shaped.role != Role::ground_places)
      members.push_back(system_member(shaped, solver + "::" + shaped.shape.result, ""));
  }
  const bool has_projection = !context.layout.blocks.empty() && context.layout.chooses_again && !context.regular_only;
  const bool advances = inputs_have_derivatives(context.model.inputs);
  FrameValues values = {
      {"banner", banner_text(context.model, "//", is_for_reading ? " --reading" : "") + legend_text(context)},
      {"constants", constants.declarations(plain(context.options.scalar))},
      {"rare_parts", rare_parts > 1   ? fmt::format("1 to {}", rare_parts)
                     : rare_parts > 0 ? "1"
                                      : ""},
      {"all_parts", rare_parts + 1},
      {"for_importers", for_importers},
      // An FMU checks rotations by itself, see mbgen/fmu/fmu_turns.hpp.
      {"turning", for_importers ? "" : turning_table(context, context.options.scalar)},
      {"pairs", context.in_pairs},
      {"has_quantities", has_quantities(context)},
      {"laws", !context.written.laws.empty() && context.options.scalar != Scalar::floats},
      {"hot", hot},
      {"rare", rare},
      {"projection", has_projection ? size_text(context.layout.projection_entries) : ""},
      {"inputs_now", advances ? "now" : "inputs"},
      {"since_start",
       context.options.scalar == Scalar::floats ? "static_cast<float>(state.t - start)" : "state.t - start"},
      {"start", context.options.initial ? start_rows(*context.options.initial, context.options.scalar) : FrameRows{}},
      {"held", held_table(context)},
      {"start_charts", context.options.initial ? start_charts(*context.options.initial, context.options.scalar) : ""}};
  values.merge(system_values(context, members, context.options.scalar));
  return {solver + ".cpp", fill_template(context, "solver.cpp.in", values), rare_parts};
}

}  // namespace mbgen
