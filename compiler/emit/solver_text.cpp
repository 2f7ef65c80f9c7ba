#include "compiler/emit/solver_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <stdexcept>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/input_text.hpp"
#include "compiler/emit/interface_text.hpp"
#include "compiler/emit/legend.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

using Items = std::vector<std::string>;

/// A static table of System.
std::string table(const std::string& type, const std::string& name, Items items, const std::string& filler = "0") {
  return array_text("  static constexpr " + type + " " + name, std::move(items), filler);
}

template <class Number>
Items items_of(const std::vector<Number>& numbers) {
  return mapped(numbers, [](Number number) { return std::to_string(static_cast<int>(number)); });
}

std::string braces(const std::vector<int>& numbers) { return fmt::format("{{{}}}", fmt::join(numbers, ", ")); }

/// Block and place of every free direction: the q-th direction of its block.
Items free_direction_items(const EmitContext& context) {
  std::vector<int> directions_of(context.layout.blocks.size(), 0);
  Items items;
  for (const std::string& name : context.programs.free_direction_coordinate) {
    const int coordinate = find_coordinate(context.topology, name);
    if (coordinate < 0) throw std::logic_error("free direction of an unknown coordinate: " + name);
    const int block = context.topology.groups[context.topology.group_of[coordinate]].block;
    items.push_back(braces({coordinate, block, block < 0 ? 0 : directions_of[block]++}));
  }
  return items;
}

/// Coordinates and hand of every ball that has charts.
Items ball_items(const Topology& topology) {
  return mapped(topology.balls, [](const Ball& ball) {
    return fmt::format("{{{{{}}}, {}}}", fmt::join(ball.coordinate, ", "), ball.hand);
  });
}

/// Place of each equation, block after block, in the order of Topology::loops.
std::vector<int> multiplier_places(const Topology& topology) {
  std::vector<int> first, places;
  int next = 0;
  for (const Loop& loop : topology.loops) {
    first.push_back(next);
    next += loop.equations;
  }
  for (const LoopBlock& block : topology.blocks) {
    for (const int loop : block.loops) {
      for (int e = 0; e < topology.loops[loop].equations; ++e) places.push_back(first[loop] + e);
    }
  }
  return places;
}

std::vector<int> drive_coordinates(const EmitContext& context) {
  return mapped(context.model.motions,
                [&](const Motion& motion) { return tree_coordinate(context.topology, motion.joint); });
}

/// Where each parameter or input is in its struct, to name one that is not finite.
std::string member_table(const std::string& scalar, const std::string& structure, const std::string& name,
                         const Items& members) {
  return table(scalar, structure + "::*" + name, member_places(structure, members), "nullptr");
}

/// Sum of all parameters and inputs: not finite when one of them is not.
std::string argument_sum(const SolverNames& names, const std::string& scalar) {
  Items terms;
  for (const std::string& name : names.parameters) terms.push_back("parameters." + name);
  for (const std::string& name : names.inputs) terms.push_back("inputs." + name);
  if (terms.empty()) terms.push_back(is_number(scalar) ? number_text(0, scalar) : scalar + "{}");
  return wrapped_statement("    return " + joined(terms, " + ") + ";");
}

bool runs_rarely(Role role) {
  return role == Role::multipliers || role == Role::closure_terms || role == Role::accelerations_chosen ||
         role == Role::outputs;
}

/// Gives programs that run rarely the parts 1, 2, ... of the file, each with at least so many values; the rest of the
/// file is part 0. A file with fewer such values stays whole. Result: the number of parts beside part 0.
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

/// Residuals live where the closure program says; the tables of System assume block after block.
void check_residual_order(const EmitContext& context) {
  for (std::size_t b = 0; b < context.layout.blocks.size(); ++b) {
    if (context.programs.residual_equation_of.at(b) != context.layout.blocks[b].first_equation) {
      throw std::logic_error("residuals of block " + std::to_string(b) + " do not follow those of the blocks before");
    }
  }
}

/// The arrays of initial_state(). Copied number by number, as a bare target may have no memcpy.
FrameRows start_rows(const InitialState& initial, const std::string& scalar) {
  return mapped(std::array{initial.z, initial.zd, initial.x}, [&](const std::vector<double>& values) {
    Items items = number_texts(values, scalar);
    if (items.empty()) items.push_back(number_text(0, scalar));
    constexpr std::size_t kIndent = 7;  // after the brace
    return FrameValues{{"numbers", "{" + wrapped_list(items, kIndent).substr(kIndent) + "}"}};
  });
}

}  // namespace

FrameValues system_member(const ShapedProgram& shaped, const std::string& type, const std::string& scope) {
  const std::string& function = shaped.shape.function;
  const bool is_called = shaped.role != Role::outputs && shaped.role != Role::derived_constants;
  return {{"result", shaped.shape.members.empty() ? "" : shaped.shape.result},
          {"type", type},
          {"name", function.substr(std::string_view("compute_").size())},
          {"function", is_called ? scope + function : ""}};
}

FrameValues system_values(const EmitContext& context, const FrameRows& members, const std::string& scalar) {
  const SolverLayout& layout = context.layout;
  const SolverNames& names = context.names;
  Items blocks;
  std::vector<int> coordinates;
  std::vector<bool> block_driven, redundant(layout.equations, false);
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    const BlockPlaces& p = layout.blocks[b];
    blocks.push_back(fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}}}", p.equations, p.coordinates, p.rank, p.free,
                                 p.first_equation, p.first_coordinate, p.first_jacobian, p.first_projection,
                                 number_text(context.analysis.blocks[b].typical_pivot)));
    for (const int joint : context.topology.blocks[b].joints) {
      coordinates.push_back(joint);
      block_driven.push_back(context.analysis.driven[joint]);
    }
    for (const int e : context.analysis.blocks[b].redundant_equations) redundant[p.first_equation + e] = true;
  }
  // What only closures or loops ask for is left out without them, so that nothing is unused; lanes leave the choice of
  // coordinates at run time to the solver of one instance.
  return {{"coordinate_count", layout.coordinates},
          {"auxiliary_states", layout.auxiliary_states},
          {"blocks", blocks.size()},
          {"equations", layout.equations},
          {"free_directions", context.programs.free_direction_coordinate.size()},
          {"closure", layout.has_closure},
          {"drives", layout.drives},
          {"number", context.options.scalar},
          {"tolerance", number_text(context.model.solver.closure_tolerance, context.options.scalar)},
          {"alone", is_number(scalar)},
          {"frozen_only", !layout.chooses_again},
          {"balls", layout.balls > 0 ? std::to_string(layout.balls) : ""},
          {"ball_table", table("mbgen::Ball", "kBall", ball_items(context.topology))},
          {"block_coordinates", blocks.empty() ? "" : std::to_string(layout.block_coordinates)},
          {"free_direction_table",
           table("mbgen::FreeDirection", "kFreeDirection", free_direction_items(context), "{0, -1, 0}")},
          {"parameter_members", member_table(scalar, "Parameters", "kParameterMember", names.parameters)},
          {"input_members", member_table(scalar, "Inputs", "kInputMember", names.inputs)},
          {"driven", table("unsigned char", "kDriven", items_of(context.analysis.driven))},
          {"redundant", table("unsigned char", "kRedundant", items_of(redundant))},
          {"drive_coordinate", table("int", "kDriveCoordinate", items_of(drive_coordinates(context)))},
          {"block_layout", table("mbgen::BlockLayout", "kBlockLayout", blocks, "{0, 0, 0, 0, 0, 0, 0, 0, 0.0}")},
          {"block_coordinate", table("int", "kBlockCoordinate", items_of(coordinates))},
          {"block_driven", table("unsigned char", "kBlockDriven", items_of(block_driven))},
          {"multiplier_place", table("int", "kMultiplierPlace", items_of(multiplier_places(context.topology)))},
          {"members", members},
          {"scalar", scalar},
          {"parameters_argument", names.parameters.empty() ? "/*parameters*/" : "parameters"},
          {"inputs_argument", names.inputs.empty() ? "/*inputs*/" : "inputs"},
          {"sum", argument_sum(names, scalar)}};
}

EmittedFile solver_file(const EmitContext& context, std::vector<ShapedProgram> programs, bool for_importers) {
  check_residual_order(context);
  const std::string& solver = context.names.solver;
  FrameRows hot, rare, members;
  ConstantNames constants(context.programs);
  const int rare_parts = divide_file(programs, context.options.file_part_values);
  for (ShapedProgram& shaped : programs) {
    shaped.shape.constants = &constants;
    FrameRows& part = shaped.shape.file_part > 0 ? rare : hot;
    part.push_back({{"program", program_text(*shaped.program, shaped.schedule, shaped.shape)}});
    members.push_back(system_member(shaped, solver + "::" + shaped.shape.result, ""));
  }
  const bool has_projection = !context.layout.blocks.empty() && context.layout.chooses_again;
  const bool advances = inputs_have_derivatives(context.model.inputs);
  FrameValues values = {
      {"banner", banner_text(context.model, "//") + legend_text(context)},
      {"constants", constants.declarations(context.options.scalar)},
      {"solver", solver},
      {"rare_parts", rare_parts > 0 ? std::to_string(rare_parts) : ""},
      {"all_parts", rare_parts + 1},
      {"for_importers", for_importers},
      {"hot", hot},
      {"rare", rare},
      {"projection", has_projection ? size_text(context.layout.projection_entries) : ""},
      {"derived", derived_constant_count(context.programs) > 0},
      {"outputs_take_multipliers", outputs_take_multipliers(context.programs)},
      {"advances", advances},
      {"later_inputs", later_inputs(context.model, context.names, context.options.scalar)},
      {"inputs_now", advances ? "now" : "inputs"},
      {"since_start", context.options.scalar == "float" ? "static_cast<float>(state.t - start)" : "state.t - start"},
      {"initial", context.options.initial.has_value()},
      {"start", context.options.initial ? start_rows(*context.options.initial, context.options.scalar) : FrameRows{}}};
  values.merge(system_values(context, members, context.options.scalar));
  return {solver + ".cpp", fill_template("solver.cpp.in", values), rare_parts};
}

}  // namespace mbgen
