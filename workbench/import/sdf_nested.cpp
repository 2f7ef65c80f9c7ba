// SDF: models inside of models, and included files, taken into one model with names NAME::INNER.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "workbench/import/known.hpp"
#include "workbench/import/sdf.hpp"

namespace mbgen::importing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepest = 32, kMostIncludes = 1000;
constexpr const char* kModel = "__model__";

/// Names of a nested model as the model around it has them.
struct Scope {
  std::string prefix;       ///< "NAME::"
  std::string model_frame;  ///< of its `__model__`
  std::string outer(const std::string& name) const {
    if (name.empty() || name == "world") return name;
    return name == kModel ? model_frame : prefix + name;
  }
};

void set_attribute(Element& element, const std::string& name, const std::string& value) {
  for (Attribute& attribute : element.attributes) {
    if (attribute.name != name) continue;
    attribute.value = value;
    return;
  }
  element.attributes.push_back({name, value, element.spot});
}

Element* inner(Element& element, std::string_view name) {
  for (Element& one : element.children)
    if (one.name == name) return &one;
  return nullptr;
}

Element& inner_or_new(Element& element, const std::string& name) {
  if (Element* found = inner(element, name)) return *found;
  element.children.push_back({.name = name, .spot = element.spot, .attributes = {}, .children = {}});
  return element.children.back();
}

/// Lets the pose be relative to a frame around the nested model; without one to `fallback`, where that is given.
void rename_pose(Element& element, const Scope& scope, const std::string& fallback) {
  const Element* given = child(element, "pose");
  const std::string base = given ? scope.outer(text_of(*given, "relative_to")) : "";
  if (!base.empty() || !fallback.empty())
    set_attribute(inner_or_new(element, "pose"), "relative_to", base.empty() ? fallback : base);
}

/// Writes down the frame that the version of the axis' own file means. joint: name as the model around it has it.
void rename_axis(Reading& reading, Element& axis, const Scope& scope, const std::string& joint, double version) {
  const std::string& meant = is_axis_of_model(reading, axis, version) ? scope.model_frame : joint;
  Element& xyz = inner_or_new(axis, "xyz");
  if (xyz.text.empty()) xyz.text = "0 0 1";
  const std::string frame = scope.outer(text_of(xyz, "expressed_in"));
  set_attribute(xyz, "expressed_in", frame.empty() ? meant : frame);
  if (Element* mimic = inner(axis, "mimic")) set_attribute(*mimic, "joint", scope.outer(text_of(*mimic, "joint")));
}

/// A link, joint or frame of a nested model with the names that the model around it has for everything.
Element renamed(Reading& reading, Element element, const Scope& scope, double version) {
  const std::string name = text_of(element, "name");
  if (!name.empty()) set_attribute(element, "name", scope.outer(name));
  if (element.name == "link") rename_pose(element, scope, scope.model_frame);
  if (element.name == "frame") {
    const std::string attached = text_of(element, "attached_to");
    set_attribute(element, "attached_to", attached.empty() ? scope.model_frame : scope.outer(attached));
    rename_pose(element, scope, "");
  }
  if (element.name != "joint") return element;
  for (const char* end : {"parent", "child", "gearbox_reference_body"})
    if (Element* at = inner(element, end)) at->text = scope.outer(at->text);
  for (const char* axis : {"axis", "axis2"})
    if (Element* at = inner(element, axis)) rename_axis(reading, *at, scope, scope.outer(name), version);
  rename_pose(element, scope, "");
  return element;
}

/// Numbers of a pose as <pose> has them.
std::string placement_text(const Isometry3d& pose) {
  const Eigen::Quaterniond turn(pose.linear());
  const Vector3d at = pose.translation();
  return fmt::format("{} {} {} {} {} {} {}", at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w());
}

struct Nesting {
  Reading& reading;
  std::vector<std::string> open_files;
  std::size_t includes = 0;

  /// Adds a model with its links, joints and frames under its name. placed: element that places it, the model itself or
  /// an <include>.
  void add(const Element& model, const Element& placed, const std::string& name, double version, std::size_t depth,
           Element& into) {
    if (inner_truth(reading, model, "static") || inner_truth(reading, placed, "static"))
      return problem(reading, placed.spot, fmt::format("static model {} inside a model is not read", quoted_text(name)),
                     "connect it to the world by a fixed joint");
    const std::optional<Element> flat = flattened(model, version, depth + 1);
    if (!flat) return;
    const bool is_merged = attribute_truth(reading, placed, "merge");
    const Scope scope = is_merged ? Scope{"", fmt::format("_merged__{}__model__", name)} : Scope{name + "::", name};
    into.children.push_back(model_frame(model, *flat, placed, scope));
    for (const Element& element : flat->children)
      if (element.name == "link" || element.name == "joint" || element.name == "frame")
        into.children.push_back(renamed(reading, element, scope, version));
  }

  /// The frame of a nested model, by the pose of the frame that it is placed by.
  Element model_frame(const Element& model, const Element& flat, const Element& placed, const Scope& scope) {
    Element frame{.name = "frame", .spot = placed.spot, .attributes = {}, .children = {}};
    set_attribute(frame, "name", scope.model_frame);
    set_attribute(frame, "attached_to", scope.outer(canonical_link(flat)));
    const Element* pose = child(placed, "pose") ? child(placed, "pose") : child(model, "pose");
    Isometry3d place = read_pose(reading, pose);
    std::string by = inner_text(placed, "placement_frame");
    if (by.empty()) by = text_of(model, "placement_frame");
    if (!by.empty())
      if (const auto at = pose_in(reading, flat, by, placed)) place = place * at->inverse();
    Element written{.name = "pose", .spot = pose ? pose->spot : placed.spot, .attributes = {}, .children = {}};
    written.text = placement_text(place);
    const std::string base = pose ? text_of(*pose, "relative_to") : "";
    set_attribute(written, "relative_to", base.empty() ? kModel : base);
    set_attribute(written, "rotation_format", "quat_xyzw");
    frame.children.push_back(std::move(written));
    return frame;
  }

  /// Text of the first of the paths that can be read, with its path.
  std::optional<std::pair<std::string, std::string>> first_of(const std::vector<fs::path>& paths) {
    for (const fs::path& path : paths) {
      std::optional<std::string> text = reading.request.read ? reading.request.read(path.string()) : std::nullopt;
      if (text && !text->empty()) return std::pair(path.string(), std::move(*text));
    }
    return std::nullopt;
  }

  /// The files that a URI may mean, beside the file that includes it; of a folder its model.sdf.
  std::vector<fs::path> candidates(std::string uri) const {
    const fs::path folder = fs::path(open_files.back()).parent_path();
    std::vector<fs::path> places;
    const auto after = [&](std::string_view scheme) { return fs::path(uri.substr(scheme.size())); };
    if (uri.starts_with("model://")) {
      for (const fs::path& beside : {folder, folder / ".."})
        places.push_back((beside / after("model://")).lexically_normal());
    } else {
      places.push_back((folder / (uri.starts_with("file://") ? after("file://") : fs::path(uri))).lexically_normal());
    }
    std::vector<fs::path> files;
    for (const fs::path& place : places) {
      if (place.has_extension()) files.push_back(place);
      files.push_back(place / "model.sdf");
    }
    return files;
  }

  void include(const Element& element, std::size_t depth, Element& into) {
    const std::string uri = inner_text(element, "uri");
    const std::size_t scheme = uri.find("://");
    const bool is_local = scheme == std::string::npos || uri.starts_with("file://") || uri.starts_with("model://");
    const auto file = is_local && !uri.empty() ? first_of(candidates(uri)) : std::nullopt;
    if (!file)
      return problem(reading, element.spot, fmt::format("<include> of {} cannot be read", quoted_text(uri)),
                     "files are read beside the file: NAME.sdf, file://NAME.sdf, and model.sdf of model://NAME");
    const auto& [path, text] = *file;
    if (std::ranges::count(open_files, path) > 0)
      return problem(reading, element.spot, fmt::format("{} includes itself", quoted_text(path)));
    if (++includes > kMostIncludes)
      return problem(reading, element.spot, fmt::format("more than {} files are included", kMostIncludes));
    const std::optional<Element> root = read_xml(reading, path, text);
    if (!root) return;
    const Element* model = root->name == "sdf" ? child(*root, "model") : nullptr;
    if (!model) return problem(reading, element.spot, fmt::format("{} has no <sdf> with a <model>", quoted_text(path)));
    note_left_out(reading, *root, kSdf);
    const std::string named = inner_text(element, "name");
    open_files.push_back(path);
    add(*model, element, named.empty() ? text_of(*model, "name") : named, sdf_version(reading, *root), depth, into);
    open_files.pop_back();
  }

  /// The model with models and includes inside of it taken into it. Fails (nothing, with a problem): nested too deeply.
  std::optional<Element> flattened(const Element& model, double version, std::size_t depth) {
    if (depth > kDeepest) {
      problem(reading, model.spot, fmt::format("models are nested deeper than {} levels", kDeepest));
      return std::nullopt;
    }
    Element flat{.name = model.name, .spot = model.spot, .attributes = model.attributes, .children = {}};
    for (const Element& element : model.children) {
      if (element.name == "model")
        add(element, element, text_of(element, "name"), version, depth, flat);
      else if (element.name == "include")
        include(element, depth, flat);
      else
        flat.children.push_back(element);
    }
    return flat;
  }
};

}  // namespace

Element with_nested_models(Reading& reading, const Element& model, double version) {
  Nesting nesting{reading, {reading.request.file}};
  return nesting.flattened(model, version, 0).value_or(Element{model.name, model.spot, {}, {}});
}

}  // namespace mbgen::importing
