#include "compiler/emit/law_text.hpp"

#include "compiler/emit/frame.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"

namespace mbgen {
namespace {

/// The place of a quantity's numbers of the element k and those beside it. before, after: around the name of the array.
GroupPlace places_of_lanes(const LawShape& law, const std::vector<std::string>& quantities, const std::string& before,
                           const std::string& after) {
  GroupPlace place{law.argument, mapped(quantities, [&](const std::string& quantity) {
                     return before + law.argument + "." + quantity + after;
                   })};
  place.element = "k";
  return place;
}

/// The function of a law.
ProgramShape function_shape(const EmitContext& context, const SharedLaw& shared, const LawShape& law, bool in_vectors) {
  ProgramShape shape;
  shape.title = in_vectors ? "The law of the elements from k on that one vector holds." : "The law of element k.";
  shape.function = law.function;
  shape.titles = context.titles;
  shape.arguments = {{law.argument, law.type + "& __restrict " + law.argument}, {"k", "int k"}};
  const std::string after = in_vectors ? ", k)" : "[k]";
  GroupPlace& arguments = shape.inputs[Array::law_argument] =
      places_of_lanes(law, shared.arguments, in_vectors ? "mbgen::lanes_of(" : "", after);
  arguments.locals = shared.arguments;
  shape.outputs[Array::law_result] = places_of_lanes(law, shared.results, in_vectors ? "mbgen::lanes_at(" : "", after);
  return shape;
}

std::string law_text(const EmitContext& context, std::size_t k, const std::string& scalar, ConstantNames* constants) {
  const SharedLaw& shared = context.programs.laws[k];
  const LawShape law = law_shape(context, k);
  const bool in_vectors = scalar == "double";
  ProgramShape shape = function_shape(context, shared, law, in_vectors);
  const std::string vector = "Lanes" + law.type;
  shape.scalar = in_vectors ? vector : scalar;
  shape.constants = constants;
  FrameRows members;
  for (const auto* names : {&shared.arguments, &shared.results})
    for (const std::string& name : *names) members.push_back({{"name", name}});
  const std::string elements =
      joined(mapped(shared.tyres, [&](int tyre) { return context.model.tyres[tyre].name; }), ", ");
  const Schedule order = schedule(shared.program, {.order = ValueOrder::fewest_alive});
  return fill_template(
      "law.in", {{"comment", wrapped_words("Tyres of one law: " + comment_text(elements) +
                                               ". Contact, properties, forces and rates, with the names and units of "
                                               "mbgen/tyre.hpp, a number of each tyre.",
                                           "/// ")},
                 {"type", law.type},
                 {"number", scalar},
                 {"elements", law.elements},
                 {"members", members},
                 {"in_vectors", in_vectors},
                 {"one_by_one", scalar == "float"},
                 {"lanes", law.lanes},
                 {"vector", vector},
                 {"program", program_text(shared.program, order, shape)}});
}

}  // namespace

std::string law_texts(const EmitContext& context, const std::string& scalar, ConstantNames* constants) {
  std::string text;
  for (std::size_t k = 0; k < context.programs.laws.size(); ++k) text += law_text(context, k, scalar, constants);
  return text;
}

}  // namespace mbgen
