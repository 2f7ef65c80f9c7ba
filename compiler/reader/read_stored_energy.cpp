// Outputs of potential energy, and which laws have none that is known.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/expressions/curve.hpp"
#include "compiler/model/mentions.hpp"
#include "compiler/reader/output_sources.hpp"

namespace mbgen::reading {
namespace {

using Of = StoredEnergyOutput::Of;

bool depends_on_motion(const Model& model, const Quantity& quantity) {
  using Kind = ExpressionNode::Kind;
  return mentions(model, quantity.expression, {Kind::position, Kind::velocity, Kind::state, Kind::length, Kind::rate});
}

bool depends_on_motion(const Model& model, const std::optional<Law>& law) {
  const Quantity* factor = law ? std::get_if<Quantity>(&*law) : nullptr;
  return factor && depends_on_motion(model, *factor);
}

/// Whether the curve is negative anywhere from zero on: looked at in sixteen places between two points.
bool falls_below_zero(const Table& table) {
  constexpr int kPlaces = 16;
  bool falls = value_along(table, 0.0) < 0;
  const auto look_at = [&](double x) { falls = falls || (x > 0 && value_along(table, x) < 0); };
  for (std::size_t i = 0; i + 1 < table.x.size(); ++i)
    for (int k = 0; k <= kPlaces; ++k) look_at(table.x[i] + k * (table.x[i + 1] - table.x[i]) / kPlaces);
  // As far again: the straight line beyond the points may fall.
  look_at(2 * std::max(table.x.back(), width_of(table)));
  return falls;
}

constexpr const char* kByExpression = "a force by an expression, which is not integrated";
constexpr const char* kByMotion = "a law that depends on the motion, which is not integrated";

/// Part of an element that is not integrated; empty where all is.
std::string trouble_of(const Model& model, const PointSpring& spring) {
  if (spring.force) return kByExpression;
  const bool moves = depends_on_motion(model, spring.stiffness) || depends_on_motion(model, spring.preload) ||
                     (spring.free_length && depends_on_motion(model, *spring.free_length));
  return moves ? kByMotion : "";
}

std::string trouble_of(const Model& model, const JointSpring& spring) {
  if (spring.force) return kByExpression;
  const bool moves = depends_on_motion(model, spring.stiffness) || depends_on_motion(model, spring.preload) ||
                     depends_on_motion(model, spring.free);
  return moves ? kByMotion : "";
}

std::string trouble_of(const Model& model, const Bushing& bushing) {
  bool moves = false;
  for (std::size_t i = 0; bushing.stiffness && i < bushing.stiffness->size(); ++i)
    moves = moves || depends_on_motion(model, (*bushing.stiffness)[i]);
  for (const auto& freedom : bushing.freedoms) {
    if (!freedom) continue;
    if (freedom->force) return kByExpression;
    moves = moves || depends_on_motion(model, freedom->stiffness) || depends_on_motion(model, freedom->preload) ||
            (freedom->maxwell_stiffness && depends_on_motion(model, *freedom->maxwell_stiffness));
  }
  return moves ? kByMotion : "";
}

std::string trouble_of(const Model& model, const BumpStop& stop) {
  if (stop.force || !stop.stiffness) return kByExpression;
  const Table* table = std::get_if<Table>(&*stop.stiffness);
  if (table && falls_below_zero(*table))
    return "a table that falls below zero, where it does not pull, which is not integrated";
  return depends_on_motion(model, stop.stiffness) || depends_on_motion(model, stop.clearance) ? kByMotion : "";
}

std::string trouble_of(const Model&, const AirSpring&) { return "a gas law, which is not integrated"; }

}  // namespace

Resolved stored_energy_output(Reader& reader, const Value& value, const StoredEnergyOutput& source) {
  const Model& model = reader.model;
  const bool is_of_all = source.of == Of::all;
  bool is_told = false;  // of all elements the first trouble is enough
  const auto check = [&](std::string_view kind, const auto& element) {
    const std::string trouble = trouble_of(model, element);
    if (trouble.empty() || is_told) return;
    is_told = true;
    report(reader, value, fmt::format("{} {} has {}", kind, in_quotes(element.name), trouble),
           is_of_all ? "ask for the energy of each of the other elements by itself" : "");
  };
  const auto check_those = [&](Of of, std::string_view kind, const auto& elements) {
    if (source.of == of && source.element >= 0) check(kind, elements[static_cast<std::size_t>(source.element)]);
    if (!is_of_all) return;
    for (const auto& element : elements) check(kind, element);
  };
  check_those(Of::spring, "spring", model.springs);
  check_those(Of::joint_spring, "joint spring", model.joint_springs);
  check_those(Of::bushing, "bushing", model.bushings);
  check_those(Of::bump_stop, "bump stop", model.bump_stops);
  check_those(Of::all, "air spring", model.air_springs);
  return {source, "J"};
}

}  // namespace mbgen::reading
