#include "compiler/formats/crg_unsupported.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "compiler/formats/crg_road.hpp"

namespace mbgen {
namespace {

double value(const CrgEntries& entries, const char* name) { return entry_of(entries, name).value_or(0); }

constexpr std::array kPoints = {"REFPOINT_X", "REFPOINT_Y", "REFPOINT_Z",          "REFPOINT_PHI",
                                "REFPOINT_U", "REFPOINT_V", "REFPOINT_U_FRACTION", "REFPOINT_V_FRACTION"};
constexpr std::array kShifts = {"REFLINE_ROTCENTER_X", "REFLINE_ROTCENTER_Y", "REFLINE_OFFSET_PHI",
                                "REFLINE_OFFSET_X",    "REFLINE_OFFSET_Y",    "REFLINE_OFFSET_Z"};
constexpr std::array kOffsets = {"REFPOINT_U_OFFSET", "REFPOINT_V_OFFSET"};
constexpr std::array kOfData = {"SCALE_Z_GRID", "SCALE_SLOPE",     "SCALE_BANKING",  "SCALE_LENGTH",
                                "SCALE_WIDTH",  "SCALE_CURVATURE", "GRID_NAN_OFFSET"};
constexpr std::array kBorderModes = {"BORDER_MODE_U", "BORDER_MODE_V"};
constexpr std::array kOffsetsBeyond = {"BORDER_OFFSET_U", "BORDER_OFFSET_V"};
constexpr std::array kSmoothing = {"BORDER_SMOOTH_UBEG", "BORDER_SMOOTH_UEND"};
/// Options without effect on heights: messages, checks, search of positions, output of curvature.
constexpr std::array<std::string_view, 5> kHarmless = {"WARN_", "CHECK_", "LOG_", "REFLINE_SEARCH_", "CURV_MODE"};

template <class Names>
bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_point(const CrgRoad& road) {
  return std::any_of(kPoints.begin(), kPoints.end(), [&](const char* name) { return road.modifiers.contains(name); });
}

/// Coordinate of a reference point along one axis, from `first` to `last`.
double reference(const CrgEntries& m, const char* place, const char* fraction, const char* offset, double first,
                 double last, double fallback) {
  if (const std::optional<double> share = entry_of(m, fraction))
    return std::lerp(first, last, *share) + value(m, offset);
  return entry_of(m, place).value_or(fallback);
}

RoadBorder border_of(const CrgEntries& options, const char* name) {
  const double mode = entry_of(options, name).value_or(2);
  return mode == 0   ? RoadBorder::refuse
         : mode == 1 ? RoadBorder::zero
         : mode == 3 ? RoadBorder::repeat
         : mode == 4 ? RoadBorder::reflect
                     : RoadBorder::keep;
}

/// Reason why a line to be closed remains open, or is not closed at its end; empty if it is closed.
std::string why_open(const CrgRoad& road, double asked) {
  using Kind = CrgClosure::Kind;
  if (asked == 0 || (asked == 1 && road.closure.kind == Kind::meeting)) return {};
  if (asked != 1) return " (neither 0 nor 1: the line goes straight on at its ends)";
  if (road.closure.kind == Kind::apart)
    return fmt::format(
        " to the letter (a closed track, but its end is {:.6g} m before its start: there the line goes "
        "straight on from both, with the heights beyond its ends)",
        road.closure.gap);
  return fmt::format(
      " (a closed track, but its end, {:.6g} m away from its start, does not lead to it: the line goes straight on at "
      "its ends)",
      road.closure.gap);
}

}  // namespace

CrgRoad relocated(CrgRoad road) {
  const CrgEntries& m = road.modifiers;
  if (has_point(road)) {
    const CrgPlace at{
        reference(m, "REFPOINT_U", "REFPOINT_U_FRACTION", "REFPOINT_U_OFFSET", road.start, road.end(), road.start),
        reference(m, "REFPOINT_V", "REFPOINT_V_FRACTION", "REFPOINT_V_OFFSET", road.v.front(), road.v.back(), 0)};
    return turned_and_moved(road, {plane_place(road, at),
                                   {value(m, "REFPOINT_X"), value(m, "REFPOINT_Y")},
                                   value(m, "REFPOINT_PHI") - course_of(road, at).heading,
                                   value(m, "REFPOINT_Z") - height_of(road, at)});
  }
  if (std::none_of(kShifts.begin(), kShifts.end(), [&](const char* name) { return m.contains(name); })) return road;
  const PlanePlace centre{entry_of(m, "REFLINE_ROTCENTER_X").value_or(road.x[0]),
                          entry_of(m, "REFLINE_ROTCENTER_Y").value_or(road.y[0])};
  return turned_and_moved(road, {centre,
                                 {centre.x + value(m, "REFLINE_OFFSET_X"), centre.y + value(m, "REFLINE_OFFSET_Y")},
                                 value(m, "REFLINE_OFFSET_PHI"),
                                 value(m, "REFLINE_OFFSET_Z")});
}

void follow_options(RoadGrid& grid) {
  const CrgEntries& options = grid.road->options;
  grid.ends = border_of(options, "BORDER_MODE_U");
  grid.sides = border_of(options, "BORDER_MODE_V");
  grid.end_offset = value(options, "BORDER_OFFSET_U");
  grid.side_offset = value(options, "BORDER_OFFSET_V");
  grid.smooth_begin = std::max(0.0, value(options, "BORDER_SMOOTH_UBEG"));
  grid.smooth_end = std::max(0.0, value(options, "BORDER_SMOOTH_UEND"));
}

std::vector<std::string> unsupported_options(const CrgRoad& road) {
  std::vector<std::string> list;
  const auto add = [&](const std::string& name, double number, std::string_view why) {
    list.push_back(fmt::format("{} = {:g}{}", name, number, why));
  };
  for (const auto& [name, number] : road.modifiers) {
    const bool is_shift = has(kShifts, name);
    if (is_shift && has_point(road))
      add(name, number, " (beside a reference point)");
    else if (name == "GRID_NAN_MODE") {
      if (number != 0 && number != 1 && number != 2) add(name, number, " (gaps get the height beside them)");
    } else if (!is_shift && !has(kPoints, name) && !has(kOffsets, name) && !has(kOfData, name))
      add(name, number, "");
  }
  for (const auto& [name, number] : road.options) {
    const bool is_harmless =
        std::any_of(kHarmless.begin(), kHarmless.end(),
                    [&option = name](std::string_view beginning) { return option.starts_with(beginning); });
    if (has(kBorderModes, name)) {
      if (number != 0 && number != 1 && number != 2 && number != 3 && number != 4) add(name, number, "");
    } else if (name == "REFLINE_CONTINUATION") {
      if (const std::string why = why_open(road, number); !why.empty()) add(name, number, why);
    } else if (!is_harmless && !has(kOffsetsBeyond, name) && !(has(kSmoothing, name) && number >= 0)) {
      add(name, number, "");
    }
  }
  return list;
}

}  // namespace mbgen
