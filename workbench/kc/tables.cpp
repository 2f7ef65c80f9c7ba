// Values along the curves, and at the start.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "workbench/kc/curves.hpp"

namespace mbgen::kc {
namespace {

/// Direction of the derivatives of a curve.
RigInputs direction_of(Sweep::Kind kind) {
  return kind == Sweep::Kind::opposite_travel ? kOpposite : kind == Sweep::Kind::steering ? kSteering : kParallel;
}

/// A quantity of one wheel. `home`: the same wheel at the start.
struct WheelReading {
  const char *name, *unit, *meaning;
  std::function<double(const WheelState& wheel, const WheelState& home)> read;
  bool needs_steering_axis = false;
};

double change(const DualVector& now, const DualVector& home, int axis) {
  return now[static_cast<std::size_t>(axis)].value - home[static_cast<std::size_t>(axis)].value;
}

/// Angles and lengths of a wheel.
std::vector<WheelReading> position_readings() {
  const auto angle = [](Dual WheelGeometry::*member) {
    return [member](const WheelState& wheel, const WheelState&) { return (geometry_of(wheel).*member).value; };
  };
  using G = WheelGeometry;
  return {
      {"steer_angle", "rad", "of the wheel, to the left", angle(&G::steer_angle)},
      {"toe", "rad", "toe-in", angle(&G::toe)},
      {"camber", "rad", "top outwards", angle(&G::camber)},
      {"caster", "rad", "steering axis leans back", angle(&G::caster), true},
      {"kingpin_inclination", "rad", "steering axis leans inwards", angle(&G::kingpin_inclination), true},
      {"caster_trail", "m", "steering axis meets the road ahead of the contact", angle(&G::caster_trail), true},
      {"scrub_radius", "m", "steering axis meets the road inside of the contact", angle(&G::scrub_radius), true},
      {"centre_x", "m", "way of the wheel centre forward",
       [](const WheelState& wheel, const WheelState& home) { return change(wheel.centre, home.centre, 0); }},
      {"centre_y", "m", "way of the wheel centre to the left",
       [](const WheelState& wheel, const WheelState& home) { return change(wheel.centre, home.centre, 1); }},
      {"contact_y", "m", "way of the contact centre to the left",
       [](const WheelState& wheel, const WheelState& home) {
         return change(geometry_of(wheel).patch, geometry_of(home).patch, 1);
       }},
      {"load", "N", "vertical, of the pad",
       [](const WheelState& wheel, const WheelState&) { return wheel.load.value; }},
  };
}

/// Rate of a wheel's load with its own travel, when both wheels move along a direction.
double wheel_rate(const WheelState& wheel, const RigInputs& direction) {
  const double own = direction[wheel.side > 0 ? kTravelLeft : kTravelRight];
  return along(wheel.load, direction) / own;
}

Column column(const std::string& name, const std::string& unit, const std::vector<PointOfCurve>& points,
              const std::function<double(const PointOfCurve&)>& read) {
  Column result{{name, unit}, {}};
  for (const PointOfCurve& point : points) result.values.push_back(read(point));
  return result;
}

/// Change of the wheelbase since the start, by the mean of both contact centres.
double wheelbase_change(const Axle& axle, const AxleState& now, const AxleState& home) {
  const double forward = 0.5 * (change(geometry_of(now.left).patch, geometry_of(home.left).patch, 0) +
                                change(geometry_of(now.right).patch, geometry_of(home.right).patch, 0));
  return axle.end == Axle::End::front ? forward : -forward;
}

/// Steering over the mean angle of the wheels: a number for angles, per rad for others.
double steer_ratio(const Rig& rig, const AxleState& axle) {
  constexpr double kDegree = 0.017453292519943295;  // rad
  return steering_rate(axle) * (rig.steer_unit == "deg" ? kDegree : 1);
}

std::string unit_of_steer_ratio(const Rig& rig) {
  if (rig.steer_unit == "rad" || rig.steer_unit == "deg") return "1";
  return (rig.steer_unit.empty() ? "1" : rig.steer_unit) + "/rad";
}

/// Collects the columns of a table.
class TableBuilder {
 public:
  TableBuilder(const Rig& rig, const PointOfCurve& start, Sweep::Kind kind, const std::vector<PointOfCurve>& points)
      : rig_(rig), start_(start), kind_(kind), points_(points) {}

  void add(const std::string& name, const std::string& unit, const std::function<double(const PointOfCurve&)>& read) {
    columns_.push_back(column(name, unit, points_, read));
  }

  void add_wheels(const WheelReading& reading) {
    for (const int which : {0, 1}) {
      if (!is_real(rig_, which) || (reading.needs_steering_axis && !start_.axle.wheel(which).has_steering_axis))
        continue;
      add(fmt::format("{}_{}", reading.name, which == 0 ? "left" : "right"), reading.unit,
          [&](const PointOfCurve& point) { return reading.read(point.axle.wheel(which), start_.axle.wheel(which)); });
    }
  }

  void add_travel() {
    const RigInputs direction = direction_of(kind_);
    if (has_rates(rig_)) {
      const std::size_t before = columns_.size();
      add_wheels({"wheel_rate", "N/m", "",
                  [direction](const WheelState& wheel, const WheelState&) { return wheel_rate(wheel, direction); }});
      mark_rates(before);
    }
    add("track_change", "m", [&](const PointOfCurve& point) { return track_of(point.axle) - track_of(start_.axle); });
    add("wheelbase_change", "m",
        [&](const PointOfCurve& point) { return wheelbase_change(rig_.axle, point.axle, start_.axle); });
    if (!has_rates(rig_)) return;
    const std::size_t before = columns_.size();
    add("roll_centre_height", "m", [](const PointOfCurve& point) { return roll_centre(point.axle).height; });
    if (kind_ == Sweep::Kind::opposite_travel) {
      add("roll_centre_to_left", "m", [](const PointOfCurve& point) { return roll_centre(point.axle).to_left; });
      add("roll_rate", "N m/rad", [](const PointOfCurve& point) { return roll_rate(point.axle); });
    } else {
      const std::vector<AntiShare> shares = anti_shares(rig_.axle, start_.axle);
      for (std::size_t i = 0; i < shares.size(); ++i)
        add(shares[i].name, "1",
            [&, i](const PointOfCurve& point) { return anti_shares(rig_.axle, point.axle)[i].value; });
    }
    for (const RigElement& element : rig_.elements) {
      if (!follows_wheels(element, start_.at)) continue;
      add("ratio_" + element.name, element.unit == "rad" ? "rad/m" : "1",
          [&, direction](const PointOfCurve& point) { return along(deflection_of(element, point.at), direction); });
    }
    mark_rates(before);
  }

  void add_steering() {
    if (has_rates(rig_)) {
      add("steer_ratio", unit_of_steer_ratio(rig_),
          [this](const PointOfCurve& point) { return steer_ratio(rig_, point.axle); });
      mark_rates(columns_.size() - 1);
    }
    if (!rig_.axle.wheelbase) return;
    add("ackermann", "1", [&](const PointOfCurve& point) {
      const auto steered = [](const WheelState& wheel, const WheelState& home) {
        return geometry_of(wheel).steer_angle.value - geometry_of(home).steer_angle.value;
      };
      return ackermann(steered(point.axle.left, start_.axle.left), steered(point.axle.right, start_.axle.right),
                       track_of(start_.axle), *rig_.axle.wheelbase);
    });
  }

  KcTable take() { return {name_of(kind_), title_of(kind_), std::move(columns_), std::move(rates_)}; }

 private:
  /// The columns from this one on are derivatives.
  void mark_rates(std::size_t first) {
    for (std::size_t c = first; c < columns_.size(); ++c) rates_.push_back(columns_[c].heading.name);
  }

  const Rig& rig_;
  const PointOfCurve& start_;
  Sweep::Kind kind_;
  const std::vector<PointOfCurve>& points_;
  std::vector<Column> columns_;
  std::vector<std::string> rates_;
};

Heading abscissa_of(const Rig& rig, Sweep::Kind kind) {
  if (kind <= Sweep::Kind::opposite_travel) return {"travel", "m"};
  if (kind == Sweep::Kind::steering) return {"steer", rig.steer_unit};
  return kind == Sweep::Kind::aligning_moment ? Heading{"moment", "N m"} : Heading{"force", "N"};
}

/// Collects values at the start.
class FigureList {
 public:
  FigureList(const Rig& rig, const AxleState& axle) : rig_(rig), axle_(axle) {}

  void add(std::string name, std::string unit, std::string meaning, double value) {
    list_.push_back({std::move(name), std::move(unit), std::move(meaning), {value}});
  }

  void add_wheels(const std::string& name, const std::string& unit, const std::string& meaning,
                  const std::function<double(const WheelState&)>& read) {
    KcFigure figure{name, unit, meaning, {}};
    for (const int which : {0, 1}) {
      if (is_real(rig_, which)) figure.values.push_back(read(axle_.wheel(which)));
    }
    list_.push_back(std::move(figure));
  }

  void add_positions() {
    for (const WheelReading& reading : position_readings()) {
      const std::string name = reading.name;
      const bool has_axis = axle_.wheel(is_real(rig_, 0) ? 0 : 1).has_steering_axis;
      if (name.starts_with("centre_") || name == "contact_y" || (reading.needs_steering_axis && !has_axis)) continue;
      add_wheels(name, reading.unit, reading.meaning, [&](const WheelState& w) { return reading.read(w, w); });
    }
  }

  void add_rates() {
    const auto rate = [](Dual WheelGeometry::*member) {
      return [member](const WheelState& wheel) { return along(geometry_of(wheel).*member, kParallel); };
    };
    add_wheels("toe_gradient", "rad/m", "toe over parallel travel", rate(&WheelGeometry::toe));
    add_wheels("camber_gradient", "rad/m", "camber over parallel travel", rate(&WheelGeometry::camber));
    add_wheels("wheel_rate", "N/m", "load over parallel travel",
               [](const WheelState& wheel) { return wheel_rate(wheel, kParallel); });
    add_wheels("wheel_rate_roll", "N/m", "load over opposite travel",
               [](const WheelState& wheel) { return wheel_rate(wheel, kOpposite); });
    add("roll_rate", "N m/rad", "track^2/2 times the wheel rate in opposite travel", roll_rate(axle_));
    add("track", "m", "between the contact centres", track_of(axle_));
    add("roll_centre_height", "m", "above the road, by the ways of the contact centres", roll_centre(axle_).height);
    for (const AntiShare& share : anti_shares(rig_.axle, axle_)) add(share.name, "1", share.meaning, share.value);
    if (rig_.inputs[kSteer] >= 0)
      add("steer_ratio", unit_of_steer_ratio(rig_), "steering over the mean angle of the wheels",
          steer_ratio(rig_, axle_));
  }

  void add_elements(const RigPoint& start) {
    const bool has_both = is_real(rig_, 0) && is_real(rig_, 1);
    for (const RigElement& element : rig_.elements) {
      if (!follows_wheels(element, start)) continue;
      const Dual deflection = deflection_of(element, start);
      const std::string unit = element.unit == "rad" ? "rad/m" : "1";
      add("ratio_" + element.name, unit, "deflection over parallel travel", along(deflection, kParallel));
      if (has_both)
        add("ratio_roll_" + element.name, unit, "deflection over opposite travel", along(deflection, kOpposite));
    }
  }

  void add_compliances() {
    const struct {
      Load load;
      const char *name, *per, *meaning;
    } loads[] = {{Load::brake_force, "brake_force", "/N", "a force forward at the contact, wheel locked"},
                 {Load::drive_force, "drive_force", "/N", "a force forward at the wheel centre"},
                 {Load::lateral_force, "lateral_force", "/N", "a force to the left at the contact"},
                 {Load::aligning_moment, "aligning_moment", "/(N m)", "a moment about z"}};
    for (const auto& one : loads) {
      const RigInputs direction = both_loads(axle_, rig_, one.load);
      const auto angle = [&](Dual WheelGeometry::*member) {
        return [member, direction](const WheelState& wheel) { return along(geometry_of(wheel).*member, direction); };
      };
      const std::string over = std::string(" over ") + one.meaning, by = std::string("_by_") + one.name;
      add_wheels("steer" + by, std::string("rad") + one.per, "steer angle" + over, angle(&WheelGeometry::steer_angle));
      add_wheels("camber" + by, std::string("rad") + one.per, "camber" + over, angle(&WheelGeometry::camber));
      if (one.load == Load::aligning_moment) continue;
      const std::size_t axis = one.load == Load::lateral_force ? 1 : 0;
      add_wheels((axis == 1 ? "centre_y" : "centre_x") + by, std::string("m") + one.per,
                 "way of the wheel centre" + over,
                 [axis, direction](const WheelState& wheel) { return along(wheel.centre[axis], direction); });
    }
  }

  std::vector<KcFigure> take() { return std::move(list_); }

 private:
  const Rig& rig_;
  const AxleState& axle_;
  std::vector<KcFigure> list_;
};

}  // namespace

double steering_rate(const AxleState& axle) {
  const double rate = 0.5 * (along(geometry_of(axle.left).steer_angle, kSteering) +
                             along(geometry_of(axle.right).steer_angle, kSteering));
  return 1 / rate;
}

Dual deflection_of(const RigElement& element, const RigPoint& point) {
  Dual result;
  const auto add = [&](int output, double factor) {
    if (output < 0) return;
    result.value += factor * point.values[static_cast<std::size_t>(output)];
    for (int i = 0; i < kRigInputs && point.slopes.size() > 0; ++i)
      result.slope[static_cast<std::size_t>(i)] += factor * point.slopes(output, i);
  };
  add(element.output, element.sense);
  add(element.less, -element.sense);
  return result;
}

bool follows_wheels(const RigElement& element, const RigPoint& start) {
  constexpr double kMoves = 1e-9;
  const Dual deflection = deflection_of(element, start);
  return std::abs(deflection.slope[kTravelLeft]) + std::abs(deflection.slope[kTravelRight]) > kMoves;
}

std::vector<AntiShare> anti_shares(const Axle& axle, const AxleState& state) {
  if (!axle.wheelbase || !axle.centre_of_gravity_height) return {};
  const double lever = *axle.wheelbase / *axle.centre_of_gravity_height;
  const bool is_front = axle.end == Axle::End::front;
  const double sign = is_front ? 1 : -1;
  std::vector<AntiShare> shares;
  if (axle.brake_share) {
    shares.push_back({is_front ? "anti_dive" : "anti_lift",
                      "share of the load transfer under braking that no spring carries",
                      sign * *axle.brake_share * longitudinal_slope(state, axle.brakes_on) * lever});
  }
  if (axle.drive_share) {
    shares.push_back({is_front ? "anti_lift_drive" : "anti_squat",
                      "share of the load transfer under drive that no spring carries",
                      sign * *axle.drive_share * longitudinal_slope(state, axle.drive_on) * lever});
  }
  return shares;
}

KcTable curve_table(const Rig& rig, const PointOfCurve& start, const Sweep& sweep,
                    const std::vector<PointOfCurve>& points) {
  TableBuilder table(rig, start, sweep.kind, points);
  const Heading abscissa = abscissa_of(rig, sweep.kind);
  table.add(abscissa.name, abscissa.unit, [](const PointOfCurve& point) { return point.imposed; });
  // Toe serves curves of travel, the steer angle curves of steering and loads.
  const std::string left_out = sweep.kind <= Sweep::Kind::opposite_travel ? "steer_angle" : "toe";
  for (const WheelReading& reading : position_readings()) {
    if (reading.name != left_out) table.add_wheels(reading);
  }
  if (sweep.kind <= Sweep::Kind::opposite_travel) table.add_travel();
  if (sweep.kind == Sweep::Kind::steering) table.add_steering();
  return table.take();
}

std::vector<KcFigure> figures(const Rig& rig, const PointOfCurve& start, bool is_compliant) {
  FigureList list(rig, start.axle);
  list.add_positions();
  list.add_rates();
  list.add_elements(start.at);
  if (is_compliant) list.add_compliances();
  return list.take();
}

}  // namespace mbgen::kc
