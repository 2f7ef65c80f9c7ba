#include "workbench/manoeuvre/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compiler/text/read_text.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

constexpr double kSettles = 5;        // s, before a slow change
constexpr double kSettlesOnRoad = 1;  // s, from the flat start to a rough road

/// Fails for an input that the manoeuvre moves by the vehicle's keys, or that is a derivative of its steering.
void refuse_own_input(const Model& model, const Event& event, int input) {
  const Vehicle& vehicle = *model.vehicle;
  const auto refuse = [&](const char* key, const char* how) {
    throw UserError(Diagnostics{{event.input_where,
                                 fmt::format("input {} {} the vehicle's \"{}\"", in_quotes(*event.input), how, key),
                                 fmt::format("give the event \"{}\" in place of \"input\"", key),
                                 {}}});
  };
  if (input == vehicle.steer) refuse("steer", "is");
  if (input == vehicle.drive) refuse("drive", "is");
  if (input == vehicle.brake) refuse("brake", "is");
  for (int i = vehicle.steer; i >= 0; i = model.inputs[static_cast<std::size_t>(i)].derivative)
    if (i == input) refuse("steer", "is a derivative of");
}

[[noreturn]] void refuse_input(const Model& model, const Event& event) {
  std::vector<std::string_view> known;
  for (const Input& input : model.inputs) known.push_back(input.name);
  throw UserError(Diagnostics{{event.input_where,
                               "unknown input " + in_quotes(*event.input),
                               known.empty() ? model.file + " has no inputs" : did_you_mean(*event.input, known),
                               {}}});
}

/// Makes the plan of each type.
struct Planner {
  const Model& model;
  const VehicleFacts& facts;
  const std::string& file;

  const Vehicle& vehicle() const { return *model.vehicle; }

  void require(bool is_there, const char* what) const {
    if (is_there) return;
    throw UserError(
        fmt::format("{}: this manoeuvre needs \"{}\" in the section \"vehicle\" of {}\n", file, what, model.file));
  }

  /// Sum of the wheels' torques, N m, for an acceleration of the whole vehicle.
  double torque_of(double acceleration) const { return facts.mass * facts.radius * acceleration; }

  double within_limit(double steer) const {
    const std::optional<double>& limit = vehicle().steer_limit;
    if (limit && std::abs(steer) > *limit)
      throw UserError(fmt::format("{}: {:.6g} rad at the steering input are beyond its steer_limit, {:.6g} rad\n", file,
                                  steer, *limit));
    return steer;
  }

  /// Fails if the sum of a signal's parts goes beyond the limit, at instants of control up to the end of its
  /// changes.
  void check_limit(const Signal& steer, double end, double period) const {
    constexpr double kMostInstants = 1e6, kRounding = 1e-9;
    const std::optional<double>& limit = vehicle().steer_limit;
    if (!limit) return;
    const double step = std::max(period, end / kMostInstants), count = std::ceil(end / step);
    double most = 0, when = 0;
    for (double i = 0; i <= count; ++i) {
      const double t = std::min(i * step, end), angle = steer.at(t).value;
      if (std::abs(angle) > std::abs(most)) most = angle, when = t;
    }
    if (std::abs(most) > *limit * (1 + kRounding))
      throw UserError(
          fmt::format("{}: {:.6g} rad at the steering input at t = {:.4g} s are beyond its steer_limit, {:.6g} rad\n",
                      file, most, when, *limit));
  }

  /// A plan at constant speed, with steering by its signal or by the driver.
  Plan at_speed(const ManoeuvreBase& base, bool steers) const {
    require(vehicle().drive >= 0, "drive");
    if (steers) require(vehicle().steer >= 0, "steer");
    Plan plan;
    plan.speed.add(base.speed.value_or(0));
    plan.torques.push_back({.holds_speed = true});
    return plan;
  }

  /// Amplitude at the steering input, rad.
  double amplitude(const ManoeuvreBase& base, const SteerAmplitude& wanted) const {
    if (wanted.steer) return within_limit(*wanted.steer);
    const double speed = *base.speed, wheels = facts.wheelbase / (speed * speed) + base.driver.understeer;
    return within_limit(vehicle().steer_ratio * wheels * *wanted.lateral_acceleration);
  }

  /// Sign of an angle at the input, or of y, for a side.
  static double sign(Side side) { return side == Side::left ? 1 : -1; }

  void drive_along(Plan& plan, Path path) const {
    plan.has_driver = true;
    plan.path = std::move(path);
  }

  Plan operator()(const EventManoeuvre& events) const;
  Plan operator()(const CircleManoeuvre& circle) const;
  Plan operator()(const LaneManoeuvre& lanes) const;
  Plan operator()(const BrakingManoeuvre& braking) const;

  Plan operator()(const StepManoeuvre& step) const {
    constexpr double kRise = 0.15, kAfter = 6;  // s
    Plan plan = at_speed(step, true);
    const double turned = step.lateral_acceleration ? 1 : std::copysign(1.0, vehicle().steer_ratio);
    const double angle = sign(step.side) * turned * amplitude(step, step);
    plan.steer.add_change(angle, step.at, step.rate ? kSmoothRate * std::abs(angle) / *step.rate : kRise);
    plan.length_of = "at";
    plan.duration = step.at + kAfter;
    return plan;
  }

  Plan operator()(const SweepManoeuvre& sweep) const {
    constexpr double kSweep = 40, kBefore = 1, kAfter = 3;  // s; behind it the response dies out
    Plan plan = at_speed(sweep, true);
    const double straight = kBefore + sweep_fade(sweep.last_frequency) + kAfter;
    plan.duration = sweep.duration.value_or(kSweep + straight);
    if (plan.duration <= straight)
      throw UserError(
          fmt::format("{}: /duration: {:g} s are too short for a sweep: {:g} s of them are before and behind "
                      "it\n  hint: leave it out for a sweep of {:g} s\n",
                      file, plan.duration, straight, kSweep));
    plan.steer.add_sweep(amplitude(sweep, sweep), kBefore, sweep.first_frequency, sweep.last_frequency,
                         plan.duration - straight);
    return plan;
  }

  Plan operator()(const WeaveManoeuvre& weave) const {
    constexpr double kBefore = 1;  // s
    Plan plan = at_speed(weave, true);
    plan.begin = kBefore;
    plan.steer.add_sine(amplitude(weave, weave), kBefore, weave.frequency, weave.cycles);
    plan.length_of = weave.frequency < 1 ? "frequency" : "cycles";
    plan.duration = kBefore + weave.cycles / weave.frequency;
    return plan;
  }

  Plan operator()(const DwellManoeuvre& dwell) const {
    constexpr double kReleased = 0.1, kAfter = 4;  // s
    Plan plan = at_speed(dwell, true);
    const double turned = dwell.lateral_acceleration ? 1 : std::copysign(1.0, vehicle().steer_ratio);
    plan.steer.add_sine_with_dwell(sign(dwell.side) * turned * amplitude(dwell, dwell), dwell.at, dwell.frequency,
                                   dwell.dwell);
    plan.torques.push_back({.at = dwell.at, .over = kReleased});
    plan.length_of = "at";
    plan.duration = dwell.end() + kAfter;
    return plan;
  }

  Plan operator()(const TrackManoeuvre& track) const;
  Plan operator()(const StartManoeuvre& start) const;

  Plan operator()(const RideManoeuvre& ride) const {
    Plan plan = at_speed(ride, false);
    if (vehicle().steer >= 0) drive_along(plan, straight_path());
    plan.begin = kSettlesOnRoad;
    plan.duration = model.solver.duration;
    return plan;
  }

  static Path straight_path() {
    return path_of_curvature([](double) { return 0.0; }, 0, 1);
  }
};

Plan Planner::operator()(const EventManoeuvre& events) const {
  Plan plan;
  if (events.speed) require(vehicle().drive >= 0, "drive");
  plan.speed.add(events.speed.value_or(0));
  plan.torques.push_back({.holds_speed = events.speed.has_value()});
  double last = 0;
  for (const Event& event : events.events) {
    TorquePhase torque{event.at, event.over, false, plan.torques.back().drive, plan.torques.back().brake};
    if (event.steer || !event.steer_table.empty()) require(vehicle().steer >= 0, "steer");
    if (event.drive || event.speed) require(vehicle().drive >= 0, "drive");
    if (event.brake) require(vehicle().brake >= 0, "brake");
    double end = event.at + event.over;
    if (event.frequency) {
      plan.steer.add_sine(within_limit(*event.steer), event.at, *event.frequency, event.cycles);
      end = event.at + event.cycles / *event.frequency;
    } else if (event.steer) {
      plan.steer.go_to(within_limit(*event.steer), event.at, event.over);
    } else if (!event.steer_table.empty()) {
      plan.steer.add_table(event.steer_table, event.at);
      end = event.at + event.steer_table.back()[0];
    } else if (event.input) {
      const auto has_name = [&](const Input& input) { return input.name == *event.input; };
      const auto input = std::find_if(model.inputs.begin(), model.inputs.end(), has_name);
      if (input == model.inputs.end()) refuse_input(model, event);
      const int place = static_cast<int>(input - model.inputs.begin());
      refuse_own_input(model, event, place);
      plan.others.push_back({place, event.at, event.over, event.value});
    } else {
      if (event.drive) torque.drive = *event.drive;
      if (event.brake) torque.drive = 0, torque.brake = *event.brake;
      if (event.is_free) torque.drive = torque.brake = 0;
      if (event.speed) {
        torque = {.at = event.at, .holds_speed = true};
        plan.speed.go_to(*event.speed, event.at, event.over);
      }
      plan.torques.push_back(torque);
    }
    last = std::max(last, end);
  }
  check_limit(plan.steer, last, events.period);
  plan.length_of = "events";
  plan.duration = last + kSettles;
  return plan;
}

Plan Planner::operator()(const CircleManoeuvre& circle) const {
  constexpr double kStraight = 1, kTransition = 3, kSlowly = 60;  // s
  Plan plan = at_speed(circle, true);
  plan.largest_lateral_acceleration = circle.largest_lateral_acceleration;
  const double first = *circle.speed;
  double begin = kStraight + kTransition + kSettles, last = circle.last_speed.value_or(2 * first);
  if (circle.method == CircleManoeuvre::Method::radius) {
    // Slightly above the limit, at which the manoeuvre ends.
    last = circle.last_speed.value_or(1.05 * std::sqrt(circle.largest_lateral_acceleration * *circle.radius));
    if (last > kMostSpeed)
      throw UserError(
          Diagnostics{{circle.radius_where,
                       fmt::format("at {:g} m the speed has to grow to {:.4g} m/s for {:g} m/s^2, beyond {:g} m/s",
                                   *circle.radius, last, circle.largest_lateral_acceleration, kMostSpeed),
                       "give \"last_speed\" or a smaller radius, in m", ""}});
    drive_along(plan, circle_path(kStraight * first, sign(circle.side) * *circle.radius, kTransition * first));
  } else {
    const double angle = within_limit(*circle.steer) * sign(circle.side) * std::copysign(1.0, vehicle().steer_ratio);
    const bool is_slow = circle.method == CircleManoeuvre::Method::speed;
    if (is_slow) {
      plan.duration = circle.duration.value_or(kSlowly);
      // The ramp takes as long as its change at the full rate, and at most a second more.
      const double rest = plan.duration - kStraight, whole = std::max(rest - 1, rest / 2);
      if (whole <= 0)
        throw UserError(fmt::format("{}: /duration: the steering begins after {:g} s, got {:g} s\n", file, kStraight,
                                    plan.duration));
      plan.steer.add_ramp(angle, kStraight, std::abs(angle) / whole);
      return plan;
    }
    plan.steer.add_change(angle, kStraight, kTransition);
  }
  plan.begin = begin;
  plan.length_of = "acceleration";
  if (last > first) plan.speed.add_ramp(last - first, begin, circle.acceleration);
  plan.duration = begin + std::max(0.0, last - first) / circle.acceleration + kSettles;
  return plan;
}

Plan Planner::operator()(const LaneManoeuvre& lanes) const {
  constexpr double kBeyond = 20, kIntoTheTrack = 2;  // m
  Plan plan = at_speed(lanes, true);
  const std::optional<double> width = lanes.width ? lanes.width : vehicle().width;
  if (!width)
    throw UserError(
        fmt::format("{}: lanes are as wide as the vehicle says: give \"width\" in this file or in the "
                    "section \"vehicle\" of {}\n",
                    file, model.file));
  const bool is_avoidance = lanes.track == LaneManoeuvre::Track::iso_3888_2;
  plan.sections = (is_avoidance ? obstacle_avoidance : double_lane_change)(*width, lanes.approach, sign(lanes.side));
  plan.last_way = plan.sections.back().to + facts.rear + kBeyond;
  if (is_avoidance) plan.free_way = lanes.approach - facts.front + kIntoTheTrack;
  drive_along(plan, lane_path(plan.sections));
  plan.length_of = lanes.approach > *lanes.speed ? "approach" : "speed";
  plan.duration = 2 * plan.last_way / *lanes.speed;
  return plan;
}

Plan Planner::operator()(const BrakingManoeuvre& braking) const {
  require(vehicle().brake >= 0, "brake");
  Plan plan = at_speed(braking, braking.has_driver);
  const double torque = braking.brake ? *braking.brake : torque_of(*braking.deceleration);
  plan.torques.push_back({braking.at, braking.over, false, 0, torque});
  plan.last_speed = braking.last_speed;
  plan.is_straight = !braking.has_driver;
  plan.path = straight_path();
  plan.has_driver = braking.has_driver;
  plan.length_of = braking.brake ? "brake" : "deceleration";
  // Three times the duration with the whole torque: wheels may lock.
  plan.duration = braking.at + braking.over + 3 * *braking.speed * torque_of(1) / torque + kSettles;
  return plan;
}

Plan Planner::operator()(const TrackManoeuvre& manoeuvre) const {
  constexpr double kLonger = 1.2;  // the vehicle is slower than the profile
  Plan plan = at_speed(manoeuvre, true);
  const std::string path = (std::filesystem::path(file).parent_path() / manoeuvre.path).string();
  const reading::FileText content = reading::read_text(path);
  if (!content.problem.empty())
    throw UserError(
        Diagnostics{{manoeuvre.path_where, fmt::format("{}: {}", path, content.problem), hint_of_missing(path), {}}});
  Track track = track_through(read_track(content.text, path), manoeuvre.is_closed, static_cast<int>(manoeuvre.laps));
  limit_speeds(track, manoeuvre, *manoeuvre.speed);
  for (const double speed : track.speeds) plan.duration += track.path.spacing / speed;
  plan.duration = kLonger * plan.duration + kSettles;
  plan.length_of = "path";
  // A closed course ends at its start, behind its last point.
  plan.last_way = manoeuvre.is_closed ? track.length * manoeuvre.laps
                                      : track.path.spacing * static_cast<double>(track.path.points.size() - 1);
  drive_along(plan, track.path);
  plan.track = std::move(track);
  return plan;
}

Plan Planner::operator()(const StartManoeuvre& start) const {
  constexpr double kSlow = 0.5;  // m/s^2: the least mean acceleration that the duration allows for
  require(vehicle().drive >= 0, "drive");
  if (start.brake > 0) require(vehicle().brake >= 0, "brake");
  if (!start.drive) require(vehicle().drive_limit.has_value(), "drive_limit");
  Plan plan;
  plan.torques = {{.brake = start.brake},
                  {start.at, start.over, false, start.drive.value_or(vehicle().drive_limit.value_or(0)), 0}};
  plan.is_straight = !start.has_driver;
  plan.path = straight_path();
  plan.has_driver = start.has_driver;
  plan.above_speed = start.last_speed;
  plan.length_of = "last_speed";
  plan.duration = start.at + start.over + start.last_speed / kSlow + kSettles;
  return plan;
}

}  // namespace

double wanted_speed(const Plan& plan, double t, double way) {
  return plan.track ? speed_at(*plan.track, way) : plan.speed.at(t).value;
}

Plan plan_of(const Manoeuvre& manoeuvre, const Model& model, const VehicleFacts& facts, const std::string& file) {
  Plan plan = std::visit(Planner{model, facts, file}, manoeuvre);
  if (const std::optional<double>& duration = base_of(manoeuvre).duration) {
    plan.duration = *duration;
    plan.length_of = "duration";
  }
  return plan;
}

}  // namespace mbgen
