#include "compiler/import/assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mbgen::importing {
namespace {

constexpr std::size_t kLongestName = 64;       // of the model format
constexpr std::size_t kLongestCoordinate = 3;  // "_tx"

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The name, or the name with the first number that makes `is_free` true.
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

}  // namespace mbgen::importing
