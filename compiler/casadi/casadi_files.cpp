// The files for CasADi and acados.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/casadi/casadi.hpp"
#include "compiler/casadi/exported.hpp"
#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/tyres.hpp"
#include "compiler/topology/names.hpp"

namespace mbgen {
namespace {

std::string integers(const std::vector<int>& values) {
  return wrapped_list(mapped(values.empty() ? std::vector<int>{0} : values, [](int v) { return std::to_string(v); }),
                      4);
}

/// Calls of the parts of a program.
FrameValues program_row(const CFunctions& functions) {
  return {{"program", functions.name}, {"calls", mapped(functions.parts, [](const CFunction& part) {
                                          return FrameValues{{"part", part.name}};
                                        })}};
}

FrameValues function_row(const CasadiFunction& function, const std::string& table) {
  const std::vector<int> colours = coloured_columns(function.jacobian);
  const int count = colours.empty() ? 0 : 1 + std::ranges::max(colours);
  return {{"table", table},
          {"name", function.name},
          {"rows", function.rows.size()},
          {"pivots", function.pivots.size()},
          {"inertias", function.inertias.size()},
          {"holds", function.holds.size()},
          {"factors", function.factors},
          {"colours", count},
          {"values_program", function.values.name},
          {"factors_program", function.factor_values.name},
          {"directions_program", function.directions.name},
          {"sums_program", function.sums.name},
          {"colour_of", integers(colours)},
          {"first_entries", integers(function.jacobian.first)},
          {"entry_rows", integers(function.jacobian.row)}};
}

/// Sizes of the work vector.
FrameValues work_sizes(const CasadiFunctions& functions, int coordinates) {
  int results = coordinates + functions.closing_residuals + functions.closing_pivots, factors = 0, rows = 0,
      entries = 0, work = functions.closing.work;
  for (const CasadiFunction& one : functions.list) {
    const int monitors = static_cast<int>(one.pivots.size() + one.inertias.size() + one.holds.size());
    results = std::max(results, monitors + static_cast<int>(one.rows.size()));
    factors = std::max(factors, monitors + one.factors);
    rows = std::max(rows, static_cast<int>(one.rows.size()));
    entries = std::max(entries, one.jacobian.entries());
    work = std::max({work, one.values.work, one.factor_values.work, one.directions.work, one.sums.work});
  }
  return {{"result_size", results},
          {"factor_size", factors},
          {"row_size", std::max(rows, functions.arguments.columns())},
          {"entry_size", entries},
          {"cross_size", work}};
}

/// Files of parts, each of some thousand values.
std::vector<std::vector<const CFunction*>> divided(const CasadiFunctions& functions) {
  std::vector<std::vector<const CFunction*>> files(1);
  std::size_t values = 0;
  const auto add = [&](const CFunctions& program) {
    for (const CFunction& part : program.parts) {
      if (values >= kFilePartValues) {
        files.emplace_back();
        values = 0;
      }
      files.back().push_back(&part);
      values += part.values;
    }
  };
  add(functions.closing);
  for (const CasadiFunction& one : functions.list) {
    add(one.values);
    add(one.factor_values);
    add(one.directions);
    add(one.sums);
  }
  return files;
}

/// 1 for each independent coordinate inside a loop block.
std::vector<int> loop_flags(const Topology& topology, const std::vector<int>& free) {
  return mapped(free, [&](int c) {
    const int group = topology.group_of[static_cast<std::size_t>(c)];
    return topology.groups[static_cast<std::size_t>(group)].block >= 0 ? 1 : 0;
  });
}

/// Second angles of balls, whose angles end at a pole.
std::vector<int> pole_angles(const Topology& topology) {
  return mapped(topology.balls, [](const Ball& ball) { return ball.coordinate[1]; });
}

std::string numbers(const std::vector<double>& values) {
  return wrapped_list(number_texts(values.empty() ? std::vector<double>{0} : values), 4);
}

/// A number for Python.
std::string python_number(double value) {
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  return fmt::format("{}", value);
}

/// Rows of a table in Python: name, unit, start value and range.
struct PythonRow {
  std::string name, unit;
  double value = 0, least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

/// columns: number of them in a row.
FrameRows python_rows(const std::vector<PythonRow>& rows, std::size_t columns) {
  return mapped(rows, [columns](const PythonRow& row) {
    std::vector<std::string> all = {string_literal(row.name), string_literal(row.unit), python_number(row.value),
                                    python_number(row.least), python_number(row.most)};
    all.resize(columns);
    return FrameValues{{"entry", "(" + joined(all, ", ") + "),"}};
  });
}

template <class Given>
PythonRow given_row(const Given& given, const std::string& name, double value) {
  PythonRow row{name, given.unit, value};
  row.least = given.shown.min.value_or(row.least);
  row.most = given.shown.max.value_or(row.most);
  return row;
}

std::vector<PythonRow> input_table(const EmitContext& context) {
  std::vector<PythonRow> rows;
  for (const Input& input : context.model.inputs)
    rows.push_back(given_row(input, context.names.inputs[rows.size()], input.default_value));
  for (const auto& actuator : context.model.actuators) {
    if (actuator.input < 0 || !actuator.limit) continue;
    PythonRow& row = rows[static_cast<std::size_t>(actuator.input)];
    row.least = std::max(row.least, -*actuator.limit);
    row.most = std::min(row.most, *actuator.limit);
  }
  return rows;
}

std::vector<PythonRow> parameter_table(const EmitContext& context) {
  std::vector<PythonRow> rows;
  for (const Parameter& parameter : tunable_parameters(context.model))
    rows.push_back(given_row(parameter, context.names.parameters[rows.size()], parameter.value));
  return rows;
}

std::vector<PythonRow> state_table(const EmitContext& context, const ArgumentLayout& layout,
                                   const InitialState& initial) {
  std::vector<PythonRow> rows;
  for (const char* rate : {"", "/s"}) {
    for (const int c : layout.free) {
      const bool is_rate = *rate != 0;
      rows.push_back({(is_rate ? "zd." : "z.") + context.topology.bodies[static_cast<std::size_t>(c)].coordinate,
                      unit_of(context.topology.bodies[static_cast<std::size_t>(c)].kind) + std::string(rate),
                      (is_rate ? initial.zd : initial.z)[static_cast<std::size_t>(c)]});
    }
  }
  for (std::size_t i = 0; const AuxiliaryState& state : auxiliary_states(context.model))
    rows.push_back({"x." + state.name, state.unit, initial.x[i++]});
  return rows;
}

std::vector<PythonRow> output_table(const EmitContext& context) {
  std::vector<PythonRow> rows;
  for (const Output& output : context.model.outputs) rows.push_back({context.names.outputs[rows.size()], output.unit});
  return rows;
}

/// A comment that names the numbers of an argument in order.
std::string listed(const char* argument, const std::vector<PythonRow>& rows) {
  std::string words = fmt::format("{}:", argument);
  for (const PythonRow& row : rows) words += fmt::format(" {} [{}],", row.name, row.unit);
  if (rows.empty()) words += " none,";
  words.pop_back();
  return wrapped_words(c_comment_text(words), " *   ");
}

/// `<model>_casadi.c`: everything but the parts of the programs.
std::string main_text(const EmitContext& context, const CasadiFunctions& functions, const InitialState& initial) {
  PatternTable patterns;
  FrameRows tables, exported, programs;
  for (const CasadiFunction& one : functions.list) {
    const std::string table = "table_" + one.name;
    tables.push_back(function_row(one, table));
    for (const CFunctions* program : {&one.values, &one.factor_values, &one.directions, &one.sums})
      programs.push_back(program_row(*program));
    for (const Exported& function : exported_functions(one, functions.arguments, table))
      exported.push_back(exported_row(function, patterns));
  }
  if (context.layout.has_closure) programs.push_back(program_row(functions.closing));
  const ArgumentLayout& layout = functions.arguments.layout;
  const std::vector<int> poles = pole_angles(context.topology);
  FrameValues values = work_sizes(functions, context.layout.coordinates);
  values.insert({{"banner", c_banner_text(context.model)},
                 {"guard", guard_of(context.names.solver)},
                 {"title", c_comment_text(context.model.name)},
                 {"has_time", functions.arguments.has_time},
                 {"has_h", functions.list.size() > 1},
                 {"states_list", listed("x", state_table(context, layout, initial))},
                 {"inputs_list", listed("u", input_table(context))},
                 {"parameters_list", listed("p", parameter_table(context))},
                 {"outputs_list", listed("y", output_table(context))},
                 {"argument_count", functions.arguments.names().size()},
                 {"columns", functions.arguments.columns()},
                 {"argument_columns", integers(functions.arguments.first())},
                 {"free_count", layout.count()},
                 {"free", integers(layout.free)},
                 {"in_loops", integers(loop_flags(context.topology, layout.free))},
                 {"start", numbers(initial.z)},
                 {"pole_count", poles.empty() ? "" : std::to_string(poles.size())},
                 {"poles", integers(poles)},
                 {"samples_table", context.model.samples ? numbers(*context.model.samples) : ""},
                 {"residuals", functions.closing_residuals},
                 {"closing_pivots", functions.closing_pivots},
                 {"programs", programs},
                 {"tables", tables},
                 {"patterns", patterns.rows()},
                 {"exported", exported}});
  return fill_template(context, "casadi.c.in", values);
}

std::string header_text(const EmitContext& context, const CasadiFunctions& functions) {
  FrameRows parts;
  for (const auto& file : divided(functions))
    for (const CFunction* part : file)
      parts.push_back({{"declaration", c_signature(part->name, context.names.solver + "_point") + ";"}});
  return fill_template(
      context, "casadi.h.in",
      {{"banner", c_banner_text(context.model)}, {"guard", guard_of(context.names.solver)}, {"declarations", parts}});
}

std::string acados_text(const EmitContext& context, const CasadiFunctions& functions, const InitialState& initial) {
  return fill_template(context, "acados.py.in",
                       {{"banner", banner_text(context.model, "#")},
                        {"title", comment_text(context.model.name)},
                        {"has_time", functions.arguments.has_time},
                        {"has_h", functions.list.size() > 1},
                        {"states", python_rows(state_table(context, functions.arguments.layout, initial), 3)},
                        {"inputs", python_rows(input_table(context), 5)},
                        {"parameters", python_rows(parameter_table(context), 5)},
                        {"outputs", python_rows(output_table(context), 2)}});
}

}  // namespace

std::string no_explicit_motion(const Model& model, const Topology& topology, const Analysis& analysis) {
  if (rolling_loop(topology) != nullptr) return "bodies roll: there are more free positions than velocities";
  if (held_state_count(model) > 0) return "sampled values change at instants";
  if (!tyres_on_host(model).empty()) return "wheels stand on ground of a host";
  if (free_coordinates(topology, analysis).empty() && auxiliary_state_count(model) == 0)
    return "it has no states: every coordinate is driven, or cannot move";
  return "";
}

std::vector<EmittedFile> emit_casadi(const Programs& programs, const Programs& for_slopes,
                                     const WrittenPrograms& emitted, const Model& model, const Topology& topology,
                                     const Analysis& analysis, const InitialState& initial) {
  const EmitContext context(emitted, model, topology, analysis, {.initial = initial});
  const std::string& solver = context.names.solver;
  const CasadiFunctions functions = casadi_functions(solver, programs, for_slopes, context.layout,
                                                     argument_layout(context.layout, topology, analysis));
  std::vector<EmittedFile> files = {{solver + "_casadi.h", header_text(context, functions)},
                                    {solver + "_casadi.c", main_text(context, functions, initial)}};
  FrameRows sources = {{{"source", solver + "_casadi.c"}}};
  for (int number = 1; const auto& parts : divided(functions)) {
    std::string body;
    for (const CFunction* part : parts) body += "\n" + part->text;
    const std::string name = fmt::format("{}_casadi_{}.c", solver, number++);
    files.push_back(
        {name, fill_template(context, "casadi_part.c.in", {{"banner", c_banner_text(model)}, {"functions", body}})});
    sources.push_back({{"source", name}});
  }
  files.push_back(
      {solver + "_casadi.cmake",
       fill_template(context, "casadi.cmake.in", {{"banner", banner_text(model, "#")}, {"sources", sources}})});
  files.push_back({solver + "_acados.py", acados_text(context, functions, initial)});
  return files;
}

}  // namespace mbgen
