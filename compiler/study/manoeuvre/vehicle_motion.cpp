#include "compiler/study/manoeuvre/vehicle_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/base/user_error.hpp"

namespace mbgen {
namespace {

/// Outputs in this order, then the loads.
enum Index : std::size_t { kX, kY, kVx, kVy, kAx, kAy, kAz, kHeading, kPitch, kRoll, kYawRate, kLoads };

Vector3 centre_of(const Model& model, const Tyre& tyre) { return reference_position(model, tyre.centre); }

/// Places of axles along x, from front to rear.
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

}  // namespace

VehicleFacts vehicle_facts(const Model& model) {
  if (!model.vehicle) {
    throw UserError(
        fmt::format("{}: the model has no vehicle\n  hint: give it a section \"vehicle\" with its inputs, see "
                    "docs/use/manoeuvres.md\n",
                    model.file));
  }
  if (model.tyres.empty()) throw UserError(fmt::format("{}: the vehicle has no tyres\n", model.file));
  const Vehicle& vehicle = *model.vehicle;
  VehicleFacts facts;
  for (const Body& body : model.bodies) facts.mass += body.mass.value;
  for (const Rod& rod : model.rods) facts.mass += rod.mass.value;
  const std::vector<double> places = axle_places(model);
  const Vector3 reference = reference_position(model, vehicle.reference);
  for (const Tyre& tyre : model.tyres) {
    const Vector3 centre = centre_of(model, tyre);
    const auto is_there = [&](double x) { return x - centre[0] <= kSameAxle; };
    const auto axle = std::find_if(places.begin(), places.end(), is_there);
    facts.wheels.push_back({tyre.name, static_cast<int>(axle - places.begin()), centre[1] >= reference[1]});
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
  facts.wheelbase = vehicle.wheelbase.value_or(places.front() - places.back());
  if (!(facts.wheelbase > 0)) {
    throw UserError(
        fmt::format("{}: \"vehicle\": all tyres stand in one line across; give \"wheelbase\"\n", model.file));
  }
  return facts;
}

void add_vehicle_outputs(Model& model) {
  const Attachment reference = model.vehicle->reference;
  using What = PointOutput::What;
  const auto point = [&](const char* name, const char* unit, What what, int axis) {
    add_output(model, name, unit, PointOutput{.what = what, .point = reference, .axis = axis});
  };
  const auto turn = [&](const char* name, int index) {
    add_output(model, name, "rad", RotationOutput{.body = reference.body, .turn = index});
  };
  point("vehicle_x", "m", What::position, 0);
  point("vehicle_y", "m", What::position, 1);
  point("vehicle_vx", "m/s", What::velocity, 0);
  point("vehicle_vy", "m/s", What::velocity, 1);
  point("vehicle_ax", "m/s^2", What::acceleration, 0);
  point("vehicle_ay", "m/s^2", What::acceleration, 1);
  point("vehicle_az", "m/s^2", What::acceleration, 2);
  turn("vehicle_heading", 0);
  turn("vehicle_pitch", 1);
  turn("vehicle_roll", 2);
  add_output(model, "vehicle_yaw_rate", "rad/s",
             RotationOutput{.what = RotationOutput::What::angular_velocity, .body = reference.body, .axis = 2});
  for (std::size_t i = 0; i < model.tyres.size(); ++i)
    add_output(model, "vehicle_load_" + model.tyres[i].name, "N",
               TyreOutput{TyreOutput::What::load, static_cast<int>(i)});
}

std::size_t first_vehicle_output(const Model& model) { return model.outputs.size() - model.tyres.size() - kLoads; }

VehicleReading vehicle_reading(const Sample& sample, std::size_t first, double last_heading) {
  const double* y = sample.outputs.y.data() + first;
  VehicleReading reading;
  const double c = std::cos(y[kHeading]), s = std::sin(y[kHeading]);
  constexpr double kTurn = 2 * std::numbers::pi;
  const double heading = last_heading + std::remainder(y[kHeading] - last_heading, kTurn);
  reading.plane = {y[kX], y[kY], heading, c * y[kVx] + s * y[kVy], c * y[kVy] - s * y[kVx], c * y[kAy] - s * y[kAx]};
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
  series.loads.resize(reading.loads.size());
  for (std::size_t i = 0; i < reading.loads.size(); ++i) series.loads[i].push_back(reading.loads[i]);
}

}  // namespace mbgen
