#include "workbench/manoeuvre/learning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/compile.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/manoeuvre/course_watch.hpp"
#include "workbench/manoeuvre/trim.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

[[noreturn]] void fail(const std::string& file, const std::string& cause) {
  throw UserError(fmt::format(
      "{}: /driver/learns: {}\n  hint: give \"understeer\" in place of \"learns\", and \"steer_ratio\" in the "
      "model's section \"vehicle\"\n",
      file, cause));
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
  const std::optional<double> slope = steering_slope(compilation, start, inputs);
  if (!slope) fail(file, "the steering input turns no wheels");
  LearnedVehicle learned{.steer_ratio = rounded(1 / *slope)};
  compilation.model.vehicle->steer_ratio = learned.steer_ratio;
  const OperatingPoint point{start.z, start.zd, start.x, start.t, inputs};
  const double speed = speed_at(compilation, point);
  const TrimSeries series = trim_series(compilation, point, {{.speed = speed}});
  if (series.trims.empty() || !series.trims.front().gains) fail(file, "there is no steady motion straight on");
  learned.understeer = series.trims.front().gains->understeer_gradient;
  return learned;
}

}  // namespace mbgen
