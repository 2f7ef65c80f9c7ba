// URDF: visuals of links, as shapes of the model.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "workbench/import/stl.hpp"
#include "workbench/import/urdf.hpp"

namespace mbgen::importing {
namespace {

using Colours = std::map<std::string, std::string, std::less<>>;

/// "#rrggbb" of a <color rgba>, "" without one.
std::string colour_of(Reading& reading, const Element& material) {
  const Element* colour = child(material, "color");
  const Attribute* rgba = colour ? attribute(*colour, "rgba") : nullptr;
  const auto values = rgba ? numbers(reading, *rgba, 3, 4) : std::nullopt;
  if (!values) return {};
  const auto byte = [&](std::size_t i) { return std::lround(255 * std::clamp((*values)[i], 0.0, 1.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2));
}

/// Named materials of the robot.
Colours named_colours(Reading& reading, const Element& root) {
  Colours colours;
  for (const Element& element : root.children) {
    if (element.name == "material") colours[text_of(element, "name")] = colour_of(reading, element);
  }
  return colours;
}

/// Visuals that are not drawn: the first, and their number.
struct Lost {
  const Element* first = nullptr;
  int count = 0;
  void add(const Element& element) {
    if (count++ == 0) first = &element;
  }
  std::string times() const { return count > 1 ? fmt::format(" ({} of them)", count) : std::string(); }
};

/// A mesh file, and its visuals.
struct MeshUse {
  std::optional<MeshBox> box;
  std::string first, last;  ///< links
  Lost links;               ///< by their visuals
};

struct VisualReader {
  Reading& reading;
  Assembly& assembly;
  Colours colours;
  Lost turned, unread;
  std::map<std::string, MeshUse> meshes;  ///< by file name, as the robot's file writes it

  /// A box along the axes of the body; a rotated box becomes its bounding box.
  void box(const Element& visual, const Element& size, const Isometry3d& frame, ShapeDraft& shape) {
    const Attribute* text = attribute(size, "size");
    const auto edges = text ? numbers(reading, *text, 3, 3) : std::nullopt;
    if (edges) lay_box(visual, 0.5 * Vector3d((*edges)[0], (*edges)[1], (*edges)[2]), frame, shape);
  }

  void lay_box(const Element& visual, const Vector3d& half, const Isometry3d& frame, ShapeDraft& shape) {
    constexpr double kAligned = 1e-6;
    const Matrix3d sizes = frame.linear().cwiseAbs();
    if ((sizes - sizes.array().round().matrix()).cwiseAbs().maxCoeff() > kAligned) turned.add(visual);
    shape.type = "box";
    shape.from = frame.translation() - sizes * half;
    shape.to = frame.translation() + sizes * half;
  }

  /// The bounding box of a mesh. Result: whether it is drawn.
  bool mesh(const Element& visual, const Element& element, const UrdfLink& link, const Isometry3d& frame,
            ShapeDraft& shape) {
    const std::string name = text_of(element, "filename");
    const auto [place, is_new] = meshes.try_emplace(name);
    MeshUse& use = place->second;
    if (is_new) use.box = box_of_mesh(reading.request, reading.request.file, name);
    if (is_new) use.first = link.name;
    if (is_new || use.last != link.name) use.links.add(visual);
    use.last = link.name;
    if (!use.box) return false;
    const Attribute* text = attribute(element, "scale");
    const auto factors = text ? numbers(reading, *text, 3, 3) : std::optional(std::vector<double>{1, 1, 1});
    if (!factors) return false;
    const Vector3d scale((*factors)[0], (*factors)[1], (*factors)[2]);
    const Vector3d centre = scale.cwiseProduct(0.5 * (use.box->least + use.box->most));
    const Vector3d half = scale.cwiseAbs().cwiseProduct(0.5 * (use.box->most - use.box->least));
    lay_box(visual, half, frame * Eigen::Translation3d(centre), shape);
    return true;
  }

  void read(const Element& visual, const UrdfLink& link) {
    const Element* geometry = child(visual, "geometry");
    const Isometry3d frame = read_inner_origin(reading, visual);
    ShapeDraft shape{.body = link.body, .from = frame.translation()};
    for (const Element& element : geometry ? geometry->children : std::vector<Element>()) {
      if (element.name == "box") box(visual, element, frame, shape);
      if (element.name == "mesh" && !mesh(visual, element, link, frame, shape)) return;
      if (element.name == "sphere" || element.name == "cylinder") {
        shape.type = element.name;
        shape.radius = number(reading, element, "radius", 0);
        const Vector3d half(0, 0, 0.5 * number(reading, element, "length", 0));
        shape.to = frame * half;
        if (element.name == "cylinder") shape.from = frame * Vector3d(-half);
      }
    }
    const bool is_round = shape.type == "sphere" || shape.type == "cylinder";
    if (shape.type.empty() || (is_round && !(shape.radius > 0))) return unread.add(visual);
    if (const Element* material = child(visual, "material")) {
      shape.colour = colour_of(reading, *material);
      const auto named = colours.find(text_of(*material, "name"));
      if (shape.colour.empty() && named != colours.end()) shape.colour = named->second;
    }
    shape.name = unique_name(link.name, assembly.shape_names);
    assembly.shapes.push_back(std::move(shape));
  }
};

}  // namespace

void add_visuals(Reading& reading, const Element& root, const UrdfRobot& robot, Assembly& assembly) {
  VisualReader reader{reading, assembly, named_colours(reading, root), {}, {}, {}};
  for (const UrdfLink& link : robot.links) {
    for (const Element& element : link.element->children) {
      if (element.name == "visual") reader.read(element, link);
    }
  }
  for (const auto& [name, use] : reader.meshes) {
    const int more = use.links.count - 1;
    note(reading, use.links.first->spot,
         fmt::format("link {}{}: mesh {} {}", quoted_text(use.first), more > 0 ? fmt::format(" and {} more", more) : "",
                     quoted_text(name),
                     use.box ? "is drawn as the box around it" : "is not drawn, no STL file of this name lies beside"),
         use.box ? "" : "only boxes, cylinders, spheres and the boxes around STL meshes are drawn");
  }
  const Lost &turned = reader.turned, &unread = reader.unread;
  if (unread.count > 0) {
    note(reading, unread.first->spot,
         fmt::format("<visual>{} not carried over: only boxes, cylinders and spheres are drawn", unread.times()));
  }
  if (turned.count > 0) {
    note(
        reading, turned.first->spot,
        fmt::format("<visual>{} is a box turned in its link: the smallest box around it along the link's axes is drawn",
                    turned.times()));
  }
}

}  // namespace mbgen::importing
