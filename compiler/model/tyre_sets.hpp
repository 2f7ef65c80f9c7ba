#pragma once
// The coefficients of a tyre set by their names in .tir files.

#include <algorithm>
#include <span>
#include <string_view>

#include "compiler/model/elements/tyre.hpp"
#include "mbgen/tyres/mf61_set.hpp"
#include "mbgen/tyres/pac2002.hpp"

namespace mbgen {

/// The coefficients of a model in the order of Tyre::coefficients; none of pac89, which has arrays without names.
inline std::span<const TyreField> tyre_fields(TyreModel model) {
  if (model == TyreModel::pac89) return {};
  return model == TyreModel::mf61 ? std::span<const TyreField>(kMf61Fields)
                                  : std::span<const TyreField>(kPac2002Fields);
}

/// Place of a name in the fields; their number for one that is not among them.
inline std::size_t tyre_field_index(std::span<const TyreField> fields, std::string_view name) {
  const auto found = std::ranges::find_if(fields, [&](const TyreField& row) { return row.name == name; });
  return static_cast<std::size_t>(found - fields.begin());
}

/// Whether a coefficient must be given, and above zero.
inline bool is_scale(TyreModel model, std::string_view name) {
  return name == "UNLOADED_RADIUS" || name == "FNOMIN" || (model == TyreModel::mf61 && name == "NOMPRES");
}

/// Whether a coefficient of MF 6.1 is one of turn slip: the last of kMf61Fields, from LMP on.
inline bool is_of_turn_slip(std::string_view name) {
  const std::size_t place = tyre_field_index(kMf61Fields, name);
  return place >= tyre_field_index(kMf61Fields, "LMP") && place < kMf61Count;
}

}  // namespace mbgen
