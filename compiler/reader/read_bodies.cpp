// Parameters, inputs, bodies with their points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/named_functions.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

void check_expression_name(Reader& reader, const Entry& entry) {
  if (is_reserved_name(entry.name) || is_reserved_name(entry.written)) {
    report(reader, entry.place, "name " + in_quotes(entry.written) + " is reserved, expressions use it");
  } else if (reader.names.parameters.contains(entry.name)) {
    report(reader, entry.place, in_quotes(entry.name) + " is a parameter and an input");
  }
}

void check_body(Reader& reader, const Value& value, const Body& body) {
  const Value* mass = find(value, "mass");
  const bool massless = body.mass.expression < 0 && body.mass.value == 0;
  if (mass && !find(value, "inertia") && !massless) {
    report(reader, *mass, "a body with mass needs inertia", "write \"inertia\": [0, 0, 0] for a point mass");
  }
}

struct PointPlace {
  Place place;
  std::size_t scope = 0;
};
using PointPlaces = std::vector<NameMap<PointPlace>>;

/// Three quantities as written in the current scope, or a hardpoint. Result: in the frame of the body.
Vector3Quantity point_position(Reader& reader, int body, const Value& value) {
  const FieldInfo info{.name = "point", .shape = Shape::position, .depends = Depends::parameters};
  if (value.kind == Value::Kind::text) {
    const int hardpoint = find_hardpoint(reader, value);
    return hardpoint < 0 ? Vector3Quantity{kUnreadable, kUnreadable, kUnreadable}
                         : position_on_body(reader, hardpoint, body);
  }
  Vector3Quantity written;
  read_value(reader, value, info, written);
  return placed_point(reader, body, written);
}

void read_points(Reader& reader, std::size_t body, const Value& value, PointPlaces& places) {
  if (value.kind != Value::Kind::object) {
    report(reader, value, fmt::format("must be an object of points, got {}", describe(value)));
    reader.names.points_unreadable[body] = true;
    return;
  }
  const bool own = reader.names.body_scopes[body] == reader.scope;
  for (const Member& member : value.members) {
    const std::string name = own ? member.key : full_name(current_scope(reader).visible.front(), member.key);
    if (!is_valid_name(name)) report(reader, member.place, "invalid name " + in_quotes(name), kNameRule);
    std::vector<Point>& points = reader.model.bodies[body].points;
    if (const auto first = places[body].find(name); first != places[body].end()) {
      // A duplicate key was reported by the parser.
      const bool reported = first->second.place.file == member.place.file && first->second.scope == reader.scope;
      if (!reported) {
        report(reader, member.place,
               fmt::format("point {} of body {} is defined twice, first at {}", in_quotes(name),
                           in_quotes(reader.model.bodies[body].name),
                           place_text(reader.documents, first->second.place, member.place)));
      }
      continue;
    }
    Point point;
    point.name = name;
    point.position = point_position(reader, static_cast<int>(body), member.value);
    places[body].emplace(name, PointPlace{member.place, reader.scope});
    reader.names.points[body].emplace(name, static_cast<int>(points.size()));
    points.push_back(std::move(point));
  }
}

/// Index of the input named by `value` as derivative of `input`, or -1 with a problem.
int derivative_of(Reader& reader, const Value& value, const InputFields& input) {
  const int index = find_named(reader, value, "input", reader.names.inputs);
  if (index < 0 || index != reader.names.inputs.find(input.name)->second) return index;
  report(reader, value, fmt::format("input {} cannot be its own derivative", in_quotes(input.name)));
  return -1;
}

/// Reports chains of too many derivatives, at the input with one too many.
void refuse_long_rows(Reader& reader, const Entries& entries) {
  constexpr int kMostDerivatives = 8;  // beyond any known signal; each one lengthens the emitted polynomials
  const std::vector<Input>& inputs = reader.model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    int derivatives = 0;
    for (int next = inputs[i].derivative; next >= 0 && derivatives < kMostDerivatives + 2; ++derivatives) {
      next = inputs[next].derivative;
    }
    if (derivatives == kMostDerivatives + 1) {
      report(
          reader, *find(*entries[i].value, "derivative"),
          fmt::format("input {} has more than {} derivatives in a row", in_quotes(inputs[i].name), kMostDerivatives));
    }
  }
}

/// Reports each cycle of inputs that are derivatives of each other, once.
void refuse_circles(Reader& reader, const Entries& entries) {
  std::vector<Input>& inputs = reader.model.inputs;
  std::vector<int> met_from(inputs.size(), -1);
  for (int start = 0; start < static_cast<int>(inputs.size()); ++start) {
    int i = start;
    for (; i >= 0 && met_from[i] < 0; i = inputs[i].derivative) met_from[i] = start;
    if (i < 0 || met_from[i] != start) continue;
    std::string names = inputs[i].name;
    for (int next = inputs[i].derivative; next != i; next = inputs[next].derivative) {
      names += " -> " + inputs[next].name;
    }
    report(reader, *find(*entries[i].value, "derivative"),
           fmt::format("inputs are derivatives of each other in a circle, {} -> {}", names, inputs[i].name));
    inputs[i].derivative = -1;
  }
}

/// An instance's value for a parameter of its subsystem, or nullptr.
const Value* override_of(const Reader& reader, const Entry& entry) {
  const Value* overrides = reader.scopes[entry.scope].instance.parameters;
  return overrides ? find(*overrides, entry.written) : nullptr;
}

/// Reports values for unknown parameters of a subsystem.
void check_overrides(Reader& reader, const Entries& entries) {
  for (std::size_t i = 1; i < reader.scopes.size(); ++i) {
    const Scope& scope = reader.scopes[i];
    const InScope in_scope(reader, scope.parent);
    const Value* overrides = scope.instance.parameters;
    if (!overrides) continue;
    if (overrides->kind != Value::Kind::object) {
      report(reader, *overrides, "must be an object of parameters, got " + describe(*overrides));
      continue;
    }
    std::vector<std::string_view> known;
    for (const Entry& entry : entries) {
      if (entry.scope == i) known.push_back(entry.written);
    }
    for (const Member& member : overrides->members) {
      if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
      report(reader, member.place,
             fmt::format("subsystem {} has no parameter {}", in_quotes(scope.file), in_quotes(member.key)),
             did_you_mean(member.key, known));
    }
  }
}

/// A parameter of a file, with the value given by the instance, if any.
void read_parameter(Reader& reader, const Entry& entry, ParameterFields& parameter) {
  const FieldInfo& value_info = fields<ParameterFields>()[0].info;
  const Value& value = *entry.value;
  if (value.kind == Value::Kind::object && !find(value, "deg")) {
    read_fields(reader, value, parameter);
  } else {
    read_value(reader, value, value_info, parameter.quantity);
  }
  if (const Value* given = override_of(reader, entry)) {
    const InScope in_scope(reader, current_scope(reader).parent);
    read_value(reader, *given, value_info, parameter.quantity);
    if (parameter.quantity.expression >= 0) parameter.tunable = false;  // it depends on the model's parameters
  } else if (parameter.tunable && parameter.quantity.expression >= 0) {
    report(reader, entry.place, in_quotes(entry.name) + " follows from tunable parameters and cannot be tuned itself",
           "leave out \"tunable\": it changes with them");
  }
}

void check_ground(Reader& reader, const Value& value) {
  for (const Member& member : value.members) {
    if (member.key == "points") continue;
    report(reader, member.place, fmt::format("ground is fixed and has points only, got {}", in_quotes(member.key)));
  }
}

/// Index of a new body. written: its pose in the current scope.
int add_body(Reader& reader, Body body, Place place, const Pose& written, WrittenInertia inertia, bool readable,
             PointPlaces& places) {
  const int index = static_cast<int>(reader.model.bodies.size());
  if (body.name == "ground") reader.model.ground = index;
  reader.names.bodies.emplace(body.name, index);
  reader.names.body_scopes.push_back(reader.scope);
  reader.body_frames.push_back(written);
  reader.inertias.push_back(inertia);
  reader.body_places.push_back(place);
  reader.names.points.emplace_back();
  reader.names.points_unreadable.push_back(!readable);
  reader.model.bodies.push_back(std::move(body));
  places.emplace_back();
  return index;
}

/// A body defined in the current scope, or points added to it by one of its files.
void read_body(Reader& reader, const Entry& entry, PointPlaces& places) {
  BodyFields body = with_defaults<BodyFields>();
  body.name = entry.name;
  body.where = where_of(reader.documents, entry.place);
  const bool ground = entry.name == "ground";
  if (ground) check_ground(reader, *entry.value);
  const bool readable = read_fields(reader, *entry.value, body);
  if (readable && !ground) check_body(reader, *entry.value, body);
  const FieldInfo com{.name = "com", .shape = Shape::position, .depends = Depends::parameters};
  if (body.written_com) read_position(reader, *body.written_com, com, body.pose, body.com);
  const Pose written = body.pose;
  place_body(reader, body);
  const auto found = reader.names.bodies.find(entry.name);
  const WrittenInertia inertia{find(*entry.value, "inertia"), body.accepts_inertia};
  const int index = found == reader.names.bodies.end()
                        ? add_body(reader, body, entry.place, written, inertia, readable, places)
                        : found->second;
  if (body.point_list) read_points(reader, static_cast<std::size_t>(index), *body.point_list, places);
}

/// Points added to a body of another scope.
void read_outer_points(Reader& reader, const Entry& entry, PointPlaces& places) {
  for (const Member& member : entry.value->members) {
    if (member.key == "points") continue;
    report(reader, member.place,
           fmt::format("body {} is defined elsewhere and has points only here, got {}", in_quotes(entry.written),
                       in_quotes(member.key)));
  }
  BodyFields body = with_defaults<BodyFields>();
  if (!read_fields(reader, *entry.value, body)) return;
  int index = find_body(reader, entry.written);
  if (index < 0 && find_outer_name(reader, entry.written) == "ground") {
    const InScope in_scope(reader, 0);
    Body ground;
    ground.name = "ground";
    ground.where = where_of(reader.documents, entry.place);
    index = add_body(reader, std::move(ground), entry.place, {}, {}, true, places);
  }
  if (index >= 0) {
    if (body.point_list) read_points(reader, static_cast<std::size_t>(index), *body.point_list, places);
    return;
  }
  const Value& target = *current_scope(reader).connections.find(entry.written)->second;
  const InScope in_parent(reader, current_scope(reader).parent);
  report(reader, target, "unknown body " + in_quotes(target.text),
         suggestion(reader, target.text, reader.names.bodies));
}

/// Reads a parameter with its value in a study.
void vary(const Reader& reader, ParameterFields& parameter) {
  const auto varied = std::find_if(reader.varied.begin(), reader.varied.end(),
                                   [&](const VariedParameter& one) { return one.name == parameter.name; });
  if (varied == reader.varied.end()) return;
  parameter.value = varied->value.value_or(parameter.value);
  parameter.tunable = varied->tunable;
  parameter.expression = -1;
}

/// Checks the fields of a parameter's object beside its value.
void check_parameter(Reader& reader, const Value& value, const ParameterFields& parameter) {
  if (value.kind != Value::Kind::object || find(value, "deg")) return;
  const Value* number = find(value, "value");
  if (number && number->kind == Value::Kind::object) check_unit_of(reader, value, parameter.unit, "rad");
  check_presentation(reader, value, parameter.unit, parameter, parameter.value);
  if (parameter.at_start && (parameter.tunable || parameter.expression >= 0)) {
    report(reader, *find(value, "at_start"),
           "a tunable parameter, or a parameter that follows from one, cannot act at the start",
           "leave out \"tunable\" or \"at_start\"");
  }
}

}  // namespace

void read_parameters(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) reader.names.later_parameters.emplace(entry.name, 0);
  check_overrides(reader, entries);
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    check_expression_name(reader, entry);
    ParameterFields parameter = with_defaults<ParameterFields>();
    parameter.name = entry.name;
    parameter.where = where_of(reader.documents, entry.place);
    read_parameter(reader, entry, parameter);
    parameter.value = parameter.quantity.value;
    parameter.expression = parameter.quantity.expression;
    vary(reader, parameter);
    check_parameter(reader, *entry.value, parameter);
    parameter.shown = parameter;
    reader.names.later_parameters.erase(entry.name);
    reader.names.parameters.emplace(entry.name, static_cast<int>(reader.model.parameters.size()));
    reader.model.parameters.push_back(std::move(parameter));
  }
}

void read_inputs(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    check_expression_name(reader, entry);
    reader.names.inputs.emplace(entry.name, static_cast<int>(reader.names.inputs.size()));
  }
  std::vector<InputFields> inputs;
  read_list(reader, entries, inputs, [&](Reader&, const Value& value, InputFields& input) {
    check_presentation(reader, value, input.unit, input, input.default_value);
    input.shown = input;
    if (input.rate) input.derivative = derivative_of(reader, *find(value, "derivative"), input);
  });
  for (InputFields& input : inputs) reader.model.inputs.push_back(std::move(input));
  refuse_circles(reader, entries);
  refuse_long_rows(reader, entries);
}

void read_bodies(Reader& reader, const Entries& entries) {
  PointPlaces places;
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    if (!entry.adds_points) read_body(reader, entry, places);
  }
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    if (entry.adds_points) read_outer_points(reader, entry, places);
  }
}

}  // namespace mbgen::reading
