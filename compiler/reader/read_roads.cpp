// Roads: their features and patches.
#include <fmt/format.h>

#include <cmath>

#include "compiler/expressions/spline_coefficients.hpp"
#include "compiler/formats/rough_road.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"
#include "compiler/reader/tables/csv_table.hpp"

namespace mbgen::reading {
namespace {

/// Required fields of a kind of feature, and fields that it does not have.
struct FeatureRule {
  const char* word;
  bool needs_length, has_waves, has_last_wave;
};
constexpr FeatureRule kRules[] = {{"bump", true, false, false},
                                  {"plank", true, false, false},
                                  {"pothole", true, false, false},
                                  {"sine", false, true, false},
                                  {"sweep", true, true, true}};  // in the order of RoadFeature::Kind

void check_sides(Reader& reader, const Value& value, const RoadStretch& stretch) {
  if (stretch.left && stretch.right && stretch.left->value <= stretch.right->value)
    report(reader, *find(value, "left"),
           fmt::format("its left side, y = {:g}, is not to the left of its right side, y = {:g}", stretch.left->value,
                       stretch.right->value));
}

void check_feature(Reader& reader, const Value& value, const RoadFeature& feature) {
  const FeatureRule& rule = kRules[static_cast<std::size_t>(feature.kind)];
  const auto check = [&](const char* key, bool needed, bool known) {
    const Member* member = find_member(value, key);
    if (needed && !member) report(reader, value, fmt::format("a {} needs {}", rule.word, in_quotes(key)));
    if (!known && member) report(reader, member->place, fmt::format("a {} has no {}", rule.word, in_quotes(key)));
  };
  const bool is_bump = feature.kind == RoadFeature::Kind::bump;
  check("length", rule.needs_length, true);
  check("wave_length", rule.has_waves, rule.has_waves);
  check("last_wave_length", rule.has_last_wave, rule.has_last_wave);
  check("phase", false, rule.has_waves);
  check("ramp", false, !is_bump && (rule.needs_length || feature.length));
  if (!is_bump && feature.length && feature.ramp > feature.length->value / 2)
    report(
        reader, member_or_object(value, "ramp"),
        fmt::format("its two ramps of {:g} m are longer than its length, {:g} m", feature.ramp, feature.length->value),
        "give it a shorter \"ramp\", 0 for steps");
  check_sides(reader, value, feature);
}

/// The named objects of a map in a road, in their order.
template <class Part, class Check>
void read_parts(Reader& reader, const Value* map, std::vector<Part>& parts, const Check& check) {
  if (!map) return;
  if (map->kind != Value::Kind::object) {
    report(reader, *map, "must be an object of named parts of the road, got " + describe(*map));
    return;
  }
  Entries entries;
  for (const Member& member : map->members) {
    if (!is_valid_name(member.key)) report(reader, member.place, "invalid name " + in_quotes(member.key), kNameRule);
    entries.push_back({member.key, member.key, member.place, &member.value, reader.scope});
  }
  read_list(reader, entries, parts, check);
}

/// coefficients: in the order of RoadTracks.
RoadTracks& add_tracks(Reader& reader, Road& road, double width, const std::vector<double>& coefficients) {
  RoadTracks& tracks = road.tracks.emplace_back();
  tracks.right = -width / 2;
  tracks.left = width / 2;
  tracks.first = static_cast<int>(reader.samples->size());
  reader.samples->insert(reader.samples->end(), coefficients.begin(), coefficients.end());
  return tracks;
}

/// A rough road, as tracks of the road.
void read_iso_road(Reader& reader, const Value& value, Road& road) {
  constexpr double kMostSamples = 200000, kLargestSeed = 9007199254740992.0;  // 2^53
  IsoRoadFields fields = with_defaults<IsoRoadFields>();
  const std::size_t problems = reader.problems.size();
  if (!read_fields(reader, value, fields)) return;
  const auto check = [&](const char* key, bool good, const std::string& message) {
    if (!good) report(reader, member_or_object(value, key), message);
  };
  if (reader.problems.size() > problems) return;
  check("seed", fields.seed == std::floor(fields.seed) && fields.seed < kLargestSeed,
        fmt::format("seed must be a whole number below 2^53, got {}", fields.seed));
  check("coherence", fields.coherence <= 1, fmt::format("coherence must be at most 1, got {:g}", fields.coherence));
  check("shortest_wave", fields.shortest_wave < fields.longest_wave,
        fmt::format("shortest_wave, {:g} m, must be shorter than longest_wave, {:g} m", fields.shortest_wave,
                    fields.longest_wave));
  check(
      "length", fields.length >= fields.longest_wave,
      fmt::format("length, {:g} m, must not be shorter than longest_wave, {:g} m", fields.length, fields.longest_wave));
  const double count = std::ceil(kSamplesPerWave * fields.length / fields.shortest_wave);
  check("length", count <= kMostSamples,
        fmt::format("road needs {:g} samples, {:g} of its shortest waves long; at most {:g} are possible", count,
                    fields.length / fields.shortest_wave, kMostSamples));
  if (reader.problems.size() > problems) return;
  const RoughRoad rough{.roughness = 16e-6 * std::pow(4, static_cast<int>(fields.letter)),
                        .seed = static_cast<std::uint64_t>(fields.seed),
                        .length = fields.length,
                        .coherence = fields.coherence,
                        .longest_wave = fields.longest_wave,
                        .shortest_wave = fields.shortest_wave,
                        .count = static_cast<int>(count)};
  RoadTracks& tracks = add_tracks(reader, road, fields.track, coefficients_of(rough));
  tracks.spacing = fields.length / count;
  tracks.count = rough.count;
  tracks.is_periodic = true;
}

/// Heights at equal distances from a column; empty with a problem.
std::vector<std::array<double, 2>> read_heights(Reader& reader, const Value& value, const RoadProfileFields& fields,
                                                const std::string& column, const char* key) {
  constexpr double kEqual = 1e-6;  // of a distance
  std::vector<std::array<double, 2>> points =
      read_csv_table(reader, value, {.x = fields.x, .y = column, .key_of_y = key, .unit = "m"});
  if (points.size() < 2) return {};
  const double spacing = (points.back()[0] - points.front()[0]) / static_cast<double>(points.size() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double expected = points.front()[0] + spacing * static_cast<double>(i);
    if (std::abs(points[i][0] - expected) <= kEqual * spacing) continue;
    report(reader, *find(value, "csv"),
           fmt::format("heights must stand at equal distances, {:g} m: number {} is at x = {:.9g}, not at {:.9g}",
                       spacing, i + 1, points[i][0], expected),
           "resample the file");
    return {};
  }
  return points;
}

/// Measured heights, as tracks of the road.
void read_profile(Reader& reader, const Value& value, Road& road) {
  RoadProfileFields fields = with_defaults<RoadProfileFields>();
  const std::size_t problems = reader.problems.size();
  if (!read_fields(reader, value, fields) || reader.problems.size() > problems) return;
  const bool has_sides = !fields.right.empty();
  if (has_sides == fields.left.empty())
    report(reader, value, "a profile of two tracks needs the columns \"right\" and \"left\"");
  else if (has_sides && !fields.z.empty())
    report(reader, find_member(value, "z")->place, "profile has both \"z\" and the columns of two tracks");
  if (reader.problems.size() > problems) return;
  std::vector<std::array<double, 2>> points;
  std::vector<double> sides[2];
  for (int side = 0; side < (has_sides ? 2 : 1); ++side) {
    const auto& [column, key] = !has_sides  ? std::pair(fields.z, "z")
                                : side == 0 ? std::pair(fields.right, "right")
                                            : std::pair(fields.left, "left");
    points = read_heights(reader, value, fields, column, key);
    if (points.empty()) return;
    for (const auto& point : points) sides[side].push_back(point[1]);
  }
  const std::vector<double> right = spline_coefficients(sides[0]);
  const std::vector<double> left = has_sides ? spline_coefficients(sides[1]) : right;
  std::vector<double> coefficients;
  for (std::size_t i = 0; i < right.size(); ++i) coefficients.insert(coefficients.end(), {right[i], left[i]});
  RoadTracks& tracks = add_tracks(reader, road, fields.track, coefficients);
  tracks.from = points.front()[0];
  tracks.count = static_cast<int>(points.size());
  tracks.spacing = (points.back()[0] - tracks.from) / (tracks.count - 1);
}

}  // namespace

void read_roads(Reader& reader, const Entries& entries) {
  std::vector<RoadFields> list;
  read_list(reader, entries, list, [](Reader& r, const Value& object, RoadFields& road) {
    r.names.roads.emplace(road.name, static_cast<int>(r.names.roads.size()));
    if (road.from_host) lay_host_plane(r, object, road);
    if (road.iso_8608) read_iso_road(r, *road.iso_8608, road);
    if (road.profile) read_profile(r, *road.profile, road);
    if (road.crg) read_crg_road(r, *road.crg, road);
    read_parts(r, road.feature_map, road.features, check_feature);
    read_parts(r, road.patch_map, road.patches,
               [](Reader& inner, const Value& value, const RoadPatch& patch) { check_sides(inner, value, patch); });
  });
  for (const RoadFields& road : list) reader.model.roads.push_back(road);
}

}  // namespace mbgen::reading
