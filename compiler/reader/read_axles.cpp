// Axles: their wheels, from tyres or given individually.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

void take_tyre(Reader& reader, const Value& value, AxleWheel& wheel) {
  const int index = find_named(reader, *find(value, "tyre"), "tyre", names_of<Tyre>(reader));
  if (index < 0) return;
  const Tyre& tyre = reader.model.tyres[static_cast<std::size_t>(index)];
  wheel.centre = tyre.centre;
  wheel.axis = tyre.axis;
  wheel.radius = tyre.radius.value;
  for (const std::string_view key : {"centre", "axis"}) {
    if (const Member* member = find_member(value, key))
      report(reader, member->place, fmt::format("wheel has both \"tyre\" and {}", in_quotes(key)),
             "leave out one of them: a tyre has its centre and its axis");
  }
}

AxleWheel read_wheel(Reader& reader, const Value& value) {
  AxleWheelFields fields = with_defaults<AxleWheelFields>();
  AxleWheel wheel;
  if (!read_fields(reader, value, fields)) return wheel;
  if (fields.written_radius) wheel.radius = *fields.written_radius;
  if (fields.tyre) {
    take_tyre(reader, value, wheel);
    if (fields.written_radius) wheel.radius = *fields.written_radius;
  } else if (!find(value, "tyre")) {
    if (!find(value, "centre")) report(reader, value, "a wheel needs \"tyre\" or \"centre\"");
    if (!find(value, "radius")) report(reader, value, "a wheel without a tyre needs \"radius\"");
    wheel.centre = fields.written_centre.value_or(Attachment{});
    Vector3 axis = fields.written_axis.value_or(Vector3{0, 1, 0});
    turn_axis_by_points(reader, find(value, "axis"), wheel.centre.body, axis);
    wheel.axis = wheel.centre.body < 0 ? axis : placed_axis(reader, wheel.centre.body, axis, FreedomKind::revolute);
    // The default is y of the wheel's own frame, with static toe and camber, wherever the wheel was placed.
    if (!fields.written_axis && wheel.centre.body >= 0)
      wheel.axis = rotated(reader.model.bodies[static_cast<std::size_t>(wheel.centre.body)].pose.rotation, {0, 1, 0});
  }
  constexpr double kSmallestTilt = 1e-3;  // rad between the axis and the vertical
  if (std::hypot(wheel.axis[0], wheel.axis[1]) < kSmallestTilt)
    report(reader, member_or_object(value, "axis"), "axis of a wheel is vertical, the wheel would lie on the road");
  if (wheel.centre.body >= 0 && wheel.centre.body == reader.model.ground)
    report(reader, member_or_object(value, "centre"), "a wheel on ground does not move");
  if (fields.steering_axis && fields.steering_axis->size() == 2) {
    wheel.lower = fields.steering_axis->front();
    wheel.upper = fields.steering_axis->back();
  }
  return wheel;
}

/// The element of that name that a rig may remove, as named in the model; "" if there is none.
std::string removable(const Reader& reader, const std::string& written) {
  const Model& model = reader.model;
  for (const Level& level : current_scope(reader).visible) {
    const std::string name = full_name(level, written);
    bool has_one = false;
    each_kind([&](auto kind) {
      const auto is_called_so = [&](const auto& element) { return element.name == name; };
      if (can_be_silent(kind)) has_one = has_one || std::ranges::any_of(kind.list(model), is_called_so);
    });
    if (has_one) return name;
  }
  return "";
}

void read_without(Reader& reader, const Value& value, Axle& axle) {
  if (value.kind != Value::Kind::array) {
    report(reader, value, "must be an array of names, got " + describe(value));
    return;
  }
  for (const Value& item : value.items) {
    if (item.kind != Value::Kind::text) {
      report(reader, item, "must be a name, got " + describe(item));
      continue;
    }
    const std::string name = removable(reader, item.text);
    if (name.empty()) report(reader, item, "unknown force or spring " + in_quotes(item.text));
    axle.without.push_back(name);
  }
}

/// y of a wheel's centre at the reference, m, global; nothing for an unreadable point.
std::optional<double> to_the_left(const Reader& reader, const AxleWheel& wheel) {
  if (wheel.centre.body < 0 || wheel.centre.point < 0) return std::nullopt;
  return reference_position(reader.model, wheel.centre)[1];
}

/// Refuses one wheel on both sides, and notes a left wheel on the right.
void check_wheel_sides(Reader& reader, const AxleFields& axle) {
  constexpr double kBeside = 1e-6;  // m
  const std::optional<double> left = to_the_left(reader, axle.left), right = to_the_left(reader, axle.right);
  if (left && right && axle.left.centre.body == axle.right.centre.body &&
      axle.left.centre.point == axle.right.centre.point) {
    report(reader, *axle.written_right, "\"left\" and \"right\" are one wheel",
           "name the wheel of the other side; an axle of one wheel has its mirror image on the other side");
    return;
  }
  const double middle = left && right ? (*left + *right) / 2 : 0;
  const bool left_is_right = left && *left < middle - kBeside;
  const bool right_is_left = !left && right && *right > middle + kBeside;
  if (left_is_right)
    note(reader, axle.written_left->place,
         fmt::format("wheel \"left\" is {:.4g} m to the right of the middle", middle - *left),
         "y is to the left: exchange \"left\" and \"right\", or angles and scrub radius count the wrong way");
  if (right_is_left)
    note(reader, axle.written_right->place,
         fmt::format("wheel \"right\" is {:.4g} m to the left of the middle", *right),
         "y is to the left: call it \"left\", or angles and scrub radius count the wrong way");
}

/// Whether a motion follows an input.
bool moves_with(const Model& model, int input) {
  const auto takes = [&](const ExpressionNode& node) {
    return node.kind == ExpressionNode::Kind::input && node.index == input;
  };
  return std::ranges::any_of(model.motions, [&](const Motion& motion) {
    const int expression = motion.position.expression;
    return expression >= 0 && std::ranges::any_of(model.expressions[static_cast<std::size_t>(expression)].nodes, takes);
  });
}

/// The coordinate that steers, or, where there is none of this name, an input.
void read_steer(Reader& reader, const Value& value, Axle& axle) {
  if (value.kind == Value::Kind::text && !find_coordinate(reader.names, value.text, current_scope(reader).visible)) {
    const auto input = find_visible(reader.names.inputs, value.text, current_scope(reader).visible);
    if (input != reader.names.inputs.end()) {
      axle.steering_input = input->second;
      if (!moves_with(reader.model, input->second))
        report(reader, value, fmt::format("no motion follows input {}, it steers nothing", in_quotes(value.text)),
               "drive the rack in \"motions\" by an expression of it, or name the coordinate that steers");
      return;
    }
  }
  axle.steer = CoordinateReference{};
  read_value(reader, value, {}, *axle.steer);
  refuse_reversed(reader, value.place, *axle.steer);
}

void check_share(Reader& reader, const Value& value, std::string_view key, const std::optional<double>& share) {
  if (share && *share > 1) report(reader, *find(value, key), fmt::format("must be at most 1, got {}", *share));
}

void read_axle(Reader& reader, const Value& value, AxleFields& axle) {
  axle.body = find_body(reader, axle.written_body);
  if (axle.body < 0 && (!find(value, "body") || find(value, "body")->kind == Value::Kind::text))
    report(reader, member_or_object(value, "body"), "unknown body " + in_quotes(axle.written_body),
           suggestion(reader, axle.written_body, reader.names.bodies));
  if (!axle.written_left && !axle.written_right) report(reader, value, "an axle needs a wheel, \"left\" or \"right\"");
  if (axle.written_left) axle.left = read_wheel(reader, *axle.written_left);
  if (axle.written_right) axle.right = read_wheel(reader, *axle.written_right);
  if (handedness(current_scope(reader).placement) < 0) {
    std::swap(axle.left, axle.right);
  } else {
    check_wheel_sides(reader, axle);
  }
  if (axle.written_steer) read_steer(reader, *axle.written_steer, axle);
  check_share(reader, value, "brake_share", axle.brake_share);
  check_share(reader, value, "drive_share", axle.drive_share);
  if (axle.written_without) read_without(reader, *axle.written_without, axle);
}

}  // namespace

void read_axles(Reader& reader, const Entries& entries) {
  std::vector<AxleFields> list;
  read_list(reader, entries, list, read_axle);
  for (const AxleFields& axle : list) reader.model.axles.push_back(axle);
}

}  // namespace mbgen::reading
