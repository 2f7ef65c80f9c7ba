#include "workbench/import/sdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "workbench/import/known.hpp"
#include "workbench/import/stl.hpp"

namespace mbgen::importing {
namespace {

/// Mass, centre of mass and inertia in the axes of the link.
void read_inertial(Reading& reading, const Element& link, BodyDraft& body, std::vector<std::string>& without) {
  const Element* inertial = child(link, "inertial");
  body.title = "link " + quoted_text(text_of(link, "name"));
  body.inertia_spot = inertial ? inertial->spot : link.spot;
  body.mass = 1;
  body.inertia = Matrix3d::Identity();
  if (!inertial) return without.push_back(text_of(link, "name"));
  if (attribute_truth(reading, *inertial, "auto"))
    return problem(reading, inertial->spot, fmt::format("{}: inertia from shapes is not computed", body.title),
                   "write <mass> and <inertia> of the link");
  body.mass = inner_number(reading, *inertial, "mass", 1);
  if (body.mass < 0)
    problem(reading, inertial->spot, fmt::format("{}: mass is negative, {:.6g} kg", body.title, body.mass));
  const Isometry3d frame = read_pose(reading, child(*inertial, "pose"));
  body.com = frame.translation();
  Matrix3d written = Matrix3d::Identity();
  if (const Element* inertia = child(*inertial, "inertia")) {
    const auto entry = [&](const char* name, double fallback) {
      return inner_number(reading, *inertia, name, fallback);
    };
    const double xx = entry("ixx", 1), yy = entry("iyy", 1), zz = entry("izz", 1);
    const double xy = entry("ixy", 0), xz = entry("ixz", 0), yz = entry("iyz", 0);
    written << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  }
  body.inertia = frame.linear() * written * frame.linear().transpose();
}

/// A box about the middle of a frame, along the axes of the link.
void lay_box(const Isometry3d& frame, const Vector3d& half_edges, ShapeDraft& shape) {
  const Vector3d half = frame.linear().cwiseAbs() * half_edges;
  shape.type = "box";
  shape.from = frame.translation() - half;
  shape.to = frame.translation() + half;
}

/// The box around a mesh in STL beside the file. Result: whether there is one.
bool read_mesh(Reading& reading, const Element& mesh, const Isometry3d& frame, ShapeDraft& shape) {
  const std::string& file = reading.sources[static_cast<std::size_t>(mesh.spot.file)].file;
  const std::optional<MeshBox> box = box_of_mesh(reading.request, file, inner_text(mesh, "uri"));
  const Element* written = child(mesh, "scale");
  const auto factors = written ? numbers(reading, {"scale", written->text, written->spot}, 3, 3) : std::nullopt;
  if (!box) return false;
  const Vector3d scale = factors ? Vector3d((*factors)[0], (*factors)[1], (*factors)[2]) : Vector3d(1, 1, 1);
  const Vector3d centre = scale.cwiseProduct(0.5 * (box->least + box->most));
  lay_box(frame * Eigen::Translation3d(centre), scale.cwiseAbs().cwiseProduct(0.5 * (box->most - box->least)), shape);
  return true;
}

/// A visual as a shape of its link. Result: whether it is drawn.
bool read_shape(Reading& reading, const Element& visual, ShapeDraft& shape) {
  const Element* geometry = child(visual, "geometry");
  const Isometry3d frame = read_pose(reading, child(visual, "pose"));
  shape.from = frame.translation();
  for (const Element& element : geometry ? geometry->children : std::vector<Element>()) {
    if (element.name == "sphere" || element.name == "cylinder") {
      shape.type = element.name;
      shape.radius = inner_number(reading, element, "radius", 0);
      const Vector3d half(0, 0, 0.5 * inner_number(reading, element, "length", 0));
      shape.to = frame * half;
      if (element.name == "cylinder") shape.from = frame * Vector3d(-half);
      return shape.radius > 0;
    }
    const Element* size = element.name == "box" ? child(element, "size") : nullptr;
    const auto edges = size ? numbers(reading, {"size", size->text, size->spot}, 3, 3) : std::nullopt;
    if (element.name == "mesh" && read_mesh(reading, element, frame, shape)) return true;
    if (!edges) continue;
    lay_box(frame, 0.5 * Vector3d((*edges)[0], (*edges)[1], (*edges)[2]), shape);
    return true;
  }
  return false;
}

std::string diffuse_colour(Reading& reading, const Element& visual) {
  const Element* material = child(visual, "material");
  const Element* diffuse = material ? child(*material, "diffuse") : nullptr;
  const auto values = diffuse ? numbers(reading, {"diffuse", diffuse->text, diffuse->spot}, 3, 4) : std::nullopt;
  if (!values) return {};
  const auto byte = [&](std::size_t i) { return std::lround(255 * std::clamp((*values)[i], 0.0, 1.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2));
}

}  // namespace

void add_sdf_links(Reading& reading, SdfModel& model, Assembly& assembly) {
  std::vector<std::string> without;
  for (const Element* link : model.links) {
    const std::string name = text_of(*link, "name");
    BodyDraft body{.name = unique_name(name, assembly.body_names)};
    if (body.name != name) body.comment = "link " + quoted_text(name);
    if (const auto pose = frame_pose(reading, model, name, *link)) body.pose = model.pose * *pose;
    read_inertial(reading, *link, body, without);
    model.body_of[name] = static_cast<int>(assembly.bodies.size());
    assembly.bodies.push_back(std::move(body));
  }
  if (!without.empty())
    note(reading, model.element->spot,
         fmt::format("without <inertial>: {}; the format gives such a link 1 kg and 1 kg m^2", few_names(without)));
}

void add_sdf_shapes(Reading& reading, const SdfModel& model, Assembly& assembly) {
  const Element *first = nullptr, *mesh = nullptr;
  int count = 0;
  for (const Element* link : model.links) {
    for (const Element& visual : link->children) {
      if (visual.name != "visual") continue;
      ShapeDraft shape{.body = model.body_of.at(text_of(*link, "name"))};
      if (!read_shape(reading, visual, shape)) {
        if (count++ == 0) first = &visual;
        continue;
      }
      const Element* geometry = child(visual, "geometry");
      if (!mesh && geometry) mesh = child(*geometry, "mesh");
      shape.colour = diffuse_colour(reading, visual);
      shape.name = unique_name(text_of(*link, "name"), assembly.shape_names);
      assembly.shapes.push_back(std::move(shape));
    }
  }
  if (mesh) note(reading, mesh->spot, "meshes are drawn as the boxes around them");
  if (first)
    note(reading, first->spot,
         fmt::format(
             "<visual>{} not carried over: only boxes, cylinders, spheres and the boxes around STL meshes beside "
             "the file are drawn",
             count > 1 ? fmt::format(" ({} of them)", count) : ""));
}

void import_sdf(Reading& reading, const Element& root, Assembly& assembly) {
  if (reading.request.loops)
    return problem(reading, root.spot, "an SDF model takes no file of loops",
                   "its joints may form loops: write the joint into the model");
  note_left_out(reading, root, kSdf);
  std::optional<SdfModel> model = read_sdf(reading, root, assembly);
  if (!model || !reading.problems.empty()) return;
  assembly.name = text_of(*model->element, "name");
  add_sdf_links(reading, *model, assembly);
  if (!reading.problems.empty()) return;
  add_sdf_joints(reading, *model, assembly);
  if (!reading.problems.empty()) return;
  add_sdf_shapes(reading, *model, assembly);
  check_inertias(reading, assembly);
  if (!assembly.frictions.empty()) {
    note(reading, root.spot,
         fmt::format("friction of {} joint{} is smoothed below {} rad/s or m/s", assembly.frictions.size(),
                     assembly.frictions.size() == 1 ? "" : "s", kFrictionVelocity));
  }
}

}  // namespace mbgen::importing
