// MJCF: fixed tendons (linear combinations of coordinates), and actuators on joints and fixed tendons.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

/// A force on a linear combination of coordinates: each coordinate has its factor times the force.
void add_force(Mjcf& mjcf, const std::string& name, const MjcfLength& length, const std::vector<Term>& force) {
  for (const auto& [factor, joint] : length.parts) {
    std::vector<Term> terms = force;
    for (Term& term : terms) term.factor *= factor;
    const std::string shown = length.parts.size() == 1 ? name : fmt::format("{}_{}", name, joint.coordinate);
    mjcf.assembly.joint_forces.push_back(
        {unique_name(shown, mjcf.assembly.force_names), joint.coordinate, sum_text(terms)});
  }
}

/// The joints of a tendon; nothing with a problem.
std::optional<MjcfLength> read_length(Mjcf& mjcf, const Element& tendon) {
  MjcfLength length;
  for (const Element& part : tendon.children) {
    if (part.name != "joint") continue;
    const std::optional<std::string> name = required_text(mjcf.reading, part, "joint");
    if (!name) return std::nullopt;
    const auto found = mjcf.joint_of.find(*name);
    const bool is_one = found != mjcf.joint_of.end() &&
                        (found->second.type == JointType::revolute || found->second.type == JointType::prismatic);
    if (!is_one) {
      problem(mjcf.reading, attribute(part, "joint")->spot, "no hinge or slide is named " + quoted_text(*name));
      return std::nullopt;
    }
    length.parts.emplace_back(number(mjcf.reading, part, "coef", 1), found->second);
  }
  return length;
}

/// Stretch of the tendon beyond the slack of its spring.
std::vector<Term> stretch_of(const MjcfLength& length, const std::vector<double>& springlength, double stiffness) {
  const double lower = springlength.front(), upper = springlength.back();
  // A negative length stands for the length at the joints' springref.
  double offset = length.reference() - lower;
  if (lower < 0) {
    offset = 0;
    for (const auto& [factor, joint] : length.parts) offset -= factor * joint.free;
  }
  if (lower == upper || lower < 0) {
    std::vector<Term> terms = terms_of(length, -stiffness, "z.");
    terms.push_back({-stiffness * offset});
    return terms;
  }
  const auto beyond = [&](double end) {
    std::vector<Term> terms = terms_of(length, 1, "z.");
    terms.push_back({length.reference() - end});
    return sum_text(terms);
  };
  return {{-stiffness, fmt::format("min(0, {})", beyond(lower))},
          {-stiffness, fmt::format("max(0, {})", beyond(upper))}};
}

void read_fixed(Mjcf& mjcf, const Element& tendon) {
  require_class(mjcf, tendon, "class");
  const std::optional<MjcfLength> length = read_length(mjcf, tendon);
  if (!length) return;
  const std::string written = text_of(tendon, "name");
  const auto value = [&](const char* name) {
    const Attribute* found = inherited_as(mjcf, tendon, "tendon", name);
    return found ? numbers(mjcf.reading, *found, 1, 1).value_or(std::vector<double>{0})[0] : 0.0;
  };
  const double stiffness = mjcf.settings.has_springs ? value("stiffness") : 0;
  const double damping = mjcf.settings.has_dampers ? value("damping") : 0;
  if (mjcf.settings.has_friction && value("frictionloss") != 0)
    lose(mjcf, tendon.spot, "tendon with frictionloss: not carried over, friction is on one coordinate");
  if (inherited_as(mjcf, tendon, "tendon", "range")) lose(mjcf, tendon.spot, "tendon with a range: it is not enforced");
  if (stiffness < 0 || damping < 0) return problem(mjcf.reading, tendon.spot, "stiffness and damping are not negative");
  std::vector<double> springlength = {-1};
  if (const Attribute* given = inherited_as(mjcf, tendon, "tendon", "springlength"))
    springlength = numbers(mjcf.reading, *given, 1, 2).value_or(springlength);
  std::vector<Term> force = stretch_of(*length, springlength, stiffness);
  for (const Term& term : terms_of(*length, -damping, "zd.")) force.push_back(term);
  if (stiffness > 0 || damping > 0) add_force(mjcf, written.empty() ? "tendon" : written, *length, force);
  if (!written.empty() && !mjcf.tendon_of.emplace(written, *length).second)
    problem(mjcf.reading, tendon.spot, fmt::format("tendon {} is defined twice", quoted_text(written)));
}

/// Damping of a position servo from its damping ratio and the inertias of the coordinates at the reference, as in
/// MuJoCo 3.
double damping_by_ratio(Mjcf& mjcf, const MjcfLength& length, double gear, double ratio, double gain) {
  if (mjcf.inertia_of.empty()) find_inertias(mjcf);
  double mass = 0;
  for (const auto& [factor, joint] : length.parts)
    if (factor * gear != 0) mass += mjcf.inertia_of[joint.coordinate] / (factor * factor * gear * gear);
  return 2 * ratio * std::sqrt(std::max(0.0, gain * mass));
}

/// Law of an actuator as forces here have it: force = gain * u + bias + by_length * length + by_rate * rate; u follows
/// the input with a first-order lag.
struct Law {
  double gain = 1, bias = 0, by_length = 0, by_rate = 0;
  double time_constant = 0;
};

/// Fails (nothing): another kind of law.
std::optional<Law> law_of(Mjcf& mjcf, const MjcfActuator& actuator, const MjcfLength& length) {
  const bool is_filter = actuator.dynamics == "filter" || actuator.dynamics == "filterexact";
  if (actuator.gain_type != "fixed" || (actuator.dynamics != "none" && !is_filter)) return std::nullopt;
  Law law{.gain = actuator.gain, .time_constant = is_filter ? actuator.time_constant : 0};
  if (!std::isfinite(law.gain) || !std::isfinite(law.time_constant)) return std::nullopt;
  if (actuator.bias_type == "none") return law;
  if (actuator.bias_type != "affine") return std::nullopt;
  law.bias = actuator.bias[0];
  law.by_length = actuator.bias[1];
  law.by_rate = actuator.damping_ratio > 0
                    ? -damping_by_ratio(mjcf, length, actuator.gear, actuator.damping_ratio, actuator.gain)
                    : actuator.bias[2];
  if (!std::isfinite(law.bias + law.by_length + law.by_rate)) return std::nullopt;
  return law;
}

std::string unit_of(const Element& actuator, const MjcfLength& length, double gear) {
  if (gear != 1 || actuator.name == "general" || length.parts.size() != 1 || length.parts[0].first != 1) return "1";
  const bool turns = length.parts[0].second.type == JointType::revolute;
  if (actuator.name == "motor") return turns ? "N m" : "N";
  if (actuator.name == "position") return turns ? "rad" : "m";
  return turns ? "rad/s" : "m/s";
}

/// Target of the actuator: a joint or a fixed tendon. Fails (nothing): another target, or a problem was added.
std::optional<MjcfLength> pulled_by(Mjcf& mjcf, const Element& actuator) {
  const Attribute* joint = attribute(actuator, "joint");
  if (!joint) joint = attribute(actuator, "jointinparent");
  if (const Attribute* tendon = attribute(actuator, "tendon")) {
    const auto found = mjcf.tendon_of.find(tendon->value);
    return found == mjcf.tendon_of.end() ? std::nullopt : std::optional(found->second);
  }
  if (!joint) return std::nullopt;
  const auto found = mjcf.joint_of.find(joint->value);
  if (found == mjcf.joint_of.end()) {
    problem(mjcf.reading, joint->spot, "no joint is named " + quoted_text(joint->value));
    return std::nullopt;
  }
  if (found->second.type != JointType::revolute && found->second.type != JointType::prismatic) return std::nullopt;
  return MjcfLength{{{1.0, found->second}}};
}

/// Limit of a motor by its ranges, whose larger end counts; infinite without one.
double limit_of(const MjcfActuator& motor) {
  double limit = std::numeric_limits<double>::infinity();
  for (const std::optional<MjcfRange>& range : {motor.control, motor.force}) {
    if (!range) continue;
    const double larger = std::max(std::abs(range->lower), std::abs(range->upper));
    if (larger > 0) limit = std::min(limit, larger);
  }
  return limit;
}

std::string within(const std::string& text, const std::optional<MjcfRange>& range) {
  return range ? fmt::format("min(max({}, {}), {})", text, number_text(range->lower), number_text(range->upper)) : text;
}

/// An input of its name, and the force of the law on each joint, both within their ranges.
void add_servo(Mjcf& mjcf, const Element& element, const MjcfActuator& actuator, const std::string& name,
               const std::string& unit, const Law& law, const MjcfLength& length) {
  Assembly& assembly = mjcf.assembly;
  const double gear = actuator.gear;
  assembly.inputs.push_back({name, unit});
  std::string acting = within(name, actuator.control);
  if (law.time_constant > 0) {
    const std::string filtered = unique_name(name + "_filtered", assembly.input_names);
    assembly.states.push_back(
        {filtered, fmt::format("({} - {})/{}", acting, filtered, number_text(law.time_constant)), unit});
    acting = filtered;
  }
  if (actuator.activation) lose(mjcf, element.spot, "actuator with a range of its activation: it is not enforced");
  const auto add_law = [&](double scale, std::vector<Term>& force) {
    force = {{scale * law.gain, acting}, {scale * (law.bias + gear * law.by_length * length.reference())}};
    for (const Term& term : terms_of(length, scale * gear * law.by_length, "z.")) force.push_back(term);
    for (const Term& term : terms_of(length, scale * gear * law.by_rate, "zd.")) force.push_back(term);
  };
  std::vector<Term> force;
  if (actuator.force) {
    add_law(1, force);
    force = {{gear, within(sum_text(force), actuator.force)}};
  } else {
    add_law(gear, force);
  }
  add_force(mjcf, name, length, force);
}

void add_actuator(Mjcf& mjcf, const Element& element) {
  static constexpr std::array<std::string_view, 4> known = {"motor", "position", "velocity", "general"};
  require_class(mjcf, element, "class");
  const std::size_t problems = mjcf.reading.problems.size();
  const bool is_known = std::find(known.begin(), known.end(), element.name) != known.end();
  const std::optional<MjcfLength> length = pulled_by(mjcf, element);
  if (mjcf.reading.problems.size() > problems) return;
  const MjcfActuator actuator = is_known && length ? read_actuator(mjcf, element) : MjcfActuator();
  const std::optional<Law> law = is_known && length ? law_of(mjcf, actuator, *length) : std::nullopt;
  if (!law) {
    lose(
        mjcf, element.spot,
        fmt::format("actuator <{}>: it is not carried over, motors, position and velocity servos on hinges, slides and "
                    "fixed tendons become inputs",
                    element.name));
    return;
  }
  Assembly& assembly = mjcf.assembly;
  const std::string written = text_of(element, "name"), unit = unit_of(element, *length, actuator.gear);
  const std::string name =
      unique_name(written.empty() ? length->parts.front().second.coordinate + "_motor" : written, assembly.input_names);
  if (element.name == "motor" && length->parts.size() == 1 && actuator.gear != 0) {
    if (actuator.control || actuator.force)
      lose(mjcf, element.spot, "motor with a range: a limit that is told and not enforced");
    const auto& [factor, joint] = length->parts.front();
    assembly.actuators.push_back({name, joint.coordinate, actuator.gear * factor, limit_of(actuator)});
    return;
  }
  add_servo(mjcf, element, actuator, name, unit, *law, *length);
}

}  // namespace

void read_tendons(Mjcf& mjcf, const Element& section) {
  for (const Element& tendon : section.children)
    if (tendon.name == "fixed") read_fixed(mjcf, tendon);
}

void read_actuators(Mjcf& mjcf, const Element& section) {
  for (const Element& actuator : section.children) add_actuator(mjcf, actuator);
}

}  // namespace mbgen::importing
