// Poses of instances, and their bodies, points, axes and forces in global axes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

Vector3 flipped(const Vector3& vector, const Vector3& flip) {
  const auto one = [&](std::size_t i) { return vector[i] == 0 ? 0.0 : flip[i] * vector[i]; };  // no -0 in dumps
  return {one(0), one(1), one(2)};
}

Matrix3 flipped_columns(const Matrix3& matrix, const Vector3& flip) {
  Matrix3 result = matrix;
  for (std::size_t i = 0; i < 9; ++i) result[i] = matrix[i] == 0 ? 0.0 : matrix[i] * flip[i % 3];
  return result;
}

/// flip * matrix * flip: a rotation in the mirrored frame.
Matrix3 flipped_both(const Matrix3& matrix, const Vector3& flip) {
  return transposed(flipped_columns(transposed(flipped_columns(matrix, flip)), flip));
}

/// A placement inside another one.
Placement composed(const Placement& outer, const Placement& inner) {
  Placement result;
  const Vector3 origin = rotated(outer.rotation, flipped(inner.origin, outer.flip));
  for (std::size_t i = 0; i < 3; ++i) {
    result.origin[i] = outer.origin[i] + origin[i];
    result.flip[i] = outer.flip[i] * inner.flip[i];
  }
  result.rotation = product(outer.rotation, flipped_both(inner.rotation, outer.flip));
  return result;
}

/// Matrix from a written vector's components to the frame of a body: for a body of the same scope the frame includes
/// the flip, other bodies are not mirrored.
Matrix3 to_body_frame(const Reader& reader, int body) {
  const Placement& placement = current_scope(reader).placement;
  const auto index = static_cast<std::size_t>(body);
  if (reader.names.body_scopes[index] == reader.scope) return flipped_columns(Placement{}.rotation, placement.flip);
  const Matrix3 to_model = axes_of(placement);
  return product(transposed(reader.model.bodies[index].pose.rotation), to_model);
}

int add_node(Expression& expression, const ExpressionNode& node) {
  expression.nodes.push_back(node);
  return static_cast<int>(expression.nodes.size()) - 1;
}

int add_number(Expression& expression, double number) {
  ExpressionNode node;
  node.number = number;
  return add_node(expression, node);
}

int add_call(Expression& expression, Function function, int first, int second = -1) {
  ExpressionNode node;
  node.kind = ExpressionNode::Kind::call;
  node.function = function;
  node.first = first;
  node.second = second;
  return add_node(expression, node);
}

/// Appends factor * term. Result: its node.
int add_multiple(Expression& sum, double factor, const Expression& term) {
  const int value = append(sum.nodes, term.nodes);
  const std::string plus = sum.text.empty() ? "" : " + ";
  if (factor == 1) {
    sum.text += fmt::format("{}({})", plus, term.text);
    return value;
  }
  sum.text +=
      factor == -1 ? fmt::format("{}-({})", plus, term.text) : fmt::format("{}{}*({})", plus, factor, term.text);
  return factor == -1 ? add_call(sum, Function::negate, value)
                      : add_call(sum, Function::multiply, value, add_number(sum, factor));
}

/// Sign of a rotation about `axis` (a displacement along it), apart from the effect of the flip on the axis.
double sense(const Scope& scope, const Vector3& axis, FreedomKind kind) {
  const double mirrored = kind == FreedomKind::revolute ? handedness(scope.placement) : 1;
  if (!scope.keeps_direction) return mirrored;
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(axis[i]) > std::abs(axis[largest])) largest = i;
  }
  return scope.placement.flip[largest];
}

Placement read_placement(Reader& reader, const InstanceFields& instance) {
  Placement placement;
  if (instance.offset) {
    read_value(reader, *instance.offset, {.name = "offset", .shape = Shape::position}, placement.origin);
    for (double& component : placement.origin) component = std::isnan(component) ? 0 : component;
  }
  if (instance.rotation) {
    read_value(reader, *instance.rotation, {.name = "rotation", .shape = Shape::rotations}, placement.rotation);
    placement.rotation = without_rest(placement.rotation);
    if (std::isnan(placement.rotation[0])) placement.rotation = Placement{}.rotation;
  }
  if (instance.mirror) {
    constexpr std::size_t kNormals[] = {1, 0, 2};  // of xz, yz, xy
    placement.flip[kNormals[static_cast<std::size_t>(*instance.mirror)]] = -1;
  }
  return placement;
}

/// Reports connections of unknown bodies, or to unknown bodies.
void check_connections(Reader& reader, const Scope& scope) {
  std::vector<std::string_view> known;
  for (const FileFields& file : scope.files) {
    if (!file.bodies) continue;
    for (const Member& member : file.bodies->members) known.push_back(member.key);
  }
  for (const auto& [name, target] : scope.connections) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    report(reader, find_member(*scope.instance.connect, name)->place,
           fmt::format("subsystem {} has no body {} to connect", in_quotes(scope.file), in_quotes(name)),
           did_you_mean(name, known));
  }
}

}  // namespace

Quantity combination(Reader& reader, const Vector3& factors, const Vector3Quantity& quantities, double constant) {
  std::vector<Expression>& expressions = reader.model.expressions;
  Quantity result(constant);
  double number = constant;  // part that is independent of parameters
  Expression sum;
  int total = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Quantity& quantity = quantities[i];
    if (factors[i] == 0) continue;
    const double product = factors[i] * quantity.value;
    result.value = result.value == 0 ? product + 0.0 : result.value + product;
    if (quantity.expression < 0) {
      number = number == 0 ? product + 0.0 : number + product;
      continue;
    }
    if (factors[i] == 1 && constant == 0 && std::count(factors.begin(), factors.end(), 0.0) == 2) return quantity;
    const int term = add_multiple(sum, factors[i], expressions[static_cast<std::size_t>(quantity.expression)]);
    total = total < 0 ? term : add_call(sum, Function::add, total, term);
  }
  if (total < 0) return result;
  if (number != 0) {
    sum.text += fmt::format(" + {}", number);
    add_call(sum, Function::add, total, add_number(sum, number));
  }
  expressions.push_back(std::move(sum));
  result.expression = static_cast<int>(expressions.size()) - 1;
  return result;
}

Matrix3 without_rest(const Matrix3& rotation) {
  constexpr double kRest = 1e-15;
  Matrix3 result = rotation;
  for (double& entry : result) {
    if (std::abs(entry - std::round(entry)) < kRest) entry = std::round(entry) + 0.0;
  }
  return result;
}

Vector3Quantity transformed(Reader& reader, const Matrix3& matrix, const Vector3Quantity& vector,
                            const Vector3& constant) {
  Vector3Quantity result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = combination(reader, {matrix[3 * i], matrix[3 * i + 1], matrix[3 * i + 2]}, vector, constant[i]);
  }
  return result;
}

Matrix3 axes_of(const Placement& placement) { return flipped_columns(placement.rotation, placement.flip); }

double handedness(const Placement& placement) { return placement.flip[0] * placement.flip[1] * placement.flip[2]; }

void place_instances(Reader& reader) {
  for (std::size_t i = 1; i < reader.scopes.size(); ++i) {
    Scope& scope = reader.scopes[i];
    const InScope in_scope(reader, scope.parent);
    reader.placed_scopes = i;
    scope.placement = composed(current_scope(reader).placement, read_placement(reader, scope.instance));
    check_connections(reader, scope);
  }
  reader.placed_scopes = reader.scopes.size();
}

bool is_outer_body(const Reader& reader, std::string_view name) {
  if (reader.scope == 0) return false;
  return name == "ground" || current_scope(reader).connections.contains(name);
}

bool is_connected(const Reader& reader, std::string_view name) {
  std::size_t scope = reader.scope;
  while (scope != 0 && !reader.scopes[scope].connections.contains(name)) scope = reader.scopes[scope].parent;
  return scope != 0;
}

std::string find_outer_name(const Reader& reader, std::string_view name) {
  std::string result(name);
  for (std::size_t scope = reader.scope; scope != 0; scope = reader.scopes[scope].parent) {
    const auto& connections = reader.scopes[scope].connections;
    const auto connection = connections.find(result);
    if (connection != connections.end()) {
      result = connection->second->text;
    } else if (result != "ground") {
      const std::string full = full_name(reader.scopes[scope].visible.front(), result);
      if (reader.names.bodies.contains(full)) return full;
    }
  }
  return result;
}

int find_body(const Reader& reader, std::string_view name) {
  const auto found = reader.names.bodies.find(find_outer_name(reader, name));
  return found == reader.names.bodies.end() ? -1 : found->second;
}

void place_body(Reader& reader, Body& body) {
  if (reader.scope == 0) return;
  const Placement& placement = current_scope(reader).placement;
  const Vector3& flip = placement.flip;
  const Vector3 origin = rotated(placement.rotation, flipped(body.pose.origin, flip));
  for (std::size_t i = 0; i < 3; ++i) body.pose.origin[i] = placement.origin[i] + origin[i];
  body.pose.rotation = product(placement.rotation, flipped_both(body.pose.rotation, flip));
  body.com = transformed(reader, flipped_columns(Placement{}.rotation, flip), body.com);
  constexpr std::size_t kProducts[3][2] = {{0, 1}, {0, 2}, {1, 2}};  // xy xz yz
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [row, column] = kProducts[i];
    Quantity& entry = body.inertia[3 + i];
    entry = combination(reader, {flip[row] * flip[column], 0, 0}, {entry, 0.0, 0.0}, 0);
  }
}

Vector3Quantity placed_point(Reader& reader, int body, const Vector3Quantity& written) {
  const auto index = static_cast<std::size_t>(body);
  const bool own = reader.names.body_scopes[index] == reader.scope;
  if (own && reader.scope == 0) return written;
  const Matrix3 matrix = to_body_frame(reader, body);
  if (own) return transformed(reader, matrix, written);
  const Placement& placement = current_scope(reader).placement;
  const Pose& pose = reader.model.bodies[index].pose;
  Vector3 offset{};
  for (std::size_t i = 0; i < 3; ++i) offset[i] = placement.origin[i] - pose.origin[i];
  return transformed(reader, matrix, written, rotated(transposed(pose.rotation), offset));
}

Vector3 placed_direction(const Reader& reader, int body, const Vector3& written) {
  const auto index = static_cast<std::size_t>(body);
  const Matrix3& of_body = reader.model.bodies[index].pose.rotation;
  const Placement& placement = current_scope(reader).placement;
  const bool own = reader.names.body_scopes[index] == reader.scope;
  return rotated(own ? of_body : placement.rotation, flipped(written, placement.flip));
}

Vector3 placed_axis(const Reader& reader, int body, const Vector3& written, FreedomKind kind) {
  if (body < 0) return {kUnreadable, kUnreadable, kUnreadable};
  const double sign = sense(current_scope(reader), written, kind);
  return placed_direction(reader, body, {sign * written[0], sign * written[1], sign * written[2]});
}

bool is_reversed(const Reader& reader, const Vector3& written, FreedomKind kind) {
  const Scope& scope = current_scope(reader);
  return scope.keeps_direction &&
         sense(scope, written, kind) != (kind == FreedomKind::revolute ? handedness(scope.placement) : 1);
}

void refuse_reversed(Reader& reader, Place place, const CoordinateReference& coordinate) {
  const auto& reversed = reader.names.reversed;
  if (!current_scope(reader).keeps_direction || coordinate.joint < 0) return;
  if (std::find(reversed.begin(), reversed.end(), coordinate) == reversed.end()) return;
  report(reader, place, reversed_message(coordinate_name(reader.model, coordinate)), kReversedHint);
}

void place_force(Reader& reader, AppliedForce& force) {
  if (force.at.body < 0) return;
  if (reader.scope == 0 && reader.names.body_scopes[static_cast<std::size_t>(force.at.body)] == 0) return;
  const Placement& placement = current_scope(reader).placement;
  const Matrix3 matrix = force.in_body_axes ? to_body_frame(reader, force.at.body) : axes_of(placement);
  Matrix3 of_moments = matrix;
  for (double& entry : of_moments) entry = entry == 0 ? 0.0 : entry * handedness(placement);
  force.force = transformed(reader, matrix, force.force);
  force.torque = transformed(reader, of_moments, force.torque);
}

}  // namespace mbgen::reading
