#pragma once
// Compliant elements, stops, sticking frictions and states of a model, in words: sections of `mbgen explain`.

#include <string>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Elements that give way, stop or stick; "" without any.
std::string elements_explanation(const Model& model);

/// States of the user's own and sampled values; "" without any.
std::string states_explanation(const Model& model);

}  // namespace mbgen
