#include "compiler/reader/read_turning.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/tyres.hpp"
#include "compiler/reader/raw.hpp"
#include "mbgen/tyres/tyre.hpp"

namespace mbgen::reading {
namespace {

MagicFormula61<double> numbers_of(const std::vector<Quantity>& coefficients) {
  std::vector<double> values;
  for (const Quantity& q : coefficients) values.push_back(q.value);
  return MagicFormula61<double>::from_fields(values.data());
}

/// Stiffness of a standing patch against turning, N m/rad, at nominal load and pressure. A patch of bristles has the
/// sum of two stiffnesses: of lateral bristles, equal to the aligning moment over the slip angle, and of longitudinal
/// bristles, the moment over spin divided by half the length of the patch; the carcass is in series. length: m, of half
/// the patch. Source: brush model, Pacejka (2012), sections 3.2 and 3.3.
double turn_stiffness(const MagicFormula61<double>& set, double length, const std::optional<double>& yaw_stiffness) {
  const double nominal = set.fnomin * set.lfzo;
  const auto at = magic::mf61_state<double>(set, nominal, set.nompres, 1, 1);
  const double aligning =
      magic::mf61_lateral<double>(set, at, 0, 0).stiffness * magic::mf61_trail<double>(set, at, 0, 0, 0);
  const double of_spin = nominal * set.unloaded_radius * set.qdz8 * set.lkzc * set.unloaded_radius /
                         magic::mf61_camber_share<double>(set, 0);
  const double patch = std::abs(aligning) + std::abs(of_spin) / length;
  return yaw_stiffness && *yaw_stiffness > 0 ? patch * *yaw_stiffness / (patch + *yaw_stiffness) : patch;
}

/// Whether turn slip is active, with problems and notes.
bool takes_turn_slip(Reader& reader, const Value& value, const TurningOfFile& of_file, const TyreFields& tyre) {
  const Member* member = find_member(value, "turn_slip");
  const bool is_wanted = tyre.written_turn_slip.value_or(of_file.turn_slip);
  if (tyre.model != TyreModel::mf61) {
    if (member && is_wanted) report(reader, member->place, "only a tyre with mf61 data has turn slip");
    return false;
  }
  if (is_wanted && has_turn_slip(tyre.coefficients)) return true;
  if (is_wanted && member) report(reader, member->place, std::string(kTurnSlipNeedsText));
  std::vector<std::string_view> idle;
  for (std::size_t i = 0; i < tyre.coefficients.size(); ++i)
    if (is_of_turn_slip(kMf61Fields[i].name) && tyre.coefficients[i].value != kMf61Fields[i].default_value)
      idle.push_back(kMf61Fields[i].name);
  if (!is_wanted && !idle.empty())
    note(reader, value.place, fmt::format("the tyre does not use turn slip ({})", fmt::join(idle, ", ")),
         "give it \"turn_slip\": true");
  return false;
}

}  // namespace

bool has_turn_slip(const std::vector<Quantity>& coefficients) {
  return std::ranges::all_of(kTurnSlipNeeds, [&](std::string_view name) {
    return coefficients[tyre_field_index(kMf61Fields, name)].value != 0;
  });
}

void use_turning(Reader& reader, const Value& value, const TurningOfFile& of_file, TyreFields& tyre) {
  if (tyre.coefficients.empty()) return;
  tyre.turn_slip = takes_turn_slip(reader, value, of_file, tyre);
  if (!tyre.written_parking && !tyre.turn_slip) return;
  TyrePatch patch = with_defaults<TyrePatch>();
  const std::size_t problems = reader.problems.size();
  if (tyre.written_parking && !read_fields(reader, *tyre.written_parking, patch)) return;
  const Value& at = tyre.written_parking ? *tyre.written_parking : value;
  const auto is_given = [&](const char* key) { return tyre.written_parking && find(at, key); };
  const std::span<const TyreField> fields = tyre_fields(tyre.model);
  const auto of_set = [&](const char* name) { return tyre.coefficients[tyre_field_index(fields, name)]; };
  if (!is_given("load")) {
    if (tyre.model == TyreModel::pac89)
      report(reader, at, "a patch of a tyre with pac89 data needs \"load\"");
    else
      patch.load = scaled(reader, of_set("LFZO").value, of_set("FNOMIN"));
  }
  if (tyre.turn_slip) {
    const MagicFormula61<double> set = numbers_of(tyre.coefficients);
    if (!is_given("radius")) patch.radius = std::abs(set.qcrp1 * set.unloaded_radius * set.lmp);
    if (!is_given("stiffness")) {
      const double length = std::sqrt(tyre.radius.value * patch.load.value / tyre.stiffness.value);
      patch.stiffness = turn_stiffness(set, length, of_file.yaw_stiffness);
    }
  } else {
    for (const char* key : {"stiffness", "radius"})
      if (!is_given(key))
        report(reader, at, fmt::format("key \"{}\" is missing", key), "only turn slip has a default for it");
  }
  if (reader.problems.size() == problems) tyre.parking = patch;
}

}  // namespace mbgen::reading
