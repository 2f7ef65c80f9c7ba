// MJCF: equalities that close loops, and motors.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compiler/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

constexpr double kMeets = 1e-6;  // m and rad, as the model's reader allows

/// Index of the body that an equality names, the ground where it names none; -1 with a problem.
int equality_body(Mjcf& mjcf, const Element& equality, std::string_view name) {
  const Attribute* named = attribute(equality, name);
  if (!named) return kGroundDraft;
  const auto found = mjcf.body_of.find(named->value);
  if (found != mjcf.body_of.end()) return found->second;
  problem(mjcf.reading, named->spot, "no body is named " + quoted_text(named->value));
  return -1;
}

/// The two ends of an equality, by bodies or by sites.
struct EqualityEnds {
  int from = -1, to = -1;
  Isometry3d at_from = Isometry3d::Identity(), at_to = Isometry3d::Identity();  ///< global at the reference
};

std::optional<EqualityEnds> ends_by_sites(Mjcf& mjcf, const Element& equality) {
  EqualityEnds ends;
  for (const bool is_first : {true, false}) {
    const std::optional<std::string> name = required_text(mjcf.reading, equality, is_first ? "site1" : "site2");
    if (!name) return std::nullopt;
    const auto found = mjcf.site_of.find(*name);
    if (found == mjcf.site_of.end()) {
      problem(mjcf.reading, equality.spot, "no site is named " + quoted_text(*name));
      return std::nullopt;
    }
    (is_first ? ends.from : ends.to) = mjcf.body_of_site.at(*name);
    (is_first ? ends.at_from : ends.at_to) = found->second;
  }
  return ends;
}

/// A pose of body2 in body1 that is not the one at the reference.
std::optional<Isometry3d> relative_pose(Mjcf& mjcf, const Element& weld) {
  const Attribute* written = attribute(weld, "relpose");
  if (!written) return std::nullopt;
  const std::optional<std::vector<double>> v = numbers(mjcf.reading, *written, 7, 7);
  if (!v) return std::nullopt;
  const Eigen::Quaterniond rotation((*v)[3], (*v)[4], (*v)[5], (*v)[6]);
  if (rotation.norm() == 0) return std::nullopt;  // MuJoCo takes the reference then
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d((*v)[0], (*v)[1], (*v)[2]);
  pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

std::optional<EqualityEnds> ends_by_bodies(Mjcf& mjcf, const Element& equality, bool is_weld) {
  if (!required_text(mjcf.reading, equality, "body1")) return std::nullopt;
  EqualityEnds ends{equality_body(mjcf, equality, "body1"), equality_body(mjcf, equality, "body2")};
  if (ends.from < 0 || ends.to < 0) return std::nullopt;
  const auto pose = [&](int body) { return mjcf.assembly.bodies[static_cast<std::size_t>(body)].pose; };
  ends.at_to = pose(ends.to);
  ends.at_from = ends.at_to;
  if (is_weld) {
    if (const std::optional<Isometry3d> relative = relative_pose(mjcf, equality))
      ends.at_from = pose(ends.from) * *relative;
    return ends;
  }
  const Attribute* anchor = attribute(equality, "anchor");
  if (!anchor) {
    problem(mjcf.reading, equality.spot, "<connect> needs an anchor");
    return std::nullopt;
  }
  const std::vector<double> v = numbers(mjcf.reading, *anchor, 3, 3).value_or(std::vector<double>(3, 0.0));
  ends.at_from = pose(ends.from) * Eigen::Translation3d(v[0], v[1], v[2]);
  ends.at_to = ends.at_from;
  return ends;
}

void add_closure(Mjcf& mjcf, const Element& equality) {
  const bool is_weld = equality.name == "weld";
  if (inherited_text(mjcf, equality, "", "active", "true") == "false") {
    note(mjcf.reading, equality.spot, fmt::format("<{}> is not active: it is left out", equality.name));
    return;
  }
  const std::optional<EqualityEnds> ends =
      attribute(equality, "site1") ? ends_by_sites(mjcf, equality) : ends_by_bodies(mjcf, equality, is_weld);
  if (!ends) return;
  if (ends->from == ends->to) {
    problem(mjcf.reading, equality.spot, fmt::format("<{}> has one body at both ends", equality.name));
    return;
  }
  const Isometry3d between = ends->at_from.inverse() * ends->at_to;
  const double gap = between.translation().norm(), turned = std::abs(Eigen::AngleAxisd(between.linear()).angle());
  if (gap > kMeets || (is_weld && turned > kMeets)) {
    problem(mjcf.reading, equality.spot,
            fmt::format("<{}> does not close at the reference, its ends are {:.6g} m and {:.6g} rad apart",
                        equality.name, gap, is_weld ? turned : 0.0),
            "move the bodies so that it holds where all joints are at their ref");
    return;
  }
  const auto name_of = [&](int body) { return mjcf.assembly.bodies[static_cast<std::size_t>(body)].name; };
  const std::string written = text_of(equality, "name");
  const std::string name =
      written.empty() ? fmt::format("{}_{}_{}", equality.name, name_of(ends->from), name_of(ends->to)) : written;
  mjcf.assembly.joints.push_back({.name = unique_joint_name(mjcf.assembly, name),
                                  .type = is_weld ? JointType::fixed : JointType::spherical,
                                  .from = ends->from,
                                  .to = ends->to,
                                  .at = ends->at_to.translation(),
                                  .cut = true});
}

/// The force of a motor on its coordinate, over the input u that is named like it: motor gear u; position
/// gear kp (u - gear q); velocity gear kv (u - gear q'), where q is MuJoCo's coordinate.
std::string actuator_force(Mjcf& mjcf, const Element& actuator, const MjcfJoint& joint, const std::string& input,
                           double gear) {
  const auto times = [](double factor) { return factor == 1 ? std::string() : fmt::format("{}*", factor); };
  if (actuator.name == "motor") return times(gear) + input;
  const bool is_position = actuator.name == "position";
  const double gain = inherited_number(mjcf, actuator, "", is_position ? "kp" : "kv", 1);
  std::string force = fmt::format("{}{} - {}{}.{}", times(gear * gain), input, times(gear * gear * gain),
                                  is_position ? "z" : "zd", joint.coordinate);
  if (!is_position) return force;
  if (joint.reference != 0) force += fmt::format(" - {}", gear * gear * gain * joint.reference);
  const double damping = inherited_number(mjcf, actuator, "", "kv", 0);
  if (damping != 0) force += fmt::format(" - {}zd.{}", times(gear * gear * damping), joint.coordinate);
  return force;
}

std::string actuator_unit(const Element& actuator, const MjcfJoint& joint, double gear) {
  const bool turns = joint.type == JointType::revolute;
  if (gear != 1) return "1";
  if (actuator.name == "motor") return turns ? "N m" : "N";
  if (actuator.name == "position") return turns ? "rad" : "m";
  return turns ? "rad/s" : "m/s";
}

void add_actuator(Mjcf& mjcf, const Element& actuator) {
  static constexpr std::array<std::string_view, 3> known = {"motor", "position", "velocity"};
  require_class(mjcf, actuator, "class");
  const Attribute* named = attribute(actuator, "joint");
  const bool is_known = std::find(known.begin(), known.end(), actuator.name) != known.end();
  const auto joint = named ? mjcf.joint_of.find(named->value) : mjcf.joint_of.end();
  if (named && joint == mjcf.joint_of.end()) {
    problem(mjcf.reading, named->spot, "no joint is named " + quoted_text(named->value));
    return;
  }
  const bool has_one_coordinate = joint != mjcf.joint_of.end() && (joint->second.type == JointType::revolute ||
                                                                   joint->second.type == JointType::prismatic);
  if (!is_known || !has_one_coordinate) {
    note(mjcf.reading, actuator.spot, fmt::format("actuator <{}> is not carried over", actuator.name),
         "motors, position and velocity servos on hinges and slides become inputs");
    return;
  }
  double gear = 1;
  if (const Attribute* written = inherited(mjcf, actuator, "", "gear")) {
    gear = numbers(mjcf.reading, *written, 1, 6).value_or(std::vector<double>{1})[0];
  }
  if (inherited(mjcf, actuator, "", "ctrlrange") || inherited(mjcf, actuator, "", "forcerange")) {
    lose(mjcf, actuator.spot, "actuator with a range: it is not enforced");
  }
  const std::string written = text_of(actuator, "name");
  const std::string name =
      unique_name(written.empty() ? joint->second.coordinate + "_motor" : written, mjcf.assembly.input_names);
  mjcf.assembly.actuators.push_back({name, joint->second.coordinate,
                                     actuator_force(mjcf, actuator, joint->second, name, gear),
                                     actuator_unit(actuator, joint->second, gear)});
}

}  // namespace

void read_equalities(Mjcf& mjcf, const Element& section) {
  for (const Element& equality : section.children) {
    if (equality.name == "connect" || equality.name == "weld") {
      add_closure(mjcf, equality);
    } else if (equality.name == "joint") {
      note(mjcf.reading, equality.spot,
           fmt::format("joint {} should follow {}: it is left free", quoted_text(text_of(equality, "joint1")),
                       quoted_text(text_of(equality, "joint2"))),
           "the format has no relation between coordinates; drive both by \"motions\" of one input to hold them "
           "together");
    } else {
      note(mjcf.reading, equality.spot, fmt::format("equality <{}> is not carried over", equality.name));
    }
  }
}

void read_actuators(Mjcf& mjcf, const Element& section) {
  for (const Element& actuator : section.children) add_actuator(mjcf, actuator);
}

}  // namespace mbgen::importing
