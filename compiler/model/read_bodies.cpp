// Parameters, inputs, bodies with their points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/raw.hpp"
#include "compiler/model/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kInertiaSlack = 1e-9;  ///< of the trace: inertias typed with few digits pass, wrong ones do not

void check_expression_name(Reader& reader, const Entry& entry) {
  if (is_reserved_name(entry.name)) {
    report(reader, entry.place, "name " + in_quotes(entry.name) + " is reserved, expressions use it");
  } else if (reader.names.parameters.contains(entry.name)) {
    report(reader, entry.place, in_quotes(entry.name) + " is a parameter and an input");
  }
}

/// Eigenvalues of a symmetric matrix (xx yy zz xy xz yz), ascending, by Jacobi rotations.
std::array<double, 3> principal_moments(const std::array<double, 6>& entries) {
  double m[3][3] = {
      {entries[0], entries[3], entries[4]}, {entries[3], entries[1], entries[5]}, {entries[4], entries[5], entries[2]}};
  constexpr int kSweeps = 12;  // converges quadratically, five are usual
  for (int step = 0; step < 3 * kSweeps; ++step) {
    const int p = step % 3 == 2 ? 1 : 0, q = step % 3 == 0 ? 1 : 2;
    if (m[p][q] == 0) continue;
    const double angle = 0.5 * std::atan2(2 * m[p][q], m[q][q] - m[p][p]);
    const double c = std::cos(angle), s = std::sin(angle);
    for (auto& row : m) {
      const double at_p = row[p], at_q = row[q];
      row[p] = c * at_p - s * at_q;
      row[q] = s * at_p + c * at_q;
    }
    for (int column = 0; column < 3; ++column) {
      const double at_p = m[p][column], at_q = m[q][column];
      m[p][column] = c * at_p - s * at_q;
      m[q][column] = s * at_p + c * at_q;
    }
  }
  std::array<double, 3> moments = {m[0][0], m[1][1], m[2][2]};
  std::sort(moments.begin(), moments.end());
  return moments;
}

void check_inertia(Reader& reader, const Value& value, const Body& body) {
  std::array<double, 6> entries{};
  for (std::size_t i = 0; i < 6; ++i) entries[i] = body.inertia[i].value;
  if (std::any_of(entries.begin(), entries.end(), [](double entry) { return std::isnan(entry); })) return;
  const auto [smallest, middle, largest] = principal_moments(entries);
  const double slack = kInertiaSlack * std::abs(entries[0] + entries[1] + entries[2]);
  const std::string moments = fmt::format("principal moments {:.6g}, {:.6g}, {:.6g}", smallest, middle, largest);
  if (smallest < -slack) {
    report(reader, value, "inertia is not positive semidefinite, " + moments);
  } else if (largest > smallest + middle + slack) {
    report(reader, value, "inertia breaks the triangle inequality, " + moments,
           "no principal moment of a rigid body exceeds the sum of the other two");
  }
}

void check_body(Reader& reader, const Value& value, const Body& body) {
  const Value* mass = find(value, "mass");
  const Value* inertia = find(value, "inertia");
  const bool massless = body.mass.expression < 0 && body.mass.value == 0;
  if (mass && !inertia && !massless) {
    report(reader, *mass, "a body with mass needs inertia", "write \"inertia\": [0, 0, 0] for a point mass");
  }
  if (!inertia) return;
  const bool rotates = std::any_of(body.inertia.begin(), body.inertia.end(), [](const Quantity& entry) {
    return entry.expression >= 0 || (entry.value != 0 && !std::isnan(entry.value));
  });
  if (massless && rotates) report(reader, *inertia, "a body with inertia needs mass");
  check_inertia(reader, *inertia, body);
}

using PointPlaces = std::vector<NameMap<Place>>;

void read_points(Reader& reader, std::size_t body, const Value& value, PointPlaces& places) {
  if (value.kind != Value::Kind::object) {
    report(reader, value, fmt::format("must be an object of points, got {}", describe(value)));
    reader.names.points_unreadable[body] = true;
    return;
  }
  for (const Member& member : value.members) {
    if (!is_valid_name(member.key)) report(reader, member.place, "invalid name " + in_quotes(member.key), kNameRule);
    std::vector<Point>& points = reader.model.bodies[body].points;
    if (const auto first = places[body].find(member.key); first != places[body].end()) {
      const bool reported = first->second.file == member.place.file;  // by the parser, as a duplicate key
      if (!reported) {
        report(reader, member.place,
               fmt::format("point {} of body {} is defined twice, first at {}", in_quotes(member.key),
                           in_quotes(reader.model.bodies[body].name),
                           place_text(reader.documents, first->second, member.place)));
      }
      continue;
    }
    const FieldInfo info{.name = "point", .shape = Shape::quantity_vector, .depends = Depends::parameters};
    Point point;
    point.name = member.key;
    read_value(reader, member.value, info, point.position);
    places[body].emplace(member.key, member.place);
    reader.names.points[body].emplace(member.key, static_cast<int>(points.size()));
    points.push_back(std::move(point));
  }
}

/// Index of the input that `value` names as the derivative of `input`, or -1 with a complaint.
int derivative_of(Reader& reader, const Value& value, const InputFields& input) {
  if (value.kind != Value::Kind::text) return -1;
  const auto found = reader.names.inputs.find(value.text);
  if (found == reader.names.inputs.end()) {
    report(reader, value, "unknown input " + in_quotes(value.text),
           suggestion(reader, value.text, reader.names.inputs));
    return -1;
  }
  if (value.text != input.name) return found->second;
  report(reader, value, fmt::format("input {} cannot be its own derivative", in_quotes(input.name)));
  return -1;
}

/// Complains about inputs with too many derivatives in a row: about the last that has one too many.
void refuse_long_rows(Reader& reader, const Entries& entries) {
  constexpr int kMostDerivatives = 8;  // more than any signal is known by; each makes the emitted polynomials longer
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

/// Complains once about each circle of inputs that are derivatives of each other.
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

void check_ground(Reader& reader, const Value& value) {
  for (const Member& member : value.members) {
    if (member.key == "points") continue;
    report(reader, member.place, fmt::format("ground is fixed and has points only, got {}", in_quotes(member.key)));
  }
}

/// Reads a parameter as a study varies it.
void vary(const Reader& reader, ParameterFields& parameter) {
  const auto varied = std::find_if(reader.varied.begin(), reader.varied.end(),
                                   [&](const VariedParameter& one) { return one.name == parameter.name; });
  if (varied == reader.varied.end()) return;
  parameter.value = varied->value.value_or(parameter.value);
  parameter.tunable = varied->tunable;
  parameter.expression = -1;
}

}  // namespace

void read_parameters(Reader& reader, const Entries& entries) {
  const FieldInfo& value_info = fields<ParameterFields>()[0].info;
  for (const Entry& entry : entries) reader.names.later_parameters.emplace(entry.name, 0);
  for (const Entry& entry : entries) {
    check_expression_name(reader, entry);
    ParameterFields parameter = with_defaults<ParameterFields>();
    parameter.name = entry.name;
    parameter.where = where_of(reader.documents, entry.place);
    if (entry.value->kind == Value::Kind::object && !find(*entry.value, "deg")) {
      read_fields(reader, *entry.value, parameter);
    } else {
      read_value(reader, *entry.value, value_info, parameter.quantity);
    }
    parameter.value = parameter.quantity.value;
    parameter.expression = parameter.quantity.expression;
    if (parameter.tunable && parameter.expression >= 0) {
      report(reader, entry.place, in_quotes(entry.name) + " follows from tunable parameters and cannot be tuned itself",
             "leave out \"tunable\": it changes with them");
    }
    vary(reader, parameter);
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
    if (input.rate) input.derivative = derivative_of(reader, *find(value, "derivative"), input);
  });
  for (InputFields& input : inputs) reader.model.inputs.push_back(std::move(input));
  refuse_circles(reader, entries);
  refuse_long_rows(reader, entries);
}

void read_bodies(Reader& reader, const Entries& entries) {
  Model& model = reader.model;
  PointPlaces places;
  for (const Entry& entry : entries) {
    BodyFields body = with_defaults<BodyFields>();
    body.name = entry.name;
    body.where = where_of(reader.documents, entry.place);
    const bool ground = entry.name == "ground";
    if (ground) check_ground(reader, *entry.value);
    const bool readable = read_fields(reader, *entry.value, body);
    if (readable && !ground) check_body(reader, *entry.value, body);
    const auto [found, is_new] = reader.names.bodies.emplace(entry.name, static_cast<int>(model.bodies.size()));
    if (is_new) {
      model.bodies.push_back(body);
      reader.names.points.emplace_back();
      reader.names.points_unreadable.push_back(!readable);
      places.emplace_back();
      if (ground) model.ground = found->second;
    }
    if (body.point_list) read_points(reader, static_cast<std::size_t>(found->second), *body.point_list, places);
  }
}

}  // namespace mbgen::reading
