#include "workbench/manoeuvre/vehicle_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "compiler/expressions/unit_exponents.hpp"
#include "compiler/model/element_access.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// Outputs in this order, then the loads; before them kX to kAy of the towed unit, its heading and yaw rate.
constexpr std::size_t kTowed = 8;
enum Index : std::size_t { kX, kY, kVx, kVy, kAx, kAy, kAz, kHeading, kPitch, kRoll, kYawRate, kLoads };

Vector3 centre_of(const Model& model, const Tyre& tyre) { return reference_position(model, tyre.centre); }

/// Positions of axles along x, from front to rear.
std::vector<double> axle_places(const Model& model) {
  std::vector<double> all, places;
  for (const Tyre& tyre : model.tyres) all.push_back(centre_of(model, tyre)[0]);
  std::sort(all.rbegin(), all.rend());
  for (const double x : all)
    if (places.empty() || places.back() - x > kSameAxle) places.push_back(x);
  return places;
}

void add_output(Model& model, const std::string& name, const char* unit, decltype(Output::source) source) {
  const auto has_name = [&](const Output& output) { return output.name == name; };
  if (std::any_of(model.outputs.begin(), model.outputs.end(), has_name)) {
    throw UserError(
        fmt::format("{}: output \"{}\" has the name of one that manoeuvres add: give it another\n", model.file, name));
  }
  model.outputs.push_back({name, {}, unit, std::move(source), {}});
}

/// Adds kX to kAy of a point.
void add_plane_outputs(Model& model, const std::string& of, const Attachment& at) {
  using What = PointOutput::What;
  const auto point = [&](const char* name, const char* unit, What what, int axis) {
    add_output(model, of + name, unit, PointOutput{.what = what, .point = at, .axis = axis});
  };
  point("_x", "m", What::position, 0);
  point("_y", "m", What::position, 1);
  point("_vx", "m/s", What::velocity, 0);
  point("_vy", "m/s", What::velocity, 1);
  point("_ax", "m/s^2", What::acceleration, 0);
  point("_ay", "m/s^2", What::acceleration, 1);
}

void add_turn(Model& model, const std::string& name, int body, int index) {
  add_output(model, name, "rad", RotationOutput{.body = body, .turn = index});
}

void add_yaw_rate(Model& model, const std::string& name, int body) {
  add_output(model, name, "rad/s",
             RotationOutput{.what = RotationOutput::What::angular_velocity, .body = body, .axis = 2});
}

/// Plane motion from kX to kAy, with the heading nearest to the last one.
PlaneMotion plane_motion(const double* y, double remainder, double last_heading) {
  const double c = std::cos(remainder), s = std::sin(remainder);
  const double heading = last_heading + std::remainder(remainder - last_heading, 2 * std::numbers::pi);
  return {y[kX], y[kY], heading, c * y[kVx] + s * y[kVy], c * y[kVy] - s * y[kVx], c * y[kAy] - s * y[kAx]};
}

/// Fails for an input of the vehicle in a multiple of a unit in which manoeuvres and trims set it.
void require_unit(const Model& model, int input, const char* key, std::initializer_list<const char*> units) {
  if (input < 0) return;
  const Input& one = model.inputs[static_cast<std::size_t>(input)];
  const std::optional<UnitExponents> found = unit_exponents(one.unit);
  if (!found || found->factor == 1) return;
  for (const char* unit : units) {
    if (!are_alike(*found, *unit_exponents(unit))) continue;
    throw UserError(
        Diagnostics{{one.where,
                     fmt::format("input \"{}\" is the vehicle's \"{}\": manoeuvres and trims set it in {}, not in {}",
                                 one.name, key, unit, one.unit),
                     fmt::format("declare it in {}, and convert it where the model uses it", unit),
                     {}}});
  }
}

void require_units(const Model& model) {
  const Vehicle& vehicle = *model.vehicle;
  require_unit(model, vehicle.steer, "steer", {"rad", "m", "N", "N m"});
  require_unit(model, vehicle.drive, "drive", {"N m", "N"});
  require_unit(model, vehicle.brake, "brake", {"N m", "N"});
}

}  // namespace

std::vector<int> axles_of_tyres(const Model& model) {
  const std::vector<double> places = axle_places(model);
  std::vector<int> axles;
  for (const Tyre& tyre : model.tyres) {
    const auto is_there = [&](double x) { return x - centre_of(model, tyre)[0] <= kSameAxle; };
    axles.push_back(static_cast<int>(std::ranges::find_if(places, is_there) - places.begin()));
  }
  return axles;
}

VehicleFacts vehicle_facts(const Model& model) {
  if (!model.vehicle) {
    throw UserError(
        fmt::format("{}: the model has no vehicle\n  hint: give it a section \"vehicle\" with its inputs, see "
                    "docs/use/manoeuvres.md\n",
                    model.file));
  }
  if (model.tyres.empty()) throw UserError(fmt::format("{}: the vehicle has no tyres\n", model.file));
  require_units(model);
  const Vehicle& vehicle = *model.vehicle;
  VehicleFacts facts;
  for (const Body& body : model.bodies) facts.mass += body.mass.value;
  for (const Rod& rod : model.rods) facts.mass += rod.mass.value;
  const std::vector<double> places = axle_places(model);
  const Vector3 reference = reference_position(model, vehicle.reference);
  const std::vector<int> axles = axles_of_tyres(model);
  for (std::size_t i = 0; i < model.tyres.size(); ++i) {
    const Tyre& tyre = model.tyres[i];
    facts.wheels.push_back({tyre.name, axles[i], centre_of(model, tyre)[1] >= reference[1]});
    facts.radius += tyre.radius.value / static_cast<double>(model.tyres.size());
  }
  for (std::size_t axle = 0; axle < places.size(); ++axle) {
    double left = -std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t i = 0; i < model.tyres.size(); ++i) {
      if (facts.wheels[i].axle != static_cast<int>(axle)) continue;
      left = std::max(left, centre_of(model, model.tyres[i])[1]);
      right = std::min(right, centre_of(model, model.tyres[i])[1]);
    }
    facts.tracks.push_back(left - right);
  }
  facts.front = places.front() - reference[0];
  facts.rear = reference[0] - places.back();
  if (vehicle.towed.body >= 0) facts.towed_rear = reference_position(model, vehicle.towed)[0] - places.back();
  facts.wheelbase = vehicle.wheelbase.value_or(places.front() - places.back());
  if (!(facts.wheelbase > 0)) {
    throw UserError(
        fmt::format("{}: \"vehicle\": all tyres stand in one line across; give \"wheelbase\"\n", model.file));
  }
  return facts;
}

void add_vehicle_outputs(Model& model) {
  const Attachment reference = model.vehicle->reference, towed = model.vehicle->towed;
  if (towed.body >= 0) {
    add_plane_outputs(model, "towed", towed);
    add_turn(model, "towed_heading", towed.body, 0);
    add_yaw_rate(model, "towed_yaw_rate", towed.body);
  }
  add_plane_outputs(model, "vehicle", reference);
  add_output(model, "vehicle_az", "m/s^2",
             PointOutput{.what = PointOutput::What::acceleration, .point = reference, .axis = 2});
  add_turn(model, "vehicle_heading", reference.body, 0);
  add_turn(model, "vehicle_pitch", reference.body, 1);
  add_turn(model, "vehicle_roll", reference.body, 2);
  add_yaw_rate(model, "vehicle_yaw_rate", reference.body);
  for (std::size_t i = 0; i < model.tyres.size(); ++i)
    add_output(model, "vehicle_load_" + model.tyres[i].name, "N", output_of<Tyre>("load", i));
}

std::size_t first_vehicle_output(const Model& model) { return model.outputs.size() - model.tyres.size() - kLoads; }

VehicleReading vehicle_reading(const Sample& sample, std::size_t first, const VehicleReading& last) {
  const double* y = sample.outputs.y.data() + first;
  VehicleReading reading;
  const double c = std::cos(y[kHeading]), s = std::sin(y[kHeading]);
  reading.plane = plane_motion(y, y[kHeading], last.plane.heading);
  if (last.towed) {
    const double* const towed = y - kTowed;
    reading.towed = {plane_motion(towed, towed[kTowed - 2], last.towed->plane.heading), towed[kTowed - 1]};
  }
  reading.longitudinal_acceleration = c * y[kAx] + s * y[kAy];
  reading.vertical_acceleration = y[kAz];
  reading.yaw_rate = y[kYawRate];
  reading.roll = y[kRoll];
  reading.pitch = y[kPitch];
  reading.loads.assign(y + kLoads, sample.outputs.y.data() + sample.outputs.y.size());
  return reading;
}

void append(VehicleSeries& series, double t, const VehicleReading& reading, double steer) {
  series.t.push_back(t);
  series.x.push_back(reading.plane.x);
  series.y.push_back(reading.plane.y);
  series.heading.push_back(reading.plane.heading);
  series.speed.push_back(reading.plane.forward);
  series.lateral_speed.push_back(reading.plane.left);
  series.longitudinal_acceleration.push_back(reading.longitudinal_acceleration);
  series.lateral_acceleration.push_back(reading.plane.lateral_acceleration);
  series.vertical_acceleration.push_back(reading.vertical_acceleration);
  series.yaw_rate.push_back(reading.yaw_rate);
  series.roll.push_back(reading.roll);
  series.pitch.push_back(reading.pitch);
  series.steer.push_back(steer);
  if (const auto& towed = reading.towed) {
    series.towed.x.push_back(towed->plane.x);
    series.towed.y.push_back(towed->plane.y);
    series.towed.heading.push_back(towed->plane.heading);
    series.towed.lateral_acceleration.push_back(towed->plane.lateral_acceleration);
    series.towed.yaw_rate.push_back(towed->yaw_rate);
  }
  series.loads.resize(reading.loads.size());
  for (std::size_t i = 0; i < reading.loads.size(); ++i) series.loads[i].push_back(reading.loads[i]);
}

}  // namespace mbgen
