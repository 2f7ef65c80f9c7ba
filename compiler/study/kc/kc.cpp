#include "compiler/study/kc/kc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/user_error.hpp"
#include "compiler/study/kc/curves.hpp"

namespace mbgen {
namespace {

using namespace kc;
using Kind = Sweep::Kind;

/// Mean x of an axle's wheel centres at the reference, m.
double place_of(const Model& model, const Axle& axle) {
  double sum = 0;
  int count = 0;
  for (const AxleWheel* wheel : {&axle.left, &axle.right}) {
    if (!wheel->is_there()) continue;
    sum += reference_position(model, wheel->centre)[0];
    ++count;
  }
  return sum / count;
}

/// The axle with the wheelbase of the model where it tells none and the model has one axle at the other end.
Axle with_wheelbase(const Model& model, Axle axle) {
  const auto is_opposite = [&](const Axle& other) { return other.end != axle.end && other.body == axle.body; };
  if (axle.wheelbase || std::count_if(model.axles.begin(), model.axles.end(), is_opposite) != 1) return axle;
  const auto opposite = std::find_if(model.axles.begin(), model.axles.end(), is_opposite);
  axle.wheelbase = std::abs(place_of(model, axle) - place_of(model, *opposite));
  return axle;
}

/// Whether loads at the wheels move them.
bool is_compliant(const Rig& rig, const CurvePoint& start) {
  constexpr double kMoves = 1e-14;  // m/N or rad/N: rubber gives 1e-9 and more
  for (const Load load : {Load::brake_force, Load::lateral_force, Load::aligning_moment}) {
    const RigInputs direction = both_loads(start.axle, rig, load);
    for (const int which : {0, 1}) {
      if (!is_real(rig, which)) continue;
      const WheelState& wheel = start.axle.wheel(which);
      for (const DualVector* vector : {&wheel.centre, &wheel.axis}) {
        const Vector3 way = along(*vector, direction);
        if (std::abs(way[0]) + std::abs(way[1]) + std::abs(way[2]) > kMoves) return true;
      }
    }
  }
  return false;
}

/// Mean load of the wheels on the rig.
double mean_load(const Rig& rig, const CurvePoint& start) {
  double sum = 0;
  int count = 0;
  for (const int which : {0, 1}) {
    if (!is_real(rig, which)) continue;
    sum += start.axle.wheel(which).load.value;
    ++count;
  }
  return sum / count;
}

std::vector<Sweep> sweeps_of(const Rig& rig, const CurvePoint& start, const KcWish& wish, bool with_loads) {
  constexpr double kTravel = 0.05, kSteerAngle = 0.3, kSteerWay = 0.03, kLeastForce = 1000, kLever = 0.05;
  const double travel = wish.travel.value_or(kTravel);
  std::vector<Sweep> sweeps = {{Kind::parallel_travel, travel}, {Kind::opposite_travel, travel}};
  if (rig.inputs[kSteer] >= 0)
    sweeps.push_back({Kind::steering, wish.steer.value_or(rig.steer_unit == "rad" ? kSteerAngle : kSteerWay)});
  if (!with_loads) return sweeps;
  const double force = wish.force.value_or(std::max(kLeastForce, 0.5 * mean_load(rig, start)));
  for (const Kind kind : {Kind::brake_force, Kind::drive_force, Kind::lateral_force}) sweeps.push_back({kind, force});
  sweeps.push_back({Kind::aligning_moment, wish.moment.value_or(kLever * force)});
  return sweeps;
}

}  // namespace

const Axle& find_axle(const Model& model, const std::string& name) {
  std::string known;
  for (const Axle& axle : model.axles) {
    if (axle.name == name) return axle;
    known += (known.empty() ? "" : ", ") + axle.name;
  }
  if (model.axles.empty()) {
    throw UserError(
        fmt::format("{}: the model has no axles\n  hint: describe one in \"axles\", see docs/use/kc.md\n", model.file));
  }
  if (name.empty() && model.axles.size() == 1) return model.axles.front();
  throw UserError(name.empty() ? fmt::format("{}: name one of the axles: {}\n", model.file, known)
                               : fmt::format("{}: unknown axle \"{}\"; known: {}\n", model.file, name, known));
}

KcReport kinematics_and_compliance(const Compilation& compilation, const Axle& axle, const OperatingPoint& at,
                                   const KcWish& wish) {
  const Axle whole = with_wheelbase(compilation.model, axle);
  Rig rig = make_rig(compilation, whole, at);
  const CurvePoint start = start_point(rig);
  const bool with_loads = is_compliant(rig, start);
  KcReport report{compilation.model.name, axle.name, figures(rig, start, with_loads), {}, {}};
  if (!with_loads) report.notes.emplace_back("nothing gives way between the wheels and the body: no curves of loads");
  for (const Sweep& sweep : sweeps_of(rig, start, wish, with_loads)) {
    const CurvePoints curve = curve_points(rig, start, sweep, wish.points);
    if (!curve.note.empty()) report.notes.push_back(curve.note);
    report.tables.push_back(curve_table(rig, start, sweep, curve.points));
  }
  return report;
}

}  // namespace mbgen
