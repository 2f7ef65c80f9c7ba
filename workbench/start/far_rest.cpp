// A note on a static equilibrium far from the hardpoints of the vehicle: springs without stiffness or preload, wheels
// at a wrong height.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

constexpr double kFarUp = 0.1;     // m; hardpoints are taken at a load within the travel of a spring
constexpr double kFarTurn = 0.12;  // rad, 7 deg, about a horizontal line

/// Whether all tyres stand on level ground of one height and the model gives no position of the vehicle.
bool is_meant_at_reference(const Model& model) {
  const Initial& initial = model.initial;
  if (!initial.equilibrium || !initial.positions.empty() || model.tyres.size() < 3) return false;
  if (!std::ranges::all_of(model.roads, &Road::is_level)) return false;
  return model.gravity[0].value == 0 && model.gravity[1].value == 0;
}

/// The body of a vehicle: the body of its reference point, or the heaviest one.
std::size_t vehicle_body(const Model& model) {
  if (model.vehicle && model.vehicle->reference.body >= 0)
    return static_cast<std::size_t>(model.vehicle->reference.body);
  const auto is_lighter = [](const Body& a, const Body& b) { return a.mass.value < b.mass.value; };
  return static_cast<std::size_t>(std::max_element(model.bodies.begin(), model.bodies.end(), is_lighter) -
                                  model.bodies.begin());
}

}  // namespace

Diagnostics far_rest_notes(const Compilation& compilation, const GenericState& start) {
  const Model& model = compilation.model;
  if (!is_meant_at_reference(model)) return {};
  const std::size_t body = vehicle_body(model);
  const GenericSolver solver(model, compilation.topology, compilation.analysis);
  const Pose before = solver.poses(reference_state(compilation))[body], after = solver.poses(start)[body];
  const double up = after.origin[2] - before.origin[2];
  // Cosine of the angle between the vertical and the body's vertical at the reference.
  double upright = 0;
  for (std::size_t i = 0; i < 3; ++i) upright += after.rotation[6 + i] * before.rotation[6 + i];
  const double turn = std::acos(std::clamp(upright, -1.0, 1.0));
  if (std::abs(up) < kFarUp && turn < kFarTurn) return {};
  return {
      {model.bodies[body].where,
       fmt::format("body \"{}\" rests {:.3g} m {} its place at the reference, leaning by {:.2g} deg",
                   model.bodies[body].name, std::abs(up), up < 0 ? "below" : "above", turn * 180 / std::numbers::pi),
       "hardpoints are those of the standing vehicle: see stiffness and preload of springs, masses, heights of wheels",
       ""}};
}

}  // namespace mbgen
