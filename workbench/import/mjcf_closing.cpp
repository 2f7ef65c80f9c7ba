// MJCF: equalities that close loops. Loops that are open at the reference are closed by moving the joints.
#include <fmt/format.h>

#include <algorithm>

#include "workbench/import/closing.hpp"
#include "workbench/import/mjcf.hpp"

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
  Isometry3d at_from = Isometry3d::Identity(), at_to = Isometry3d::Identity();  ///< in their bodies
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
  const Isometry3d between = pose(ends.from).inverse() * pose(ends.to);
  if (is_weld) {
    ends.at_from = relative_pose(mjcf, equality).value_or(between);
    return ends;
  }
  const Attribute* anchor = attribute(equality, "anchor");
  if (!anchor) {
    problem(mjcf.reading, equality.spot, "<connect> needs an anchor");
    return std::nullopt;
  }
  const std::vector<double> v = numbers(mjcf.reading, *anchor, 3, 3).value_or(std::vector<double>(3, 0.0));
  ends.at_from.translation() = Vector3d(v[0], v[1], v[2]);
  ends.at_to = between.inverse() * ends.at_from;
  return ends;
}

/// A connect or weld under the name of the joint that it becomes.
struct MjcfClosure {
  const Element* element = nullptr;
  std::string name;
  EqualityEnds ends;
  bool is_weld() const { return element->name == "weld"; }
};

const std::string& name_of(const Mjcf& mjcf, int body) {
  return mjcf.assembly.bodies[static_cast<std::size_t>(body)].name;
}

void read_closure(Mjcf& mjcf, const Element& equality, std::vector<MjcfClosure>& closures) {
  const bool is_weld = equality.name == "weld";
  const std::optional<EqualityEnds> ends =
      attribute(equality, "site1") ? ends_by_sites(mjcf, equality) : ends_by_bodies(mjcf, equality, is_weld);
  if (!ends) return;
  if (ends->from == ends->to) {
    problem(mjcf.reading, equality.spot, fmt::format("<{}> has one body at both ends", equality.name));
    return;
  }
  const std::string written = text_of(equality, "name");
  const std::string name =
      written.empty() ? fmt::format("{}_{}_{}", equality.name, name_of(mjcf, ends->from), name_of(mjcf, ends->to))
                      : written;
  closures.push_back({&equality, unique_joint_name(mjcf.assembly, name), *ends});
}

/// A joint equality as its follower has it; one that has a leader already, or leads its leader, stays as it is.
void add_relation_to(Chain& chain, Mjcf& mjcf, const Element& equality,
                     const std::map<std::string, int, std::less<>>& index_of) {
  const auto index = [&](const char* name) {
    const auto joint = mjcf.joint_of.find(text_of(equality, name));
    const auto found = joint == mjcf.joint_of.end() ? index_of.end() : index_of.find(joint->second.coordinate);
    return found == index_of.end() ? -1 : found->second;
  };
  const int follower = index("joint1"), leader = index("joint2");
  if (follower < 0 || (leader < 0 && attribute(equality, "joint2"))) return;
  ChainJoint& joint = chain.joints[static_cast<std::size_t>(follower)];
  if (!joint.relation.empty()) return;
  for (int at = leader; at >= 0; at = chain.joints[static_cast<std::size_t>(at)].leader)
    if (at == follower) return;
  std::vector<double> relation = polynomial_of(mjcf, equality);
  if (leader < 0) relation.resize(1);
  joint.leader = leader;
  joint.relation = relation;
}

/// The tree at the reference as written; coordinates count from there.
Chain chain_of_tree(Mjcf& mjcf, const Element& root, const std::vector<MjcfClosure>& closures) {
  Chain chain;
  std::map<std::string, int, std::less<>> index_of;
  std::map<std::string, const MjcfJoint*, std::less<>> limits_of;
  for (const MjcfJoint& joint : mjcf.scalar_joints) limits_of[joint.coordinate] = &joint;
  for (const BodyDraft& body : mjcf.assembly.bodies) chain.poses.push_back(body.pose);
  for (const JointDraft& draft : mjcf.assembly.joints) {
    const auto pose = [&](int body) { return chain.poses[static_cast<std::size_t>(body)]; };
    const Isometry3d at(Eigen::Translation3d(draft.at));
    index_of[draft.name] = static_cast<int>(chain.joints.size());
    chain.joints.push_back({.name = draft.name,
                            .type = draft.type,
                            .from = draft.from,
                            .to = draft.to,
                            .start = pose(draft.from).inverse() * at,
                            .end = at.inverse() * pose(draft.to),
                            .axis = draft.axis});
    const auto found = limits_of.find(draft.name);
    if (found == limits_of.end()) continue;
    chain.joints.back().lower = found->second->lower;
    chain.joints.back().upper = found->second->upper;
  }
  for_equalities(mjcf, root, [&](const Element& equality) {
    if (equality.name == "joint") add_relation_to(chain, mjcf, equality, index_of);
  });
  for (const MjcfClosure& closure : closures) {
    chain.loops.push_back({closure.name,
                           closure.ends.from,
                           closure.ends.to,
                           {closure.is_weld() ? JointType::fixed : JointType::spherical, closure.ends.at_from,
                            closure.ends.at_to, Vector3d::UnitX()}});
  }
  return chain;
}

/// Coordinates are zero at the present joint positions: quantities that refer to the old zero are shifted.
void move_zero(Mjcf& mjcf, MjcfJoint& joint, double move) {
  joint.moved = move;
  joint.reference += move;
  joint.free -= move;
  for (SpringDraft& spring : mjcf.assembly.springs)
    if (spring.coordinate == joint.coordinate) spring.free -= move;
  for (StopDraft& stop : mjcf.assembly.stops)
    if (stop.coordinate == joint.coordinate) stop.clearance += stop.is_above ? -move : move;
}

/// Poses, axes and zeros of the closed place.
void take_over(Mjcf& mjcf, const Chain& chain) {
  Assembly& assembly = mjcf.assembly;
  std::map<std::string, double, std::less<>> moves;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    JointDraft& draft = assembly.joints[i];
    const auto from = static_cast<std::size_t>(draft.from);
    const Isometry3d turned = chain.poses[from] * assembly.bodies[from].pose.inverse();
    draft.at = turned * draft.at;
    draft.axis = turned.linear() * draft.axis;
    if (chain.joints[i].position != 0) moves[draft.name] = chain.joints[i].position;
  }
  for (std::size_t i = 0; i < assembly.bodies.size(); ++i) assembly.bodies[i].pose = chain.poses[i];
  for (MjcfJoint& joint : mjcf.scalar_joints)
    if (moves.contains(joint.coordinate)) move_zero(mjcf, joint, moves[joint.coordinate]);
  for (auto& [name, joint] : mjcf.joint_of)
    for (const MjcfJoint& moved : mjcf.scalar_joints)
      if (moved.coordinate == joint.coordinate) joint = moved;
}

void add_closure(Mjcf& mjcf, const MjcfClosure& closure, const Closed& closed) {
  const EqualityEnds& ends = closure.ends;
  const auto pose = [&](int body) { return mjcf.assembly.bodies[static_cast<std::size_t>(body)].pose; };
  const JointType type = closure.is_weld() ? JointType::fixed : JointType::spherical;
  const Isometry3d at = pose(ends.to) * ends.at_to;
  mjcf.assembly.joints.push_back(
      {.name = closure.name, .type = type, .from = ends.from, .to = ends.to, .at = at.translation(), .cut = true});
  const bool is_told = !closed.has_moved && (closed.left_open.empty() || closed.left_open.contains(closure.name));
  const Gap gap = gap_between({type, pose(ends.from) * ends.at_from, at, Vector3d::UnitX()});
  if (!is_told || gap.is_below(kMeets, kMeets)) return;
  std::string text =
      fmt::format("<{}> {} does not close the loop of {} and {}, its ends are {:.6g} m", closure.element->name,
                  quoted_text(closure.name), quoted_text(name_of(mjcf, ends.from)), quoted_text(name_of(mjcf, ends.to)),
                  gap.apart.norm());
  if (closure.is_weld()) text += fmt::format(" and {:.6g} rad", gap.turned.norm());
  text += " apart at the reference";
  const auto left = closed.left_open.find(closure.name);
  text += left == closed.left_open.end() ? "; no joint moves one end against the other" : "; " + left->second;
  problem(mjcf.reading, closure.element->spot, text,
          "move the bodies so that it holds where all joints are at their ref, or widen the ranges of joints");
}

bool has_attribute(const Element& element, std::string_view name) {
  if (attribute(element, name)) return true;
  return std::any_of(element.children.begin(), element.children.end(),
                     [&](const Element& inner) { return has_attribute(inner, name); });
}

}  // namespace

void close_loops_of(Mjcf& mjcf, const Element& root) {
  std::vector<MjcfClosure> closures;
  for_equalities(mjcf, root, [&](const Element& equality) {
    if (equality.name == "connect" || equality.name == "weld") read_closure(mjcf, equality, closures);
  });
  if (!mjcf.reading.problems.empty()) return;
  Chain chain = chain_of_tree(mjcf, root, closures);
  const Closed closed = close_chain(chain);
  if (closed.has_moved) {
    // MuJoCo takes the inertias where the joints are as written.
    if (mjcf.inertia_of.empty() && has_attribute(root, "dampratio")) find_inertias(mjcf);
    take_over(mjcf, chain);
    note_moves(mjcf.reading, root.spot, closed, "the coordinates of the model are zero there");
  }
  for (const MjcfClosure& closure : closures) add_closure(mjcf, closure, closed);
}

}  // namespace mbgen::importing
