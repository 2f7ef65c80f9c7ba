#pragma once
// Turning of a tyre's contact: turn slip and the moment of a parked wheel.

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Coefficients that the formulas of turn slip divide by.
inline constexpr std::string_view kTurnSlipNeeds[] = {"PHYP1", "PHYP2", "QCRP1", "QDRP1"};
inline constexpr std::string_view kTurnSlipNeedsText =
    "turn slip needs PHYP1, PHYP2, QCRP1 and QDRP1 of its set, not zero";

/// Data of a .tir file on turning.
struct TurningOfFile {
  bool turn_slip = false;                    ///< USE_MODE asks for it
  std::optional<double> yaw_stiffness = {};  ///< N m/rad: YAW_STIFFNESS, of the carcass
};

/// Whether a set of mf61 has all that turn slip divides by.
bool has_turn_slip(const std::vector<Quantity>& coefficients);

/// Sets turn_slip and parking of a tyre whose set, radius and stiffness are known, and notes coefficients of turn slip
/// in a set of the model that do not act. Complains about turn slip of other sets than mf61, or of a set without
/// PHYP1, PHYP2, QCRP1 or QDRP1, and about a patch without a number that the set does not give.
void use_turning(Reader& reader, const Value& value, const TurningOfFile& of_file, TyreFields& tyre);

}  // namespace mbgen::reading
