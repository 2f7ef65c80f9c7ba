#include "workbench/motion/contact_watch.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace mbgen {
namespace {

constexpr double kRoundingOfForce = 1e-9;  // of the largest: a contact without load pulls by rounding

using Eigen::Vector3d;

/// Current direction of a body-fixed direction, given at the reference, for a body with this pose.
Vector3d turned(const Body& body, const Pose& pose, const Vector3& direction) {
  using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Map<const Rotation> reference(body.pose.rotation.data()), now(pose.rotation.data());
  return now * (reference.transpose() * Vector3d(direction.data()));
}

}  // namespace

ContactWatch::ContactWatch(const Compilation& compilation) : compilation_(compilation) {
  std::size_t row = 0;
  for (const Loop& loop : compilation.topology.loops) {
    if (loop.kind == ClosureKind::rolling_disc || loop.kind == ClosureKind::rolling_ball)
      contacts_.push_back({&loop, row});
    row += static_cast<std::size_t>(loop.equations);
  }
  if (!contacts_.empty()) solver_.emplace(compilation.model, compilation.topology, compilation.analysis);
}

Vector3d ContactWatch::forward_of(const Contact& contact, const std::vector<Pose>& poses) const {
  const Model& model = compilation_.model;
  const Joint& joint = model.joints[static_cast<std::size_t>(contact.loop->joint)];
  const auto on = [&](const Attachment& at, const Vector3& direction) {
    const auto body = static_cast<std::size_t>(at.body);
    return turned(model.bodies[body], poses[body], direction);
  };
  return on(joint.to, joint.second_axis).cross(on(joint.from, joint.axis));
}

void ContactWatch::add(const Sample& sample) {
  if (contacts_.empty()) return;
  const std::vector<Pose> poses = solver_->poses(sample.state);
  for (Contact& contact : contacts_) {
    if (contact.loop->kind == ClosureKind::rolling_disc) {
      const Vector3d forward = forward_of(contact, poses);
      if (contact.flat < 0 && forward.dot(contact.forward) < 0) contact.flat = sample.state.t;
      contact.forward = forward;
    }
    const double force = sample.multipliers[contact.row];
    contact.scale = std::max(contact.scale, std::abs(force));
    if (!(-force > contact.largest)) continue;
    if (contact.largest == 0) contact.since = sample.state.t;
    contact.largest = -force;
  }
}

std::vector<std::string> ContactWatch::warnings() const {
  std::vector<std::string> texts;
  for (const Contact& contact : contacts_) {
    if (!(contact.largest > kRoundingOfForce * contact.scale)) continue;
    texts.push_back(
        fmt::format("{} \"{}\" pulls from t = {:.6g} s on, by up to {:.4g} N: {} would lift off there, which is not "
                    "computed",
                    name_of(contact.loop->kind), contact.loop->name, contact.since, contact.largest,
                    contact.loop->kind == ClosureKind::rolling_disc ? "the disc" : "the ball"));
  }
  return texts;
}

std::string ContactWatch::failure() const {
  for (const Contact& contact : contacts_)
    if (contact.flat >= 0)
      return fmt::format(
          "rolling_disc \"{}\" fell flat before t = {:.6g} s, where its contact jumps to the other side "
          "of the rim: the motion is wrong from there on",
          contact.loop->name, contact.flat);
  return {};
}

void ContactWatch::judge(const SimulationSummary&, StepVerdict& verdict) const {
  for (std::string& warning : warnings()) verdict.warnings.push_back(std::move(warning));
  if (std::string flat = failure(); !flat.empty() && verdict.failure.empty()) {
    verdict.failure = std::move(flat);
    verdict.outcome = "a disc fell flat";
  }
}

}  // namespace mbgen
