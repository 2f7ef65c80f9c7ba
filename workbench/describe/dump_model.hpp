#pragma once
// The model after reading, as text.

#include <string>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Every element of the model with its numbers, and expressions as written.
std::string dump_model(const Model& model);

}  // namespace mbgen
