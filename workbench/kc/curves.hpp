#pragma once
// The curves of a rig: successive points, and their evaluation.

#include <functional>
#include <string>
#include <vector>

#include "workbench/kc/geometry.hpp"
#include "workbench/kc/kc_report.hpp"

namespace mbgen::kc {

/// Imposed motion of a curve.
struct Sweep {
  enum class Kind {
    parallel_travel,
    opposite_travel,
    steering,
    brake_force,
    drive_force,
    lateral_force,
    aligning_moment
  };
  Kind kind = Kind::parallel_travel;
  double amplitude = 0;
};

/// A point of a curve with its axle; for an axle with one wheel the other one is its mirror image.
struct PointOfCurve {
  double imposed = 0;
  RigPoint at;
  AxleState axle;
};

/// The points of a curve from the lowest value to the highest, and the reason for an early end, "" without one.
struct CurvePoints {
  std::vector<PointOfCurve> points;
  std::string note;
  bool is_stopped = false;  ///< by its watcher, before the last point
};

/// The point with zero inputs; the rig gets partitions that are well-conditioned there. Fails: with one problem if
/// there is no equilibrium, or no derivatives where the rig has rates.
Result<PointOfCurve> start_point(Rig& rig);

/// goes_on: called after every point.
CurvePoints curve_points(const Rig& rig, const PointOfCurve& start, const Sweep& sweep, int count,
                         const std::function<bool()>& goes_on = {});

/// Name of a curve, used for its files, and its title.
std::string name_of(Sweep::Kind kind);
std::string title_of(Sweep::Kind kind);

/// Deflection of an element, with derivatives.
Dual deflection_of(const RigElement& element, const RigPoint& point);

/// Whether an element moves with the wheels.
bool follows_wheels(const RigElement& element, const RigPoint& start);

/// Table of values along a curve.
KcTable curve_table(const Rig& rig, const PointOfCurve& start, const Sweep& sweep,
                    const std::vector<PointOfCurve>& points);

/// Steering input or coordinate over the mean angle of the wheels, in the unit of the rig's steering per rad.
double steering_rate(const AxleState& axle);

/// Values at the start.
std::vector<KcFigure> figures(const Rig& rig, const PointOfCurve& start, bool is_compliant);

/// Effect of a unit load at both wheels, or at the only one.
RigInputs both_loads(const AxleState& axle, const Rig& rig, Load load);

/// Whether a wheel is on the rig; the other one of a lone wheel is a mirror image.
inline bool is_real(const Rig& rig, int which) { return rig.wheels[static_cast<std::size_t>(which)].centre >= 0; }

/// Shares of anti-dive, anti-lift and anti-squat at a point, named by the axle's end; none if the axle lacks the
/// necessary data.
struct AntiShare {
  std::string name, meaning;
  double value;
};
std::vector<AntiShare> anti_shares(const Axle& axle, const AxleState& state);

}  // namespace mbgen::kc
