#pragma once
// Pictures that elements draw of themselves in a report.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Adds shapes on bodies, at each place one. point: radius of a ball without one, m. shapes: per body.
void add_element_shapes(const Model& model, double point, std::vector<nlohmann::ordered_json>& shapes);

/// Adds lines between bodies. radius: m.
void add_element_lines(const Model& model, double radius, nlohmann::ordered_json& links);

}  // namespace mbgen
