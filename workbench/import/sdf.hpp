#pragma once
// SDF: links and joints of one model of SDFormat 1.4 to 1.12 (http://sdformat.org/spec). Poses of links are absolute,
// so that every joint is closed as written; loops are joints like others.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "workbench/import/assembly.hpp"

namespace mbgen::importing {

/// A link, joint or frame of the model: something with a pose.
struct SdfFrame {
  const Element* element = nullptr;
  std::string fallback = {};     ///< frame of its pose where it names none: "__model__", the child of a joint
  std::string attached_to = {};  ///< frame that it moves with; of a link itself
  mutable std::optional<Isometry3d> pose = {};  ///< in the model, once it was asked for
};

struct SdfModel {
  Element whole;  ///< with all models inside of it
  const Element* element = nullptr;
  double version = 0;  ///< of the format, 1.7 for example
  std::map<std::string, SdfFrame, std::less<>> frames;
  std::vector<const Element*> links, joints;
  std::map<std::string, int, std::less<>> body_of;  ///< index into Assembly::bodies, by link
  Isometry3d pose = Isometry3d::Identity();         ///< of the model in the world
};

/// Text between the tags of a child, "" without it.
std::string inner_text(const Element& element, std::string_view name);
/// The number between the tags of a child, `fallback` if it is absent or unreadable.
double inner_number(Reading& reading, const Element& element, std::string_view name, double fallback);
/// The number of a limit, infinite where it means none.
double inner_limit(Reading& reading, const Element& element, std::string_view name, double fallback);
/// Whether the child says true or 1, in any case; false without it. Fails (false, with a problem): another word than
/// these, false and 0.
bool inner_truth(Reading& reading, const Element& element, std::string_view name);
/// The same of an attribute.
bool attribute_truth(Reading& reading, const Element& element, std::string_view name);

/// A pose as <pose> says it, identity without one.
Isometry3d read_pose(Reading& reading, const Element* pose);

/// Version of the format, 1.7 for example; 2 for 1.10 and later.
double sdf_version(Reading& reading, const Element& root);
/// Whether an axis without a frame is in the axes of the model.
bool is_axis_of_model(Reading& reading, const Element& axis, double version);
/// The link that the frame of a model moves with: its canonical_link, else its first link, of the models inside where
/// it has none. flat: with nested models taken into it.
std::string canonical_link(const Element& flat);
/// Pose of a frame in a model that has no models inside. Fails (nothing): as frame_pose.
std::optional<Isometry3d> pose_in(Reading& reading, const Element& model, std::string_view name, const Element& user);
/// The model with the links, joints and frames of all models and included files inside of it, under names NAME::INNER.
/// Problems: files that cannot be read or that include themselves, static models inside.
Element with_nested_models(Reading& reading, const Element& model, double version);

/// The model of the file, in <sdf> or in its <world>, with its links, joints and frames. Fails (nothing, with
/// problems).
std::optional<SdfModel> read_sdf(Reading& reading, const Element& root, Assembly& assembly);

/// Pose of a frame in the model. Fails (nothing, with a problem at `user`): an unknown frame, poses in a circle.
std::optional<Isometry3d> frame_pose(Reading& reading, const SdfModel& model, std::string_view name,
                                     const Element& user);
/// Index into Assembly::bodies of the link that a frame moves with, the ground for "world"; -1 with a problem.
int body_of_frame(Reading& reading, const SdfModel& model, std::string_view name, const Element& user);

/// Adds all links as bodies. Requires: the model is read.
void add_sdf_links(Reading& reading, SdfModel& model, Assembly& assembly);
/// Adds all joints, springs and couplings; chooses the joints that close loops, and holds what hangs on nothing.
void add_sdf_joints(Reading& reading, const SdfModel& model, Assembly& assembly);
/// Adds visuals of links as shapes: boxes, cylinders and spheres.
void add_sdf_shapes(Reading& reading, const SdfModel& model, Assembly& assembly);

/// The whole translation. Problems and notes are added.
void import_sdf(Reading& reading, const Element& root, Assembly& assembly);

}  // namespace mbgen::importing
