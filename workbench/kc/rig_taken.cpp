// The parts of the user's model that a rig removes.

#include "compiler/model/element_access.hpp"
#include "workbench/kc/rig.hpp"

namespace mbgen::kc {
namespace {

/// Removes frictions, with their pressing loads, which are the last sampled values, and the friction of others.
void take_frictions_away(Model& model) {
  std::size_t loads = 0;
  each_friction(model, [&loads](const FrictionLaw& friction) { loads += friction.load >= 0 ? 1 : 0; });
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    if constexpr (std::is_base_of_v<FrictionLaw, Kind>) kind.list(model).clear();
    if constexpr (requires(Kind & element) { kind.smooth(element); })
      for (Kind& element : kind.list(model)) kind.smooth(element);
  });
  model.sampled.resize(model.sampled.size() - loads);
}

/// Quantities of tyres and frictions, which expressions may look at, are zero without them.
void forget_observed(Model& model) {
  const auto is_gone = [&](const ObservedOutput& observed) {
    if (const auto* wheel = std::get_if<WheelOutput>(&observed.output.source)) return wheel->tyre >= 0;
    const auto* element = std::get_if<ElementOutput>(&observed.output.source);
    bool gone = false;
    if (element)
      with_kind(element->kind,
                [&](auto kind) { gone = static_cast<std::size_t>(element->element) >= kind.list(model).size(); });
    return gone;
  };
  for (ObservedOutput& observed : model.observed)
    if (is_gone(observed)) observed.output.source = ExpressionOutput{0.0};
}

}  // namespace

void take_away(const Axle& axle, Model& model) {
  model.tyres.clear();
  take_frictions_away(model);
  forget_observed(model);
  model.outputs.clear();
  model.notes.clear();
  model.initial = {};
  for (const std::string& name : axle.without) {
    each_kind([&](auto kind) {
      if constexpr (can_be_silent(decltype(kind){})) {
        for (auto& element : kind.list(model))
          if (element.name == name) kind.silence(element);
      }
    });
  }
}

}  // namespace mbgen::kc
