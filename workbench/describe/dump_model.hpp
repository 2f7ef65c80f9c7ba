#pragma once
// The model as the reader understood it, as text.

#include <string>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Every element of the model with its numbers; expressions as they were written.
std::string dump_model(const Model& model);

}  // namespace mbgen
