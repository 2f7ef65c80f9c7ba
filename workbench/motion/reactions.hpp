#pragma once
// Forces and moments of joints and rods, for every engine: by its own computation if it has one, else by outputs of the
// model.

#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

/// Appends an output for each component of the reaction of every joint, then every rod, on its `to` body: force, then
/// moment about the joint's point on that body, global axes.
void add_reaction_outputs(Model& model);

/// Lets an engine of a model with these outputs take its reactions from them, if it cannot compute them itself.
void use_reaction_outputs(Engine& engine, const Model& model);

/// {name: {"force": [x, y, z], "moment": [x, y, z]}} for the joints, then the rods; null stands for a value that is not
/// finite. Fails: UserError when a joint and a rod have the same name.
nlohmann::ordered_json reactions_json(const Model& model, const std::vector<std::array<double, 6>>& wrenches);

}  // namespace mbgen
