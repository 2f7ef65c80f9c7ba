#include <algorithm>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/function_text.hpp"
#include "compiler/emit/law_text.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// Costs of an operation on slopes over one on eight derivatives, which needs more loads and stores; in lanes, one is
/// done for four tyres.
constexpr double kCostOfSlopes = 0.7, kCostOfSlopesInLanes = 0.2;

constexpr const char* kSlopes = "AccelerationSlopes";

/// Arrays whose numbers have derivatives, and are members of structs with both.
bool has_both(SlotGroup group) {
  return group.array != Array::t && group.array != Array::law_argument && group.array != Array::law_result;
}

/// Charts are 0 or 1, and the time has no derivative.
bool moves(const Slot& slot) { return slot.group.array != Array::t && slot.group.array != Array::charts; }

/// Nothing asks how a pivot moves.
bool is_wanted(const Slot& slot) {
  return slot.group.array != Array::pivot && slot.group.array != Array::inertia &&
         slot.group.array != Array::state_pivot;
}

void take_member(GroupPlace& place, const std::string& member) {
  for (std::string& text : place.texts) text += member;
  place.member = member;
}

LawShape along_of(LawShape law) {
  law.beside = "slopes." + law.argument;
  law.argument += "_along";
  law.type += "Along";
  law.lanes += "Along";
  return law;
}

/// The shape without numbers of the types of other ones.
ProgramShape common_shape(const ProgramShape& whole, int slopes) {
  ProgramShape shape = whole;
  shape.members.clear();
  shape.inputs[Array::t].texts = {"state.t"};
  for (Argument& argument : shape.arguments)
    if (argument.type == kOfScalar) argument.type = "const Real";
  for (LawShape& law : shape.laws) law.home = "slopes." + law.argument;
  for (auto& [group, place] : shape.inputs)
    if (has_both(group)) take_member(place, ".value");
  shape.inputs[Array::slope] = {"slopes", indexed("slopes.of", slopes), {}, "", "slopes.of"};
  return shape;
}

ProgramShape values_shape(ProgramShape shape, ConstantNames* constants) {
  shape.title = "Values of the accelerations, and the slopes that their derivatives need.";
  shape.function = "compute_acceleration_values";
  shape.work = "AccelerationValues";
  shape.scalar = Scalar::doubles;
  shape.constants = constants;
  shape.arguments.push_back({"slopes", kSlopes, Passing::sole_reference});
  for (auto& [group, place] : shape.outputs)
    if (has_both(group)) take_member(place, ".value");
  shape.outputs[Array::slope] = shape.inputs.extract(Array::slope).mapped();
  return shape;
}

/// Places of derivatives in place of the values'.
GroupPlace moved_place(SlotGroup group, GroupPlace place, const std::vector<LawShape>& laws) {
  place.locals.clear();
  if (has_both(group)) {
    take_member(place, ".tangent");
  } else {
    const LawShape& law = *std::ranges::find(laws, place.argument, &LawShape::argument);
    for (std::string& text : place.texts) text = along_of(law).argument + text.substr(law.argument.size());
    place.argument = along_of(law).argument;
  }
  if (!place.missing.empty()) place.missing = "0.0";
  return place;
}

ProgramShape along_shape(const ProgramShape& whole, ProgramShape shape) {
  shape.title = "Derivatives of the accelerations.";
  shape.function = "compute_accelerations_along";
  shape.work = "AccelerationsAlong";
  shape.scalar = Scalar::directions;
  shape.arguments.push_back({"slopes", std::string("const ") + kSlopes, Passing::sole_reference});
  for (auto& [group, place] : shape.inputs) {
    place.locals.clear();
    if (group.array != Array::law_result) continue;
    place.argument = "slopes";
    for (std::string& text : place.texts) text = "slopes." + text;
  }
  for (const auto& [group, place] : whole.inputs)
    if (group.array != Array::t) shape.inputs[derivative_of(group)] = moved_place(group, place, whole.laws);
  shape.outputs.clear();
  for (const auto& [group, place] : whole.outputs)
    shape.outputs[derivative_of(group)] = moved_place(group, place, whole.laws);
  for (LawShape& law : shape.laws) {
    law.home.clear();
    law = along_of(law);
  }
  return shape;
}

std::string call_of(const ProgramShape& shape) {
  const auto names = mapped(shape.arguments, [](const Argument& argument) { return argument.name; });
  return shape.function + "(" + joined(names, ", ") + ", result);";
}

std::string text_of_program(const EmitContext& context, const Program& program, const ProgramShape& shape) {
  ScheduleOptions options = schedule_options(shape, context.options.roll_above);
  // Vectors of directions that cross parts are more than the first cache holds.
  options.shares_places = shape.scalar == Scalar::directions;
  return program_text(program, schedule(program, options), shape);
}

}  // namespace

std::string accelerations_apart_text(const EmitContext& context, const ShapedProgram& shaped) {
  const ProgramShape& whole = shaped.shape;
  std::string laws;
  for (std::size_t k = 0; k < whole.laws.size(); ++k) {
    const SharedLaw& law = context.written.laws[k];
    const auto moves_in_law = [&](const Slot& slot) {
      return slot.group.array != Array::law_argument ||
             law.arguments[static_cast<std::size_t>(slot.index)].numbers.empty();
    };
    const DerivativesApart apart = take_derivatives_apart(law.program, moves_in_law, is_wanted, kCostOfSlopesInLanes);
    laws += law_with_slopes_text(context, k, apart, whole.laws[k], along_of(whole.laws[k]), whole.constants) + "\n";
  }
  const DerivativesApart apart = take_derivatives_apart(*shaped.program, moves, is_wanted, kCostOfSlopes);
  const ProgramShape common = common_shape(whole, apart.slopes);
  const ProgramShape values = values_shape(common, whole.constants), along = along_shape(whole, common);
  const FrameRows members = mapped(whole.members, [](const ArrayMember& member) {
    return FrameValues{{"name", member.name}, {"size", size_text(member.size)}, {"comment", member.comment}};
  });
  const FrameRows law_structs = mapped(whole.laws, [](const LawShape& law) {
    return FrameValues{{"type", law.type}, {"argument", law.argument}};
  });
  return fill_template("accelerations_apart.in", {{"function", whole.function},
                                                  {"result", whole.result},
                                                  {"members", members},
                                                  {"laws", laws},
                                                  {"slopes", kSlopes},
                                                  {"count", size_text(apart.slopes)},
                                                  {"law_structs", law_structs},
                                                  {"values", text_of_program(context, apart.values, values)},
                                                  {"along", text_of_program(context, apart.along, along)},
                                                  {"title", whole.title},
                                                  {"declaration", function_declaration(whole)},
                                                  {"call_values", call_of(values)},
                                                  {"call_along", call_of(along)}});
}

}  // namespace mbgen
