#include "workbench/describe/explained_elements.hpp"

#include <fmt/format.h>

#include "compiler/model/element_access.hpp"
#include "compiler/topology/names.hpp"
#include "workbench/describe/paragraphs.hpp"

namespace mbgen {
namespace {

/// "input", or "input less output" between two coordinates.
std::string name_of(const Model& model, const CoordinateReference& joint,
                    const std::optional<CoordinateReference>& relative_to) {
  const std::string& name = freedom_of(model, joint).name;
  return relative_to ? name + " less " + freedom_of(model, *relative_to).name : name;
}

std::string number_or_text(const Model& model, const Quantity& quantity) {
  return quantity.expression < 0 ? fmt::format("{:g}", quantity.value) : model.expressions[quantity.expression].text;
}

const std::string& body_of(const Model& model, const Attachment& at) {
  return model.bodies[static_cast<std::size_t>(at.body)].name;
}

std::string text_of(const Model& model, const Bushing& bushing) {
  std::vector<std::string> acting, branches;
  for (int i = 0; i < kBushingFreedoms; ++i) {
    const std::string name(kBushingFreedomNames[static_cast<std::size_t>(i)]);
    if (bushing_acts(bushing, i)) acting.push_back(name);
    if (has_maxwell_branch(bushing, i)) branches.push_back(fmt::format("x.{}_{}", bushing.name, name));
  }
  std::string words = fmt::format("{} is a bushing between {} and {}", bushing.name, body_of(model, bushing.from),
                                  body_of(model, bushing.to));
  if (acting.empty()) return words + " without any force.";
  words += fmt::format("; it acts in {}.", listed(acting));
  if (!branches.empty())
    words += fmt::format(" Its Maxwell {} the {} {}.", branches.size() == 1 ? "branch has" : "branches have",
                         branches.size() == 1 ? "state" : "states", listed(branches));
  return words;
}

std::string text_of(const Model& model, const BumpStop& stop) {
  const std::string clearance = number_or_text(model, stop.clearance);
  const bool is_on_this_side = stop.side == BumpStop::Side::above || stop.side == BumpStop::Side::compression;
  if (stop.is_on_joint()) {
    const Freedom& freedom = freedom_of(model, stop.joint);
    return fmt::format("{} pushes back where {} is {} {} {}.", stop.name, name_of(model, stop.joint, stop.relative_to),
                       is_on_this_side ? "above" : "below minus", clearance, unit_of(freedom.kind));
  }
  return fmt::format("{} pushes {} and {} {} where their ends have come {} m {}{} than at the reference.", stop.name,
                     body_of(model, stop.from), body_of(model, stop.to), is_on_this_side ? "apart" : "together",
                     clearance, is_on_this_side ? "nearer" : "farther apart", stop.axis ? ", along its axis," : "");
}

/// Spans of one rope have one text.
std::string text_of(const Model& model, const Rope& rope) {
  if (rope.path.empty()) return "";
  std::vector<std::string> stations, slips;
  for (const RopeStation& station : rope.path) {
    static constexpr const char* kKinds[] = {"", "a pulley on ", "a drum on ", "a cylinder on ", "a sphere on "};
    static constexpr const char* kContacts[] = {"", " that grips", " with friction"};
    stations.push_back(kKinds[static_cast<int>(station.kind)] + body_of(model, station.at) +
                       kContacts[static_cast<int>(station.contact)]);
    if (station.contact == RopeStation::Contact::rubs)
      slips.push_back(fmt::format("x.{}_slip{}", rope.name, slips.size() + 1));
  }
  std::string words = fmt::format("{} is a {} over {}", rope.name, rope.closed ? "belt" : "rope", listed(stations));
  if (rope.spans > 1) words += fmt::format(", with {} tensions", rope.spans);
  words += ".";
  if (!slips.empty())
    words += fmt::format(" Its slip in grooves with friction {} the {} {}.", slips.size() == 1 ? "is" : "are",
                         slips.size() == 1 ? "state" : "states", listed(slips));
  return words;
}

std::string text_of(const Model& model, const SurfaceContact& contact) {
  const bool on_road = contact.shape == SurfaceContact::Shape::road;
  const std::string surface = on_road
                                  ? "the road " + model.roads[static_cast<std::size_t>(contact.road)].name
                                  : fmt::format("a {} of {}", kContactShapes[static_cast<std::size_t>(contact.shape)],
                                                body_of(model, contact.to));
  std::string words = fmt::format("{} pushes {} away from {} where {} of it goes in; it never pulls.", contact.name,
                                  body_of(model, contact.from), surface,
                                  contact.radius.expression < 0 && contact.radius.value == 0
                                      ? "a point"
                                      : fmt::format("a sphere of radius {} m", number_or_text(model, contact.radius)));
  if (contact.has_friction())
    words += fmt::format(
        " It sticks and slides with a friction of {}, by two bristles whose deflections are the states x.{}_bristle1 "
        "and x.{}_bristle2.",
        number_or_text(model, contact.friction), contact.name, contact.name);
  return words;
}

std::string friction_text(const std::string& name, const std::string& place, const FrictionLaw& law) {
  return fmt::format(
      "{} sticks {}, by bristles ({}) whose deflection is the state x.{}_bristle.", name, place,
      law.kind == FrictionLaw::Kind::lugre ? "LuGre, which creeps under loads that vibrate" : "elasto-plastic", name);
}

std::string text_of(const Model& model, const JointFriction& friction) {
  return friction.has_bristle()
             ? friction_text(friction.name, "on " + name_of(model, friction.joint, friction.relative_to), friction)
             : "";
}

std::string text_of(const Model& model, const SpringFriction& friction) {
  return friction.has_bristle() ? friction_text(friction.name, "along " + model.springs[friction.spring].name, friction)
                                : "";
}

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
      if constexpr (requires { text_of(model, element); })
        if (const std::string words = text_of(model, element); !words.empty()) text += paragraph(words);
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
