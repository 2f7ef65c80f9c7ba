#include "workbench/manoeuvre/course_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/model/vectors.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/manoeuvre/vehicle_motion.hpp"

namespace mbgen {
namespace {

constexpr double kDegreeOfHeading = std::numbers::pi / 180;
constexpr double kAcross = 90 * kDegreeOfHeading;
constexpr double kSlide = 30 * kDegreeOfHeading;  // beyond the slip angle of any tyre's largest force
constexpr double kFast = 5;                       // m/s: tight bends at lower speeds reach such angles too

void note_first(bool happens, double t, std::optional<double>& first) {
  if (happens && !first) first = t;
}

/// Heading of a tyre's wheel, rad to the left of `ahead`, within half a turn.
double heading_of(const Model& model, const std::vector<Pose>& poses, const Tyre& tyre, double ahead) {
  const auto body = static_cast<std::size_t>(tyre.centre.body);
  Vector3 axis = rotated(poses[body].rotation, to_body_axes(model.bodies[body].pose, tyre.axis));
  if (tyre.axis[1] < 0) axis = {-axis[0], -axis[1], -axis[2]};
  return std::remainder(std::atan2(-axis[0], axis[1]) - ahead, 2 * std::numbers::pi);
}

}  // namespace

void CourseWatch::add(double t, const PlaneMotion& motion, const std::optional<CoursePlace>& place, double most,
                      double heading) {
  note_first(place && std::abs(place->offset) > most, t, leaves);
  note_first(place && std::abs(std::remainder(motion.heading - heading, 2 * std::numbers::pi)) > kAcross, t, turns);
  note_first(motion.speed() > kFast && std::abs(std::atan2(motion.left, motion.forward)) > kSlide, t, slides);
}

std::vector<std::string> CourseWatch::warnings(double most) const {
  std::vector<std::string> list;
  if (leaves)
    list.push_back(
        fmt::format("the vehicle leaves its course by more than {:g} m, first at t = {:.6g} s", most, *leaves));
  if (turns)
    list.push_back(
        fmt::format("the vehicle turns by more than {:g} deg from its course, first at t = {:.6g} s", 90.0, *turns));
  if (slides)
    list.push_back(fmt::format("the vehicle slides: it moves more than {:g} deg off its heading, first at t = {:.6g} s",
                               30.0, *slides));
  return list;
}

std::optional<double> steer_angle(const Compilation& c, const GenericState& state, const std::vector<double>& inputs) {
  GenericSolver solver(c.model, c.topology, c.analysis);
  solver.set_inputs(inputs);
  const std::vector<Pose> poses = solver.poses(state);
  const VehicleFacts facts = vehicle_facts(c.model);
  const int last = static_cast<int>(facts.tracks.size()) - 1;
  const double ahead = heading_of(c.model, poses, c.model.tyres.front(), 0);
  double sum[2] = {0, 0};
  int count[2] = {0, 0};
  for (std::size_t i = 0; i < c.model.tyres.size(); ++i) {
    const int axle = facts.wheels[i].axle;
    if (axle != 0 && axle != last) continue;
    sum[axle == 0 ? 0 : 1] += heading_of(c.model, poses, c.model.tyres[i], ahead);
    ++count[axle == 0 ? 0 : 1];
  }
  if (count[0] == 0 || count[1] == 0) return {};
  return sum[0] / count[0] - sum[1] / count[1];
}

std::optional<double> steering_slope(const Compilation& compilation, const GenericState& start,
                                     const std::vector<double>& inputs) {
  constexpr double kTurn = 1e-3, kMoves = 1e-6;  // rad at the input; slope
  if (compilation.model.vehicle->steer < 0) return {};
  const auto steered = [&](double change) -> std::optional<double> {
    GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
    std::vector<double> turned = inputs;
    turned[static_cast<std::size_t>(compilation.model.vehicle->steer)] += change;
    solver.set_inputs(turned);
    GenericState state = start;
    if (!solver.project(state).ok()) return {};
    return steer_angle(compilation, state, turned);
  };
  const std::optional<double> ahead = steered(kTurn), behind = steered(-kTurn);
  if (!ahead || !behind) return {};
  const double slope = (*ahead - *behind) / (2 * kTurn);
  return std::abs(slope) > kMoves ? std::optional(slope) : std::nullopt;
}

}  // namespace mbgen
