#include "compiler/adjoint/adjoint.hpp"
#include "compiler/adjoint/adjoint_programs.hpp"
#include "compiler/analysis/held_start.hpp"
#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/program/in_threads.hpp"

namespace mbgen {
namespace {

/// Weights that a program takes: an array of results, and the array in C++ that holds them.
struct WeightsOf {
  Array array;
  const char* text;
};

/// An adjoint program as its text names it.
struct AdjointRow {
  const Program* program;
  const char *title, *function, *result;
  Role role;         ///< whose arguments it takes
  const char* type;  ///< of the argument `weights`
  Passing passing;
  std::vector<WeightsOf> weights;
  std::vector<Array> more = {};  ///< members of the result beside kMembers
};

/// Derivatives by these are members of every result; derived constants have them by parameters alone.
constexpr Array kMembers[] = {Array::z, Array::zd, Array::x, Array::in, Array::par, Array::derived};

ProgramShape shape_of(const EmitContext& context, const AdjointRow& row) {
  ProgramShape shape;
  shape.title = row.title;
  shape.name = shape.function = row.function;
  shape.result = row.result;
  shape.titles = context.titles;
  shape.order = ValueOrder::fewest_alive;
  shape.arguments = arguments_of(row.role);
  std::erase_if(shape.arguments, [](const Argument& argument) { return argument.name == "tau"; });
  shape.arguments.push_back({"weights", row.type, row.passing});
  shape.inputs = input_places(context);
  for (const auto& [array, text] : row.weights)
    shape.inputs[derivative_of(array)] = {"weights", indexed(text, size_in(context, array)), {}, "", text};
  std::vector<Array> members = row.more;
  if (row.role != Role::derived_constants) members.insert(members.begin(), std::begin(kMembers), std::end(kMembers));
  for (const Array array : members) {
    const bool is_pivot = array == Array::pivot;
    const std::string name = std::string("result.") + name_of(array);
    const int size = size_in(context, array);
    shape.members.push_back({name_of(array), size, is_pivot ? "of each block over its reference" : "derivatives"});
    shape.outputs[is_pivot ? SlotGroup(array) : derivative_of(array)] = {
        "result", indexed(name, size), {}, is_pivot ? "1.0" : "0.0", name};
  }
  return shape;
}

std::vector<AdjointRow> rows_of(const AdjointPrograms& programs) {
  using enum Array;
  constexpr auto pointer = Passing::pointer, reference = Passing::reference;
  return {{&programs.derived,
           "Derivatives by parameters of weighted constants that follow from them.",
           "derived_adjoint",
           "DerivedAdjoint",
           Role::derived_constants,
           "const double",
           pointer,
           {{derived, "weights"}},
           {par}},
          {&programs.accelerations,
           "Derivatives of weighted accelerations and rates of auxiliary states.",
           "accelerations_adjoint",
           "AccelerationsAdjoint",
           Role::accelerations,
           "const Derivative",
           reference,
           {{zdd, "weights.zdd"}, {xd, "weights.xd"}}},
          {&programs.velocities,
           "Derivatives of weighted velocities that are consistent with closed loops.",
           "velocities_adjoint",
           "VelocitiesAdjoint",
           Role::closure,
           "const double",
           pointer,
           {{zd, "weights"}},
           {pivot}},
          {&programs.positions,
           "Derivatives of weighted corrections at a closed position.",
           "positions_adjoint",
           "PositionsAdjoint",
           Role::closure,
           "const double",
           pointer,
           {{dz, "weights"}}},
          {&programs.multipliers,
           "Derivatives of weighted multipliers and driving forces.",
           "multipliers_adjoint",
           "MultipliersAdjoint",
           Role::multipliers,
           "const Multipliers",
           reference,
           {{lambda, "weights.lambda"}, {drive, "weights.drive"}},
           {zdd, pivot}},
          {&programs.outputs,
           "Derivatives of weighted outputs.",
           "outputs_adjoint",
           "OutputsAdjoint",
           Role::outputs,
           "const double",
           pointer,
           {{y, "weights"}},
           {zdd, lambda, drive}}};
}

/// Whether the solver has such a program, and its outputs or steps need it.
bool is_written(const EmitContext& context, const AdjointRow& row) {
  if (row.role == Role::derived_constants) return derived_constant_count(context.programs) > 0;
  if (row.role == Role::multipliers) return context.layout.has_closure && takes_multipliers(context.programs.outputs);
  return row.role != Role::closure || context.layout.has_closure;
}

std::string programs_text(const EmitContext& context, const AdjointPrograms& programs) {
  std::vector<AdjointRow> rows = rows_of(programs);
  std::erase_if(rows, [&](const AdjointRow& row) { return !is_written(context, row); });
  std::vector<std::string> texts(rows.size());
  in_threads(rows.size(), [&](std::size_t i) {
    const ProgramShape shape = shape_of(context, rows[i]);
    const Program& program = *rows[i].program;
    texts[i] = program_text(program, schedule(program, schedule_options(shape, context.options.roll_above)), shape);
  });
  return joined(texts, "\n");
}

std::string member_table(const std::string& type, const std::string& structure, const std::string& name,
                         const std::vector<std::string>& members, const char* indent) {
  return array_text(std::string(indent) + "[[maybe_unused]] static constexpr " + type + " " + structure + "::*" + name,
                    member_places(structure, members), "nullptr");
}

std::string source_text(const EmitContext& context, const AdjointPrograms& programs) {
  const SolverNames& names = context.names;
  const Program& outputs = context.programs.outputs;
  const SolverLayout& layout = context.layout;
  const int derived = derived_constant_count(context.programs);
  const auto driven = mapped(context.analysis.driven, [](bool flag) { return std::string(flag ? "1" : "0"); });
  const auto derivatives =
      mapped(context.model.inputs, [](const Input& input) { return std::to_string(input.derivative); });
  const char *of_system = "  ", *of_directions = "    ";
  return fill_template(
      context, "adjoint.cpp.in",
      {{"programs", programs_text(context, programs)},
       {"output_size", size_text(layout.outputs)},
       {"derived_count", derived},
       {"ball_count", layout.balls},
       {"starts", has_start_with_derivatives(context.model, context.topology, context.analysis)},
       {"takes_rates", takes(outputs, Array::zdd) || takes_multipliers(outputs)},
       {"driven_table", array_text("  [[maybe_unused]] static constexpr unsigned char kDriven", driven, "0")},
       {"input_derivatives", array_text("  [[maybe_unused]] static constexpr int kInputDerivative", derivatives, "-1")},
       {"parameter_table", member_table("double", "Parameters", "kParameterMember", names.parameters, of_system)},
       {"input_table", member_table("double", "Inputs", "kInputMember", names.inputs, of_system)},
       {"direction_parameter_table",
        member_table("Real", "Parameters", "kParameterMember", names.parameters, of_directions)},
       {"direction_input_table", member_table("Real", "Inputs", "kInputMember", names.inputs, of_directions)},
       {"direction_output_table", member_table("Real", "Outputs", "kOutputMember", names.outputs, of_directions)}});
}

}  // namespace

std::vector<EmittedFile> emit_adjoint(const WrittenPrograms& written, const Model& model, const Topology& topology,
                                      const Analysis& analysis, const EmitOptions& options) {
  const EmitContext context(written, model, topology, analysis, options);
  const SolverNames& names = context.names;
  const std::string outputs = size_text(context.layout.outputs);
  const bool starts = has_start_with_derivatives(model, topology, analysis);
  std::vector<EmittedFile> files = {
      {names.solver + "_adjoint.hpp",
       fill_template(context, "adjoint.hpp.in",
                     {{"output_size", outputs},
                      {"derived_size", size_text(derived_constant_count(context.programs))},
                      {"starts", starts}})},
      {names.solver + "_adjoint.cpp", source_text(context, adjoint_programs(written))}};
  if (!options.c_interface) return files;
  const FrameValues header = {
      {"banner", c_banner_text(model)}, {"title", c_comment_text(model.name)}, {"guard", guard_of(names.solver)}};
  const FrameValues source = {{"parameters", name_rows(names.parameters)},
                              {"inputs", name_rows(names.inputs)},
                              {"outputs", name_rows(names_of(output_members(context)))},
                              {"output_size", outputs}};
  files.push_back({names.solver + "_adjoint_c.h", fill_template(context, "adjoint_c.h.in", header)});
  files.push_back({names.solver + "_adjoint_c.cpp", fill_template(context, "adjoint_c.cpp.in", source)});
  const std::string example = names.outputs.empty() ? "name" : names.outputs.front();
  files.push_back({names.solver + "_adjoint.py",
                   fill_template(context, "adjoint.py.in",
                                 {{"banner", banner_text(model, "#")}, {"example_output", string_literal(example)}})});
  return files;
}

}  // namespace mbgen
