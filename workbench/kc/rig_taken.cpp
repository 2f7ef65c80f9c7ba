// The parts of the user's model that a rig removes.

#include "compiler/model/element_access.hpp"
#include "workbench/kc/rig.hpp"

namespace mbgen::kc {
namespace {

/// Removes frictions, and their pressing loads, which are the last sampled values.
void take_frictions_away(Model& model) {
  std::size_t loads = 0;
  each_friction(model, [&loads](const FrictionLaw& friction) { loads += friction.load >= 0 ? 1 : 0; });
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    if constexpr (std::is_base_of_v<FrictionLaw, Kind>) kind.list(model).clear();
  });
  model.sampled.resize(model.sampled.size() - loads);
}

}  // namespace

void take_away(const Axle& axle, Model& model) {
  model.tyres.clear();
  take_frictions_away(model);
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
