// MJCF: equalities that close loops, or relate coordinates and fixed tendons.
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

/// The sum of coordinates that a joint or tendon names; nothing with a problem where there is none. Nothing without the
/// attribute.
std::optional<MjcfLength> length_by(Mjcf& mjcf, const Element& element, std::string_view name, bool is_tendon) {
  const Attribute* named = attribute(element, name);
  if (!named) return std::nullopt;
  if (is_tendon) {
    const auto found = mjcf.tendon_of.find(named->value);
    if (found != mjcf.tendon_of.end()) return found->second;
    problem(mjcf.reading, named->spot, "no fixed tendon is named " + quoted_text(named->value));
    return std::nullopt;
  }
  const auto found = mjcf.joint_of.find(named->value);
  if (found == mjcf.joint_of.end()) {
    problem(mjcf.reading, named->spot, "no joint is named " + quoted_text(named->value));
  } else if (found->second.type != JointType::revolute && found->second.type != JointType::prismatic) {
    problem(mjcf.reading, named->spot, fmt::format("joint {} has not one coordinate", quoted_text(named->value)));
  } else {
    return MjcfLength{{{1.0, found->second}}};
  }
  return std::nullopt;
}

/// y - y0 = polycoef of (x - x0), of joints or fixed tendons, where y0 and x0 are at the reference: the model's zeros.
void add_relation(Mjcf& mjcf, const Element& equality) {
  const bool is_tendon = equality.name == "tendon";
  const std::string name = equality.name;
  if (!required_text(mjcf.reading, equality, name + "1")) return;
  const std::optional<MjcfLength> follower = length_by(mjcf, equality, name + "1", is_tendon);
  const std::optional<MjcfLength> leader = length_by(mjcf, equality, name + "2", is_tendon);
  if (!follower || (attribute(equality, name + "2") && !leader)) return;
  std::vector<double> factors = {0, 1};
  if (const Attribute* written = attribute(equality, "polycoef"))
    factors = numbers(mjcf.reading, *written, 1, 5).value_or(factors);
  // MuJoCo keeps the defaults of those that are not given.
  if (factors.size() < 2) factors.push_back(1);
  std::vector<Term> terms = terms_of(*follower, 1, "z.");
  terms.push_back({-factors[0]});
  if (leader) {
    for (const Term& term : terms_of(*leader, -factors[1], "z.")) terms.push_back(term);
    const std::string x = sum_text(terms_of(*leader, 1, "z."));
    const bool is_one = leader->parts.size() == 1 && leader->parts.front().first == 1;
    for (std::size_t power = 2; power < factors.size(); ++power)
      terms.push_back({-factors[power], fmt::format("{}^{}", is_one ? x : "(" + x + ")", power)});
  }
  const std::string written = text_of(equality, "name");
  const std::string shown = written.empty() ? "equality_" + text_of(equality, name + "1") : written;
  mjcf.assembly.couplings.push_back({unique_name(shown, mjcf.assembly.coupling_names), sum_text(terms)});
}

void add_equality(Mjcf& mjcf, const Element& equality) {
  static constexpr std::array<std::string_view, 4> known = {"connect", "weld", "joint", "tendon"};
  if (std::find(known.begin(), known.end(), equality.name) == known.end()) return;
  require_class(mjcf, equality, "class");
  const Attribute* active = inherited_as(mjcf, equality, "equality", "active");
  if (active && active->value == "false")
    return note(mjcf.reading, equality.spot, fmt::format("<{}> is not active: it is left out", equality.name));
  if (equality.name == "connect" || equality.name == "weld") return add_closure(mjcf, equality);
  add_relation(mjcf, equality);
}

}  // namespace

std::vector<Term> terms_of(const MjcfLength& length, double factor, std::string_view prefix) {
  std::vector<Term> terms;
  for (const auto& [part, joint] : length.parts)
    terms.push_back({factor * part, fmt::format("{}{}", prefix, joint.coordinate)});
  return terms;
}

void read_equalities(Mjcf& mjcf, const Element& section) {
  for (const Element& equality : section.children) add_equality(mjcf, equality);
}

}  // namespace mbgen::importing
