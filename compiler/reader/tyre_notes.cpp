#include "compiler/reader/tyre_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compiler/model/tyres.hpp"
#include "mbgen/tyres/tyre.hpp"

namespace mbgen::reading {
namespace {

using Names = std::vector<std::string_view>;

/// A set of numbers at its nominal load.
struct NominalSet {
  double load = 0;                                                   ///< N
  std::function<TyreForces<double>(double kappa, double alpha)> of;  ///< N, y to the left
  double friction_x = 1, friction_y = 1;                             ///< at the peaks; only their sign is used
  /// Coefficient by name; 0 for pac89, which has no names.
  std::function<double(std::string_view name)> number;
};

std::vector<double> coefficients_of(const std::vector<Quantity>& coefficients) {
  std::vector<double> values;
  for (const Quantity& q : coefficients) values.push_back(q.value);
  return values;
}

NominalSet nominal_set(const Tyre& tyre) {
  constexpr double kLoadOfPac89 = 4000;  // N; its coefficients have no nominal load
  const std::vector<double> values = coefficients_of(tyre.coefficients);
  const std::span<const TyreField> fields = tyre_fields(tyre.model);
  NominalSet set;
  set.number = [values, fields](std::string_view name) {
    const std::size_t place = tyre_field_index(fields, name);
    return place < values.size() && !fields.empty() ? values[place] : 0;
  };
  if (tyre.model == TyreModel::pac89) {
    set.load = kLoadOfPac89;
    set.of = [pac89 = Pac89<double>::from_fields(values.data()), load = set.load](double kappa, double alpha) {
      const TyreForces<double> f = magic_formula_pac89<double>(pac89, load, kappa, alpha, 0, 1, 0);
      return TyreForces<double>{f.fx, -f.fy, -f.mz, f.mx};
    };
    return set;
  }
  set.load = set.number("FNOMIN");
  if (tyre.model == TyreModel::mf61) {
    const auto mf61 = MagicFormula61<double>::from_fields(values.data());
    const auto at = magic::mf61_state<double>(mf61, set.load, mf61.nompres, 1, 0);
    set.friction_x = magic::mf61_longitudinal<double>(mf61, at, 0, 0).curve.d / set.load;
    set.friction_y = magic::mf61_lateral<double>(mf61, at, 0, 0).friction;
    set.of = [mf61, load = set.load](double kappa, double alpha) {
      return magic_formula_61<double>(mf61, load, {kappa, alpha, 0}, mf61.nompres, 1, 0);
    };
    return set;
  }
  const auto pac2002 = Pac2002<double>::from_fields(values.data());
  const auto at = magic::load_terms<double>(pac2002.fnomin * pac2002.lfzo, set.load, 1, 0);
  set.friction_x = magic::pac2002_longitudinal<double>(pac2002, at, 0, 0).curve.d / set.load;
  set.friction_y = magic::pac2002_lateral<double>(pac2002, at, 0, 0).friction;
  set.of = [pac2002, load = set.load](double kappa, double alpha) {
    return magic_formula_pac2002<double>(pac2002, load, kappa, alpha, 0, 1, 0);
  };
  return set;
}

/// " (PKX1 and PDX1 are 0)" for the names whose coefficients are 0; empty for none.
std::string zeros_among(const NominalSet& set, const TyreModel& model, const Names& names) {
  Names zeros;
  for (const std::string_view name : names)
    if (model != TyreModel::pac89 && set.number(name) == 0) zeros.push_back(name);
  if (zeros.empty()) return {};
  return fmt::format(" ({} {} 0)", fmt::join(zeros, ", "), zeros.size() == 1 ? "is" : "are");
}

/// Name of a force in one direction, and its coefficients.
struct Direction {
  std::string_view force, stiffness, unit, effect;
  Names names;
  std::string_view sign;
};

/// Notes on one direction. force: over its slip, positive if it opposes the slip. Result: whether there is a force.
bool note_direction(Reader& reader, Place place, const NominalSet& set, TyreModel model, const Direction& direction,
                    const std::function<double(double)>& force) {
  constexpr double kSmall = 1e-6, kLeast = 1e-6;
  double peak = 0;
  for (int i = 1; i <= 100; ++i) peak = std::max(peak, std::abs(force(0.01 * i)));
  if (!(peak > kLeast * set.load)) {
    note_once(reader, place,
              fmt::format("the set has no {} at its nominal load{}", direction.force,
                          zeros_among(set, model, direction.names)),
              std::string(direction.effect));
    return false;
  }
  const double slope = (force(kSmall) - force(-kSmall)) / (2 * kSmall);
  if (slope < 0)
    note_once(reader, place,
              fmt::format("{} at the nominal load is {:.5g} {}: slip pushes the wrong way and brings energy",
                          direction.stiffness, slope, direction.unit),
              model == TyreModel::pac89 ? std::string() : std::string(direction.sign));
  return true;
}

/// Missing coefficients of combined slip; empty for a complete set.
std::string pure_slip_only(const NominalSet& set) {
  const auto is_zero = [&](std::string_view name) { return set.number(name) == 0; };
  Names missing;
  if (is_zero("RCX1") || (is_zero("RBX1") && is_zero("RBX3"))) missing.insert(missing.end(), {"RBX1", "RCX1"});
  if (is_zero("RCY1") || (is_zero("RBY1") && is_zero("RBY4"))) missing.insert(missing.end(), {"RBY1", "RCY1"});
  std::erase_if(missing, [&](std::string_view name) { return !is_zero(name); });
  if (missing.empty()) return {};
  return fmt::format("{} {} 0", fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are");
}

}  // namespace

void note_once(Reader& reader, Place place, const std::string& message, const std::string& hint) {
  const auto is_same = [&](const auto& other) {
    return other.place.file == place.file && other.place.offset == place.offset && other.message == message;
  };
  if (std::ranges::none_of(reader.notes, is_same)) note(reader, place, message, hint);
}

void note_tyre_set(Reader& reader, Place place, const Tyre& tyre) {
  if (tyre.coefficients.empty()) return;
  const NominalSet set = nominal_set(tyre);
  if (!(set.load > 0)) return;
  const Direction along{"longitudinal force",
                        "longitudinal slip stiffness",
                        "N",
                        "the tyre neither drives nor brakes",
                        {"PCX1", "PDX1", "PKX1", "LCX", "LMUX", "LKX"},
                        "PKX1 is above 0"};
  const Direction across{"lateral force",
                         "cornering stiffness",
                         "N/rad",
                         "the tyre holds no course",
                         {"PCY1", "PDY1", "PKY1", "PKY2", "LCY", "LMUY", "LKY"},
                         "PKY1 is below 0, with y to the left"};
  const bool has_x =
      note_direction(reader, place, set, tyre.model, along, [&](double slip) { return set.of(slip, 0).fx; });
  const bool has_y =
      note_direction(reader, place, set, tyre.model, across, [&](double slip) { return -set.of(0, slip).fy; });
  for (const auto& [name, friction] : {std::pair("longitudinal", set.friction_x), {"lateral", set.friction_y}})
    if (friction < 0)
      note_once(reader, place, fmt::format("{} friction at the nominal load is {:.5g}, below 0", name, friction));
  if (tyre.model == TyreModel::pac89 || !has_x || !has_y || tyre.combined_slip == CombinedSlip::ellipse) return;
  if (const std::string missing = pure_slip_only(set); !missing.empty())
    note_once(reader, place,
              fmt::format("the set has coefficients of pure slip only ({}): forces along and across together go beyond "
                          "friction",
                          missing),
              "\"combined_slip\": \"ellipse\" of the tyre shares friction between them");
}

}  // namespace mbgen::reading
