#include "workbench/report/modes.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "workbench/report/ground.hpp"
#include "workbench/report/places.hpp"
#include "workbench/report/poses.hpp"
#include "workbench/report/scene.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// The largest swing: over the model's size, and rad. The page shows half of it at first.
constexpr double kLargestMotion = 0.1, kLargestTurn = 0.5;
/// By what and how often the swing is made smaller until the loops close, and what the closures may add to the linear
/// motion, over it.
constexpr double kSmaller = 0.75;
constexpr int kMostTrials = 20;
constexpr double kLargestCorrection = 0.35;
/// Deviation of a mode's largest coordinate at which the displacement of the shapes is measured.
constexpr double kSmallDeviation = 1e-6;
/// Frames of a period, and numbers that all modes of a page may have; more modes have fewer frames.
constexpr std::size_t kMostFrames = 32, kFewestFrames = 12, kMostModeNumbers = 320'000;

/// Largest displacement of a shape, and largest turn of a body.
struct Moved {
  double motion = 0;  ///< m
  double turn = 0;    ///< rad, small angles
};

/// The frame's turn: the Frobenius norm of the difference is 2 sqrt(2) sin(angle / 2).
double turn_between(const Matrix3& a, const Matrix3& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (b[i] - a[i]) * (b[i] - a[i]);
  return std::sqrt(squares / 2);
}

Moved moved_between(const std::vector<BodyPlace>& places, const std::vector<Pose>& a, const std::vector<Pose>& b) {
  Moved moved;
  for (const BodyPlace& place : places) {
    const Pose &from = a[place.body], &to = b[place.body];
    const double turn = turn_between(from.rotation, to.rotation);
    const double shift = distance(to_global(from, place.at), to_global(to, place.at));
    moved.motion = std::max(moved.motion, shift + place.margin * turn);
    moved.turn = std::max(moved.turn, turn);
  }
  return moved;
}

GenericState state_of(const OperatingPoint& point) {
  return {point.z, std::vector<double>(point.z.size()), point.x, point.t};
}

/// The point plus the linear deviation of a mode at a phase (rad).
GenericState deviated(const OperatingPoint& point, const Mode& mode, double amplitude, double phase) {
  GenericState state = state_of(point);
  const std::complex<double> turned = std::polar(amplitude, phase);
  for (std::size_t i = 0; i < state.z.size(); ++i) state.z[i] += (turned * mode.coordinates[i]).real();
  return state;
}

double phase_of(std::size_t frame, std::size_t count) {
  return 2 * std::numbers::pi * static_cast<double>(frame) / static_cast<double>(count);
}

/// Frames with closed loops for half of an amplitude and for all of it. Fails: loops that do not close, or only far
/// away.
std::optional<std::vector<GenericState>> closed_frames(const ModesSource& source, const GenericSolver& solver,
                                                       const std::vector<BodyPlace>& places, const Mode& mode,
                                                       double amplitude, const Moved& linear, std::size_t count) {
  std::vector<GenericState> frames;
  for (std::size_t k = 0; k < 2 * count; ++k) {
    const double part = k < count ? amplitude / 2 : amplitude;
    GenericState state = deviated(source.point, mode, part, phase_of(k, count));
    const std::vector<Pose> before = solver.poses(state);
    if (!solver.project(state).ok()) return std::nullopt;
    const Moved correction = moved_between(places, before, solver.poses(state));
    const double allowed = kLargestCorrection * amplitude;
    if (!(correction.motion <= allowed * linear.motion && correction.turn <= allowed * linear.turn + kSmallDeviation)) {
      return std::nullopt;
    }
    frames.push_back(std::move(state));
  }
  return frames;
}

Json mode_json(const ModesSource& source, const GenericSolver& solver, const Mode& mode, std::size_t frames,
               const std::vector<Quaternion>& rest) {
  const Swing swing = swing_of(source, solver, mode, mode.oscillates() ? frames : 2);
  std::vector<float> numbers;
  for (const GenericState& frame : swing.frames) {
    std::vector<Quaternion> before = rest;
    add_poses(solver.poses(frame), before, numbers);
  }
  return {{"name", leading_coordinates(source.model, source.topology, source.analysis, mode)},
          {"kind", "mode"},
          {"eigenvalue", {mode.eigenvalue.real(), mode.eigenvalue.imag()}},
          {"frequency", mode.frequency()},
          {"damping_ratio", mode.damping_ratio()},
          {"oscillates", mode.oscillates()},
          {"neutral", mode.is_neutral},
          {"unstable", mode.is_unstable},
          {"motion", swing.motion},
          {"count", swing.frames.size() / 2},
          {"poses", base64(numbers)}};
}

GenericSolver solver_at(const ModesSource& source) {
  GenericSolver solver(source.model, source.topology, source.analysis);
  solver.set_inputs(source.point.inputs);
  return solver;
}

}  // namespace

Swing swing_of(const ModesSource& source, const GenericSolver& solver, const Mode& mode, std::size_t count) {
  const std::vector<BodyPlace> places = drawn_places(source.model);
  const std::vector<Pose> rest = solver.poses(state_of(source.point));
  Moved linear;  // per amplitude
  for (std::size_t k = 0; k < count; ++k) {
    const GenericState state = deviated(source.point, mode, kSmallDeviation, phase_of(k, count));
    const Moved moved = moved_between(places, rest, solver.poses(state));
    linear.motion = std::max(linear.motion, moved.motion / kSmallDeviation);
    linear.turn = std::max(linear.turn, moved.turn / kSmallDeviation);
  }
  Swing swing{std::vector<GenericState>(2 * count, state_of(source.point)), 0};
  constexpr double kNothing = 1e-6;  // rounding error relative to the small deviation
  if (!(std::max(linear.motion, linear.turn) > kNothing)) return swing;
  double amplitude = std::min(kLargestMotion * model_size(source.model) / linear.motion, kLargestTurn / linear.turn);
  for (int trial = 0; trial < kMostTrials; ++trial, amplitude *= kSmaller) {
    auto frames = closed_frames(source, solver, places, mode, amplitude, linear, count);
    if (!frames) continue;
    swing.frames = std::move(*frames);
    for (const GenericState& frame : swing.frames) {
      swing.motion = std::max(swing.motion, moved_between(places, rest, solver.poses(frame)).motion);
    }
    break;
  }
  return swing;
}

Json modes_json(const ModesSource& source) {
  const GenericSolver solver = solver_at(source);
  const std::size_t all = 2 * kPoseNumbers * source.model.bodies.size() * std::max<std::size_t>(1, source.modes.size());
  const std::size_t frames = std::clamp(kMostModeNumbers / all / 2 * 2, kFewestFrames, kMostFrames);
  std::vector<float> rest;
  std::vector<Quaternion> turns;
  add_poses(solver.poses(state_of(source.point)), turns, rest);
  Json list = Json::array();
  for (const Mode& mode : source.modes) list.push_back(mode_json(source, solver, mode, frames, turns));
  return {{"point", {{"state", source.state}, {"drift", source.drift}}}, {"rest", base64(rest)}, {"animations", list}};
}

Json ground_at_point(const ModesSource& source) {
  return ground_json(source.model, solver_at(source), {state_of(source.point)}, true);
}

Vector3 carried(const ModesSource& source, int body, const Vector3& place) {
  if (body < 0) return place;
  const Pose pose = solver_at(source).poses(state_of(source.point))[static_cast<std::size_t>(body)];
  return to_global(pose, to_local(source.model.bodies[static_cast<std::size_t>(body)].pose, place));
}

}  // namespace mbgen
