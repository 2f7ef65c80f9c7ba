// Checks of inertias, over each group of rigidly connected bodies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/reader.hpp"
#include "mbgen/body_inertia.hpp"

namespace mbgen::reading {
namespace {

enum class Fault { none, indefinite, no_mass, triangle };

/// A fault and its message.
struct Finding {
  Fault fault = Fault::none;
  std::string text;
};

/// Eigenvalues of a symmetric matrix (xx yy zz xy xz yz), ascending, by Jacobi rotations.
std::array<double, 3> principal_moments(const std::array<double, 6>& entries) {
  double m[3][3] = {
      {entries[0], entries[3], entries[4]}, {entries[3], entries[1], entries[5]}, {entries[4], entries[5], entries[2]}};
  constexpr int kSweeps = 12;  // converges quadratically, five are usual
  for (int step = 0; step < 3 * kSweeps; ++step) {
    const int p = step % 3 == 2 ? 1 : 0, q = step % 3 == 0 ? 1 : 2;
    if (m[p][q] == 0) continue;
    const double angle = 0.5 * std::atan2(2 * m[p][q], m[q][q] - m[p][p]);
    const double c = std::cos(angle), s = std::sin(angle);
    for (auto& row : m) {
      const double at_p = row[p], at_q = row[q];
      row[p] = c * at_p - s * at_q;
      row[q] = s * at_p + c * at_q;
    }
    for (int column = 0; column < 3; ++column) {
      const double at_p = m[p][column], at_q = m[q][column];
      m[p][column] = c * at_p - s * at_q;
      m[q][column] = s * at_p + c * at_q;
    }
  }
  std::array<double, 3> moments = {m[0][0], m[1][1], m[2][2]};
  std::sort(moments.begin(), moments.end());
  return moments;
}

/// Fault of a physically impossible inertia. None for NaN, which has been reported.
Finding finding_of(double mass, const std::array<double, 6>& inertia) {
  if (std::any_of(inertia.begin(), inertia.end(), [](double entry) { return std::isnan(entry); })) return {};
  const auto [smallest, middle, largest] = principal_moments(inertia);
  const double slack = inertia_slack({inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]});
  const std::string moments = fmt::format(", principal moments {:.6g}, {:.6g}, {:.6g}", smallest, middle, largest);
  if (smallest < -slack) return {Fault::indefinite, "inertia is not positive semidefinite" + moments};
  if (largest > smallest + middle + slack) return {Fault::triangle, "inertia breaks the triangle inequality" + moments};
  const bool turns = std::any_of(inertia.begin(), inertia.end(), [](double entry) { return entry != 0; });
  if (mass == 0 && turns) return {Fault::no_mass, "a body with inertia needs mass"};
  return {};
}

std::array<double, 6> inertia_of(const Body& body) {
  std::array<double, 6> result{};
  for (std::size_t i = 0; i < 6; ++i) result[i] = body.inertia[i].value;
  return result;
}

/// Adds the moments and products of a point mass: mass (d.d E - d d').
void add_point_mass(std::array<double, 6>& inertia, double mass, const Vector3& d) {
  const double square = dot(d, d);
  for (std::size_t i = 0; i < 3; ++i) inertia[i] += mass * (square - d[i] * d[i]);
  inertia[3] -= mass * d[0] * d[1];
  inertia[4] -= mass * d[0] * d[2];
  inertia[5] -= mass * d[1] * d[2];
}

/// Reports the fault of a body's inertia, or notes the reason for accepting it.
void judge(Reader& reader, int body, const Finding& alone, const std::vector<int>& groups) {
  const WrittenInertia& written = reader.inertias[body];
  const InScope in_scope(reader, reader.names.body_scopes[body]);
  const int ground = reader.model.ground;
  const bool is_held = ground >= 0 && groups[body] == groups[ground];
  const bool is_alone = std::count(groups.begin(), groups.end(), groups[body]) == 1;
  Finding together = is_held ? Finding{} : alone;
  if (!is_held && !is_alone) {
    const RigidGroup group = rigid_group(reader.model, groups, groups[body]);
    together = finding_of(group.mass, group.inertia);
  }
  const Place place = written.value->place;
  if (is_held) {
    note(reader, place, alone.text + "; the body is fixed to the ground, where that has no effect");
  } else if (together.fault == Fault::none) {
    note(reader, place,
         alone.text + "; together with the bodies that are fixed to it, it is the inertia of a rigid body");
  } else if (together.fault != Fault::indefinite && written.accepted) {
    note(reader, place, alone.text + "; it is taken as it is");
  } else {
    const bool of_triangle = alone.fault == Fault::triangle && together.fault == Fault::triangle;
    report(reader, place, alone.text + (!is_alone ? "; the bodies that are fixed to it do not mend that" : ""),
           of_triangle ? "no principal moment of a rigid body exceeds the sum of the other two; "
                         "\"accept_inertia\": true takes it as it is"
                       : "");
  }
}

}  // namespace

std::vector<int> rigid_groups(const Model& model) {
  std::vector<int> group(model.bodies.size());
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = static_cast<int>(i);
  const auto first = [&](int body) {
    while (group[body] != body) body = group[body] = group[group[body]];
    return body;
  };
  for (const Joint& joint : model.joints) {
    if (joint.type != JointType::fixed || joint.from.body < 0 || joint.to.body < 0) continue;
    const int a = first(joint.from.body), b = first(joint.to.body);
    group[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = first(static_cast<int>(i));
  return group;
}

RigidGroup rigid_group(const Model& model, const std::vector<int>& groups, int group) {
  RigidGroup sum;
  std::vector<std::pair<int, Vector3>> members;  // with their centres of mass
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (groups[k] != group) continue;
    const Body& body = model.bodies[k];
    Vector3 at = rotated(body.pose.rotation, {body.com[0].value, body.com[1].value, body.com[2].value});
    for (std::size_t i = 0; i < 3; ++i) sum.centre[i] += body.mass.value * (at[i] += body.pose.origin[i]);
    sum.mass += body.mass.value;
    members.emplace_back(static_cast<int>(k), at);
  }
  for (double& component : sum.centre) component /= sum.mass == 0 ? 1 : sum.mass;
  for (const auto& [index, at] : members) {
    const Body& body = model.bodies[index];
    const auto [xx, yy, zz, xy, xz, yz] = inertia_of(body);
    const Matrix3 turned =
        product(product(body.pose.rotation, {xx, xy, xz, xy, yy, yz, xz, yz, zz}), transposed(body.pose.rotation));
    constexpr std::size_t kEntries[] = {0, 4, 8, 1, 2, 5};
    for (std::size_t i = 0; i < 6; ++i) sum.inertia[i] += turned[kEntries[i]];
    add_point_mass(sum.inertia, body.mass.value, {at[0] - sum.centre[0], at[1] - sum.centre[1], at[2] - sum.centre[2]});
  }
  return sum;
}

void check_inertias(Reader& reader) {
  const Model& model = reader.model;
  const std::vector<int> groups = rigid_groups(model);
  for (int i = 0; i < static_cast<int>(groups.size()); ++i) {
    if (!reader.inertias[i].value || i == model.ground) continue;
    const Finding alone = finding_of(model.bodies[i].mass.value, inertia_of(model.bodies[i]));
    const bool has_tunable_mass = alone.fault == Fault::no_mass && model.bodies[i].mass.expression >= 0;
    if (alone.fault != Fault::none && !has_tunable_mass) judge(reader, i, alone, groups);
  }
}

}  // namespace mbgen::reading
