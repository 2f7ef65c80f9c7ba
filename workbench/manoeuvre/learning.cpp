#include "workbench/manoeuvre/learning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/compile.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/manoeuvre/course_watch.hpp"
#include "workbench/manoeuvre/trim.hpp"
#include "workbench/manoeuvre/vehicle_motion.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

constexpr double kGentle = 0.2;  // m/s^2, of the bend in which forces steer

[[noreturn]] void fail(const std::string& file, const std::string& cause) {
  throw UserError(fmt::format(
      "{}: /driver/learns: {}\n  hint: give \"understeer\" in place of \"learns\", and \"steer_ratio\" in the "
      "model's section \"vehicle\"\n",
      file, cause));
}

/// Angle of the wheels over the steering input between two steady motions; none where they do not differ.
std::optional<double> slope_between(const Compilation& compilation, const Trim& one, const Trim& other) {
  const auto angle = [&](const Trim& trim) {
    const OperatingPoint& at = trim.steady.point;
    return steer_angle(compilation, {at.z, at.zd, at.x, at.t}, at.inputs);
  };
  const std::optional<double> first = angle(one), second = angle(other);
  if (!first || !second || other.steer == one.steer || *second == *first) return {};
  return (*second - *first) / (other.steer - one.steer);
}

/// The slope is of difference quotients: five digits count.
double rounded(double value) { return std::stod(fmt::format("{:.5g}", value)); }

}  // namespace

LearnedVehicle learn_vehicle(const Model& model, const std::string& file) {
  Model seen = model;
  if (std::ranges::find(seen.outputs, "vehicle_vx", &Output::name) == seen.outputs.end()) prepare_trims(seen);
  Compilation compilation = expect(compile(std::move(seen)));
  const std::vector<double> inputs = input_values(compilation.model, {});
  const GenericState start = initial_state(compilation, inputs);
  const OperatingPoint point{start.z, start.zd, start.x, start.t, inputs};
  const double speed = speed_at(compilation, point);
  std::optional<double> slope = steering_slope(compilation, start, inputs);
  const TrimSeries series =
      trim_series(compilation, point, {{.speed = speed}, {.speed = speed, .lateral_acceleration = kGentle}});
  if (series.trims.size() < 2 || !series.trims.front().gains) fail(file, "there is no steady motion straight on");
  // Where forces steer the wheels, as a rack that an input pushes, they turn in the bend alone.
  if (!slope) slope = slope_between(compilation, series.trims[0], series.trims[1]);
  if (!slope) fail(file, "the steering input turns no wheels");
  LearnedVehicle learned{.steer_ratio = rounded(1 / *slope)};
  const double steer = 1 / (speed * series.trims.front().gains->yaw_rate);  // over lateral acceleration
  learned.understeer = steer / learned.steer_ratio - vehicle_facts(compilation.model).wheelbase / (speed * speed);
  return learned;
}

}  // namespace mbgen
