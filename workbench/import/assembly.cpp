#include "workbench/import/assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "compiler/expressions/names.hpp"

namespace mbgen::importing {
namespace {

constexpr std::size_t kLongestCoordinate = 3;  // "_tx"

using reading::is_digit, reading::is_letter, reading::kLongestName;

/// The name, or the name with the first number for which `is_free` is true.
template <class IsFree>
std::string numbered(const std::string& name, const IsFree& is_free) {
  std::string candidate = name;
  for (int number = 2; !is_free(candidate); ++number) {
    const std::string suffix = fmt::format("_{}", number);
    candidate = name.substr(0, kLongestName - kLongestCoordinate - suffix.size()) + suffix;
  }
  return candidate;
}

}  // namespace

std::string valid_name(std::string_view text) {
  std::string name;
  for (const char c : text) name += is_letter(c) || is_digit(c) ? c : '_';
  if (name.empty() || is_digit(name[0])) name.insert(name.begin(), '_');
  return name.substr(0, kLongestName - kLongestCoordinate);
}

std::string unique_name(std::string_view text, std::set<std::string>& taken) {
  const std::string name = numbered(valid_name(text), [&](const std::string& n) { return !taken.contains(n); });
  taken.insert(name);
  return name;
}

std::string unique_joint_name(Assembly& assembly, std::string_view text) {
  static constexpr std::array suffixes = {"", "_tx", "_ty", "_tz", "_rx", "_ry", "_rz", "_t1", "_t2"};
  const std::string name = numbered(valid_name(text), [&](const std::string& candidate) {
    return std::none_of(suffixes.begin(), suffixes.end(),
                        [&](const char* suffix) { return assembly.coordinate_names.contains(candidate + suffix); });
  });
  for (const char* suffix : suffixes) assembly.coordinate_names.insert(name + suffix);
  return name;
}

std::string add_point(BodyDraft& body, std::string_view name, const Vector3d& position) {
  const std::string unique = numbered(valid_name(name), [&](const std::string& candidate) {
    return std::none_of(body.points.begin(), body.points.end(),
                        [&](const auto& point) { return point.first == candidate; });
  });
  body.points.emplace_back(unique, position);
  return unique;
}

void add_joint_forces(Assembly& assembly, const std::string& coordinate, double stiffness, double damping, double free,
                      double friction) {
  if (stiffness > 0 || damping > 0) assembly.springs.push_back({coordinate, stiffness, damping, free});
  if (friction > 0) assembly.frictions.push_back({coordinate, friction});
}

void add_stops(const ImportRequest& request, Assembly& assembly, const std::string& coordinate, double lower,
               double upper) {
  if (!(request.stop_stiffness > 0) || !(lower < upper)) return;
  assembly.stop_stiffness = request.stop_stiffness;
  const auto add = [&](bool is_above, double clearance) {
    if (!std::isfinite(clearance)) return;
    const std::string name = unique_name(coordinate + (is_above ? "_upper" : "_lower"), assembly.stop_names);
    assembly.stops.push_back({name, coordinate, is_above, clearance});
  };
  add(false, -lower);
  add(true, upper);
}

void note_narrow(Reading& reading, Spot spot, const std::string& joint, double lower, double upper,
                 const std::string& unit, const std::string& hint) {
  if (lower > upper)
    note(reading, spot,
         fmt::format("joint {}: its lower limit, {} {}, is above its upper one, {} {}: it is imported without limits",
                     quoted_text(joint), lower, unit, upper, unit),
         "exchange the two");
  if (lower == upper && std::isfinite(lower))
    note(reading, spot,
         fmt::format("joint {} is locked by its limits, both {} {}: it is imported free to move", quoted_text(joint),
                     lower, unit),
         hint);
}

void add_rotor(Assembly& assembly, const std::string& coordinate, double inertia) {
  constexpr double kRadius = 0.1;  // m, of the disc; only its axial inertia matters
  BodyDraft rotor{.name = unique_name(coordinate + "_rotor", assembly.body_names)};
  rotor.mass = 2 * inertia / (kRadius * kRadius);
  rotor.inertia = Vector3d(inertia / 2, inertia / 2, inertia).asDiagonal();
  rotor.comment = fmt::format("inertia of a geared rotor, felt by {} alone", coordinate);
  rotor.title = "rotor of " + coordinate;
  JointDraft joint{.name = unique_joint_name(assembly, rotor.name), .type = JointType::revolute};
  joint.to = static_cast<int>(assembly.bodies.size());
  joint.axis = Vector3d::UnitZ();
  const std::string relation = fmt::format("z.{} - z.{}", joint.name, coordinate);
  assembly.couplings.push_back({unique_name(rotor.name, assembly.coupling_names), relation});
  assembly.bodies.push_back(std::move(rotor));
  assembly.joints.push_back(std::move(joint));
}

std::string number_text(double value) {
  if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : fmt::format("{}", value);
  // A difference of a few units in the last place is rounding: thirteen digits are then sufficient.
  constexpr double kRounding = 8e-16;
  const std::string typed = fmt::format("{:.12e}", value);
  double rounded = value;
  std::from_chars(typed.data(), typed.data() + typed.size(), rounded);
  return fmt::format("{}", std::abs(rounded - value) <= kRounding * std::abs(value) ? rounded : value);
}

std::string sum_text(const std::vector<Term>& terms) {
  std::string text;
  for (const Term& term : terms) {
    if (term.factor == 0) continue;
    const std::string size = number_text(std::abs(term.factor));
    const std::string product = term.name.empty() ? size : size == "1" ? term.name : size + "*" + term.name;
    if (text.empty())
      text = (term.factor < 0 ? "-" : "") + product;
    else
      text += (term.factor < 0 ? " - " : " + ") + product;
  }
  return text.empty() ? "0" : text;
}

std::string few_names(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 3;
  std::string text;
  const std::size_t shown = names.size() <= kShown + 1 ? names.size() : kShown;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i > 0 && i + 1 == names.size();
    text += (i == 0 ? "" : is_last ? " and " : ", ") + quoted_text(names[i]);
  }
  return shown == names.size() ? text : text + fmt::format(" and {} more", names.size() - shown);
}

}  // namespace mbgen::importing
