#include "compiler/emit/solver_text.hpp"

#include <algorithm>
#include <stdexcept>

#include "compiler/emit/file_parts.hpp"
#include "compiler/emit/input_text.hpp"
#include "compiler/emit/interface_text.hpp"
#include "compiler/emit/legend.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/tuned_text.hpp"

namespace mbgen {
namespace {

using Items = std::vector<std::string>;

/// Text that only a solver which chooses its coordinates at run time needs; lanes leave that to the scalar solver.
std::string where_chosen(const std::string& scalar, const std::string& text) { return is_number(scalar) ? text : ""; }

/// A static table of System.
std::string table(const std::string& type, const std::string& name, Items items, const std::string& filler = "0") {
  return array_text("  static constexpr " + type + " " + name, std::move(items), filler) + "\n";
}

std::string constant(const std::string& type, const std::string& name, const std::string& value) {
  return "  static constexpr " + type + " " + name + " = " + value + ";\n";
}

std::string braces(const Items& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "{" : ", ") + item;
  return text + "}";
}

template <class Number>
Items items_of(const std::vector<Number>& numbers) {
  Items items;
  for (const auto number : numbers) items.push_back(std::to_string(static_cast<int>(number)));
  return items;
}

std::string braces(const std::vector<int>& numbers) { return braces(items_of(numbers)); }

/// Sizes and decisions; what only closures or loops ask for is left out without them, so that nothing is unused.
std::string constants(const EmitContext& context, const std::string& scalar) {
  const SolverLayout& layout = context.layout;
  std::string text =
      constant("int", "kCoordinates", std::to_string(layout.coordinates)) +
      constant("int", "kAuxiliaryStates", std::to_string(layout.auxiliary_states)) +
      constant("int", "kBlocks", std::to_string(layout.blocks.size())) +
      constant("int", "kEquations", std::to_string(layout.equations)) +
      constant("int", "kFreeDirections", std::to_string(context.programs.free_direction_coordinate.size())) +
      constant("bool", "kHasClosure", layout.has_closure ? "true" : "false");
  if (layout.has_closure) {
    text += constant("int", "kDrives", std::to_string(layout.drives)) +
            constant(context.scalar, "kClosureTolerance",
                     number_text(context.model.solver.closure_tolerance, context.scalar));
  }
  if (!layout.chooses_again) text += where_chosen(scalar, constant("bool", "kFrozenOnly", "true"));
  if (!layout.blocks.empty()) {
    text += where_chosen(scalar, constant("int", "kBlockCoordinates", std::to_string(layout.block_coordinates)));
  }
  return text;
}

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
  std::vector<int> coordinates;
  for (const Motion& motion : context.model.motions) {
    coordinates.push_back(tree_coordinate(context.topology, motion.joint));
  }
  return coordinates;
}

/// Where each parameter or input is in its struct, to name one that is not finite.
std::string member_table(const std::string& scalar, const std::string& structure, const std::string& name,
                         const Items& members) {
  return table(scalar, structure + "::*" + name, member_places(structure, members), "nullptr");
}

/// The call of the outputs' program, once the arguments are found good.
std::string outputs_call(const EmitContext& context) {
  if (!outputs_take_multipliers(context.programs)) {
    return "  if (status.ok()) compute_outputs(parameters, inputs, state, tau, derivative, values);";
  }
  return "  if (status.ok()) {\n"
         "    compute_outputs(parameters, inputs, state, tau, derivative,\n"
         "                    mbgen::multipliers_or_nan<System>(parameters, inputs, state, tau, derivative), values);\n"
         "  }";
}

std::string tables(const EmitContext& context, const std::string& scalar) {
  const SolverLayout& layout = context.layout;
  Items blocks;
  std::vector<int> coordinates;
  std::vector<bool> block_driven, redundant(layout.equations, false);
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    const BlockPlaces& p = layout.blocks[b];
    Items block = items_of(std::vector<int>{p.equations, p.coordinates, p.rank, p.free, p.first_equation,
                                            p.first_coordinate, p.first_jacobian, p.first_projection});
    block.push_back(number_text(context.analysis.blocks[b].typical_pivot));
    blocks.push_back(braces(block));
    for (const int joint : context.topology.blocks[b].joints) {
      coordinates.push_back(joint);
      block_driven.push_back(context.analysis.driven[joint]);
    }
    for (const int e : context.analysis.blocks[b].redundant_equations) redundant[p.first_equation + e] = true;
  }
  std::string text = where_chosen(
      scalar, table("mbgen::FreeDirection", "kFreeDirection", free_direction_items(context), "{0, -1, 0}"));
  text += where_chosen(scalar, member_table(scalar, "Parameters", "kParameterMember", context.names.parameters) +
                                   member_table(scalar, "Inputs", "kInputMember", context.names.inputs));
  if (layout.has_closure) {
    text +=
        table("unsigned char", "kDriven", items_of(context.analysis.driven)) +
        table("unsigned char", "kRedundant", items_of(redundant)) +
        where_chosen(scalar, table("int", "kDriveCoordinate", items_of(drive_coordinates(context))) +
                                 table("mbgen::BlockLayout", "kBlockLayout", blocks, "{0, 0, 0, 0, 0, 0, 0, 0, 0.0}"));
  }
  if (!layout.blocks.empty()) {
    text += table("int", "kBlockCoordinate", items_of(coordinates)) +
            where_chosen(scalar, table("unsigned char", "kBlockDriven", items_of(block_driven)) +
                                     table("int", "kMultiplierPlace", items_of(multiplier_places(context.topology))));
  }
  return text;
}

/// Sum of all parameters and inputs: not finite when one of them is not.
std::string argument_sum(const SolverNames& names, const std::string& scalar) {
  Items terms;
  for (const std::string& name : names.parameters) terms.push_back("parameters." + name);
  for (const std::string& name : names.inputs) terms.push_back("inputs." + name);
  std::string sum;
  for (const std::string& term : terms) sum += (sum.empty() ? "" : " + ") + term;
  const std::string zero = is_number(scalar) ? number_text(0, scalar) : scalar + "{}";
  const auto parameter = [](bool used, const std::string& name) { return used ? name : "/*" + name + "*/"; };
  return "  static " + scalar + " argument_sum(const Parameters& " +
         parameter(!names.parameters.empty(), "parameters") + ", const Inputs& " +
         parameter(!names.inputs.empty(), "inputs") + ") noexcept {\n" +
         wrapped_statement("    return " + (sum.empty() ? zero : sum) + ";") + "\n  }\n";
}

/// Accelerations and velocities that the pivoting path hands to the program of the chosen partition.
std::string projection_struct(const SolverLayout& layout, const std::string& scalar) {
  if (layout.blocks.empty() || !layout.chooses_again) return "";
  return "/// Projection of the loop blocks, chosen at run time.\nstruct Projection {\n  " + scalar + " Rz[" +
         std::to_string(std::max(layout.projection_entries, 1)) + "];  ///< of each block, row by row\n  " + scalar +
         " zdd_star[" + std::to_string(layout.block_coordinates) +
         "];  ///< accelerations of each block at zero independent ones\n};\n\n";
}

/// Residuals live where the closure program says; the tables of System assume block after block.
void check_residual_order(const EmitContext& context) {
  for (std::size_t b = 0; b < context.layout.blocks.size(); ++b) {
    if (context.programs.residual_equation_of.at(b) != context.layout.blocks[b].first_equation) {
      throw std::logic_error("residuals of block " + std::to_string(b) + " do not follow those of the blocks before");
    }
  }
}

/// initial_state(), or nothing. Copied number by number, as a bare target may have no memcpy.
std::string initial_definition(const EmitContext& context) {
  if (!context.initial) return "";
  const InitialState& initial = *context.initial;
  std::string text = "State initial_state() noexcept {\n  static constexpr State start = {\n";
  for (const std::vector<double>* values : {&initial.z, &initial.zd, &initial.x}) {
    Items items = number_texts(*values, context.scalar);
    if (items.empty()) items.push_back(number_text(0, context.scalar));
    constexpr std::size_t kIndent = 7;  // after the brace
    text += "      {" + wrapped_list(items, kIndent).substr(kIndent) + "},\n";
  }
  return text +
         "      0.0};\n  State state;\n  mbgen::integrator_detail::copy_state(start, state);\n  return state;\n}\n\n";
}

}  // namespace

std::string system_text(const EmitContext& context, const std::string& members, const std::string& scalar) {
  std::string system =
      constants(context, scalar) + tables(context, scalar) + members + argument_sum(context.names, scalar);
  system.pop_back();
  return system;
}

std::string constants_text(const ConstantNames& names, const std::string& scalar) {
  const std::string declarations = names.declarations(scalar);
  return declarations.empty() ? "" : "// Numbers of the model.\n" + declarations + "\n";
}

EmittedFile solver_file(const EmitContext& context, std::vector<ShapedProgram> programs, const std::string& appendix) {
  check_residual_order(context);
  std::string hot, rare, members;
  ConstantNames constants(context.programs);
  const int rare_parts = divide_file(programs, context.file_part_values);
  for (ShapedProgram& shaped : programs) {
    shaped.shape.constants = &constants;
    (shaped.shape.file_part > 0 ? rare : hot) += program_text(*shaped.program, shaped.schedule, shaped.shape) + "\n";
    const std::string member = shaped.shape.function.substr(std::string("compute_").size());
    if (!shaped.shape.members.empty()) {
      members += "  using " + shaped.shape.result + " = " + context.names.solver + "::" + shaped.shape.result + ";\n";
    }
    if (shaped.role != Role::outputs && shaped.role != Role::derived_constants)
      members += constant("auto", member, "&" + shaped.shape.function);
  }
  if (!context.layout.blocks.empty() && context.layout.chooses_again) {
    members += "  using Projection = " + context.names.solver + "::Projection;\n";
  }
  const std::string system = system_text(context, members, context.scalar);
  const std::string projection = projection_struct(context.layout, context.scalar);
  const InputText inputs = input_text(context.model, context.names, context.scalar);
  const std::string text = fill_template(
      "solver.cpp.in", {{"banner", banner_text(context.model, "//") + legend_text(context)},
                        {"constants", constants_text(constants, context.scalar)},
                        {"solver", context.names.solver},
                        {"scalar", context.scalar},
                        {"file_parts", rare_parts > 0 ? file_parts_text(rare_parts) : ""},
                        {"programs", rare_parts > 0 ? divided_programs(hot, projection + rare) : projection + hot},
                        {"end_of_part", rare_parts > 0 ? "#endif  // part 0\n" : ""},
                        {"tuned_constructor", tuned_constructor_text(context.programs)},
                        {"outputs_call", outputs_call(context)},
                        {"system", system},
                        {"advance_inputs", inputs.definition},
                        {"initial_state", initial_definition(context)},
                        {"inputs_now", inputs.now},
                        {"inputs", inputs.name},
                        {"start", inputs.start}});
  return {context.names.solver + ".cpp",
          text + (rare_parts > 0 && !appendix.empty() ? in_file_part(0, appendix) : appendix), rare_parts};
}

}  // namespace mbgen
