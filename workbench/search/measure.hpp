#pragma once
// Numbers and curves of a model that a search follows, in the words of fit, sweep, kc and manoeuvres:
//   start:OUTPUT              an output where the model starts, as the static load of a wheel
//   mode:K:frequency          Hz, undamped, of oscillation K, from 1 by increasing frequency; mode:K:damping its ratio
//   kc:AXLE:NAME              a figure of the axle's rig at the start; NAME_left where NAME has two sides
//   kc:AXLE:CURVE:COLUMN      a column along a curve of the rig
//   EXPRESSION                a metric of the motion, as `sweep --metric` takes it
//   NAME                      a number of the manoeuvre that is driven
// With several manoeuvres the last two have the file's name without its end in front: step_steer:yaw_rate_gain.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

struct Measure {
  enum class Of { start, mode, figure, curve, metric, manoeuvre };
  Of of = Of::metric;
  std::string name;       ///< as typed
  std::string unit = {};  ///< of rigs and manoeuvres known after an evaluation
  int output = -1, mode = 0;
  std::string axle = {}, curve = {};
  std::string part = {};        ///< of a mode "frequency" or "damping"; figure, column, expression, manoeuvre's number
  int motion = 0;               ///< place of its manoeuvre
  std::vector<double> at = {};  ///< wanted abscissas of a curve; none: the rig's own points
};

/// All forms of a measure, for messages.
constexpr const char* kMeasures =
    "start:OUTPUT, mode:K:frequency, mode:K:damping, kc:AXLE:FIGURE, kc:AXLE:CURVE:COLUMN, a metric as in sweep, or a "
    "number of a manoeuvre";

/// Reads a measure. option: of its text, for messages; manoeuvres: files that are driven, none: the model moves by
/// itself. With manoeuvres an expression of a metric is not looked at. Fails: UserError.
Measure read_measure(const std::string& option, const std::string& text, const Model& model,
                     const std::vector<std::string>& manoeuvres);

/// Texts of an option, which may be separated by commas outside of parentheses too.
std::vector<std::string> split_list(const std::vector<std::string>& texts);

}  // namespace mbgen
