#include "compiler/emit/system_values.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/solver/fine_blocks.hpp"

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

/// Block and place of every free direction: the q-th direction of its block.
Items free_direction_items(const EmitContext& context) {
  std::vector<int> directions_of(context.layout.blocks.size(), 0);
  Items items;
  for (const int coordinate : free_coordinates(context.topology, context.analysis)) {
    const int block = context.topology.groups[context.topology.group_of[coordinate]].block;
    items.push_back(fmt::format("{{{}, {}, {}}}", coordinate, block, block < 0 ? 0 : directions_of[block]++));
  }
  return items;
}

/// Coordinates and handedness of every ball that has charts.
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

std::string multiplier_place_table(const EmitContext& context) {
  return table("int", "kMultiplierPlace", items_of(multiplier_places(context.topology)));
}

/// Whether a solver takes pivots of loop blocks: one of regular positions alone for inverse dynamics only.
bool pivots_blocks(const EmitContext& context) { return !context.regular_only || context.layout.actuators > 0; }

std::vector<int> drive_coordinates(const EmitContext& context) {
  return mapped(context.model.motions,
                [&](const Motion& motion) { return tree_coordinate(context.topology, motion.joint); });
}

/// One over the root of each actuator's weight.
Items actuator_scales(const EmitContext& context) {
  return mapped(context.model.actuators, [&](const Actuator& actuator) {
    return number_text(1 / std::sqrt(actuator.weight), context.options.scalar);
  });
}

/// Place of each parameter or input in its struct, for messages on values that are not finite.
std::string member_table(Scalar scalar, const std::string& structure, const std::string& name, const Items& members) {
  return table(name_of(scalar), structure + "::*" + name, member_places(structure, members), "nullptr");
}

/// Sum of all parameters and inputs: not finite when one of them is not.
std::string argument_sum(const SolverNames& names, Scalar scalar) {
  Items terms;
  for (const std::string& name : names.parameters) terms.push_back("parameters." + name);
  for (const std::string& name : names.inputs) terms.push_back("inputs." + name);
  if (terms.empty()) terms.push_back(is_number(scalar) ? number_text(0, scalar) : std::string(name_of(scalar)) + "{}");
  return wrapped_statement("    return " + joined(terms, " + ") + ";");
}

/// The tables of fine blocks, none where no block has any: "fine_tables".
std::string fine_tables(const EmitContext& context) {
  Items layouts, parts, rows, columns, earlier, others;
  const auto add = [](const std::vector<int>& numbers, Items& items) {
    for (const int number : numbers) items.push_back(std::to_string(number));
  };
  for (std::size_t b = 0; b < context.layout.blocks.size(); ++b) {
    const FineBlocks fine =
        fine_blocks(context.analysis.blocks[b], b, context.layout.blocks[b], context.programs.closure_terms);
    layouts.push_back(fmt::format("{{{}, {}, {}, {}, {}, {}}}", parts.size(), fine.parts.size(), rows.size(),
                                  earlier.size(), others.size(), fine.largest()));
    for (const FineBlocks::Part& part : fine.parts)
      parts.push_back(fmt::format("{{{}, {}, {}, {}}}", part.size, part.first, part.first_earlier, part.earlier));
    add(fine.rows, rows);
    add(fine.columns, columns);
    add(fine.earlier, earlier);
    add(fine.others, others);
  }
  if (parts.empty()) return "";
  return table("mbgen::FineLayout", "kFineLayout", layouts) + "\n" + table("mbgen::FineBlock", "kFineBlock", parts) +
         "\n" + table("int", "kFineRow", rows) + "\n" + table("int", "kFineColumn", columns) + "\n" +
         table("int", "kFineEarlier", earlier) + "\n" + table("int", "kFineOther", others);
}

/// Taylor polynomial of an input by Horner's rule: `inputs.a + dt * (inputs.b + dt / 2.0 * inputs.c)`.
std::string polynomial(const Model& model, const SolverNames& names, int input, int order, Scalar scalar) {
  const std::string value = "inputs." + names.inputs[input];
  const int rate = model.inputs[input].derivative;
  if (rate < 0) return value;
  const std::string factor = order == 1 ? "dt" : "dt / " + number_text(order, scalar);
  const std::string rest = polynomial(model, names, rate, order + 1, scalar);
  const bool is_last = model.inputs[rate].derivative < 0;
  return fmt::format("{} + {} * {}", value, factor, is_last ? rest : fmt::format("({})", rest));
}

/// The table of loop blocks; lanes without blocks do not read it.
std::string block_layout(const Items& blocks, Scalar scalar) {
  if (blocks.empty() && !is_number(scalar)) return "";
  return table("mbgen::BlockLayout", "kBlockLayout", blocks, "{0, 0, 0, 0, 0, 0, 0, 0, 0.0}");
}

/// Each input dt seconds after `inputs`: `member`, `value`. scalar: type of the inputs.
FrameRows later_inputs(const Model& model, const SolverNames& names, Scalar scalar) {
  FrameRows rows;
  for (std::size_t i = 0; i < names.inputs.size(); ++i) {
    rows.push_back({{"member", names.inputs[i]}, {"value", polynomial(model, names, static_cast<int>(i), 1, scalar)}});
  }
  return rows;
}

/// For closures, and for positions by those of actuators, which an open chain has too; empty where nothing is closed.
std::string closure_tolerance(const EmitContext& context, Scalar scalar) {
  const bool is_used = context.layout.has_closure || (context.layout.maps_actuators && is_number(scalar));
  return is_used ? number_text(context.model.solver.closure_tolerance, context.options.scalar) : "";
}

}  // namespace

FrameValues system_member(const ShapedProgram& shaped, const std::string& type, const std::string& scope) {
  const bool is_called = shaped.role != Role::outputs && shaped.role != Role::derived_constants;
  return {{"result", shaped.shape.members.empty() ? "" : shaped.shape.result},
          {"type", type},
          {"name", shaped.shape.name},
          {"function", is_called ? scope + shaped.shape.function : ""}};
}

FrameValues system_values(const EmitContext& context, const FrameRows& members, Scalar scalar) {
  const SolverLayout& layout = context.layout;
  const SolverNames& names = context.names;
  Items blocks;
  std::vector<int> coordinates;
  std::vector<bool> block_driven, redundant(layout.equations, false), late(layout.equations, false);
  std::vector<int> early_rank;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    const BlockPlaces& p = layout.blocks[b];
    blocks.push_back(fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}}}", p.equations, p.coordinates, p.rank, p.free,
                                 p.first_equation, p.first_coordinate, p.first_jacobian, p.first_projection,
                                 number_text(context.analysis.blocks[b].typical_pivot)));
    for (const int joint : context.topology.blocks[b].joints) {
      coordinates.push_back(joint);
      block_driven.push_back(context.analysis.driven[joint]);
    }
    const BlockAnalysis& decided = context.analysis.blocks[b];
    for (const int e : decided.redundant_equations) redundant[p.first_equation + e] = true;
    for (const int e : decided.late.equations) late[p.first_equation + e] = true;
    early_rank.push_back(decided.late.equations.empty() ? decided.rank : decided.late.early_rank);
  }
  const bool has_late = std::find(late.begin(), late.end(), true) != late.end();
  const bool pivots = pivots_blocks(context);
  const bool watches_states = context.model.solver.is_implicit() && layout.own_states > 0;
  // Members for closures and loops are left out without them, so that nothing is unused; lanes leave the choice of
  // coordinates at run time to the solver of one instance.
  return {{"blocks", blocks.size()},
          {"free_directions", layout.free_directions},
          {"actuated_directions", layout.actuated_directions},
          {"first_own_state", watches_states ? std::to_string(first_user_state(context.model)) : ""},
          {"number", name_of(plain(context.options.scalar))},
          {"tolerance", closure_tolerance(context, scalar)},
          {"alone", is_number(scalar)},
          {"holds", layout.holds > 0 ? std::to_string(layout.holds) : ""},
          {"frozen_only", !layout.chooses_again},
          {"ball_table", table("mbgen::Ball", "kBall", ball_items(context.topology))},
          {"block_coordinates", blocks.empty() ? "" : std::to_string(layout.block_coordinates)},
          {"free_direction_table",
           table("mbgen::FreeDirection", "kFreeDirection", free_direction_items(context), "{0, -1, 0}")},
          {"parameter_members", member_table(scalar, "Parameters", "kParameterMember", names.parameters)},
          {"input_members", member_table(scalar, "Inputs", "kInputMember", names.inputs)},
          {"actuator_scale", table(name_of(plain(context.options.scalar)), "kActuatorScale", actuator_scales(context))},
          {"typical_actuation", number_text(context.analysis.typical_actuation)},
          {"driven", table("unsigned char", "kDriven", items_of(context.analysis.driven))},
          {"redundant", table("unsigned char", "kRedundant", items_of(redundant))},
          {"late_equation", table("unsigned char", "kLateEquation", items_of(late))},
          {"early_rank", has_late ? table("int", "kEarlyRank", items_of(early_rank)) : ""},
          {"drive_coordinate", table("int", "kDriveCoordinate", items_of(drive_coordinates(context)))},
          {"block_layout", block_layout(blocks, scalar)},
          {"fine_tables", is_number(scalar) && layout.chooses_again && pivots ? fine_tables(context) : ""},
          {"block_coordinate", table("int", "kBlockCoordinate", items_of(coordinates))},
          {"block_driven", pivots ? table("unsigned char", "kBlockDriven", items_of(block_driven)) : ""},
          {"multiplier_place", context.regular_only ? "" : multiplier_place_table(context)},
          {"members", members},
          {"later_inputs", later_inputs(context.model, names, context.options.scalar)},
          {"scalar", name_of(scalar)},
          {"parameters_argument", names.parameters.empty() ? "/*parameters*/" : "parameters"},
          {"inputs_argument", names.inputs.empty() ? "/*inputs*/" : "inputs"},
          {"sum", argument_sum(names, scalar)}};
}

}  // namespace mbgen
