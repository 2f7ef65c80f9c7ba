#pragma once
// Sources of outputs: common parts of their readers.

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// In the order of Quantities.
inline constexpr std::array<std::string_view, 31> kQuantityWords = {"position",
                                                                    "velocity",
                                                                    "acceleration",
                                                                    "load",
                                                                    "longitudinal_force",
                                                                    "lateral_force",
                                                                    "aligning_moment",
                                                                    "longitudinal_slip",
                                                                    "lateral_slip",
                                                                    "force",
                                                                    "length",
                                                                    "rate",
                                                                    "moment",
                                                                    "distance",
                                                                    "angle",
                                                                    "rotation_vector",
                                                                    "quaternion",
                                                                    "angular_velocity",
                                                                    "angular_acceleration",
                                                                    "kinetic_energy",
                                                                    "potential_energy",
                                                                    "momentum",
                                                                    "angular_momentum",
                                                                    "toe",
                                                                    "camber",
                                                                    "steer_angle",
                                                                    "caster",
                                                                    "kingpin_inclination",
                                                                    "deflection",
                                                                    "speed",
                                                                    "power"};

/// Calls use(KindOf<Kind>{}) for the first kind of every source that is an element with quantities.
template <class Use>
constexpr void each_element_source(const Use& use) {
  int index = 0;
  each_kind([&](auto kind) {
    bool is_first = kind.quantities.size() > 0;
    int before = 0;
    each_kind([&](auto other) {
      if (before++ < index && source_key(other) == source_key(kind)) is_first = false;
    });
    ++index;
    if (is_first) use(kind);
  });
}

/// Sources of an output, exactly one per output. Tyres, also the source of outputs of wheels, precede the other
/// elements.
constexpr auto kOutputSources = [] {
  constexpr std::string_view before[] = {"expression", "point", "points", "body", "bodies", "joint", "tyre"};
  constexpr std::string_view after[] = {"elements", "motion", "reaction", "multiplier"};
  constexpr std::size_t elements = [] {
    std::size_t count = 0;
    each_element_source([&](auto kind) { count += source_key(kind) == "tyre" ? 0 : 1; });
    return count;
  }();
  std::array<std::string_view, std::size(before) + elements + std::size(after)> sources;
  std::size_t next = 0;
  for (const std::string_view key : before) sources[next++] = key;
  each_element_source([&](auto kind) {
    if (source_key(kind) != "tyre") sources[next++] = source_key(kind);
  });
  for (const std::string_view key : after) sources[next++] = key;
  return sources;
}();

/// Quantities of a point or a coordinate.
inline constexpr std::array kMotionQuantities = {Quantities::position, Quantities::velocity, Quantities::acceleration};

/// The source of an output and its SI unit.
struct Resolved {
  decltype(Output::source) source;
  std::string unit;
};

/// Reports a field that an output of `source` does not have.
void refuse(Reader& reader, const Value& value, std::string_view key, std::string_view source);

/// Reports a missing field of an output of `source`.
void require(Reader& reader, const Value& value, std::string_view key, std::string_view source);

/// The quantity if the source has it, else the first quantity of the source, with a problem.
Quantities quantity_of(Reader& reader, const Value& value, const OutputFields& output,
                       std::span<const Quantities> allowed, std::string_view source);

/// Index of a named element, or -1 with a problem.
int find_element(Reader& reader, const Value& value, std::string_view key, const NameMap<int>& names);

/// A joint, a rod or a coupling by its name; all -1 with a problem.
struct Connection {
  int joint = -1, rod = -1, coupling = -1;
};

/// couplings: whether couplings are allowed.
Connection find_connection(Reader& reader, const Value& value, std::string_view key, const std::string& name,
                           bool couplings);

// Outputs of motions, energies and wheels: see docs/use/outputs.md.
Resolved point_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved points_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved body_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved bodies_output(Reader& reader, const Value& value, const OutputFields& output);
Resolved wheel_output(Reader& reader, const Value& value, const OutputFields& output, Quantities quantity);

/// Whether a quantity is an angle of a wheel.
inline bool is_of_wheel(const std::optional<Quantities>& quantity) {
  return quantity >= Quantities::toe && quantity <= Quantities::kingpin_inclination;
}

/// A quantity of a source's element; fails for the energy of a force that is not integrated.
Resolved element_output(Reader& reader, const Value& value, const OutputFields& output, std::string_view source);

/// Potential energy of all elements; likewise.
Resolved elements_output(Reader& reader, const Value& value, const OutputFields& output);

/// Unit of a position, velocity or acceleration.
const char* motion_unit(bool rotation, Quantities quantity);

template <class What>
What offset(Quantities quantity, Quantities first) {
  return static_cast<What>(static_cast<int>(quantity) - static_cast<int>(first));
}

}  // namespace mbgen::reading
