#pragma once
// The door of the kinematics and compliance room: the curves of an axle on its rig, as tables, text, pictures and a
// page.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "workbench/kc/kc_report.hpp"

namespace mbgen {

namespace kc {
struct RigDecisions;
}

/// Requests to a rig. Values are amplitudes: the rig goes from minus to plus.
struct KcSettings {
  std::optional<double> travel = {};  ///< m, of the wheels' centres; none: 0.05
  /// rad or m, of the steering coordinate; none: 0.3 rad or 0.03 m. Of a steering input: in its unit; none: as far as
  /// its ratio turns the wheels by 0.3 rad.
  std::optional<double> steer = {};
  std::optional<double> force = {};      ///< N, at each wheel; none: half the wheels' load at the start, at least 1000
  std::optional<double> moment = {};     ///< N m, about z at each wheel; none: 0.05 m times the force
  int points = 21;                       ///< of a curve; an even number takes one more
  std::vector<std::string> curves = {};  ///< their names; none: all that the rig has
  /// Figures, matrices and columns of derivatives, whose programs take most of the time. Without them curves are named,
  /// and so is the amplitude of steering.
  bool has_rates = true;
  std::shared_ptr<const kc::RigDecisions> decisions = {};  ///< null: made for this rig
};

/// The decisions about an axle's rig at a state of the model, which serve for other values of its tunable parameters.
/// Fails: UserError, as kinematics_and_compliance.
std::shared_ptr<const kc::RigDecisions> decisions_of_rig(const Compilation& compilation, const Axle& axle,
                                                         const OperatingPoint& at);

/// The axle of this name; without a name the only one of the model. Fails: UserError.
const Axle& find_axle(const Model& model, const std::string& name);

/// The axles of these names, each once; without names all of the model. Fails: UserError, also if there are none.
std::vector<const Axle*> find_axles(const Model& model, const std::vector<std::string>& names);

/// Receives the number of completed points of all curves. Result: false to stop there.
using KcWatch = std::function<bool(long done, long of)>;

/// Runs the rig of an axle from a state of the model. Definitions: docs/use/kc.md. A curve that a watcher stops has its
/// points so far, with a note. Fails: UserError if the rig cannot be made or has no equilibrium at the start.
KcReport kinematics_and_compliance(const Compilation& compilation, const Axle& axle, const OperatingPoint& at,
                                   const KcSettings& options, const KcWatch& watch = {});

}  // namespace mbgen
