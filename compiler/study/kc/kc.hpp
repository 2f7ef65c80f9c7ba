#pragma once
// The door of the kinematics and compliance room: the curves of an axle on its rig, as tables, text, pictures and a
// page.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/files.hpp"
#include "compiler/compile.hpp"
#include "compiler/results/table.hpp"

namespace mbgen {

/// What is asked of a rig. Values are amplitudes: the rig goes from minus to plus.
struct KcWish {
  std::optional<double> travel = {};  ///< m, of the wheels' centres; none: 0.05
  std::optional<double> steer = {};   ///< rad or m, of the steering coordinate; none: 0.3 rad or 0.03 m
  std::optional<double> force = {};   ///< N, at each wheel; none: half the wheels' load at the start, at least 1000
  std::optional<double> moment = {};  ///< N m, about z at each wheel; none: 0.05 m times the force
  int points = 21;                    ///< of a curve; an even number takes one more
};

/// A value of the axle at the start: one of the axle, or of a single wheel; or two, left and right.
struct KcFigure {
  std::string name, unit, meaning;
  std::vector<double> values;
};

/// One rig curve; its first column is what the rig imposes. SI units, angles in rad.
struct KcTable {
  std::string name, title;
  std::vector<Column> columns;
};

struct KcReport {
  std::string model, axle;
  std::vector<KcFigure> figures;
  std::vector<KcTable> tables;
  std::vector<std::string> notes;  ///< curves that end early, and curves that are not there
};

/// The axle of this name; without a name the only one of the model. Fails: UserError.
const Axle& find_axle(const Model& model, const std::string& name);

/// Runs the rig of an axle from a state of the model. Definitions: docs/use/kc.md.
/// Fails: UserError where the rig cannot be made or has no equilibrium at the start.
KcReport kinematics_and_compliance(const Compilation& compilation, const Axle& axle, const OperatingPoint& at,
                                   const KcWish& wish);

/// The figures for people: angles in degrees, small lengths in mm.
std::string kc_text(const KcReport& report);

/// The figures and tables for machines.
nlohmann::ordered_json kc_json(const KcReport& report);

/// A CSV table and an SVG picture for each curve, then the page AXLE.html with all of them.
std::vector<NamedText> kc_files(const KcReport& report);

}  // namespace mbgen
