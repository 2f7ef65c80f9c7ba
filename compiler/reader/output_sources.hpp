#pragma once
// Sources of outputs: what the readers of them share.

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// An output has one of them.
constexpr std::array<std::string_view, 15> kOutputSources = {
    "expression",   "point",   "points",    "body",     "bodies", "joint",    "tyre",      "spring",
    "joint_spring", "bushing", "bump_stop", "elements", "motion", "reaction", "multiplier"};

/// Of a point or a coordinate.
inline constexpr std::array kMotionQuantities = {Quantities::position, Quantities::velocity, Quantities::acceleration};

/// The source of an output and the unit it has by itself.
struct Resolved {
  decltype(Output::source) source;
  std::string unit;
};

/// Complains about a field that an output of `source` does not take.
void refuse(Reader& reader, const Value& value, std::string_view key, std::string_view source);

/// Complains where a field that an output of `source` needs is not there.
void require(Reader& reader, const Value& value, std::string_view key, std::string_view source);

/// The quantity, when the source has it, else the first quantity of the source, with a complaint.
Quantities quantity_of(Reader& reader, const Value& value, const OutputFields& output,
                       std::span<const Quantities> allowed, std::string_view source);

/// Index of a named element, or -1 with a complaint.
int find_element(Reader& reader, const Value& value, std::string_view key, const NameMap<int>& names);

/// A joint, a rod or a coupling by its name; all -1 with a complaint.
struct Connection {
  int joint = -1, rod = -1, coupling = -1;
};

/// couplings: whether the name may be that of a coupling.
Connection find_connection(Reader& reader, const Value& value, std::string_view key, const std::string& name,
                           bool couplings);

// Outputs of motions, energies and wheels: see docs/use/outputs.md.
Resolved point_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved points_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved body_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved bodies_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved wheel_output(Reader& reader, const Value& value, const OutputFields& output, Quantities quantity);

/// Energy that an element, or all of them, holds; complains where a force of one is not integrated.
Resolved stored_energy_output(Reader& reader, const Value& value, const StoredEnergyOutput& source);

/// Unit of a position, velocity or acceleration.
const char* motion_unit(bool rotation, Quantities quantity);

template <class What>
What offset(Quantities quantity, Quantities first) {
  return static_cast<What>(static_cast<int>(quantity) - static_cast<int>(first));
}

}  // namespace mbgen::reading
