// MJCF: actuators with their defaults. A class has one default actuator, which the elements of all kinds write.
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

constexpr std::array<std::string_view, 13> kKinds = {"general", "motor",       "position", "velocity", "intvelocity",
                                                     "damper",  "cylinder",    "muscle",   "adhesion", "pid",
                                                     "dcmotor", "orientation", "plugin"};

/// An actuator while its elements are applied, from the defaults to its own.
struct Writer {
  Mjcf& mjcf;
  MjcfActuator made = {};
  /// Whether the damping or the dynamics stem from <position>, which keeps its own only.
  bool has_own_damping = true, has_own_dynamics = true;
  bool depends_on_version = false;  ///< of MuJoCo

  std::optional<double> value(const Element& element, std::string_view name) {
    if (!attribute(element, name)) return std::nullopt;
    return number(mjcf.reading, element, name, 0);
  }

  void set_types(const char* dynamics, const char* gain, const char* bias) {
    made.dynamics = dynamics;
    made.gain_type = gain;
    made.bias_type = bias;
  }

  void set_bias(double length, double rate) {
    made.bias[0] = 0;
    made.bias[1] = length;
    made.bias[2] = rate;
    made.damping_ratio = 0;
  }

  void general(const Element& element) {
    const auto take = [&](const char* name, std::string& text) {
      if (const Attribute* found = attribute(element, name)) text = found->value;
    };
    take("dyntype", made.dynamics);
    take("gaintype", made.gain_type);
    take("biastype", made.bias_type);
    has_own_dynamics = has_own_dynamics && !attribute(element, "dyntype") && !attribute(element, "dynprm");
    const auto list = [&](const char* name) {
      const Attribute* found = attribute(element, name);
      return found ? numbers(mjcf.reading, *found, 1, 100).value_or(std::vector<double>()) : std::vector<double>();
    };
    // As in MuJoCo: a shorter list leaves the other numbers as they are.
    if (const auto gain = list("gainprm"); !gain.empty()) made.gain = gain[0];
    if (const auto dynamics = list("dynprm"); !dynamics.empty()) made.time_constant = dynamics[0];
    const std::vector<double> bias = list("biasprm");
    std::copy_n(bias.begin(), std::min(bias.size(), made.bias.size()), made.bias.begin());
    if (bias.size() > 2) made.damping_ratio = 0;
    if (!bias.empty()) has_own_damping = false;
  }

  /// MuJoCo 2 clears the damping, the constant force and the dynamics that <position> has from another kind; MuJoCo 3
  /// keeps them.
  void position(const Element& element) {
    const auto own_damping = value(element, "kv"), own_ratio = value(element, "dampratio"),
               time_constant = value(element, "timeconst");
    if (own_damping && own_ratio && *own_damping != 0 && *own_ratio != 0)
      problem(mjcf.reading, element.spot, "<position> takes kv or dampratio, not both");
    const bool keeps_force =
        !has_own_damping && (made.bias[0] != 0 || (made.bias[2] != 0 && !own_damping && !own_ratio));
    const bool keeps_dynamics = !has_own_dynamics && made.dynamics != "none" && !time_constant;
    depends_on_version = depends_on_version || keeps_force || keeps_dynamics;
    made.gain = value(element, "kp").value_or(made.gain);
    const double ratio = has_own_damping ? made.damping_ratio : 0;
    set_bias(-made.gain, has_own_damping ? made.bias[2] : 0);
    made.damping_ratio = ratio;
    if (own_damping) set_bias(-made.gain, -*own_damping);
    if (own_ratio && *own_ratio != 0) {
      set_bias(-made.gain, 0);
      made.damping_ratio = *own_ratio;
    }
    if (!has_own_dynamics) made.dynamics = "none";
    if (time_constant) {
      made.time_constant = *time_constant;
      made.dynamics = *time_constant == 0 ? "none" : "filterexact";
    }
    made.gain_type = "fixed";
    made.bias_type = "affine";
    has_own_damping = has_own_dynamics = true;
  }

  void velocity(const Element& element) {
    made.gain = value(element, "kv").value_or(made.gain);
    set_bias(0, -made.gain);
    set_types("none", "fixed", "affine");
    has_own_damping = depends_on_version = false;
  }

  void cylinder(const Element& element) {
    made.time_constant = value(element, "timeconst").value_or(made.time_constant);
    if (const Attribute* bias = attribute(element, "bias")) {
      const auto values = numbers(mjcf.reading, *bias, 1, 3).value_or(std::vector<double>());
      std::copy(values.begin(), values.end(), made.bias.begin());
    }
    made.gain = value(element, "area").value_or(made.gain);
    if (const auto diameter = value(element, "diameter")) made.gain = std::numbers::pi / 4 * *diameter * *diameter;
    set_types("filter", "fixed", "affine");
    has_own_damping = has_own_dynamics = false;
  }

  void law(const Element& element) {
    if (element.name == "general") return general(element);
    if (element.name == "position") return position(element);
    if (element.name == "velocity") return velocity(element);
    if (element.name == "cylinder") return cylinder(element);
    if (element.name == "motor") {
      made.gain = 1;
      return set_types("none", "fixed", "none");
    }
    if (element.name == "intvelocity") {
      position(element);
      made.dynamics = "integrator";
      has_own_dynamics = false;
      return;
    }
    if (element.name == "damper") {
      made.gain = 0;
      return set_types("none", "affine", "none");
    }
    // A law that a model has not: an actuator that keeps a part of it is not carried over.
    set_types("other", "other", "other");
    made.gain = made.time_constant = std::numeric_limits<double>::quiet_NaN();
    made.bias.fill(made.gain);
    has_own_damping = has_own_dynamics = false;
  }
};

/// The range "ctrl", "force" or "act" where it is in force. elements: of the actuator, the nearest first.
std::optional<MjcfRange> range_of(Mjcf& mjcf, const std::vector<const Element*>& elements, const std::string& what) {
  const Attribute* written = nullptr;
  std::string limited = "auto";
  for (auto at = elements.rbegin(); at != elements.rend(); ++at) {
    if (const Attribute* range = attribute(**at, what + "range")) written = range;
    if (const Attribute* own = attribute(**at, what + "limited")) limited = own->value;
    const std::string& kind = (*at)->name;
    if ((what == "ctrl" && (kind == "damper" || kind == "adhesion")) || (what == "act" && kind == "intvelocity"))
      limited = "true";
  }
  const auto range = written ? numbers(mjcf.reading, *written, 2, 2) : std::nullopt;
  if (!range || limited == "false" || (limited == "auto" && !mjcf.settings.limits_by_range)) return std::nullopt;
  if ((*range)[0] > (*range)[1]) {
    problem(mjcf.reading, written->spot, what + "range has its larger end first");
    return std::nullopt;
  }
  return MjcfRange{(*range)[0], (*range)[1]};
}

}  // namespace

MjcfActuator read_actuator(Mjcf& mjcf, const Element& element) {
  const std::vector<const Element*> elements = with_defaults(mjcf, element, "", [](std::string_view name) {
    return std::find(kKinds.begin(), kKinds.end(), name) != kKinds.end();
  });
  Writer writer{mjcf};
  for (auto at = elements.rbegin(); at != elements.rend(); ++at) {
    writer.law(**at);
    if (const Attribute* gear = attribute(**at, "gear"))
      writer.made.gear = numbers(mjcf.reading, *gear, 1, 6).value_or(std::vector<double>{1})[0];
  }
  MjcfActuator made = writer.made;
  if (writer.depends_on_version && made.bias_type == "affine")
    lose(mjcf, element.spot,
         "actuator with defaults of <position> and another kind: damping, constant force and filter of the other kind "
         "are left out as by MuJoCo 2, MuJoCo 3 keeps them");
  made.control = range_of(mjcf, elements, "ctrl");
  made.force = range_of(mjcf, elements, "force");
  made.activation = range_of(mjcf, elements, "act");
  return made;
}

}  // namespace mbgen::importing
