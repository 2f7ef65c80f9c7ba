// Cross-sections of beams: area, second moments, torsion constant.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/reader/elements/beam.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 10> kSectionKeys = {"diameter", "wall", "width", "height", "flange",
                                                           "web",      "A",    "Iy",    "Iz",     "J"};

/// Keys that a shape needs; a box may be without wall.
std::vector<std::string_view> keys_of(BeamShape shape) {
  switch (shape) {
    case BeamShape::round:
      return {"diameter"};
    case BeamShape::tube:
      return {"diameter", "wall"};
    case BeamShape::box:
      return {"width", "height"};
    case BeamShape::i:
      return {"width", "height", "flange", "web"};
    case BeamShape::general:
      return {"A", "Iy", "Iz", "J"};
  }
  return {};
}

bool check_section_keys(Reader& reader, const Value& value, BeamShape shape) {
  const std::vector<std::string_view> needed = keys_of(shape);
  const std::string_view word = kBeamShapes[static_cast<std::size_t>(shape)];
  bool is_good = true;
  for (const std::string_view key : kSectionKeys) {
    const bool is_needed = std::ranges::find(needed, key) != needed.end(), is_there = find(value, key) != nullptr;
    const bool is_allowed = is_needed || (shape == BeamShape::box && key == "wall");
    if (is_needed && !is_there) report(reader, value, fmt::format("a section \"{}\" needs {}", word, in_quotes(key)));
    if (is_there && !is_allowed)
      report(reader, *find(value, key), fmt::format("a section \"{}\" has no {}", word, in_quotes(key)));
    is_good = is_good && is_needed <= is_there && is_there <= is_allowed;
  }
  return is_good;
}

BeamSection ring(double outer, double inner) {
  const double area = std::numbers::pi / 4 * (outer * outer - inner * inner);
  const double bending = std::numbers::pi / 64 * (std::pow(outer, 4) - std::pow(inner, 4));
  return {area, bending, bending, 2 * bending};
}

/// Source of the torsion of a solid rectangle: R. J. Roark, Formulas for Stress and Strain, table 20, 4 % at most;
/// of a hollow one: R. Bredt, 1896, constant shear flow along the middle of the wall.
BeamSection box(double width, double height, std::optional<double> wall) {
  const double in_width = wall ? width - 2 * *wall : 0, in_height = wall ? height - 2 * *wall : 0;
  BeamSection section;
  section.area = width * height - in_width * in_height;
  section.iy = (width * std::pow(height, 3) - in_width * std::pow(in_height, 3)) / 12;
  section.iz = (height * std::pow(width, 3) - in_height * std::pow(in_width, 3)) / 12;
  const double a = std::max(width, height), b = std::min(width, height), slimness = b / a;
  section.j = a * std::pow(b, 3) * (1.0 / 3 - 0.21 * slimness * (1 - std::pow(slimness, 4) / 12));
  if (wall) {
    const double w = width - *wall, h = height - *wall;
    section.j = 2 * *wall * w * w * h * h / (w + h);
  }
  return section;
}

/// Torsion of an open section of thin walls: the sum of length thickness^3 / 3.
BeamSection i_beam(const BeamSectionFields& f) {
  const double width = *f.width, height = *f.height, flange = *f.flange, web = *f.web, between = height - 2 * flange;
  BeamSection section;
  section.area = 2 * width * flange + between * web;
  section.iy = (width * std::pow(height, 3) - (width - web) * std::pow(between, 3)) / 12;
  section.iz = (2 * flange * std::pow(width, 3) + between * std::pow(web, 3)) / 12;
  section.j = (2 * width * std::pow(flange, 3) + (height - flange) * std::pow(web, 3)) / 3;
  return section;
}

/// Whether walls fit into the outer dimensions.
bool check_walls(Reader& reader, const Value& value, const BeamSectionFields& f) {
  const auto fits = [&](std::string_view key, std::optional<double> inner, double most) {
    if (!inner || *inner < most) return true;
    report(reader, *find(value, key), fmt::format("must be less than {:g} m, got {:g} m", most, *inner));
    return false;
  };
  if (f.shape == BeamShape::tube) return fits("wall", f.wall, *f.diameter / 2 * (1 + 1e-12));
  if (f.shape == BeamShape::box) return fits("wall", f.wall, std::min(*f.width, *f.height) / 2);
  if (f.shape == BeamShape::i) return fits("flange", f.flange, *f.height / 2) && fits("web", f.web, *f.width);
  return true;
}

}  // namespace

std::optional<BeamSection> read_beam_section(Reader& reader, const Value& value) {
  const std::size_t problems = reader.problems.size();
  BeamSectionFields f = with_defaults<BeamSectionFields>();
  if (!read_fields(reader, value, f) || reader.problems.size() > problems) return {};
  if (!check_section_keys(reader, value, f.shape) || !check_walls(reader, value, f)) return {};
  switch (f.shape) {
    case BeamShape::round:
      return ring(*f.diameter, 0);
    case BeamShape::tube:
      return ring(*f.diameter, *f.diameter - 2 * *f.wall);
    case BeamShape::box:
      return box(*f.width, *f.height, f.wall);
    case BeamShape::i:
      return i_beam(f);
    case BeamShape::general:
      return BeamSection{*f.area, *f.iy, *f.iz, *f.j};
  }
  return {};
}

}  // namespace mbgen::reading
