// Tables of fields: roads.
#include <array>

#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 2> kRoadLocals = {"x", "y"};
constexpr const char* kTrack = "distance of the left and the right track";
/// In the order of IsoRoadFields::Class.
constexpr std::array<std::string_view, 8> kRoadClasses = {"A", "B", "C", "D", "E", "F", "G", "H"};
/// In the order of RoadBorder.
constexpr std::array<std::string_view, 5> kBorders = {"keep", "zero", "repeat", "reflect", "refuse"};
/// In the order of RoadFeature::Kind.
constexpr std::array<std::string_view, 5> kFeatures = {"bump", "plank", "pothole", "sine", "sweep"};

FieldInfo length(std::string_view name, std::string_view doc, Bound bound = Bound::none) {
  return {.name = name, .doc = doc, .unit = "m", .bound = bound, .depends = Depends::motion};
}

FieldInfo over_place(std::string_view name, std::string_view doc, std::string_view unit) {
  return {
      .name = name, .shape = Shape::force, .doc = doc, .unit = unit, .depends = Depends::motion, .locals = kRoadLocals};
}

FieldInfo slope(std::string_view name, std::string_view doc) {
  return {.name = name, .doc = doc, .unit = "1", .fallback = 0, .depends = Depends::motion};
}

FieldInfo number(std::string_view name, std::string_view doc, std::string_view unit, double fallback, Bound bound) {
  return constant_info(name, doc, unit, fallback, bound, Depends::parameters);
}

/// Fields of the position of a feature or patch.
template <class S>
auto stretch_fields(std::string_view doc_of_length) {
  FieldInfo from = length("from", "x where it begins");
  from.fallback = 0;
  return std::array{
      field<S, &S::from>(from),
      field<S, &S::length>(length("length", doc_of_length, Bound::positive)),
      field<S, &S::right>(length("right", "y of its right side; default: the right side of the road")),
      field<S, &S::left>(length("left", "y of its left side; default: the left side of the road")),
  };
}

}  // namespace

template <>
std::span<const Field<RoadFeature>> fields<RoadFeature>() {
  using S = RoadFeature;
  static const std::array table = joined(
      std::array{
          field<S, &S::kind>({.name = "type",
                              .shape = Shape::word,
                              .doc = "h sin^2(pi u/length); a plank; a plank that goes down; h sin(2 pi u/wave_length "
                                     "+ phase); the same with wave numbers that grow linearly over the length from "
                                     "1/wave_length to 1/last_wave_length. u: x less from",
                              .need = Need::required,
                              .words = kFeatures}),
          field<S, &S::height>({.name = "height",
                                .doc = "height of a bump or plank, depth of a pothole, amplitude of a sine or sweep",
                                .unit = "m",
                                .need = Need::required,
                                .depends = Depends::motion}),
          field<S, &S::ramp>({.name = "ramp",
                              .shape = Shape::number,
                              .doc = "of a plank or pothole, and of a sine or sweep with a length, which grows and "
                                     "fades along it: length of the smooth ramps at both ends, inside its length; 0 "
                                     "makes steps",
                              .unit = "m",
                              .fallback = 0.05,
                              .bound = Bound::not_negative,
                              .depends = Depends::nothing}),
          field<S, &S::wave_length>(length("wave_length", "of a sine; of a sweep at its beginning", Bound::positive)),
          field<S, &S::last_wave_length>(length("last_wave_length", "of a sweep at its end", Bound::positive)),
          field<S, &S::phase>({.name = "phase",
                               .doc = "of a sine or sweep where it begins",
                               .unit = "rad",
                               .fallback = 0,
                               .depends = Depends::motion,
                               .angle = true}),
      },
      stretch_fields<S>("its length along the road; a sine without one has no ends"));
  return table;
}

template <>
std::span<const Field<RoadPatch>> fields<RoadPatch>() {
  using S = RoadPatch;
  static const std::array table =
      joined(std::array{field<S, &S::friction>({.name = "friction",
                                                .doc = "factor of the friction of tyres on it",
                                                .unit = "1",
                                                .need = Need::required,
                                                .bound = Bound::not_negative,
                                                .depends = Depends::motion})},
             stretch_fields<S>("its length along the road; default: infinite"));
  return table;
}

template <>
std::span<const Field<IsoRoadFields>> fields<IsoRoadFields>() {
  using S = IsoRoadFields;
  static const std::array table = {
      field<S, &S::letter>(
          {.name = "class",
           .shape = Shape::word,
           .doc = "class: the spectral density is the geometric mean of its band, 16e-6 m^3 for A and four times the "
                  "previous class for the others; it falls with the square of the wave number",
           .need = Need::required,
           .words = kRoadClasses}),
      field<S, &S::seed>(number("seed", "whole number, seed of the random phases", "", 1, Bound::not_negative)),
      field<S, &S::length>(number("length", "period of the road, which repeats smoothly", "m", 250, Bound::positive)),
      field<S, &S::track>(number("track", kTrack, "m", 2, Bound::positive)),
      field<S, &S::coherence>(
          number("coherence",
                 "of the two tracks, squared as usual, at a wave length of 10 m; its logarithm grows with the wave "
                 "number, so that long waves are equal on both sides; 1: all waves are equal, 0: none is",
                 "1", 0.5, Bound::not_negative)),
      field<S, &S::longest_wave>(number("longest_wave", "longest wave length of the road", "m", 90, Bound::positive)),
      field<S, &S::shortest_wave>(
          number("shortest_wave", "shortest wave length of the road", "m", 0.35, Bound::positive)),
  };
  return table;
}

template <>
std::span<const Field<RoadProfileFields>> fields<RoadProfileFields>() {
  using S = RoadProfileFields;
  const auto column = [](std::string_view name, std::string_view doc) {
    return FieldInfo{.name = name, .shape = Shape::text, .doc = doc};
  };
  static const std::array table = {
      field<S, &S::csv>({.name = "csv",
                         .shape = Shape::text,
                         .doc = "file with the heights, relative to this file: a line with the names of the columns, "
                                "then numbers separated by commas",
                         .need = Need::required}),
      field<S, &S::x>(column("x", "column of x along the road, m, at equal distances; default: the first")),
      field<S, &S::z>(column("z", "column of the height, m; default: the second")),
      field<S, &S::right>(column("right", "column of the height of the right track, m; needs left")),
      field<S, &S::left>(column("left", "column of the height of the left track, m; needs right")),
      field<S, &S::track>(number("track", kTrack, "m", 2, Bound::positive)),
  };
  return table;
}

template <>
std::span<const Field<CrgFields>> fields<CrgFields>() {
  using S = CrgFields;
  const auto zone = [](std::string_view name, std::string_view doc) {
    return number(name, doc, "m", 0, Bound::not_negative);
  };
  static const std::array table = {
      field<S, &S::file>({.name = "file",
                          .shape = Shape::text,
                          .doc = "OpenCRG file, text or binary data, relative to this file",
                          .need = Need::required}),
      field<S, &S::smooth_begin>(
          zone("smooth_begin",
               "length over which heights grow from the reference line at its start; default: from the file, else 0")),
      field<S, &S::smooth_end>(
          zone("smooth_end", "length over which heights fade to the reference line at its end; likewise")),
      field<S, &S::beyond_ends>(
          {.name = "beyond_ends",
           .shape = Shape::word,
           .doc = "heights before its start and after its end: the border's, 0, the road repeated, its mirror image, "
                  "or none (refuse: a wheel there ends the motion); default: from the file, else keep",
           .words = kBorders}),
      field<S, &S::beyond_sides>(
          {.name = "beyond_sides", .shape = Shape::word, .doc = "likewise to its left and right", .words = kBorders}),
  };
  return table;
}

template <>
std::span<const Field<RoadFields>> fields<RoadFields>() {
  using S = RoadFields;
  static const std::array table = {
      field<S, &S::origin>(
          {.name = "origin",
           .shape = Shape::vector,
           .doc = "point with x = y = 0 of the road, in global axes, default [0, 0, 0]; its z is the zero of heights",
           .unit = "m",
           .depends = Depends::nothing}),
      field<S, &S::heading>({.name = "heading",
                             .shape = Shape::number,
                             .doc = "direction of its x, from the global one to the left",
                             .unit = "rad",
                             .fallback = 0,
                             .depends = Depends::nothing,
                             .angle = true}),
      field<S, &S::height>(over_place("height", "height over `x` and `y` (m) of the road; default: 0", "m")),
      field<S, &S::from_host>(
          {.name = "host",
           .shape = Shape::boolean,
           .doc = "true: a host gives the ground under the one wheel on it, as a plane: inputs NAME_x and NAME_y (a "
                  "position, m), NAME_height (m), NAME_slope_x and NAME_slope_y (there, global axes) and "
                  "NAME_friction, with the road's name as NAME",
           .fallback = 0}),
      field<S, &S::slope_x>(slope("slope_x",
                                  "slope along x of ground under a wheel given by inputs, beside `height`; added to "
                                  "the slopes of all heights")),
      field<S, &S::slope_y>(slope("slope_y", "likewise along y")),
      field<S, &S::friction>(
          over_place("friction", "factor of the friction of tyres, over `x` and `y` (m) of the road; default: 1", "1")),
      field<S, &S::iso_8608>({.name = "iso_8608",
                              .shape = Shape::object,
                              .doc = "an added rough road of a class of ISO 8608",
                              .of = "iso_road"}),
      field<S, &S::profile>({.name = "profile",
                             .shape = Shape::object,
                             .doc = "measured heights along it, from a file",
                             .of = "road_profile"}),
      field<S, &S::crg>({.name = "crg",
                         .shape = Shape::object,
                         .doc = "a road from an OpenCRG file, with the same x and y",
                         .of = "crg_road"}),
      field<S, &S::feature_map>({.name = "features",
                                 .shape = Shape::map,
                                 .doc = "bumps, planks, potholes, waves; heights of several are added",
                                 .of = "road_feature"}),
      field<S, &S::patch_map>({.name = "patches",
                               .shape = Shape::map,
                               .doc = "parts with their own friction; where several overlap, the last one counts",
                               .of = "road_patch"}),
  };
  return table;
}

}  // namespace mbgen::reading
