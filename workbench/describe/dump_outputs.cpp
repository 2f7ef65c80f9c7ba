#include "workbench/describe/dump_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/model/element_access.hpp"
#include "compiler/topology/names.hpp"

namespace mbgen {
namespace {

/// Prints the sources of outputs.
struct OutputText : ModelWords {
  static std::string component(int axis, bool in_body_axes) {
    return fmt::format("{}, {} axes", "xyz"[axis], in_body_axes ? "body" : "global");
  }
  std::string component_of(int axis, int body) const {
    return body < 0 ? component(axis, false) : fmt::format("{}, axes of {}", "xyz"[axis], body_name(body));
  }
  std::string seen_from(int observer) const { return ", seen from " + body_name(observer); }
  std::string connection(int joint, int rod) const {
    return joint >= 0 ? "joint " + model_.joints[joint].name : "rod " + model_.rods[rod].name;
  }

  std::string source(const ExpressionOutput& output) const { return quantity(output.value); }
  std::string source(const PointOutput& output) const {
    const char* quantities[] = {"position", "velocity", "acceleration"};
    const bool is_relative = output.relative_to.body >= 0;
    const int axes = output.in_body_axes ? kNoBody : output.axes;
    return fmt::format("{} of {}{}, {}{}", quantities[static_cast<int>(output.what)], attachment(output.point),
                       is_relative ? " relative to " + attachment(output.relative_to) : "",
                       axes < 0 ? component(output.axis, output.in_body_axes) : component_of(output.axis, axes),
                       is_relative && output.what != PointOutput::What::position ? seen_from(output.observer) : "");
  }
  std::string source(const PointsOutput& output) const {
    const auto& [first, second, third] = output.points;
    if (third.body < 0) return fmt::format("distance of {} and {}", attachment(first), attachment(second));
    return fmt::format("angle at {} between {} and {}", attachment(second), attachment(first), attachment(third));
  }
  std::string source(const RotationOutput& output) const {
    using What = RotationOutput::What;
    const char* quantities[] = {"angle", "rotation vector", "quaternion", "angular velocity", "angular acceleration"};
    const std::string subject = fmt::format("{} of {} relative to {}", quantities[static_cast<int>(output.what)],
                                            body_name(output.body), body_name(output.relative_to));
    if (output.what == What::angle) {
      std::string sequence;
      for (const int axis : output.sequence) sequence += "xyz"[axis];
      return fmt::format("{}, turn {} of {}", subject, output.turn + 1, sequence);
    }
    if (output.what <= What::quaternion) return fmt::format("{}, {}", subject, "xyzw"[output.axis]);
    return fmt::format("{}, {}{}", subject, component_of(output.axis, output.axes),
                       output.what == What::angular_acceleration ? seen_from(output.observer) : "");
  }
  std::string source(const MomentumOutput& output) const {
    using What = MomentumOutput::What;
    const char* quantities[] = {"kinetic energy", "potential energy", "momentum", "angular momentum"};
    std::string text = fmt::format("{} of {}", quantities[static_cast<int>(output.what)],
                                   output.body < 0 ? "all bodies and rods" : body_name(output.body));
    if (output.what == What::angular_momentum)
      text += " about " + (output.about.body < 0 ? "the centre of mass" : attachment(output.about));
    return output.what < What::momentum ? text : text + ", " + component_of(output.axis, output.axes);
  }
  std::string source(const WheelOutput& output) const {
    const char* quantities[] = {"toe", "camber", "steer angle", "caster", "kingpin inclination"};
    std::string text = fmt::format("{} of {} relative to {}, {}", quantities[static_cast<int>(output.what)],
                                   output.tyre >= 0 ? "tyre " + model_.tyres[output.tyre].name
                                                    : "the wheel in joint " + model_.joints[output.joint].name,
                                   body_name(output.vehicle), output.side > 0 ? "left" : "right");
    if (output.what >= WheelOutput::What::caster)
      text += fmt::format(", steered about {} to {}", attachment(output.lower), attachment(output.upper));
    return text;
  }
  std::string source(const CoordinateOutput& output) const {
    const char* quantities[] = {"position", "velocity", "acceleration"};
    return fmt::format("{} of {}", quantities[static_cast<int>(output.what)], coordinate(output.coordinate));
  }
  std::string source(const ElementOutput& output) const {
    const ElementQuantity quantity = quantity_of(output);
    std::string text = quantity.name;
    std::replace(text.begin(), text.end(), '_', ' ');
    with_kind(output.kind,
              [&](auto kind) { text += fmt::format(" of {} {}", kind.words, element_name(model_, output)); });
    return quantity.components > 1 ? fmt::format("{}, {}", text, "xyz"[output.axis]) : text;
  }
  std::string source(const StoredEnergyOutput&) const { return "potential energy of all elements"; }
  std::string source(const DriveOutput& output) const {
    return "driving force of motion " + model_.motions[output.motion].name;
  }
  std::string source(const ReactionOutput& output) const {
    return fmt::format("{} of {} on its {} body, {}", output.what == ReactionOutput::What::force ? "force" : "moment",
                       connection(output.joint, output.rod), output.end == ReactionOutput::End::to ? "to" : "from",
                       component(output.axis, output.in_body_axes));
  }
  std::string source(const MultiplierOutput& output) const {
    if (output.coupling >= 0) return "multiplier of coupling " + model_.couplings[output.coupling].name;
    const std::string_view row =
        output.rod >= 0 ? kRodRow.name : closure_rows(model_.joints[output.joint].type)[output.equation].name;
    return fmt::format("multiplier {} of {}", row, connection(output.joint, output.rod));
  }
};

}  // namespace

std::string ModelWords::quantity(const Quantity& value) const {
  if (value.expression < 0) return fmt::format("{}", value.value);
  return fmt::format("{{{}}}", model_.expressions[value.expression].text);
}

std::string ModelWords::attachment(const Attachment& at) const {
  const Body& body = model_.bodies[at.body];
  return body.name + "." + body.points[at.point].name;
}

std::string ModelWords::coordinate(const CoordinateReference& reference) const {
  return freedom_of(model_, reference).name;
}

std::string ModelWords::body_name(int body) const { return body < 0 ? "ground" : model_.bodies[body].name; }

std::string output_text(const Model& model, const Output& output) {
  const OutputText text{{model}};
  const auto source = [&](const auto& of) { return text.source(of); };
  return fmt::format("  {} [{}]: {}\n", output.name, output.unit, std::visit(source, output.source));
}

}  // namespace mbgen
