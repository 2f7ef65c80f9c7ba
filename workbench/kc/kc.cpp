#include "workbench/kc/kc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/text/user_error.hpp"
#include "workbench/kc/compliance.hpp"
#include "workbench/kc/curves.hpp"
#include "workbench/kc/rig_freedom.hpp"

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

/// The axle; one without a wheelbase gets the distance to the only axle at the other end of the model.
Axle with_wheelbase(const Model& model, Axle axle) {
  const auto is_opposite = [&](const Axle& other) { return other.end != axle.end && other.body == axle.body; };
  if (axle.wheelbase || std::count_if(model.axles.begin(), model.axles.end(), is_opposite) != 1) return axle;
  const auto opposite = std::find_if(model.axles.begin(), model.axles.end(), is_opposite);
  axle.wheelbase = std::abs(place_of(model, axle) - place_of(model, *opposite));
  return axle;
}

/// Whether the wheels move under load.
bool is_compliant(const Rig& rig, const PointOfCurve& start) {
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
double mean_load(const Rig& rig, const PointOfCurve& start) {
  double sum = 0;
  int count = 0;
  for (const int which : {0, 1}) {
    if (!is_real(rig, which)) continue;
    sum += start.axle.wheel(which).load.value;
    ++count;
  }
  return sum / count;
}

std::vector<Sweep> all_sweeps(const Rig& rig, const PointOfCurve& start, const KcSettings& options, bool with_loads) {
  constexpr double kTravel = 0.05, kSteerAngle = 0.3, kSteerWay = 0.03, kLeastForce = 1000, kLever = 0.05;
  const double travel = options.travel.value_or(kTravel);
  std::vector<Sweep> sweeps = {{Kind::parallel_travel, travel}, {Kind::opposite_travel, travel}};
  if (rig.inputs[kSteer] >= 0) {
    const double usual = options.steer                  ? *options.steer
                         : rig.axle.steering_input >= 0 ? kSteerAngle * std::abs(steering_rate(start.axle))
                         : rig.steer_unit == "rad"      ? kSteerAngle
                                                        : kSteerWay;
    sweeps.push_back({Kind::steering, usual});
  }
  if (!with_loads) return sweeps;
  const double force = options.force.value_or(std::max(kLeastForce, 0.5 * mean_load(rig, start)));
  for (const Kind kind : {Kind::brake_force, Kind::drive_force, Kind::lateral_force}) sweeps.push_back({kind, force});
  sweeps.push_back({Kind::aligning_moment, options.moment.value_or(kLever * force)});
  return sweeps;
}

/// The curves that are asked for.
std::vector<Sweep> sweeps_of(const Rig& rig, const PointOfCurve& start, const KcSettings& options, bool with_loads) {
  std::vector<Sweep> sweeps = all_sweeps(rig, start, options, with_loads);
  if (!options.curves.empty())
    std::erase_if(sweeps, [&](const Sweep& one) { return std::ranges::count(options.curves, name_of(one.kind)) == 0; });
  return sweeps;
}

/// A rig at its start.
struct StandingRig {
  Rig rig;
  PointOfCurve start;
  Pads pads;
};

Result<StandingRig> standing_rig(const Compilation& user, const Axle& axle, const OperatingPoint& at, const Pads& pads,
                                 bool with_rates, const RigDecisions* known) {
  Result<Rig> rig = make_rig(user, axle, at, pads, known);
  if (!rig) return rig.problems();
  if (with_rates) {
    add_programs(rig->compilation);
    add_directional(rig->compilation);
  }
  Result<PointOfCurve> start = start_point(*rig);
  if (!start) return start.problems();
  return StandingRig{std::move(*rig), std::move(*start), pads};
}

/// Wheels that are on pads, or hang free, together.
struct OtherWheels {
  std::string name;  ///< for a note
  std::set<int> tyres;
};

/// The other axles with wheels on tyres, then tyres of no axle.
std::vector<OtherWheels> other_wheels(const Model& model, const Axle& axle) {
  std::vector<OtherWheels> list;
  std::set<int> rest;
  for (std::size_t i = 0; i < model.tyres.size(); ++i) rest.insert(static_cast<int>(i));
  const auto take = [&](const Axle& of) {
    OtherWheels wheels{fmt::format("axle \"{}\"", of.name), {}};
    for (const int i : rest) {
      const int body = model.tyres[static_cast<std::size_t>(i)].centre.body;
      if (body == of.left.centre.body || body == of.right.centre.body) wheels.tyres.insert(i);
    }
    for (const int i : wheels.tyres) rest.erase(i);
    return wheels;
  };
  take(axle);
  for (const Axle& other : model.axles) {
    OtherWheels wheels = take(other);
    if (!wheels.tyres.empty()) list.push_back(std::move(wheels));
  }
  for (const int i : rest) {
    list.push_back({fmt::format("tyre \"{}\"", model.tyres[static_cast<std::size_t>(i)].name), {i}});
  }
  return list;
}

std::string note_of_hanging(const std::vector<OtherWheels>& hanging) {
  std::string names;
  for (std::size_t i = 0; i < hanging.size(); ++i)
    names += (i == 0 ? "" : i + 1 == hanging.size() ? " and " : ", ") + hanging[i].name;
  return fmt::format("wheels of {} hang free: on pads they would have no position of rest", names);
}

/// The rig with other axles on pads; axles that cannot stand there hang free, with a note. Fails: UserError. Cost: a
/// rig for each other axle if one cannot stand.
StandingRig standing_rig(const Compilation& user, const Axle& axle, const OperatingPoint& at, bool with_rates,
                         std::vector<std::string>& notes) {
  Result<StandingRig> on_pads = standing_rig(user, axle, at, Pads{}, with_rates, nullptr);
  if (on_pads) return std::move(*on_pads);
  if (const std::optional<Diagnostic> fault = ride_fault(user, axle, at)) throw UserError(Diagnostics{*fault});
  std::vector<OtherWheels> hanging = other_wheels(user.model, axle);
  Pads pads;
  for (const OtherWheels& wheels : hanging) pads.hanging.insert(wheels.tyres.begin(), wheels.tyres.end());
  Result<StandingRig> best = standing_rig(user, axle, at, pads, with_rates, nullptr);
  if (!best) throw UserError(on_pads.problems());
  // Every axle that can stand is put back on its pads.
  for (std::size_t i = 0; i < hanging.size() && hanging.size() > 1;) {
    Pads more = pads;
    for (const int tyre : hanging[i].tyres) more.hanging.erase(tyre);
    Result<StandingRig> next = standing_rig(user, axle, at, more, with_rates, nullptr);
    if (!next) {
      ++i;
      continue;
    }
    best = std::move(next);
    pads = std::move(more);
    hanging.erase(hanging.begin() + static_cast<std::ptrdiff_t>(i));
  }
  notes.push_back(note_of_hanging(hanging));
  return std::move(*best);
}

}  // namespace

std::vector<const Axle*> find_axles(const Model& model, const std::vector<std::string>& names) {
  std::vector<const Axle*> axles;
  for (const std::string& name : names) {
    const Axle& axle = find_axle(model, name);
    if (std::find(axles.begin(), axles.end(), &axle) == axles.end()) axles.push_back(&axle);
  }
  if (!names.empty()) return axles;
  if (model.axles.empty()) find_axle(model, "");
  for (const Axle& axle : model.axles) axles.push_back(&axle);
  return axles;
}

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

std::shared_ptr<const RigDecisions> decisions_of_rig(const Compilation& compilation, const Axle& axle,
                                                     const OperatingPoint& at) {
  std::vector<std::string> notes;
  StandingRig standing = standing_rig(compilation, with_wheelbase(compilation.model, axle), at, false, notes);
  Compilation& made = standing.rig.compilation;
  return std::make_shared<const RigDecisions>(
      RigDecisions{std::move(standing.pads), std::move(made.topology), std::move(made.analysis)});
}

KcReport kinematics_and_compliance(const Compilation& compilation, const Axle& axle, const OperatingPoint& at,
                                   const KcSettings& options, const KcWatch& watch) {
  const Axle whole = with_wheelbase(compilation.model, axle);
  KcReport report{.model = compilation.model.name, .axle = axle.name};
  const RigDecisions* known = options.decisions.get();
  const auto [rig, start, pads] =
      known == nullptr ? standing_rig(compilation, whole, at, options.has_rates, report.notes)
                       : expect(standing_rig(compilation, whole, at, known->pads, options.has_rates, known));
  const bool with_loads = !options.has_rates || is_compliant(rig, start);
  if (options.has_rates) {
    report.figures = figures(rig, start, with_loads);
    report.matrices = compliance_matrices(rig, start);
  }
  if (!with_loads) report.notes.emplace_back("nothing gives way between the wheels and the body: no curves of loads");
  if (options.steer && rig.inputs[kSteer] < 0)
    report.notes.emplace_back("the axle has no steering: --steer changes nothing");
  const std::vector<Sweep> sweeps = sweeps_of(rig, start, options, with_loads);
  const long all = static_cast<long>(sweeps.size()) * 2 * (options.points / 2);
  long done = 0;
  const auto goes_on = [&] { return !watch || watch(++done, all); };
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const CurvePoints curve = curve_points(rig, start, sweeps[i], options.points, goes_on);
    if (!curve.note.empty()) report.notes.push_back(curve.note);
    report.tables.push_back(curve_table(rig, start, sweeps[i], curve.points));
    if (!curve.is_stopped) continue;
    std::string note = fmt::format("interrupted: {} is not complete", name_of(sweeps[i].kind));
    for (std::size_t k = i + 1; k < sweeps.size(); ++k)
      note += fmt::format("{}{}", k == i + 1 ? "; there is no " : ", ", name_of(sweeps[k].kind));
    report.notes.push_back(std::move(note));
    break;
  }
  return report;
}

}  // namespace mbgen
