// SDF: the model of a file, its frames and their poses.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/import/sdf.hpp"

namespace mbgen::importing {
namespace {

constexpr const char* kModelFrame = "__model__";

std::string name_of(const Element& element) { return text_of(element, "name"); }

/// The truth that a text says, in the words of SDF; false where it is empty. Fails: with a problem.
bool truth_of(Reading& reading, const Attribute& written) {
  std::string text = written.value;
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (text == "true" || text == "1") return true;
  if (!text.empty() && text != "false" && text != "0")
    problem(reading, written.spot,
            fmt::format("{} takes true or false, got {}", written.name, quoted_text(written.value)));
  return false;
}

/// Adds a frame under its name.
void add_frame(Reading& reading, const Element& element, std::string fallback, std::string attached_to,
               SdfModel& model) {
  const std::optional<std::string> name = required_text(reading, element, "name");
  if (!name) return;
  if (*name == "world" || name->starts_with("__"))
    return problem(reading, element.spot, fmt::format("{} is a reserved name in SDF", quoted_text(*name)));
  const bool is_new =
      model.frames.try_emplace(*name, SdfFrame{&element, std::move(fallback), std::move(attached_to)}).second;
  if (!is_new)
    problem(reading, element.spot, fmt::format("{} is the name of two links, joints or frames", quoted_text(*name)));
}

/// whole: with nested models taken into it; links, joints and frames of the model point into it.
void read_members(Reading& reading, const Element& whole, SdfModel& model) {
  for (const Element& element : whole.children) {
    if (element.name == "link") {
      model.links.push_back(&element);
      add_frame(reading, element, kModelFrame, name_of(element), model);
    }
    if (element.name == "joint") {
      model.joints.push_back(&element);
      const std::string below = inner_text(element, "child");
      add_frame(reading, element, below, below, model);
    }
    if (element.name == "frame") {
      const std::string attached = text_of(element, "attached_to");
      const std::string base = attached.empty() ? kModelFrame : attached;
      add_frame(reading, element, base, base, model);
    }
  }
}

/// The models in an element, and their number.
std::vector<const Element*> models_in(const Element& element) {
  std::vector<const Element*> models;
  for (const Element& inner : element.children)
    if (inner.name == "model") models.push_back(&inner);
  return models;
}

/// The only model of a world that moves.
const Element* model_of_world(Reading& reading, const Element& world) {
  std::vector<const Element*> models = models_in(world);
  const auto is_static = [&](const Element* model) { return inner_truth(reading, *model, "static"); };
  if (models.size() > 1) {
    const auto first = std::find_if(models.begin(), models.end(), is_static);
    if (first != models.end()) note(reading, (*first)->spot, "static models of the world are left out");
    std::erase_if(models, is_static);
  }
  if (models.size() == 1) return models.front();
  problem(reading, world.spot, fmt::format("the world has {} models that move, one is read", models.size()),
          "write the model into a file of its own, in <sdf>");
  return nullptr;
}

void read_world(Reading& reading, const Element& world, Assembly& assembly) {
  assembly.gravity = Vector3d(0, 0, -9.8);  // default of the format
  if (const Element* gravity = child(world, "gravity"))
    if (const auto g = numbers(reading, {"gravity", gravity->text, gravity->spot}, 3, 3))
      assembly.gravity = Vector3d((*g)[0], (*g)[1], (*g)[2]);
  if (const Element* physics = child(world, "physics"))
    assembly.step = std::max(0.0, inner_number(reading, *physics, "max_step_size", 0));
}

/// Adds the problem of a name that no link, joint or frame has.
void tell_unknown(Reading& reading, std::string_view name, const Element& user) {
  problem(reading, user.spot, fmt::format("no link, joint or frame is named {}", quoted_text(name)));
}

}  // namespace

std::string inner_text(const Element& element, std::string_view name) {
  const Element* inner = child(element, name);
  return inner ? inner->text : "";
}

double inner_number(Reading& reading, const Element& element, std::string_view name, double fallback) {
  const Element* inner = child(element, name);
  if (!inner) return fallback;
  const auto values = numbers(reading, {std::string(name), inner->text, inner->spot}, 1, 1);
  return values ? values->front() : fallback;
}

double inner_limit(Reading& reading, const Element& element, std::string_view name, double fallback) {
  const Element* inner = child(element, name);
  if (!inner) return fallback;
  const auto values = limits(reading, {std::string(name), inner->text, inner->spot}, 1, 1);
  return values ? values->front() : fallback;
}

bool inner_truth(Reading& reading, const Element& element, std::string_view name) {
  const Element* inner = child(element, name);
  return inner && truth_of(reading, {std::string(name), inner->text, inner->spot});
}

bool attribute_truth(Reading& reading, const Element& element, std::string_view name) {
  const Attribute* written = attribute(element, name);
  return written && truth_of(reading, *written);
}

Isometry3d read_pose(Reading& reading, const Element* pose) {
  Isometry3d frame = Isometry3d::Identity();
  if (!pose || pose->text.empty()) return frame;
  const std::string format = text_of(*pose, "rotation_format");
  const bool is_quaternion = format == "quat_xyzw";
  if (!is_quaternion && !format.empty() && format != "euler_rpy")
    problem(reading, attribute(*pose, "rotation_format")->spot,
            fmt::format("unknown rotation_format {}", quoted_text(format)), "known: euler_rpy, quat_xyzw");
  const std::size_t count = is_quaternion ? 7 : 6;
  const auto values = numbers(reading, {"pose", pose->text, pose->spot}, count, count);
  if (!values) return frame;
  const std::vector<double>& v = *values;
  frame.translation() = Vector3d(v[0], v[1], v[2]);
  if (is_quaternion) {
    const Eigen::Quaterniond turn(v[6], v[3], v[4], v[5]);
    if (turn.norm() == 0) problem(reading, pose->spot, "quat_xyzw gives no orientation");
    if (turn.norm() > 0) frame.linear() = turn.normalized().toRotationMatrix();
    return frame;
  }
  const double unit = attribute_truth(reading, *pose, "degrees") ? std::numbers::pi / 180 : 1;
  frame.linear() = turn_of(unit * Vector3d(v[3], v[4], v[5]));
  return frame;
}

std::optional<Isometry3d> frame_pose(Reading& reading, const SdfModel& model, std::string_view name,
                                     const Element& user) {
  // Chains of frames may be as long as the file: no recursion, and poses that are known end a chain.
  std::vector<const SdfFrame*> chain;
  const Element* naming = &user;
  std::string at(name);
  while (!at.empty() && at != kModelFrame && at != "world") {
    const auto found = model.frames.find(at);
    if (found == model.frames.end()) {
      tell_unknown(reading, at, *naming);
      return std::nullopt;
    }
    if (chain.size() > model.frames.size()) {
      problem(reading, naming->spot, fmt::format("the pose of {} follows from itself", quoted_text(at)));
      return std::nullopt;
    }
    const SdfFrame& frame = found->second;
    chain.push_back(&frame);
    if (frame.pose) break;
    naming = frame.element;
    const Element* written = child(*frame.element, "pose");
    const std::string base = written ? text_of(*written, "relative_to") : "";
    at = base.empty() ? frame.fallback : base;
  }
  const bool is_in_world = at == "world";
  Isometry3d pose = is_in_world ? model.pose.inverse() : Isometry3d::Identity();
  for (auto frame = chain.rbegin(); frame != chain.rend(); ++frame) {
    pose = (*frame)->pose ? *(*frame)->pose : pose * read_pose(reading, child(*(*frame)->element, "pose"));
    if (!is_in_world) (*frame)->pose = pose;
  }
  return pose;
}

int body_of_frame(Reading& reading, const SdfModel& model, std::string_view name, const Element& user) {
  std::string at(name);
  for (std::size_t steps = 0; steps <= model.frames.size() + 1; ++steps) {
    if (at == "world") return kGroundDraft;
    if (at == kModelFrame) at = canonical_link(model.whole);
    if (const auto link = model.body_of.find(at); link != model.body_of.end()) return link->second;
    const auto found = model.frames.find(at);
    if (found == model.frames.end()) {
      tell_unknown(reading, at, user);
      return -1;
    }
    if (found->second.attached_to.empty()) {
      problem(reading, user.spot, fmt::format("frame {} is attached to no link", quoted_text(at)));
      return -1;
    }
    at = found->second.attached_to;
  }
  problem(reading, user.spot, fmt::format("frame {} is attached to itself", quoted_text(name)));
  return -1;
}

std::string canonical_link(const Element& flat) {
  if (const std::string named = text_of(flat, "canonical_link"); !named.empty()) return named;
  std::string first;
  for (const Element& element : flat.children) {
    if (element.name != "link") continue;
    const std::string name = name_of(element);
    if (name.find("::") == std::string::npos) return name;
    if (first.empty()) first = name;
  }
  return first;
}

double sdf_version(Reading& reading, const Element& root) {
  // 1.10 to 1.12 are later than 1.9.
  const std::string version = text_of(root, "version");
  if (version == "1.10" || version == "1.11" || version == "1.12") return 2;
  const Attribute* written = attribute(root, "version");
  const auto value = written ? numbers(reading, *written, 1, 1) : std::nullopt;
  return value ? value->front() : 0;
}

bool is_axis_of_model(Reading& reading, const Element& axis, double version) {
  return version < 1.45 || (version < 1.65 && inner_truth(reading, axis, "use_parent_model_frame"));
}

std::optional<Isometry3d> pose_in(Reading& reading, const Element& model, std::string_view name, const Element& user) {
  SdfModel alone;
  read_members(reading, model, alone);
  return frame_pose(reading, alone, name, user);
}

std::optional<SdfModel> read_sdf(Reading& reading, const Element& root, Assembly& assembly) {
  SdfModel model;
  model.version = sdf_version(reading, root);
  const Element* world = child(root, "world");
  const std::vector<const Element*> models = models_in(root);
  if (world) {
    model.element = model_of_world(reading, *world);
    read_world(reading, *world, assembly);
  } else if (models.size() == 1) {
    model.element = models.front();
  } else {
    problem(reading, root.spot, fmt::format("<{}> has {} models, one is read", root.name, models.size()));
  }
  if (!model.element) return std::nullopt;
  model.whole = with_nested_models(reading, *model.element, model.version);
  if (!reading.problems.empty()) return std::nullopt;
  read_members(reading, model.whole, model);
  if (model.links.empty()) problem(reading, model.element->spot, "model has no links");
  if (!reading.problems.empty()) return std::nullopt;
  const Element* pose = child(*model.element, "pose");
  model.pose = read_pose(reading, pose);
  if (const std::string base = pose ? text_of(*pose, "relative_to") : ""; !base.empty() && base != "world")
    note(reading, pose->spot,
         fmt::format("the pose of model {} is relative to {}, which is not read: it stands elsewhere by that frame",
                     quoted_text(name_of(*model.element)), quoted_text(base)),
         "write the pose relative to the world");
  if (const std::string placed = text_of(*model.element, "placement_frame"); !placed.empty())
    if (const auto frame = frame_pose(reading, model, placed, *model.element))
      model.pose = model.pose * frame->inverse();
  return model;
}

}  // namespace mbgen::importing
