#include "workbench/motion/reactions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kComponents = 6;

void add_outputs(Model& model, const std::string& name, ReactionOutput source) {
  for (const auto what : {ReactionOutput::What::force, ReactionOutput::What::moment}) {
    const bool is_force = what == ReactionOutput::What::force;
    for (int axis = 0; axis < 3; ++axis) {
      source.what = what;
      source.axis = axis;
      model.outputs.push_back({fmt::format("{}_{}_{}", name, is_force ? "force" : "moment", "xyz"[axis]),
                               {},
                               is_force ? "N" : "N m",
                               source});
    }
  }
}

Json components(const double* values) {
  Json result = Json::array();
  for (int i = 0; i < 3; ++i) result.push_back(std::isfinite(values[i]) ? Json(values[i]) : Json(nullptr));
  return result;
}

}  // namespace

void add_reaction_outputs(Model& model) {
  ReactionOutput source;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    source.joint = static_cast<int>(j);
    add_outputs(model, model.joints[j].name, source);
  }
  source.joint = -1;
  for (std::size_t r = 0; r < model.rods.size(); ++r) {
    source.rod = static_cast<int>(r);
    add_outputs(model, model.rods[r].name, source);
  }
}

void use_reaction_outputs(Engine& engine, const Model& model) {
  if (engine.reactions) return;
  const std::size_t count = model.joints.size() + model.rods.size();
  const std::size_t first = model.outputs.size() - kComponents * count;
  engine.reactions = [outputs = engine.outputs, first, count](const LoadedState& at,
                                                              const GenericDerivative& derivative,
                                                              std::vector<std::array<double, kComponents>>& wrenches) {
    GenericOutputs values;
    const Status status = outputs(at, derivative, values);
    if (!status.ok()) return status;
    wrenches.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::copy_n(values.y.begin() + static_cast<std::ptrdiff_t>(first + kComponents * i), kComponents,
                  wrenches[i].begin());
    }
    return Status{};
  };
}

Json reactions_json(const Model& model, const std::vector<std::array<double, kComponents>>& wrenches) {
  Json result = Json::object();
  for (std::size_t i = 0; i < wrenches.size(); ++i) {
    const std::size_t joints = model.joints.size();
    const std::string& name = i < joints ? model.joints[i].name : model.rods[i - joints].name;
    if (result.contains(name)) {
      throw UserError(fmt::format("--reactions: \"{}\" is a joint and a rod; rename one of them\n", name));
    }
    result[name] = {{"force", components(wrenches[i].data())}, {"moment", components(wrenches[i].data() + 3)}};
  }
  return result;
}

}  // namespace mbgen
