// Readers of single values: numbers, words, vectors, axes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/reader.hpp"
#include "compiler/text/number.hpp"

namespace mbgen::reading {
namespace {

/// Default parameters and inputs, t = 0, every coordinate zero.
struct ReferenceEnvironment {
  const Model& model;
  double parameter(int index) const { return model.parameters[static_cast<std::size_t>(index)].value; }
  double input(int index) const { return model.inputs[static_cast<std::size_t>(index)].default_value; }
  double time() const { return 0; }
  double position(const CoordinateReference&) const { return 0; }
  double velocity(const CoordinateReference&) const { return 0; }
  double local(int) const { return 0; }
  /// Expressions of states are read after all initial values.
  double state(int index) const {
    const auto i = static_cast<std::size_t>(index), count = model.states.size();
    if (i < count) return model.states[i].initial;
    return i - count < model.sampled.size() ? model.sampled[i - count].initial : 0;
  }
  double length(int) const { return 0; }
  double rate(int) const { return 0; }
  double output(int) const { return 0; }
};

void wrong_type(Reader& reader, const Value& value, std::string_view wanted, std::string hint = {}) {
  report(reader, value, fmt::format("must be {}, got {}", wanted, describe(value)), std::move(hint));
}

/// Reports a number that is too large or out of its bound; NaN passes, since it has been reported. Result: whether it
/// is usable.
bool check_number(Reader& reader, const Value& value, const FieldInfo& info, double number) {
  if (std::abs(number) > kLargestNumber) {
    report(reader, value, too_large(fmt::format("{}", number)));
  } else if (info.bound == Bound::positive && number <= 0) {
    report(reader, value, fmt::format("must be positive, got {}", number));
  } else if (info.bound == Bound::not_negative && number < 0) {
    report(reader, value, fmt::format("must not be negative, got {}", number));
  } else {
    return true;
  }
  return false;
}

/// The nodes of an expression text. Result: nothing after problems.
std::optional<Expression> parse(Reader& reader, const Value& value, const FieldInfo& info) {
  const Scope& place = current_scope(reader);
  const ExpressionScope scope{reader.names,         place.visible, reader.model.parameters, reader.model.expressions,
                              info.depends,         info.locals,   suggests(reader),        place.keeps_direction,
                              reader.folds_tunable, info.at_start};
  ParsedExpression parsed = parse_expression(value.text, scope);
  for (ExpressionProblem& problem : parsed.problems) {
    report(reader, place_in_text(reader.documents, value, problem.offset), std::move(problem.message),
           std::move(problem.hint));
  }
  if (!parsed.problems.empty()) return std::nullopt;
  for (const OutputUse& use : parsed.outputs)
    reader.output_uses.push_back(
        {place_in_text(reader.documents, value, use.offset), reader.scope, use.output, info.sees_accelerations});
  return std::move(parsed.expression);
}

int add_expression(Reader& reader, Expression expression) {
  reader.model.expressions.push_back(std::move(expression));
  return static_cast<int>(reader.model.expressions.size()) - 1;
}

/// The single parameter or input that decides the sign of an expression: in products and quotients with positive
/// numbers. Result: its node, or null.
const ExpressionNode* signed_as(const Expression& expression) {
  const ExpressionNode* found = nullptr;
  for (const ExpressionNode& node : expression.nodes) {
    if (node.kind == ExpressionNode::Kind::parameter || node.kind == ExpressionNode::Kind::input) {
      if (found) return nullptr;
      found = &node;
    } else if (node.kind == ExpressionNode::Kind::call) {
      if (node.function != Function::multiply && node.function != Function::divide) return nullptr;
    } else if (node.kind != ExpressionNode::Kind::number || !(node.number > 0)) {
      return nullptr;
    }
  }
  return found;
}

/// A tunable parameter or input that alone decides a bounded number gets this bound as its least value, for run time
/// too.
void bound_at_run_time(Reader& reader, const Expression& expression, const FieldInfo& info) {
  const ExpressionNode* node = info.bound == Bound::none ? nullptr : signed_as(expression);
  if (!node) return;
  const auto place = static_cast<std::size_t>(node->index);
  Presentation& shown = node->kind == ExpressionNode::Kind::input ? reader.model.inputs[place].shown
                                                                  : reader.model.parameters[place].shown;
  const double least = info.bound == Bound::positive ? std::numeric_limits<double>::min() : 0;
  shown.min = std::max(shown.min.value_or(least), least);
}

void read_expression(Reader& reader, const Value& value, const FieldInfo& info, Quantity& target) {
  std::optional<Expression> expression = parse(reader, value, info);
  if (!expression) return;
  target.value = evaluate<double>(*expression, ReferenceEnvironment{reader.model});
  const bool constant = expression->nodes.size() == 1 && expression->nodes[0].kind == ExpressionNode::Kind::number;
  // A force may be singular where all coordinates are zero; an expression of parameters alone may not.
  const bool must_be_finite = info.depends <= Depends::parameters || constant;
  if (must_be_finite && !std::isfinite(target.value)) {
    const bool spoiled = std::any_of(expression->nodes.begin(), expression->nodes.end(),
                                     [](const ExpressionNode& node) { return std::isnan(node.number); });
    if (!spoiled)
      report(reader, value,
             std::isnan(target.value) ? "is not a number at default parameters" : "is infinite at default parameters");
    target = kUnreadable;
    return;
  }
  if (std::isfinite(target.value) && !check_number(reader, value, info, target.value)) {
    target = kUnreadable;
  } else if (!constant) {
    bound_at_run_time(reader, *expression, info);
    target.expression = add_expression(reader, std::move(*expression));
  }
}

void read_degrees(Reader& reader, const Value& value, const FieldInfo& info, Quantity& target) {
  const Value* degrees = find(value, "deg");
  if (!degrees || value.members.size() != 1) {
    wrong_type(reader, value, "an angle: a number or an expression in rad, or {\"deg\": number}");
  } else if (degrees->kind == Value::Kind::text) {
    Quantity quantity(kUnreadable);
    read_expression(reader, *degrees, info, quantity);
    target = scaled(reader, std::numbers::pi / 180, quantity);
  } else if (degrees->kind != Value::Kind::number) {
    wrong_type(reader, *degrees, "a number or an expression of degrees");
  } else if (check_number(reader, *degrees, info, degrees->number)) {
    target = degrees->number * std::numbers::pi / 180;
  }
}

std::string_view wanted_of(const FieldInfo& info) {
  return info.shape == Shape::position ? "an array of 3 numbers or the name of a hardpoint" : "an array of 3 numbers";
}

/// Three constants or quantities. Result: false, with an unreadable target, for an array of another size.
template <class Number>
void read_three(Reader& reader, const Value& value, const FieldInfo& info, std::array<Number, 3>& target,
                std::string_view wanted) {
  target.fill(kUnreadable);
  if (value.kind != Value::Kind::array || value.items.size() != 3) return wrong_type(reader, value, wanted);
  for (std::size_t i = 0; i < 3; ++i) read_value(reader, value.items[i], info, target[i]);
}

void read_axis(Reader& reader, const Value& value, const FieldInfo& info, Vector3& target) {
  const std::string_view wanted =
      info.by_points ? "an axis: \"x\", \"-y\" and so on, an array of 3 numbers, or two points {\"from\", \"to\"}"
                     : "an axis: \"x\", \"-y\" and so on, or an array of 3 numbers";
  target.fill(kUnreadable);
  if (value.kind == Value::Kind::text) {
    const bool negative = value.text.starts_with('-');
    const std::string_view letter = std::string_view(value.text).substr(negative ? 1 : 0);
    const auto index = letter.size() == 1 ? std::string_view("xyz").find(letter) : std::string_view::npos;
    if (index == std::string_view::npos) return wrong_type(reader, value, wanted);
    target = {0, 0, 0};
    target[index] = negative ? -1 : 1;
    return;
  }
  if (info.by_points && value.kind == Value::Kind::object) return read_axis_by_points(reader, value, target);
  read_three(reader, value, info, target, wanted);
  constexpr double kSmallestLength = 1e-12;
  const double length = norm(target);
  if (length < kSmallestLength) {
    report(reader, value, "axis is zero");
    target.fill(kUnreadable);
  } else {
    for (double& component : target) component /= length;
  }
}

}  // namespace

void report(Reader& reader, Place place, std::string message, std::string hint) {
  reader.problems.push_back({place, std::move(message), std::move(hint), current_scope(reader).path});
}

void note(Reader& reader, Place place, std::string message, std::string hint) {
  reader.notes.push_back({place, std::move(message), std::move(hint), current_scope(reader).path});
}

const Value& member_or_object(const Value& object, std::string_view key) {
  const Value* member = find(object, key);
  return member ? *member : object;
}

bool check_keys(Reader& reader, const Value& value, const std::vector<const FieldInfo*>& rows) {
  if (value.kind != Value::Kind::object) {
    wrong_type(reader, value, "an object");
    return false;
  }
  std::vector<std::string_view> known;
  for (const FieldInfo* row : rows) known.push_back(row->name);
  for (const Member& member : value.members) {
    const auto row = std::find(known.begin(), known.end(), member.key);
    if (row == known.end()) {
      const std::string hint = did_you_mean(member.key, known);
      report(reader, member.place, "unknown key " + in_quotes(member.key), hint.empty() ? list_of(known) : hint);
    }
  }
  for (const FieldInfo* row : rows) {
    if (row->need == Need::required && !find(value, row->name)) {
      report(reader, value, "key " + in_quotes(row->name) + " is missing");
    }
  }
  return true;
}

int read_word(Reader& reader, const Value& value, const FieldInfo& info) {
  if (value.kind == Value::Kind::text) {
    const auto word = std::find(info.words.begin(), info.words.end(), value.text);
    if (word != info.words.end()) return static_cast<int>(word - info.words.begin());
  }
  std::string wanted;
  for (const std::string_view word : info.words) wanted += (wanted.empty() ? "" : ", ") + std::string(word);
  const std::string hint = value.kind == Value::Kind::text
                               ? did_you_mean(value.text, {info.words.begin(), info.words.end()})
                               : std::string();
  wanted = info.words.size() == 1 ? in_quotes(wanted) : "one of " + wanted;
  wrong_type(reader, value, wanted, hint.starts_with("did") ? hint : "");
  return -1;
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, bool& target) {
  if (!info.words.empty()) {
    target = read_word(reader, value, info) == 1;
  } else if (value.kind == Value::Kind::boolean) {
    target = value.boolean;
  } else {
    wrong_type(reader, value, "true or false");
  }
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, double& target) {
  FieldInfo constant = info;
  constant.depends = Depends::nothing;
  Quantity quantity;
  read_value(reader, value, constant, quantity);
  target = quantity.value;
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::string& target) {
  if (value.kind != Value::Kind::text) {
    wrong_type(reader, value, "a text");
  } else if (value.text.size() > info.longest) {
    report(reader, value, fmt::format("text is longer than {} bytes, it has {}", info.longest, value.text.size()));
  } else {
    target = value.text;
  }
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, Quantity& target) {
  target = kUnreadable;
  if (value.kind == Value::Kind::number) {
    if (check_number(reader, value, info, value.number)) target = value.number;
  } else if (value.kind == Value::Kind::text) {
    read_expression(reader, value, info, target);
  } else if (info.angle && value.kind == Value::Kind::object) {
    read_degrees(reader, value, info, target);
  } else {
    const bool degrees = value.kind == Value::Kind::object && find(value, "deg");
    wrong_type(reader, value, "a number or an expression",
               degrees ? "degrees are read only where an angle stands" : "");
  }
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, Vector3& target) {
  if (info.shape == Shape::axis) {
    read_axis(reader, value, info, target);
  } else if (info.shape == Shape::position && value.kind == Value::Kind::text) {
    read_constant_hardpoint(reader, value, target);
  } else {
    read_three(reader, value, info, target, wanted_of(info));
  }
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::array<double, 4>& target) {
  target.fill(kUnreadable);
  if (value.kind != Value::Kind::array || value.items.size() != 4) {
    return wrong_type(reader, value, "an array of 4 numbers (w, x, y, z)");
  }
  for (std::size_t i = 0; i < 4; ++i) read_value(reader, value.items[i], info, target[i]);
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, Vector3Quantity& target) {
  read_three(reader, value, info, target, wanted_of(info));
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::array<Quantity, 6>& target) {
  target.fill(kUnreadable);
  const std::size_t size = value.items.size();
  if (value.kind != Value::Kind::array || (size != 3 && size != 6)) {
    return wrong_type(reader, value, "an array of 3 numbers (xx yy zz) or 6 (xx yy zz xy xz yz)");
  }
  target.fill(0.0);
  for (std::size_t i = 0; i < size; ++i) read_value(reader, value.items[i], info, target[i]);
}

void read_value(Reader&, const Value& value, const FieldInfo&, const Value*& target) { target = &value; }

int read_force_expression(Reader& reader, const Value& value, const FieldInfo& info) {
  if (value.kind == Value::Kind::number) {
    if (!check_number(reader, value, info, value.number)) return -1;
    ExpressionNode node;
    node.number = value.number;
    return add_expression(reader, {fmt::format("{}", value.number), {node}});
  }
  if (value.kind != Value::Kind::text) {
    wrong_type(reader, value, "a number or an expression");
    return -1;
  }
  std::optional<Expression> expression = parse(reader, value, info);
  return expression ? add_expression(reader, std::move(*expression)) : -1;
}

}  // namespace mbgen::reading
