// Initial state.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

bool has_parts(const Value& value) {
  if (value.kind != Value::Kind::object) return false;
  const std::span<const Field<InitialValueFields>> table = fields<InitialValueFields>();
  return std::any_of(table.begin(), table.end(), [&](const auto& row) { return find(value, row.info.name); });
}

/// A number, or an object with a number, its weight and its lock. Result: the number's text.
const Value& read_initial_value(Reader& reader, const Value& value, const FieldInfo& info, InitialValue& target) {
  if (!has_parts(value)) {
    Quantity quantity;
    read_value(reader, value, info, quantity);
    target.value = quantity.value;
    target.expression = quantity.expression;
    return value;
  }
  InitialValueFields parts = with_defaults<InitialValueFields>();
  read_fields(reader, value, parts);
  target.value = parts.value.value;
  target.expression = parts.value.expression;
  target.weight = parts.weight;
  target.locked = parts.locked;
  return member_or_object(value, "value");
}

/// Degree of an expression: 0 constant, 1 linear, else 2.
int degree(const Expression& expression) {
  std::vector<int> degrees;
  for (const ExpressionNode& node : expression.nodes) {
    const auto of = [&](int operand) { return operand < 0 ? 0 : degrees[static_cast<std::size_t>(operand)]; };
    const int first = of(node.first), second = of(node.second), all = std::max({first, second, of(node.third)});
    const bool is_sum =
        node.function == Function::add || node.function == Function::subtract || node.function == Function::negate;
    if (node.kind != ExpressionNode::Kind::call) {
      degrees.push_back(node.kind == ExpressionNode::Kind::number ? 0 : 1);
    } else if (is_sum || all == 0) {
      degrees.push_back(all);
    } else if (node.function == Function::multiply) {
      degrees.push_back(std::min(2, first + second));
    } else {
      degrees.push_back(node.function == Function::divide && second == 0 ? first : 2);
    }
  }
  return degrees.back();
}

void read_initial_values(Reader& reader, const Value* values, std::string_view key, bool locks,
                         std::vector<InitialValue>& list) {
  if (!values) return;
  if (values->kind != Value::Kind::object) {
    report(reader, *values, "must be an object of coordinates, got " + describe(*values));
    return;
  }
  const FieldInfo info{
      .name = key, .shape = Shape::number, .depends = Depends::nothing, .angle = true, .at_start = true};
  for (const Member& member : values->members) {
    InitialValue initial;
    initial.where = where_of(reader.documents, member.place);
    initial.coordinate = read_coordinate(reader, member.place, member.key);
    refuse_reversed(reader, member.place, initial.coordinate);
    const Value& number = read_initial_value(reader, member.value, info, initial);
    if (initial.locked && !locks) {
      report(reader, *find(member.value, "locked"), "no position is locked where the start is an equilibrium",
             "hold the joint by a motion, or leave out \"equilibrium\"");
    }
    if (initial.expression >= 0 && degree(reader.model.expressions[static_cast<std::size_t>(initial.expression)]) > 1) {
      report(reader, number, "must be linear in parameters that act at the start");
    }
    if (initial.expression >= 0 && key == "positions") {
      report(reader, number, "a parameter that acts at the start may stand in velocities only",
             "leave out its \"at_start\"");
    }
    if (initial.coordinate.joint < 0) continue;
    if (find(number, "deg") && !is_rotation(reader.model, initial.coordinate)) {
      report(reader, number,
             fmt::format("coordinate {} is a translation, degrees have no meaning", in_quotes(member.key)));
    }
    const auto earlier = std::find_if(
        list.begin(), list.end(), [&](const InitialValue& other) { return other.coordinate == initial.coordinate; });
    if (earlier == list.end()) {
      list.push_back(initial);
    } else {
      *earlier = initial;
    }
  }
}

/// Whether the model, as opposed to one of its instances, starts from equilibrium.
bool asks_for_equilibrium(const std::vector<Part>& parts) {
  bool asks = false;
  for (const auto& [value, scope] : parts) {
    const Value* written = scope == 0 ? find(*value, "equilibrium") : nullptr;
    if (written) asks = written->boolean;
  }
  return asks;
}

}  // namespace

void read_initial(Reader& reader, const std::vector<Part>& parts) {
  InitialFields fields = with_defaults<InitialFields>();
  Initial& initial = reader.model.initial;
  const bool balances = asks_for_equilibrium(parts);
  reader.folds_tunable = !reader.varied.empty();  // a study computes the initial state for each value
  for (const auto& [value, scope] : parts) {
    const InScope in_scope(reader, scope);
    fields.positions = fields.velocities = fields.orientations = nullptr;
    read_fields(reader, *value, fields);
    read_initial_values(reader, fields.positions, "positions", !balances, initial.positions);
    read_initial_values(reader, fields.velocities, "velocities", true, initial.velocities);
    read_orientations(reader, fields.orientations, initial);
    if (scope != 0) fields.equilibrium = false;  // a property of the whole model
  }
  reader.folds_tunable = false;
  initial.equilibrium = fields.equilibrium;
}

}  // namespace mbgen::reading
