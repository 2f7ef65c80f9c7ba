#include "workbench/kc/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/engines/engine.hpp"

namespace mbgen::kc {
namespace {

constexpr Load kLoadOf[] = {Load::brake_force, Load::drive_force, Load::lateral_force, Load::aligning_moment};

bool is_load(Sweep::Kind kind) { return kind >= Sweep::Kind::brake_force; }

Load load_of(Sweep::Kind kind) { return kLoadOf[static_cast<int>(kind) - static_cast<int>(Sweep::Kind::brake_force)]; }

/// The wheels of the rig; a missing one is empty.
AxleState wheels_of(const Rig& rig, const RigPoint& point) {
  return {wheel_of(rig, point, 0), wheel_of(rig, point, 1)};
}

/// Fills the missing wheel of `state` with the mirror image of the existing wheel of `partner`.
void complete(AxleState& state, const AxleState& partner) {
  if (!state.left.is_there) state.left = mirrored(partner.right);
  if (!state.right.is_there) state.right = mirrored(partner.left);
}

RigInputs scaled(double factor, RigInputs inputs) {
  for (double& value : inputs) value *= factor;
  return inputs;
}

/// Inputs of a point of a curve; a missing wheel has none.
RigInputs imposed_at(const Rig& rig, Sweep::Kind kind, double value) {
  if (kind == Sweep::Kind::steering) return scaled(value, kSteering);
  if (kind == Sweep::Kind::parallel_travel || !is_real(rig, 0) || !is_real(rig, 1)) return scaled(value, kParallel);
  return scaled(value, kOpposite);
}

/// A point under load. Forces and their arms turn with the wheels: directions and balance are found in turns.
Status find_loaded_point(const Rig& rig, Load load, double value, const RigPoint& near, RigPoint& point) {
  constexpr double kTurnsNoMore = 1e-12;
  constexpr int kMostTurns = 50;
  RigInputs direction = both_loads(wheels_of(rig, near), rig, load);
  GenericState state = near.state;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    if (const Status status = find_point(rig, scaled(value, direction), state, point); !status.ok()) return status;
    const RigInputs next = both_loads(wheels_of(rig, point), rig, load);
    double change = 0;
    for (std::size_t i = 0; i < next.size(); ++i) change = std::max(change, std::abs(next[i] - direction[i]));
    if (change < kTurnsNoMore) return {};
    direction = next;
    state = point.state;
  }
  return {Code::no_equilibrium, -1};
}

/// The balance at a value of the curve's input, found from the point at another value: at once, or in smaller steps.
Status walk_to(Rig& rig, const Sweep& sweep, double value, const PointOfCurve& near, RigPoint& found) {
  Status status;
  for (const int parts : {1, 4, 16}) {
    RigPoint at = near.at;
    for (int k = 1; k <= parts; ++k) {
      const double part = k == parts ? value : near.imposed + (value - near.imposed) * k / parts;
      choose_at(rig, at.state);
      RigPoint next;
      status = is_load(sweep.kind) ? find_loaded_point(rig, load_of(sweep.kind), part, at, next)
                                   : find_point(rig, imposed_at(rig, sweep.kind, part), at.state, next);
      if (!status.ok()) break;
      at = std::move(next);
    }
    if (!status.ok()) continue;
    found = std::move(at);
    return {};
  }
  return status;
}

/// A point of a curve, found from a near one with partitions that are well-conditioned there. Result: the reason if
/// there is none, else "".
std::string find_curve_point(Rig& rig, const Sweep& sweep, double value, const PointOfCurve& near,
                             PointOfCurve& found) {
  found.imposed = value;
  if (const Status status = walk_to(rig, sweep, value, near, found.at); !status.ok()) return text(status.code);
  if (is_load(sweep.kind) || !has_rates(rig)) return "";
  choose_at(rig, found.at.state);
  const std::optional<Diagnostic> problem = add_slopes(rig, found.at);
  return problem ? problem->message : "";
}

/// Gives every point its axle. If wheels move against each other, the mirror of the wheel is the wheel at minus the
/// value; points without it are left out.
std::vector<PointOfCurve> completed(const Rig& rig, Sweep::Kind kind, std::vector<PointOfCurve> points) {
  std::vector<AxleState> wheels;
  for (const PointOfCurve& point : points) wheels.push_back(wheels_of(rig, point.at));
  std::vector<PointOfCurve> result;
  const bool has_both = is_real(rig, 0) && is_real(rig, 1);
  const bool is_against = kind == Sweep::Kind::opposite_travel || kind == Sweep::Kind::steering;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t partner = i;
    for (std::size_t k = 0; is_against && k < points.size(); ++k) {
      if (points[k].imposed == -points[i].imposed) partner = k;
    }
    if (is_against && !has_both && points[partner].imposed != -points[i].imposed) continue;
    points[i].axle = wheels[i];
    complete(points[i].axle, wheels[partner]);
    result.push_back(std::move(points[i]));
  }
  return result;
}

}  // namespace

std::string name_of(Sweep::Kind kind) {
  constexpr const char* kNames[] = {"parallel_travel", "opposite_travel", "steering",       "brake_force",
                                    "drive_force",     "lateral_force",   "aligning_moment"};
  return kNames[static_cast<int>(kind)];
}

std::string title_of(Sweep::Kind kind) {
  constexpr const char* kTitles[] = {"Parallel wheel travel",
                                     "Opposite wheel travel",
                                     "Steering",
                                     "Longitudinal force at the contact patch, wheels locked to their carriers",
                                     "Longitudinal force at the wheel centre, torque carried by the body",
                                     "Lateral force at the contact patch",
                                     "Aligning moment"};
  return kTitles[static_cast<int>(kind)];
}

RigInputs both_loads(const AxleState& axle, const Rig& rig, Load load) {
  RigInputs direction{};
  for (const int which : {0, 1}) {
    if (!is_real(rig, which)) continue;
    const RigInputs one = load_direction(axle.wheel(which), load);
    for (std::size_t i = 0; i < one.size(); ++i) direction[i] += one[i];
  }
  return direction;
}

Result<PointOfCurve> start_point(Rig& rig) {
  const Model& model = rig.compilation.model;
  PointOfCurve start;
  choose_at(rig, rig.start);
  const Status status = find_point(rig, {}, rig.start, start.at);
  if (!status.ok()) {
    return problem_of(model, rig.axle, "the rig has no equilibrium at the start: " + describe(rig.compilation, status));
  }
  choose_at(rig, start.at.state);
  if (has_rates(rig))
    if (const std::optional<Diagnostic> problem = add_slopes(rig, start.at))
      return problem_of(model, rig.axle, "the rig has no curves from the start: " + problem->message);
  start.axle = wheels_of(rig, start.at);
  complete(start.axle, start.axle);
  return start;
}

CurvePoints curve_points(const Rig& given, const PointOfCurve& start, const Sweep& sweep, int count,
                         const std::function<bool()>& goes_on) {
  Rig rig = given;
  const int half = count / 2;
  CurvePoints curve;
  std::vector<PointOfCurve> below, above;
  for (const int sign : {-1, 1}) {
    std::vector<PointOfCurve>& side = sign < 0 ? below : above;
    for (int k = 1; k <= half && !curve.is_stopped; ++k) {
      const double value = sign * sweep.amplitude * k / half;
      PointOfCurve point;
      const std::string fault = find_curve_point(rig, sweep, value, side.empty() ? start : side.back(), point);
      if (!fault.empty()) {
        curve.note +=
            fmt::format("{}{} ends before {:g}: {}", curve.note.empty() ? "" : "; ", name_of(sweep.kind), value, fault);
        break;
      }
      side.push_back(std::move(point));
      curve.is_stopped = goes_on && !goes_on();
    }
  }
  std::reverse(below.begin(), below.end());
  below.push_back(start);
  below.insert(below.end(), above.begin(), above.end());
  curve.points = completed(rig, sweep.kind, std::move(below));
  return curve;
}

}  // namespace mbgen::kc
