// The mechanism as text: one line per body and joint, as written by a person.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "compiler/text/characters.hpp"
#include "workbench/import/assembly.hpp"

namespace mbgen::importing {
namespace {

constexpr double kNoDirection = 1e-14;  // of the largest component of an axis; rad
constexpr double kNoise = 4e-15;        // m, or of the size of an axis or inertia
constexpr int kDecimals = 12;

/// The number without rounding errors of multiplied frames: rounded to twelve decimals (relative to the power of ten
/// above `scale`) if the difference is small enough.
double without_noise(double value, double scale) {
  const double power = std::pow(10, kDecimals - std::ceil(std::log10(scale)));
  const double rounded = std::round(value * power) / power;
  return std::abs(rounded - value) < kNoise * scale ? rounded : value;
}

std::string vector_text(const Vector3d& v) {
  const auto component = [&](int i) { return number_text(without_noise(v[i], 1)); };
  return fmt::format("[{}, {}, {}]", component(0), component(1), component(2));
}

/// A letter for a direction along an axis, else the vector, scaled to a largest component of one if that is exact.
std::string axis_text(const Vector3d& direction) {
  const double largest = direction.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    Vector3d rest = direction / largest;
    const bool is_negative = rest[i] < 0;
    rest[i] = 0;
    if (rest.cwiseAbs().maxCoeff() < kNoDirection) return fmt::format("\"{}{}\"", is_negative ? "-" : "", "xyz"[i]);
  }
  const Vector3d scaled = direction / largest;
  const bool is_clean = (scaled - scaled.array().round().matrix()).cwiseAbs().maxCoeff() < kNoDirection;
  return vector_text(is_clean ? Vector3d(scaled.array().round()) : direction);
}

std::string angle_text(double angle) {
  const double degrees = angle * 180 / std::numbers::pi;
  const double rounded = std::round(degrees * 1000) / 1000;
  if (std::abs(degrees - rounded) < 1e-12 * std::abs(degrees)) return fmt::format("{{ \"deg\": {} }}", rounded);
  return number_text(angle);
}

std::string pose_text(const Isometry3d& pose) {
  std::string text = fmt::format("\"origin\": {}", vector_text(pose.translation()));
  const Eigen::AngleAxisd rotation(pose.linear());
  if (std::abs(rotation.angle()) > kNoDirection) {
    text += fmt::format(", \"rotation\": {{ \"axis\": {}, \"angle\": {} }}", axis_text(rotation.axis()),
                        angle_text(rotation.angle()));
  }
  return fmt::format("{{ {} }}", text);
}

std::string inertia_text(const Matrix3d& inertia) {
  const double scale = inertia.trace();
  if (scale == 0) return "[0, 0, 0]";
  const auto entry = [&](int i, int j) { return number_text(without_noise(inertia(i, j), scale)); };
  const std::string diagonal = fmt::format("{}, {}, {}", entry(0, 0), entry(1, 1), entry(2, 2));
  const std::string products = fmt::format("{}, {}, {}", entry(0, 1), entry(0, 2), entry(1, 2));
  return products == "0, 0, 0" ? fmt::format("[{}]", diagonal) : fmt::format("[{}, {}]", diagonal, products);
}

/// Lines of a comment, each after `indent`; a question mark replaces a control character or invalid UTF-8.
std::string comment_text(const std::string& comment, std::string_view indent) {
  if (comment.empty()) return {};
  std::string text = fmt::format("{}// ", indent);
  for (const auto& [character, is_plain] : characters_of(comment)) {
    if (character == "\n")
      text += fmt::format("\n{}// ", indent);
    else
      text += is_plain ? character : "?";
  }
  return text + "\n";
}

std::string body_text(const BodyDraft& body, bool is_ground) {
  std::vector<std::string> lines;
  const bool is_placed = !body.pose.matrix().isApprox(Isometry3d::Identity().matrix(), 1e-16);
  if (!is_ground && is_placed) lines.push_back(fmt::format("\"pose\": {}", pose_text(body.pose)));
  if (body.mass > 0 || !body.inertia.isZero(0)) {
    std::string line = fmt::format("\"mass\": {}", number_text(body.mass));
    if (body.com.cwiseAbs().maxCoeff() >= kNoise) line += ", \"com\": " + vector_text(body.com);
    line += ", \"inertia\": " + inertia_text(body.inertia);
    lines.push_back(line + (body.accepts_inertia ? ", \"accept_inertia\": true" : ""));
  }
  if (!body.points.empty()) {
    std::vector<std::string> points;
    for (const auto& [name, at] : body.points) {
      points.push_back(fmt::format("\"{}\": {}", name, vector_text(at)));
    }
    lines.push_back(fmt::format("\"points\": {{ {} }}", fmt::join(points, ", ")));
  }
  return fmt::format("{}    \"{}\": {{ {} }}", comment_text(body.comment, "    "), body.name,
                     fmt::join(lines, ",\n      "));
}

/// Adds the joint's points to its bodies.
std::string joint_text(const JointDraft& joint, std::vector<BodyDraft>& bodies) {
  BodyDraft &from = bodies[static_cast<std::size_t>(joint.from)], &to = bodies[static_cast<std::size_t>(joint.to)];
  const std::string at_from = add_point(from, joint.name, from.pose.inverse() * joint.at);
  const std::string at_to = add_point(to, joint.name, to.pose.inverse() * joint.at);
  std::string text = fmt::format("\"type\": \"{}\", \"from\": \"{}.{}\", \"to\": \"{}.{}\"", name_of(joint.type),
                                 from.name, at_from, to.name, at_to);
  if (!joint.axis.isZero(0)) text += ", \"axis\": " + axis_text(from.pose.linear().transpose() * joint.axis);
  if (!joint.axis2.isZero(0)) text += ", \"axis2\": " + axis_text(from.pose.linear().transpose() * joint.axis2);
  if (joint.cut) text += ", \"cut\": true";
  return fmt::format("{}    \"{}\": {{ {} }}", comment_text(joint.comment, "    "), joint.name, text);
}

std::string spring_text(const SpringDraft& spring) {
  std::string text = fmt::format("\"joint\": \"{}\"", spring.coordinate);
  if (spring.stiffness > 0) text += ", \"stiffness\": " + number_text(spring.stiffness);
  if (spring.stiffness > 0 && spring.free != 0) text += ", \"free\": " + number_text(spring.free);
  if (spring.damping > 0) text += ", \"damping\": " + number_text(spring.damping);
  return fmt::format("    \"{}\": {{ {} }}", spring.coordinate, text);
}

std::string friction_text(const FrictionDraft& friction) {
  return fmt::format("    \"{0}\": {{ \"joint\": \"{0}\", \"coulomb\": {1}, \"velocity\": {2} }}", friction.coordinate,
                     number_text(friction.coulomb), number_text(kFrictionVelocity));
}

std::string stop_text(const StopDraft& stop, double stiffness) {
  return fmt::format("    \"{}\": {{ \"joint\": \"{}\", \"side\": \"{}\", \"clearance\": {}, \"stiffness\": {} }}",
                     stop.name, stop.coordinate, stop.is_above ? "above" : "below", number_text(stop.clearance),
                     number_text(stiffness));
}

/// Adds the shape's points to its body.
std::string shape_text(const ShapeDraft& shape, std::vector<BodyDraft>& bodies) {
  BodyDraft& body = bodies[static_cast<std::size_t>(shape.body)];
  const auto point = [&](const Vector3d& at) { return body.name + "." + add_point(body, "shape_" + shape.name, at); };
  std::string text = fmt::format("\"type\": \"{}\", \"from\": \"{}\"", shape.type, point(shape.from));
  if (shape.type != "sphere") text += fmt::format(", \"to\": \"{}\"", point(shape.to));
  if (shape.radius > 0) text += ", \"radius\": " + number_text(shape.radius);
  if (!shape.colour.empty()) text += fmt::format(", \"colour\": \"{}\"", shape.colour);
  return fmt::format("    \"{}\": {{ {} }}", shape.name, text);
}

/// A member of the model with one entry per line, or "" if it is empty.
std::string section(std::string_view name, const std::vector<std::string>& entries) {
  if (entries.empty()) return {};
  return fmt::format(",\n  \"{}\": {{\n{}\n  }}", name, fmt::join(entries, ",\n"));
}

std::string actuator_text(const ActuatorDraft& actuator) {
  std::string text = fmt::format("    \"{}\": {{ \"joint\": \"{}\"", actuator.name, actuator.coordinate);
  if (actuator.gear != 1) text += fmt::format(", \"gear\": {}", number_text(actuator.gear));
  if (std::isfinite(actuator.limit)) text += fmt::format(", \"limit\": {}", number_text(actuator.limit));
  return text + " }";
}

}  // namespace

std::string model_text(const Assembly& assembly) {
  std::vector<BodyDraft> bodies = assembly.bodies;
  std::vector<std::string> body_lines, joints, springs, frictions, inputs, forces, shapes, couplings, states, stops,
      actuators;
  for (const ActuatorDraft& actuator : assembly.actuators) actuators.push_back(actuator_text(actuator));
  for (const JointDraft& joint : assembly.joints) joints.push_back(joint_text(joint, bodies));
  for (const ShapeDraft& shape : assembly.shapes) shapes.push_back(shape_text(shape, bodies));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i == kGroundDraft && bodies[i].points.empty()) continue;
    body_lines.push_back(body_text(bodies[i], i == kGroundDraft));
  }
  for (const SpringDraft& spring : assembly.springs) springs.push_back(spring_text(spring));
  for (const FrictionDraft& friction : assembly.frictions) frictions.push_back(friction_text(friction));
  for (const InputDraft& input : assembly.inputs)
    inputs.push_back(fmt::format("    \"{}\": {{ \"unit\": \"{}\", \"default\": 0 }}", input.name, input.unit));
  for (const JointForceDraft& force : assembly.joint_forces)
    forces.push_back(fmt::format("    \"{}\": {{ \"joint\": \"{}\", \"force\": \"{}\" }}", force.name, force.coordinate,
                                 force.force));
  for (const CouplingDraft& coupling : assembly.couplings)
    couplings.push_back(fmt::format("    \"{}\": {{ \"relation\": \"{}\" }}", coupling.name, coupling.relation));
  for (const StateDraft& state : assembly.states)
    states.push_back(
        fmt::format("    \"{}\": {{ \"derivative\": \"{}\", \"initial\": 0, \"unit\": \"{}\", \"nominal\": 1 }}",
                    state.name, state.derivative, state.unit));
  for (const StopDraft& stop : assembly.stops) stops.push_back(stop_text(stop, assembly.stop_stiffness));
  std::string text = comment_text(assembly.comment, "");
  text += fmt::format("{{\n  \"mbgen\": 1, \"name\": \"{}\", \"gravity\": {}", assembly.name,
                      vector_text(assembly.gravity));
  text += section("inputs", inputs) + section("bodies", body_lines) + section("joints", joints) +
          section("couplings", couplings) + section("states", states);
  text += section("joint_springs", springs) + section("frictions", frictions) + section("bump_stops", stops) +
          section("joint_forces", forces) + section("actuators", actuators) + section("shapes", shapes);
  if (assembly.step > 0) text += fmt::format(",\n  \"solver\": {{ \"step\": {} }}", number_text(assembly.step));
  return text + "\n}\n";
}

}  // namespace mbgen::importing
