#include "workbench/describe/vehicle_text.hpp"

#include <fmt/format.h>

#include "workbench/describe/paragraphs.hpp"

namespace mbgen {
namespace {

std::string point_name(const Model& model, const Attachment& at) {
  const Body& body = model.bodies[static_cast<std::size_t>(at.body)];
  return body.name + "." + body.points[static_cast<std::size_t>(at.point)].name;
}

const std::string& input_name(const Model& model, int input) {
  return model.inputs[static_cast<std::size_t>(input)].name;
}

}  // namespace

std::string vehicle_dump(const Model& model) {
  if (!model.vehicle) return "";
  const Vehicle& vehicle = *model.vehicle;
  std::string text = fmt::format("vehicle\n  reference {}, steer_ratio {}\n", point_name(model, vehicle.reference),
                                 vehicle.steer_ratio);
  if (vehicle.towed.body >= 0) text += fmt::format("  towed {}\n", point_name(model, vehicle.towed));
  const auto input = [&](const char* name, int index, const std::optional<double>& limit) {
    if (index < 0) return;
    text += fmt::format("  {}: {}{}\n", name, input_name(model, index), limit ? fmt::format(", up to {}", *limit) : "");
  };
  input("steer", vehicle.steer, vehicle.steer_limit);
  input("drive", vehicle.drive, vehicle.drive_limit);
  input("brake", vehicle.brake, vehicle.brake_limit);
  if (vehicle.speed >= 0)
    text += fmt::format("  speed at the start: {}\n", model.parameters[static_cast<std::size_t>(vehicle.speed)].name);
  if (vehicle.wheelbase) text += fmt::format("  wheelbase {}\n", *vehicle.wheelbase);
  if (vehicle.width) text += fmt::format("  width {}\n", *vehicle.width);
  return text;
}

std::string vehicle_explanation(const Model& model) {
  if (!model.vehicle) return "";
  const Vehicle& vehicle = *model.vehicle;
  std::vector<std::string> inputs;
  const auto input = [&](const char* does, int index) {
    if (index >= 0) inputs.push_back(fmt::format("{} {} it", input_name(model, index), does));
  };
  input("steers", vehicle.steer);
  input("drives", vehicle.drive);
  input("brakes", vehicle.brake);
  std::string words = fmt::format("Its motion is taken at {}", point_name(model, vehicle.reference));
  if (vehicle.towed.body >= 0)
    words += fmt::format(", the motion of the last towed unit at {}", point_name(model, vehicle.towed));
  words += inputs.empty() ? "; no input moves it." : fmt::format("; the inputs: {}.", listed(inputs));
  if (vehicle.speed >= 0)
    words += fmt::format(" A manoeuvre sets its speed at the start by the parameter {}.",
                         model.parameters[static_cast<std::size_t>(vehicle.speed)].name);
  return heading("Vehicle") + paragraph(words);
}

}  // namespace mbgen
