#include "workbench/describe/explained_elements.hpp"

#include <fmt/format.h>

#include "compiler/model/element_access.hpp"
#include "compiler/topology/names.hpp"
#include "workbench/describe/paragraphs.hpp"

namespace mbgen {
namespace {

std::string number_or_text(const Model& model, const Quantity& quantity) {
  return quantity.expression < 0 ? fmt::format("{:g}", quantity.value) : model.expressions[quantity.expression].text;
}

/// Words for the sentences of elements.
struct ElementWords {
  const Model& model;

  const std::string& body(const Attachment& at) const { return model.bodies[static_cast<std::size_t>(at.body)].name; }
  const std::string& road(int index) const { return model.roads[static_cast<std::size_t>(index)].name; }
  const std::string& along(const AlongSpring& at) const { return name_of(model, at); }
  std::string number(const Quantity& quantity) const { return number_or_text(model, quantity); }
  std::string unit(const CoordinateReference& joint) const { return unit_of(freedom_of(model, joint).kind); }
  /// "input", or "input less output" between two coordinates.
  std::string coordinate(const CoordinateReference& joint,
                         const std::optional<CoordinateReference>& relative_to) const {
    const std::string& name = freedom_of(model, joint).name;
    return relative_to ? name + " less " + freedom_of(model, *relative_to).name : name;
  }
  std::string list(const std::vector<std::string>& names) const { return listed(names); }
  /// "state x.a", "states x.a and x.b".
  std::string states(const std::vector<std::string>& names) const {
    return (names.size() == 1 ? "state " : "states ") + listed(names);
  }
};

/// "the force of crank_pin across its axis".
std::string reaction_text(const Model& model, const ReactionLoad& load) {
  static constexpr const char* kDirections[] = {"", " across its axis",
                                                " along its axis"};  // in the order of Direction
  return fmt::format("the {} of {}{}", load.what == ReactionOutput::What::force ? "force" : "moment",
                     load.joint >= 0 ? model.joints[static_cast<std::size_t>(load.joint)].name
                                     : model.rods[static_cast<std::size_t>(load.rod)].name,
                     kDirections[static_cast<int>(load.direction)]);
}

/// For a friction with a reaction as normal load: the reaction, and its delay by sampling.
std::string load_text(const Model& model, const std::string& name, const FrictionLaw& law) {
  if (law.load < 0) return "";
  const SampledValue& load = model.sampled[static_cast<std::size_t>(law.load)];
  return paragraph(fmt::format("{} is pressed by {}, x.{}, as it was taken last: every {:g} s.", name,
                               reaction_text(model, *load.load), load.name, load.period));
}

}  // namespace

std::string elements_explanation(const Model& model) {
  std::string text;
  const auto add_kinds = [&](bool frictions) {
    each_element(model, [&]<class Element>(const Element& element) {
      if (std::is_base_of_v<FrictionLaw, Element> != frictions) return;
      if constexpr (requires { KindOf<Element>::sentence(ElementWords{model}, element); })
        if (const std::string words = KindOf<Element>::sentence(ElementWords{model}, element); !words.empty())
          text += paragraph(words);
    });
  };
  add_kinds(false);
  add_kinds(true);
  each_friction(model, [&](const auto& friction) { text += load_text(model, friction.name, friction); });
  return text.empty() ? "" : heading("What gives way, stops or sticks") + text;
}

std::string states_explanation(const Model& model) {
  std::string text;
  for (const UserState& state : model.states)
    text += paragraph(fmt::format("{} is integrated with the motion: its derivative is {}, it starts at {:g}.",
                                  state.name, number_or_text(model, state.derivative), state.initial));
  for (const SampledValue& value : model.sampled)
    text +=
        paragraph(fmt::format("{} is set every {:g} s to {}{} and holds in between{}.", value.name, value.period,
                              value.load ? reaction_text(model, *value.load) : number_or_text(model, value.value),
                              value.delay > 0 ? ", " + counted(value.delay, "instant") + " later" : "",
                              value.load && value.delay == 0 ? "" : fmt::format("; it starts at {:g}", value.initial)));
  return text.empty() ? "" : heading("States") + text;
}

}  // namespace mbgen
