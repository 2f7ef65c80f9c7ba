// A note on wheels that do not turn as they run at the start: forgotten rates of wheel joints, and rates of the wrong
// sign.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "workbench/describe/notes.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

using Eigen::Vector3d;
using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kInstant = 1e-6;   // s, between two positions whose difference is a velocity
constexpr double kRuns = 1;         // m/s: slower tyres are at rest
constexpr double kSlides = 0.5;     // of the speed, more than a driven or braked wheel slips at a start
constexpr double kBackwards = 0.1;  // of the rate that rolls: a wheel that is meant to spin back is rare
constexpr double kOneAxis = 0.9;    // cosine between the axes of a tyre and of the joint that its wheel turns in

/// A tyre that slides in its wheel's plane.
struct SlidingTyre {
  const Tyre* tyre;
  const TreeBody* wheel;
  double speed;    ///< m/s, of the wheel centre, forwards
  double moves;    ///< m/s, of the wheel centre, any way
  double spin;     ///< rad/s, of the wheel
  double rolling;  ///< rad/s, of the coordinate where the wheel rolls
};

Vector3d vector_of(const Vector3& v) { return {v[0], v[1], v[2]}; }
Rotation rotation_of(const Pose& pose) { return Eigen::Map<const Rotation>(pose.rotation.data()); }

/// Whether the model gives the rate of a coordinate.
bool is_said(const Model& model, const TreeBody& wheel) {
  const auto is_it = [&](const CoordinateReference& one) {
    return one.joint == wheel.joint && one.component == wheel.component;
  };
  const auto& velocities = model.initial.velocities;
  return std::any_of(velocities.begin(), velocities.end(),
                     [&](const auto& value) { return is_it(value.coordinate); }) ||
         std::any_of(model.motions.begin(), model.motions.end(),
                     [&](const auto& motion) { return is_it(motion.joint); });
}

/// Motion of a tyre between two poses of its body, an instant apart.
SlidingTyre moving(const Model& model, const Tyre& tyre, const TreeBody& wheel, const Pose& before, const Pose& after) {
  const Body& body = model.bodies[static_cast<std::size_t>(tyre.centre.body)];
  const Vector3Quantity& point = body.points[static_cast<std::size_t>(tyre.centre.point)].position;
  const Vector3d centre(point[0].value, point[1].value, point[2].value);
  const Rotation first = rotation_of(before), second = rotation_of(after);
  const Vector3d way = second * centre + vector_of(after.origin) - first * centre - vector_of(before.origin);
  const Vector3d axis = first * (rotation_of(body.pose).transpose() * vector_of(tyre.axis));
  const Vector3d forward = axis.cross(Vector3d::UnitZ());
  const Rotation change = (second * first.transpose() - first * second.transpose()) / 2;
  const Vector3d turn(change(2, 1), change(0, 2), change(1, 0));
  const double lies = forward.norm() < kOneAxis ? 0 : 1;  // a wheel that lies runs nowhere
  return {
      &tyre, &wheel, lies * way.dot(forward.normalized()) / kInstant, way.norm() / kInstant, turn.dot(axis) / kInstant,
      0};
}

/// The motion of every tyre whose wheel turns about its axis.
std::vector<SlidingTyre> moving_tyres(const Compilation& compilation, const GenericState& start) {
  const Model& model = compilation.model;
  const GenericSolver solver(model, compilation.topology, compilation.analysis);
  GenericState later = start;
  for (std::size_t i = 0; i < later.z.size(); ++i) later.z[i] += kInstant * start.zd[i];
  const std::vector<Pose> before = solver.poses(start), after = solver.poses(later);
  std::vector<SlidingTyre> tyres;
  for (const Tyre& tyre : model.tyres) {
    const auto body = static_cast<std::size_t>(tyre.centre.body);
    const int coordinate = compilation.topology.tree_body[body];
    if (coordinate < 0) continue;
    const TreeBody& wheel = compilation.topology.bodies[coordinate];
    const double along = vector_of(wheel.axis).dot(vector_of(tyre.axis));
    if (wheel.kind != FreedomKind::revolute || std::abs(along) < kOneAxis) continue;
    SlidingTyre one = moving(model, tyre, wheel, before[body], after[body]);
    const double rolls = one.speed / tyre.radius.value;
    one.rolling = start.zd[static_cast<std::size_t>(coordinate)] + std::copysign(1, along) * (rolls - one.spin);
    tyres.push_back(one);
  }
  return tyres;
}

/// Tyres that slide without being told to.
std::vector<SlidingTyre> sliding_of(const Model& model, const std::vector<SlidingTyre>& tyres) {
  std::vector<SlidingTyre> sliding;
  for (const SlidingTyre& one : tyres) {
    const double rolls = one.speed / one.tyre->radius.value;
    const bool is_backwards = one.spin * rolls < -kBackwards * rolls * rolls;
    if (is_said(model, *one.wheel) && !is_backwards) continue;
    if (std::abs(one.speed) < kRuns || std::abs(one.spin - rolls) < kSlides * std::abs(rolls)) continue;
    sliding.push_back(one);
  }
  return sliding;
}

/// A note where all wheels turn and none runs: the vehicle's own speed is likely forgotten.
Diagnostics standing_notes(const std::vector<SlidingTyre>& tyres) {
  constexpr double kStands = 0.1;     // of the speed at which the wheel rolls
  constexpr std::size_t kFewest = 3;  // tyres of a vehicle; a rig may spin one up
  const auto spins = [](const SlidingTyre& one) {
    const double rolls = std::abs(one.spin) * one.tyre->radius.value;
    return rolls > kRuns && one.moves < kStands * rolls;
  };
  if (tyres.size() < kFewest || !std::all_of(tyres.begin(), tyres.end(), spins)) return {};
  const SlidingTyre& first = tyres.front();
  return {{first.tyre->where,
           fmt::format("all wheels turn at the start and the vehicle stands: the wheel of tyre \"{}\" turns at {:.4g} "
                       "rad/s, its centre moves at {:.2f} m/s",
                       first.tyre->name, first.spin, first.moves),
           fmt::format("give the vehicle its speed, {:.4g} m/s, among the \"velocities\" of \"initial\"",
                       std::abs(first.spin) * first.tyre->radius.value),
           ""}};
}

/// A note on a speed that is likely in km/h.
Diagnostics fast_notes(const std::vector<SlidingTyre>& tyres) {
  constexpr double kUnlikely = 70;  // m/s, 252 km/h, as in manoeuvres
  for (const SlidingTyre& one : tyres) {
    if (std::abs(one.speed) < kUnlikely) continue;
    return {{one.tyre->where,
             fmt::format("tyre \"{}\" runs at {:.4g} m/s at the start, {:.4g} km/h", one.tyre->name, one.speed,
                         3.6 * one.speed),
             "speeds are in m/s; km/h may be written \"80/3.6\"", ""}};
  }
  return {};
}

/// A note on the sliding tyres.
Diagnostics slip_notes(const std::vector<SlidingTyre>& sliding) {
  if (sliding.empty()) return {};
  const SlidingTyre& first = sliding.front();
  std::vector<std::string> rates;
  for (const SlidingTyre& one : sliding)
    rates.push_back(fmt::format("\"{}\": {:.4g}", one.wheel->coordinate, one.rolling));
  const std::string others = sliding.size() == 1 ? "" : fmt::format(", one of {},", sliding.size());
  const bool is_backwards = first.spin * first.speed < 0;
  if (is_backwards) {
    return {
        {first.tyre->where,
         fmt::format("the wheel of tyre \"{}\"{} starts turning backwards: its centre moves at {:.4g} m/s, it turns "
                     "at {:.4g} rad/s",
                     first.tyre->name, others, first.speed, first.spin),
         fmt::format("wheels that roll have \"initial\": {{\"velocities\": {{{}}}}}; a joint's axis to the left "
                     "makes rolling forwards positive",
                     fmt::join(rates, ", ")),
         ""}};
  }
  return {
      {first.tyre->where,
       fmt::format("tyre \"{}\"{} slides at the start: its centre moves at {:.4g} m/s, its wheel turns at {:.4g} rad/s",
                   first.tyre->name, others, first.speed, first.spin),
       fmt::format("wheels that roll have \"initial\": {{\"velocities\": {{{}}}}}; where they are to slide, write "
                   "the rates that they have",
                   fmt::join(rates, ", ")),
       ""}};
}

}  // namespace

Diagnostics sliding_notes(const Compilation& compilation, const GenericState& start) {
  if (compilation.model.tyres.empty()) return {};
  const std::vector<SlidingTyre> tyres = moving_tyres(compilation, start);
  Diagnostics notes = fast_notes(tyres);
  for (const Diagnostics& more : {standing_notes(tyres), slip_notes(sliding_of(compilation.model, tyres))})
    notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

}  // namespace mbgen
