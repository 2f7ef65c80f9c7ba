// Roads of a host: their inputs, and the plane that these tell.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/model/reader.hpp"

namespace mbgen::reading {
namespace {

/// The places of kHostInputs.
enum HostInput { kX, kY, kHeight, kSlopeX, kSlopeY, kFriction };

std::string input_name(const std::string& road, int which) {
  return fmt::format("{}_{}", road, kHostInputs[static_cast<std::size_t>(which)]);
}

/// Builds an expression over inputs and the place on the road.
struct ExpressionBuilder {
  Expression expression;
  int add(ExpressionNode::Kind kind, int index, Function function = {}, int first = -1, int second = -1) {
    ExpressionNode& node = expression.nodes.emplace_back();
    node.kind = kind;
    node.index = index;
    node.function = function;
    node.first = first;
    node.second = second;
    return static_cast<int>(expression.nodes.size()) - 1;
  }
  int input(int index) { return add(ExpressionNode::Kind::input, index); }
  int local(int index) { return add(ExpressionNode::Kind::local, index); }
  int call(Function function, int first, int second) {
    return add(ExpressionNode::Kind::call, -1, function, first, second);
  }
  /// slope * (place - told place)
  int rise(int slope, int place, int told) {
    const int factor = input(slope), at = local(place);
    return call(Function::multiply, factor, call(Function::subtract, at, input(told)));
  }
};

int add_expression(Reader& reader, ExpressionBuilder builder, std::string text) {
  builder.expression.text = std::move(text);
  reader.model.expressions.push_back(std::move(builder.expression));
  return static_cast<int>(reader.model.expressions.size()) - 1;
}

}  // namespace

void add_host_inputs(Reader& reader, const Entries& roads) {
  constexpr const char* kUnits[] = {"m", "m", "m", "1", "1", "1"};
  constexpr const char* kMeanings[] = {"x of the place at which the ground is told",
                                       "y of the place at which the ground is told",
                                       "height of the ground there",
                                       "slope of the ground along x",
                                       "slope of the ground along y",
                                       "factor of the friction of the tyre"};
  for (const Entry& entry : roads) {
    const Value* host = entry.value->kind == Value::Kind::object ? find(*entry.value, "host") : nullptr;
    if (!host || host->kind != Value::Kind::boolean || !host->boolean) continue;
    const Place place = find_member(*entry.value, "host")->place;
    for (int i = 0; i < static_cast<int>(kHostInputs.size()); ++i) {
      Input input{.name = input_name(entry.name, i), .where = where_of(reader.documents, place), .unit = kUnits[i]};
      input.default_value = i == kFriction ? 1 : 0;
      input.shown.description = kMeanings[i];
      const int index = static_cast<int>(reader.model.inputs.size());
      const bool is_new = reader.names.inputs.emplace(input.name, index).second;
      if (!is_new || reader.names.parameters.contains(input.name))
        report(reader, place,
               fmt::format("the host's input {} has the name of {}", in_quotes(input.name),
                           is_new ? "a parameter" : "an input"),
               "rename one of them, or the road");
      if (is_new) reader.model.inputs.push_back(std::move(input));
    }
  }
}

void lay_host_plane(Reader& reader, const Value& value, Road& road) {
  for (const Member& member : value.members)
    if (member.key != "host")
      report(reader, member.place, fmt::format("a road of a host takes no {}", in_quotes(member.key)),
             "the host tells height, slopes and friction in global axes");
  const auto first = reader.names.inputs.find(input_name(road.name, kX));
  if (first == reader.names.inputs.end()) return;
  const int input = road.host_input = first->second;
  ExpressionBuilder plane, grip;
  const int height = plane.input(input + kHeight);
  const int along = plane.call(Function::add, height, plane.rise(input + kSlopeX, 0, input + kX));
  plane.call(Function::add, along, plane.rise(input + kSlopeY, 1, input + kY));
  grip.input(input + kFriction);
  const auto name = [&](int which) { return input_name(road.name, which); };
  road.height = add_expression(
      reader, std::move(plane),
      fmt::format("{} + {}*(x - {}) + {}*(y - {})", name(kHeight), name(kSlopeX), name(kX), name(kSlopeY), name(kY)));
  road.friction = add_expression(reader, std::move(grip), name(kFriction));
}

void check_host_road(Reader& reader, const Value& value, const Tyre& tyre, const std::vector<Tyre>& before) {
  if (tyre.road < 0 || reader.model.roads[static_cast<std::size_t>(tyre.road)].host_input < 0) return;
  const auto other = std::find_if(before.begin(), before.end(), [&](const Tyre& one) { return one.road == tyre.road; });
  if (other == before.end()) return;
  report(reader, member_or_object(value, "road"),
         fmt::format("a host tells the ground of road {} under one wheel, and tyre {} stands there",
                     in_quotes(reader.model.roads[static_cast<std::size_t>(tyre.road)].name), in_quotes(other->name)),
         "give each wheel a road of its own");
}

}  // namespace mbgen::reading
