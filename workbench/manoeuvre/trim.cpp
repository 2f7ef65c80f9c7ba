#include "workbench/manoeuvre/trim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/text/user_error.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/manoeuvre/vehicle_motion.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen {
namespace {

constexpr double kBend = 1;           // m/s^2, the largest change of lateral acceleration at once
constexpr double kFaster = 0.25;      // the largest share by which the speed changes at once
constexpr double kFinest = 1.0 / 16;  // of the way to the next motion: there the search ends
constexpr double kMoves = 1e-3;       // m/s

/// Place of the yaw rate among the goals of a trim: speed along the path, speed across it, yaw rate.
constexpr Eigen::Index kYawRateGoal = 2;

int output_named(const Model& model, std::string_view name) {
  return static_cast<int>(std::ranges::find(model.outputs, name, &Output::name) - model.outputs.begin());
}

/// A speed and a yaw rate.
struct Pace {
  double speed = 0, turn = 0;  ///< m/s, rad/s
  double lateral_acceleration() const { return speed * turn; }
};

Pace pace_of(const TrimRequest& request) {
  if (request.lateral_acceleration) return {request.speed, *request.lateral_acceleration / request.speed};
  return {request.speed, request.radius ? request.speed / *request.radius : 0.0};
}

/// Between two paces: the speed and the lateral acceleration change evenly.
Pace pace_between(const Pace& from, const Pace& to, double share) {
  const double speed = from.speed + share * (to.speed - from.speed);
  return {speed, std::lerp(from.lateral_acceleration(), to.lateral_acceleration(), share) / speed};
}

/// The way from one steady motion to the next.
class PaceWay {
 public:
  PaceWay(Compilation& compilation, const OperatingPoint& start)
      : c_(compilation), heading_(heading_at(compilation, start)), facts_(vehicle_facts(compilation.model)) {
    add_directional(c_);
    reached_.speed = speed_at(c_, start);
    last_.point = start;
    if (reached_.speed < kMoves)
      throw UserError(
          fmt::format("{}: the vehicle stands at the start\n  hint: give it velocities in \"initial\", and "
                      "name the parameter of its speed as \"speed\" in \"vehicle\"\n",
                      c_.model.file));
  }

  /// The steady motion straight on, at the speed of the first request.
  void begin(double speed) {
    const Pace straight{speed, 0};
    if (reach(straight)) return;
    if (c_.model.vehicle->drive < 0)
      throw UserError(
          fmt::format("{}: no steady motion straight on, the vehicle has no drive against drag\n  hint: name "
                      "its input as \"drive\" in \"vehicle\"\n",
                      c_.model.file));
    steady(straight);  // fails with its cause
  }

  /// Whether the motion was reached.
  bool go_to(const Pace& to) {
    const Pace from = reached_;
    const double bends = std::abs(to.lateral_acceleration() - from.lateral_acceleration()) / kBend,
                 faster = std::abs(std::log(to.speed / from.speed)) / kFaster;
    double share = 1 / std::max(1.0, std::ceil(std::max(bends, faster))), done = 0;
    const double least = share * kFinest;
    while (done < 1) {
      const double next = done + share > 1 - least ? 1 : done + share;
      const Pace pace = pace_between(from, to, next);
      if (reach(pace) || (choose_again() && reach(pace))) {
        done = next;
        continue;
      }
      share /= 2;
      if (share < least) return false;
    }
    return true;
  }

  const Pace& reached() const { return reached_; }

  /// The motion at hand with its gains.
  Trim trim() const {
    const OperatingPoint& point = last_.point;
    const std::vector<double> y = outputs_at(c_, point, c_.model.file);
    const Vehicle& vehicle = *c_.model.vehicle;
    Trim trim{.steady = last_, .system = expect(linearise(c_, point))};
    trim.speed = std::hypot(y[index("vehicle_vx")], y[index("vehicle_vy")]);
    if (last_.across[0] >= 0) trim.yaw_rate = reached_.turn;
    trim.lateral_acceleration = trim.speed * trim.yaw_rate;
    trim.steer = point.inputs[static_cast<std::size_t>(vehicle.steer)];
    if (vehicle.drive >= 0) trim.drive = point.inputs[static_cast<std::size_t>(vehicle.drive)];
    trim.sideslip = std::remainder(heading_ - y[index("vehicle_heading")], 2 * std::numbers::pi);
    trim.roll = y[index("vehicle_roll")];
    trim.pitch = y[index("vehicle_pitch")];
    trim.loads.assign(y.end() - static_cast<std::ptrdiff_t>(c_.model.tyres.size()), y.end());
    if (last_.across[0] >= 0) trim.gains = gains(trim);
    return trim;
  }

 private:
  bool reach(const Pace& pace) {
    try {
      last_ = steady(pace);
    } catch (const UserError&) {
      return false;
    }
    reached_ = pace;
    return true;
  }

  /// Chooses the independent coordinates again where those of the compilation become poor. Result: whether it did.
  bool choose_again() {
    std::optional<Compilation> anew = chosen_at(c_, last_.point.z);
    if (anew) c_ = std::move(*anew);
    return anew.has_value();
  }

  std::size_t index(std::string_view name) const { return static_cast<std::size_t>(output_named(c_.model, name)); }

  /// The steady motion of a pace, from the last one with its rates in proportion.
  SteadyMotion steady(const Pace& pace) const {
    OperatingPoint guess = last_.point;
    for (double& rate : guess.zd) rate *= pace.speed / reached_.speed;
    SteadyRequest request;
    request.finds_heading = true;
    request.goals = {{output_named(c_.model, "vehicle_vx"), pace.speed * std::cos(heading_)},
                     {output_named(c_.model, "vehicle_vy"), pace.speed * std::sin(heading_)},
                     {output_named(c_.model, "vehicle_yaw_rate"), pace.turn}};
    const Vehicle& vehicle = *c_.model.vehicle;
    for (const int input : {vehicle.steer, vehicle.drive})
      if (input >= 0) request.solve.push_back(c_.model.inputs[static_cast<std::size_t>(input)].name);
    return steady_motion(c_, guess, request);
  }

  SteeringGains gains(const Trim& trim) const {
    const Eigen::VectorXd by = trim.steady.by_goals.col(kYawRateGoal);
    const Eigen::Index states = trim.system.A.cols();
    const auto change = [&](std::string_view output) {
      const auto row = static_cast<Eigen::Index>(index(output));
      return trim.system.C.row(row).dot(by.head(states)) + trim.system.D.row(row).dot(by.tail(by.size() - states));
    };
    const Vehicle& vehicle = *c_.model.vehicle;
    const double steer = by[states + vehicle.steer];
    SteeringGains gains;
    gains.yaw_rate = 1 / steer;
    gains.lateral_acceleration = trim.speed / steer;
    gains.sideslip = -change("vehicle_heading") / steer;
    gains.understeer_gradient = steer / vehicle.steer_ratio / trim.speed - facts_.wheelbase / (trim.speed * trim.speed);
    gains.roll_gradient = change("vehicle_roll") / trim.speed;
    return gains;
  }

  Compilation& c_;
  double heading_ = 0;  ///< rad, of the path
  VehicleFacts facts_;
  SteadyMotion last_;
  Pace reached_;
};

}  // namespace

void prepare_trims(Model& model) {
  vehicle_facts(model);
  if (model.vehicle->steer < 0)
    throw UserError(fmt::format("{}: \"vehicle\" has no steering input\n  hint: name it as \"steer\"\n", model.file));
  add_vehicle_outputs(model);
}

void incline(Model& model, double grade, double heading) {
  const double down = -model.gravity[2].value, angle = std::atan(grade);
  if (model.gravity[0].value != 0 || model.gravity[1].value != 0)
    throw UserError(fmt::format("{}: gravity is inclined already, a grade is of a level road\n", model.file));
  model.gravity = {-down * std::sin(angle) * std::cos(heading), -down * std::sin(angle) * std::sin(heading),
                   -down * std::cos(angle)};
}

double heading_at(const Compilation& compilation, const OperatingPoint& point) {
  return outputs_at(
      compilation, point,
      compilation.model.file)[static_cast<std::size_t>(output_named(compilation.model, "vehicle_heading"))];
}

double speed_at(const Compilation& compilation, const OperatingPoint& point) {
  const std::vector<double> y = outputs_at(compilation, point, compilation.model.file);
  const auto value = [&](const char* name) {
    return y[static_cast<std::size_t>(output_named(compilation.model, name))];
  };
  return std::hypot(value("vehicle_vx"), value("vehicle_vy"));
}

TrimSeries trim_series(Compilation& compilation, const OperatingPoint& start,
                       const std::vector<TrimRequest>& requests) {
  TrimSeries series;
  PaceWay way(compilation, start);
  way.begin(requests.front().speed);
  for (const TrimRequest& request : requests) {
    const Pace pace = pace_of(request);
    if (!way.go_to(pace)) {
      series.end = fmt::format(
          "no steady motion at {:.4g} m/s with a lateral acceleration of {:.4g} m/s^2: the search came to {:.4g} m/s "
          "and "
          "{:.4g} m/s^2",
          pace.speed, pace.lateral_acceleration(), way.reached().speed, way.reached().lateral_acceleration());
      break;
    }
    series.trims.push_back(way.trim());
  }
  return series;
}

}  // namespace mbgen
