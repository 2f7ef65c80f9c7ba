#pragma once
// The vehicle of a model in words.

#include <string>

#include "compiler/model/model.hpp"

namespace mbgen {

/// A section of the model's dump, "" without a vehicle.
std::string vehicle_dump(const Model& model);

/// Parts moved by manoeuvres, and the inputs used, for `explain`; "" without a vehicle.
std::string vehicle_explanation(const Model& model);

}  // namespace mbgen
