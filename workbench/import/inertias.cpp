// Inertias that no rigid body has: files of real robots have them, and the group of bodies that moves as one decides.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compiler/algebra/dense.hpp"
#include "workbench/import/assembly.hpp"

namespace mbgen::importing {
namespace {

/// Share of the trace; stricter than the model's reader, so that rounding of written numbers cannot matter.
constexpr double kInertiaSlack = 0.5e-9;

enum class Fault { none, indefinite, no_mass, triangle };

struct Finding {
  Fault fault = Fault::none;
  std::string text;
};

Finding finding_of(double mass, const Matrix3d& inertia) {
  const Vector3d moments = symmetric_eigenvalues(inertia);
  const double slack = kInertiaSlack * std::abs(inertia.trace());
  const std::string values =
      fmt::format(", principal moments {:.6g}, {:.6g}, {:.6g}", moments[0], moments[1], moments[2]);
  if (moments[0] < -slack) return {Fault::indefinite, "inertia is not positive semidefinite" + values};
  if (moments[2] > moments[0] + moments[1] + slack)
    return {Fault::triangle, "inertia breaks the triangle inequality" + values};
  if (mass == 0 && inertia.cwiseAbs().maxCoeff() > 0) return {Fault::no_mass, "a body with inertia needs mass"};
  return {};
}

/// Per body: the lowest index among the bodies that fixed joints connect to it.
std::vector<int> rigid_groups(const Assembly& assembly) {
  std::vector<int> group(assembly.bodies.size());
  std::iota(group.begin(), group.end(), 0);
  const auto first = [&](int body) {
    while (group[body] != body) body = group[body] = group[group[body]];
    return body;
  };
  for (const JointDraft& joint : assembly.joints) {
    if (joint.type != JointType::fixed) continue;
    const int a = first(joint.from), b = first(joint.to);
    group[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = first(static_cast<int>(i));
  return group;
}

/// Of the bodies of one group together.
Finding finding_of_group(const Assembly& assembly, const std::vector<int>& groups, int group) {
  double mass = 0;
  Vector3d centre = Vector3d::Zero();
  Matrix3d inertia = Matrix3d::Zero();
  const auto for_members = [&](const auto& use) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (groups[i] == group) use(assembly.bodies[i]);
    }
  };
  for_members([&](const BodyDraft& body) {
    mass += body.mass;
    centre += body.mass * (body.pose * body.com);
  });
  if (mass > 0) centre /= mass;
  for_members([&](const BodyDraft& body) {
    const Vector3d d = body.pose * body.com - centre;
    inertia += body.pose.linear() * body.inertia * body.pose.linear().transpose();
    inertia += body.mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  });
  return finding_of(mass, inertia);
}

}  // namespace

void check_inertias(Reading& reading, Assembly& assembly) {
  const std::vector<int> groups = rigid_groups(assembly);
  for (std::size_t i = 1; i < groups.size(); ++i) {
    BodyDraft& body = assembly.bodies[i];
    const Finding alone = finding_of(body.mass, body.inertia);
    if (alone.fault == Fault::none) continue;
    const std::string text = fmt::format("{}: {}", body.title, alone.text);
    const bool is_held = groups[i] == kGroundDraft;
    const Finding together = is_held ? Finding{} : finding_of_group(assembly, groups, groups[i]);
    if (together.fault == Fault::indefinite) {
      problem(reading, body.inertia_spot, text, "look for a wrong sign, or for products of inertia above the moments");
    } else if (is_held) {
      note(reading, body.inertia_spot, text + "; it is fixed to the ground, where that has no effect");
    } else if (together.fault == Fault::none) {
      note(reading, body.inertia_spot,
           text + "; together with the bodies that are fixed to it, it is the inertia of a rigid body");
    } else {
      body.accepts_inertia = true;
      note(reading, body.inertia_spot, text + "; it is taken as it is");
    }
  }
}

}  // namespace mbgen::importing
