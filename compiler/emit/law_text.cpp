#include "compiler/emit/law_text.hpp"

#include "compiler/emit/frame.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"

namespace mbgen {
namespace {

/// Elements as the function of a law sees them.
enum class Elements {
  in_lanes,     ///< several at once, an element in each lane of a vector
  one_by_one,   ///< numbers
  of_instances  ///< one by one, each a vector whose lanes are instances
};

/// Place of an argument of element k, or of the elements computed with it.
std::string argument_text(const LawShape& law, const LawArgument& argument, Elements elements,
                          const std::string& type) {
  const std::string place = law.argument + "." + argument.name, element = place + "[k]";
  const auto every_lane = [&](const std::string& number) { return "mbgen::every_lane<" + type + ">(" + number + ")"; };
  if (elements == Elements::in_lanes)
    return argument.is_common ? every_lane(place) : "mbgen::lanes_of(" + place + ", k)";
  if (argument.is_common) return place;
  return elements == Elements::of_instances && !argument.numbers.empty() ? every_lane(element) : element;
}

/// The function of a law.
ProgramShape function_shape(const EmitContext& context, const SharedLaw& shared, const LawShape& law, Elements elements,
                            Scalar scalar) {
  ProgramShape shape;
  shape.title = elements == Elements::in_lanes ? "The law of the elements from k on that one vector holds."
                                               : "The law of element k.";
  shape.name = law.argument;
  shape.function = law.function();
  shape.scalar = scalar;
  if (scalar == Scalar::elements) shape.elements = law.type;
  shape.titles = context.titles;
  shape.arguments = {{law.argument, law.type, Passing::sole_reference}, {"k", "int", Passing::value}};
  GroupPlace arguments{law.argument, {}}, results{law.argument, {}};
  for (const LawArgument& argument : shared.arguments) {
    arguments.texts.push_back(argument_text(law, argument, elements, type_text(shape)));
    arguments.locals.push_back(argument.name);
  }
  for (const std::string& name : shared.results) {
    const std::string place = law.argument + "." + name;
    results.texts.push_back(elements == Elements::in_lanes ? "mbgen::lanes_at(" + place + ", k)" : place + "[k]");
  }
  arguments.element = results.element = "k";
  shape.inputs[Array::law_argument] = std::move(arguments);
  shape.outputs[Array::law_result] = std::move(results);
  return shape;
}

/// The arguments that are known numbers, unless the law's program contains them.
FrameRows known_rows(const SharedLaw& shared, const LawShape& law, Scalar scalar) {
  FrameRows rows;
  for (const LawArgument& argument : shared.arguments) {
    if (argument.numbers.empty() || argument.is_common) continue;
    const std::string place = argument.name + "[" + std::to_string(law.elements) + "] = ";
    rows.push_back({{"member", braced_list(std::string("  static constexpr ") + name_of(scalar) + " " + place,
                                           number_texts(argument.numbers, scalar), ";")}});
  }
  return rows;
}

/// program: of the law. slopes: that it gives beside its results.
std::string law_text(const EmitContext& context, std::size_t k, const Program& program, int slopes, Scalar scalar,
                     ConstantNames* constants) {
  const SharedLaw& shared = context.written.laws[k];
  const LawShape law = law_shape(context, k);
  const Elements seen = scalar == Scalar::doubles ? Elements::in_lanes
                        : is_number(scalar)       ? Elements::one_by_one
                                                  : Elements::of_instances;
  ProgramShape shape =
      function_shape(context, shared, law, seen, seen == Elements::in_lanes ? Scalar::elements : scalar);
  shape.constants = constants;
  if (slopes > 0) {
    shape.work = law.type;
    shape.outputs[Array::slope] = {law.argument, {}, {}, "", "", 0, "", "k"};
    for (const std::string& slope : indexed(law.argument + ".slopes", slopes))
      shape.outputs[Array::slope].texts.push_back("mbgen::lanes_at(" + slope + ", k)");
  }
  FrameRows common, members;
  for (const LawArgument& argument : shared.arguments)
    if (argument.numbers.empty()) (argument.is_common ? common : members).push_back({{"name", argument.name}});
  for (const std::string& name : shared.results) members.push_back({{"name", name}});
  const std::string elements =
      joined(mapped(shared.tyres, [&](int tyre) { return context.model.tyres[tyre].name; }), ", ");
  const Schedule order =
      schedule(program, {.order = ValueOrder::fewest_alive,
                         .gathering = seen == Elements::one_by_one ? Gathering::in_lanes : Gathering::of_vectors});
  return fill_template(
      "law.in",
      {{"comment", wrapped_words("Tyres of one law: " + comment_text(elements) +
                                     ". The road's normal, the wheel's axis, the height and the motion of its "
                                     "centre, forces and moment there, in the axes of the frame that carries "
                                     "the wheel; the other names and the units are those of mbgen/tyre.hpp.",
                                 "/// ")},
       {"type", law.type},
       {"number", name_of(scalar)},
       {"elements", law.elements},
       {"slopes", slopes > 0 ? std::to_string(slopes) : ""},
       {"known", known_rows(shared, law, scalar == Scalar::floats ? scalar : Scalar::doubles)},
       {"common", common},
       {"members", members},
       {"in_vectors", seen == Elements::in_lanes},
       {"one_by_one", seen == Elements::one_by_one},
       {"lanes", law.lanes},
       {"vector", name_of(Scalar::elements) + law.type},
       {"program", program_text(program, order, shape)}});
}

/// The function of a law's derivatives.
ProgramShape along_shape(const EmitContext& context, const SharedLaw& shared, const LawShape& law,
                         const LawShape& along, int slopes) {
  ProgramShape shape = function_shape(context, shared, along, Elements::one_by_one, Scalar::directions);
  shape.title = "Derivatives of the law of element k.";
  shape.work = along.type;
  shape.arguments.insert(shape.arguments.begin() + 1, {law.argument, "const " + law.type, Passing::sole_reference});
  shape.inputs = {
      {Array::law_argument,
       function_shape(context, shared, law, Elements::one_by_one, Scalar::directions).inputs[Array::law_argument]},
      {derivative_of(Array::law_argument), shape.inputs[Array::law_argument]},
      {Array::slope, {law.argument, {}, {}, "", "", 0, "", "k"}}};
  for (auto& [group, place] : shape.inputs) place.locals.clear();
  for (const std::string& slope : indexed(law.argument + ".slopes", slopes))
    shape.inputs[Array::slope].texts.push_back(slope + "[k]");
  shape.outputs = {{derivative_of(Array::law_result), shape.outputs[Array::law_result]}};
  shape.outputs.begin()->second.missing = "0.0";
  return shape;
}

}  // namespace

std::string law_texts(const EmitContext& context, Scalar scalar, ConstantNames* constants) {
  std::string text;
  for (std::size_t k = 0; k < context.written.laws.size(); ++k)
    text += law_text(context, k, context.written.laws[k].program, 0, scalar, constants);
  return text;
}

std::string law_with_slopes_text(const EmitContext& context, std::size_t k, const DerivativesApart& apart,
                                 const LawShape& law, const LawShape& along, ConstantNames* constants) {
  const SharedLaw& shared = context.written.laws[k];
  const ProgramShape shape = along_shape(context, shared, law, along, apart.slopes);
  FrameRows common, members;
  for (const LawArgument& argument : shared.arguments)
    if (argument.numbers.empty()) (argument.is_common ? common : members).push_back({{"name", argument.name}});
  for (const std::string& name : shared.results) members.push_back({{"name", name}});
  const Schedule order = schedule(apart.along, {.order = ValueOrder::fewest_alive});
  return law_text(context, k, apart.values, apart.slopes, Scalar::doubles, constants) + "\n" +
         fill_template("law.in", {{"comment", "/// Derivatives of the numbers in " + law.type + "."},
                                  {"type", along.type},
                                  {"number", name_of(Scalar::directions)},
                                  {"elements", along.elements},
                                  {"known", FrameRows{}},
                                  {"common", common},
                                  {"members", members},
                                  {"slopes", ""},
                                  {"in_vectors", false},
                                  {"one_by_one", true},
                                  {"lanes", along.lanes},
                                  {"vector", ""},
                                  {"program", program_text(apart.along, order, shape)}});
}

}  // namespace mbgen
