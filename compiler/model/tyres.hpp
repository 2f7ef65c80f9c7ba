#pragma once
// Tyres of a model: coefficients of their sets by their names in .tir files, and the ones on ground of a host.

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/model/model.hpp"
#include "mbgen/tyres/mf61_set.hpp"
#include "mbgen/tyres/pac2002.hpp"

namespace mbgen {

/// The coefficients of a model in the order of Tyre::coefficients; none for pac89, with its unnamed arrays.
inline std::span<const TyreField> tyre_fields(TyreModel model) {
  if (model == TyreModel::pac89) return {};
  return model == TyreModel::mf61 ? std::span<const TyreField>(kMf61Fields)
                                  : std::span<const TyreField>(kPac2002Fields);
}

/// Index of a name in the fields; their number for an unknown name.
inline std::size_t tyre_field_index(std::span<const TyreField> fields, std::string_view name) {
  const auto found = std::ranges::find_if(fields, [&](const TyreField& row) { return row.name == name; });
  return static_cast<std::size_t>(found - fields.begin());
}

/// Whether a coefficient is required and positive.
inline bool is_scale(TyreModel model, std::string_view name) {
  return name == "UNLOADED_RADIUS" || name == "FNOMIN" || (model == TyreModel::mf61 && name == "NOMPRES");
}

/// Whether a coefficient of MF 6.1 belongs to turn slip: the last of kMf61Fields, from LMP on.
inline bool is_of_turn_slip(std::string_view name) {
  const std::size_t place = tyre_field_index(kMf61Fields, name);
  return place >= tyre_field_index(kMf61Fields, "LMP") && place < kMf61Count;
}

/// Indices of the tyres on roads given by a host, one per road.
std::vector<int> tyres_on_host(const Model& model);

}  // namespace mbgen
