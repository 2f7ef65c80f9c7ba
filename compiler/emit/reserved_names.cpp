// Names that emitted code cannot give to elements of the model.

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/names.hpp"

namespace mbgen {
namespace {

/// Whether an embedded list of names contains this one.
template <const char* list>
bool is_in(std::string_view name) {
  static const std::vector<std::string> words = words_of(list);
  static const std::set<std::string_view> names(words.begin(), words.end());
  return names.contains(name);
}

constexpr char kReserved[] = "reserved.names", kGlobal[] = "global.names", kTargets[] = "build_targets.names";

/// Endings of the library's functions for types other than double, longest first.
constexpr std::string_view kPrecisions[] = {
    "f128_r", "f128_l", "f32x_r", "f32x_l", "f64x_r", "f64x_l", "f32_r", "f32_l", "f64_r", "f64_l", "f128", "f32x",
    "f64x",   "f32",    "f64",    "f_r",    "l_r",    "f_l",    "l_l",   "_r",    "_l",    "f",     "l"};

bool is_upper_case(std::string_view name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; });
}

bool may_be_macro(std::string_view name) {
  if (is_upper_case(name) && name.find('_') != std::string_view::npos) return true;
  return name.starts_with("M_") || name.starts_with("HUGE_VAL") || name.starts_with("SNANF");
}

/// Whether the C library has a function of this name for another type than double: `sinf`, `f64mulf128`.
bool is_of_other_precision(std::string_view name) {
  if (name.starts_with("f32") || name.starts_with("f64")) return true;
  for (const std::string_view ending : kPrecisions) {
    if (!name.ends_with(ending)) continue;
    const std::string_view start = name.substr(0, name.size() - ending.size());
    if (is_in<kGlobal>(start) || is_in<kReserved>(start)) return true;
  }
  return false;
}

}  // namespace

bool is_reserved(std::string_view name) { return is_in<kReserved>(name) || may_be_macro(name); }

bool is_reserved_for_solvers(std::string_view name) {
  return is_in<kGlobal>(name) || is_in<kTargets>(name) || name.ends_with("_t") || is_of_other_precision(name);
}

}  // namespace mbgen
