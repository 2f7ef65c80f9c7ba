// Motions, outputs, initial state, solver settings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/raw.hpp"
#include "compiler/model/reader.hpp"

namespace mbgen::reading {
namespace {

void resolve_motion(Reader& reader, const Value& value, MotionFields& motion) {
  const Value* angle = find(value, "angle");
  const Value* displacement = find(value, "position");
  if (!angle && !displacement) report(reader, value, "motion needs \"angle\" or \"position\"");
  if (angle && displacement) {
    report(reader, find_member(value, "position")->place, "motion has both \"angle\" and \"position\"");
  }
  refuse_reversed(reader, member_or_object(value, "joint").place, motion.joint);
  motion.position = motion.angle ? *motion.angle : motion.displacement.value_or(Quantity());
  if (motion.joint.joint < 0 || (angle && displacement)) return;
  const bool rotation = is_rotation(reader.model, motion.joint);
  const std::string name = in_quotes(coordinate_name(reader.model, motion.joint));
  if (const Member* member = find_member(value, rotation ? "position" : "angle")) {
    report(reader, member->place,
           fmt::format("coordinate {} is a {}, drive its \"{}\"", name, rotation ? "rotation" : "translation",
                       rotation ? "angle" : "position"));
  }
  const std::vector<Motion>& motions = reader.model.motions;
  const auto same =
      std::find_if(motions.begin(), motions.end(), [&](const Motion& other) { return other.joint == motion.joint; });
  if (same != motions.end()) {
    report(reader, *find(value, "joint"),
           fmt::format("coordinate {} is already driven by motion {}", name, in_quotes(same->name)));
  }
}

constexpr std::string_view kSources[] = {"expression", "point",  "joint",    "tyre",
                                         "spring",     "motion", "reaction", "multiplier"};

/// What kind of thing an output shows; index into kSources, or -1 with a complaint.
int source_of(Reader& reader, const Value& value) {
  int source = -1;
  for (std::size_t i = 0; i < std::size(kSources); ++i) {
    const Member* member = find_member(value, kSources[i]);
    if (!member) continue;
    if (source >= 0) {
      report(reader, member->place,
             fmt::format("output has both {} and {}", in_quotes(kSources[static_cast<std::size_t>(source)]),
                         in_quotes(kSources[i])));
      return -1;
    }
    source = static_cast<int>(i);
  }
  if (source < 0) {
    report(reader, value, "output needs one of expression, point, joint, tyre, spring, motion, reaction, multiplier");
  }
  return source;
}

/// The quantity when it is one of those that the source has, else the first of them, with a complaint.
Quantities quantity_of(Reader& reader, const Value& value, const OutputFields& output,
                       std::initializer_list<Quantities> allowed, std::string_view source) {
  if (!output.quantity) return *allowed.begin();
  if (std::find(allowed.begin(), allowed.end(), *output.quantity) != allowed.end()) return *output.quantity;
  report(reader, *find(value, "quantity"), fmt::format("a {} has no {}", source, find(value, "quantity")->text));
  return *allowed.begin();
}

constexpr std::initializer_list<Quantities> kMotionQuantities = {Quantities::position, Quantities::velocity,
                                                                 Quantities::acceleration};
constexpr std::initializer_list<Quantities> kTyreQuantities = {Quantities::load,
                                                               Quantities::longitudinal_force,
                                                               Quantities::lateral_force,
                                                               Quantities::aligning_moment,
                                                               Quantities::longitudinal_slip,
                                                               Quantities::lateral_slip};

void refuse(Reader& reader, const Value& value, std::string_view key, std::string_view source) {
  if (const Member* member = find_member(value, key)) {
    report(reader, member->place, fmt::format("an output of {} takes no {}", source, in_quotes(key)));
  }
}

void require_axis(Reader& reader, const Value& value, std::string_view source) {
  if (!find(value, "axis")) report(reader, value, fmt::format("an output of {} needs \"axis\"", source));
}

/// Index of a named element, or -1 with a complaint.
int find_element(Reader& reader, const Value& value, std::string_view key, const NameMap<int>& names) {
  const Value& reference = *find(value, key);
  if (reference.kind != Value::Kind::text) return -1;
  const auto found = find_visible(names, reference.text, current_scope(reader).visible);
  if (found != names.end()) return found->second;
  report(reader, reference, fmt::format("unknown {} {}", key, in_quotes(reference.text)),
         suggestion(reader, reference.text, names));
  return -1;
}

template <class What>
What offset(Quantities quantity, Quantities first) {
  return static_cast<What>(static_cast<int>(quantity) - static_cast<int>(first));
}

const char* motion_unit(bool rotation, Quantities quantity) {
  if (quantity == Quantities::position) return rotation ? "rad" : "m";
  if (quantity == Quantities::velocity) return rotation ? "rad/s" : "m/s";
  return rotation ? "rad/s^2" : "m/s^2";
}

/// The source of an output and the unit it has by itself.
struct Resolved {
  decltype(Output::source) source;
  std::string unit;
};

Resolved point_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, kMotionQuantities, "point");
  require_axis(reader, value, "point");
  PointOutput point;
  point.what = offset<PointOutput::What>(quantity, Quantities::position);
  point.point = *output.point;
  point.axis = static_cast<int>(output.axis.value_or(Letter::x));
  point.in_body_axes = output.in_body_axes.value_or(false);
  return {point, motion_unit(false, quantity)};
}

Resolved joint_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, kMotionQuantities, "coordinate");
  const bool rotation = output.joint->joint >= 0 && is_rotation(reader.model, *output.joint);
  return {CoordinateOutput{offset<CoordinateOutput::What>(quantity, Quantities::position), *output.joint},
          motion_unit(rotation, quantity)};
}

Resolved tyre_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, kTyreQuantities, "tyre");
  const int tyre = find_element(reader, value, "tyre", reader.names.tyres);
  const char* unit = quantity == Quantities::aligning_moment     ? "N m"
                     : quantity >= Quantities::longitudinal_slip ? "1"
                                                                 : "N";
  if (quantity == Quantities::lateral_slip) unit = "rad";
  return {TyreOutput{offset<TyreOutput::What>(quantity, Quantities::load), tyre}, unit};
}

Resolved spring_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity =
      quantity_of(reader, value, output, {Quantities::force, Quantities::length, Quantities::rate}, "spring");
  SpringOutput spring;
  spring.what = offset<SpringOutput::What>(quantity, Quantities::force);
  const std::string& name = *output.spring;
  const Visibility& visible = current_scope(reader).visible;
  const auto air_spring = find_visible(reader.names.air_springs, name, visible);
  const bool is_spring = find_visible(reader.names.springs, name, visible) != reader.names.springs.end();
  const bool is_air_spring = air_spring != reader.names.air_springs.end();
  if (is_spring && is_air_spring) {
    report(reader, *find(value, "spring"), in_quotes(name) + " is a spring and an air spring", "rename one of them");
  } else if (is_air_spring) {
    spring.air_spring = air_spring->second;
  } else {
    NameMap<int> known = reader.names.springs;
    if (!is_spring) known.insert(reader.names.air_springs.begin(), reader.names.air_springs.end());
    spring.point_spring = find_element(reader, value, "spring", known);
  }
  return {spring, quantity == Quantities::force ? "N" : quantity == Quantities::length ? "m" : "m/s"};
}

Resolved motion_output(Reader& reader, const Value& value) {
  const int motion = find_element(reader, value, "motion", reader.names.motions);
  const CoordinateReference joint =
      motion < 0 ? CoordinateReference{} : reader.model.motions[static_cast<std::size_t>(motion)].joint;
  return {DriveOutput{motion}, joint.joint >= 0 && is_rotation(reader.model, joint) ? "N m" : "N"};
}

/// A joint or a rod by its name; both -1 with a complaint.
struct Connection {
  int joint = -1, rod = -1;
};

Connection find_connection(Reader& reader, const Value& value, std::string_view key, const std::string& name) {
  if (find(value, key)->kind != Value::Kind::text) return {};
  const Visibility& visible = current_scope(reader).visible;
  const auto joint = find_visible(reader.names.joints, name, visible),
             rod = find_visible(reader.names.rods, name, visible);
  const bool is_joint = joint != reader.names.joints.end(), is_rod = rod != reader.names.rods.end();
  if (is_joint && is_rod) {
    report(reader, *find(value, key), in_quotes(name) + " is a joint and a rod", "rename one of them");
    return {};
  }
  if (is_joint) return {joint->second, -1};
  if (is_rod) return {-1, rod->second};
  NameMap<int> known = reader.names.joints;
  known.insert(reader.names.rods.begin(), reader.names.rods.end());
  report(reader, *find(value, key), "unknown joint or rod " + in_quotes(name), suggestion(reader, name, known));
  return {};
}

Resolved reaction_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, {Quantities::force, Quantities::moment}, "reaction");
  require_axis(reader, value, "reaction");
  const Connection connection = find_connection(reader, value, "reaction", *output.reaction);
  const bool is_force = quantity == Quantities::force;
  ReactionOutput reaction;
  reaction.what = is_force ? ReactionOutput::What::force : ReactionOutput::What::moment;
  reaction.joint = connection.joint;
  reaction.rod = connection.rod;
  reaction.axis = static_cast<int>(output.axis.value_or(Letter::x));
  reaction.in_body_axes = output.in_body_axes.value_or(false);
  reaction.end = output.end.value_or(ReactionOutput::End::to);
  return {reaction, is_force ? "N" : "N m"};
}

/// Index of the equation that is written as a number or a name; 0 with a complaint.
int equation_of(Reader& reader, const Value& value, const Value* written, std::span<const ClosureRow> rows,
                const std::string& of) {
  std::vector<std::string_view> names;
  for (const ClosureRow& row : rows) names.push_back(row.name);
  const std::string known = fmt::format("its equations are {}", fmt::join(names, ", "));
  if (!written) {
    if (rows.size() > 1) report(reader, value, "an output of multiplier needs \"equation\"", known);
    return 0;
  }
  if (written->kind == Value::Kind::number) {
    const double number = written->number;
    if (number >= 0 && number < static_cast<double>(rows.size()) && number == std::floor(number)) {
      return static_cast<int>(number);
    }
    report(reader, *written, fmt::format("{} has equations 0 to {}, got {}", of, rows.size() - 1, number), known);
    return 0;
  }
  if (written->kind == Value::Kind::text) {
    const auto found = std::find(names.begin(), names.end(), written->text);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    report(reader, *written, fmt::format("{} has no equation {}", of, in_quotes(written->text)), known);
    return 0;
  }
  report(reader, *written, "must be the name or number of an equation, got " + describe(*written));
  return 0;
}

Resolved multiplier_output(Reader& reader, const Value& value, const OutputFields& output) {
  const std::string& name = *output.multiplier;
  const Connection connection = find_connection(reader, value, "multiplier", name);
  MultiplierOutput multiplier{connection.joint, connection.rod, 0};
  const auto& unreadable = reader.names.unreadable_joints;
  const bool unknown = std::find(unreadable.begin(), unreadable.end(), name) != unreadable.end();
  if (unknown || (connection.joint < 0 && connection.rod < 0)) return {multiplier, ""};
  std::span<const ClosureRow> rows(&kRodRow, 1);
  if (connection.joint >= 0) rows = closure_rows(reader.model.joints[static_cast<std::size_t>(connection.joint)].type);
  if (rows.empty()) {
    report(reader, *find(value, "multiplier"), fmt::format("joint {} is free and closes nothing", in_quotes(name)));
    return {multiplier, ""};
  }
  const std::string of = (connection.rod >= 0 ? "rod " : "joint ") + in_quotes(name);
  multiplier.equation = equation_of(reader, value, output.equation, rows, of);
  return {multiplier, std::string(rows[static_cast<std::size_t>(multiplier.equation)].unit)};
}

Resolved resolve_output(Reader& reader, const Value& value, const OutputFields& output) {
  const int source = source_of(reader, value);
  if (source < 0) return {};
  const std::string_view name = kSources[static_cast<std::size_t>(source)];
  if (name == "expression" || name == "motion" || name == "multiplier") refuse(reader, value, "quantity", name);
  if (name != "point" && name != "reaction") {
    refuse(reader, value, "axis", name);
    refuse(reader, value, "frame", name);
  }
  if (name != "reaction") refuse(reader, value, "end", name);
  if (name != "multiplier") refuse(reader, value, "equation", name);
  if (name == "expression") return {ExpressionOutput{*output.expression}, ""};
  if (name == "point") return point_output(reader, value, output);
  if (name == "joint") return joint_output(reader, value, output);
  if (name == "tyre") return tyre_output(reader, value, output);
  if (name == "spring") return spring_output(reader, value, output);
  if (name == "reaction") return reaction_output(reader, value, output);
  if (name == "multiplier") return multiplier_output(reader, value, output);
  return motion_output(reader, value);
}

bool has_parts(const Value& value) {
  if (value.kind != Value::Kind::object) return false;
  const std::span<const Field<InitialValueFields>> table = fields<InitialValueFields>();
  return std::any_of(table.begin(), table.end(), [&](const auto& row) { return find(value, row.info.name); });
}

/// A number, or an object with that and how it gives way. Result: the number's text.
const Value& read_initial_value(Reader& reader, const Value& value, const FieldInfo& info, InitialValue& target) {
  if (!has_parts(value)) {
    read_value(reader, value, info, target.value);
    return value;
  }
  InitialValueFields parts = with_defaults<InitialValueFields>();
  read_fields(reader, value, parts);
  target.value = parts.value;
  target.weight = parts.weight;
  target.locked = parts.locked;
  return member_or_object(value, "value");
}

void read_initial_values(Reader& reader, const Value* values, std::string_view key, bool locks,
                         std::vector<InitialValue>& list) {
  if (!values) return;
  if (values->kind != Value::Kind::object) {
    report(reader, *values, "must be an object of coordinates, got " + describe(*values));
    return;
  }
  const FieldInfo info{.name = key, .shape = Shape::number, .depends = Depends::nothing, .angle = true};
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

/// Whether the model, not one of its instances, asks for it.
bool asks_for_equilibrium(const std::vector<Part>& parts) {
  bool asks = false;
  for (const auto& [value, scope] : parts) {
    const Value* written = scope == 0 ? find(*value, "equilibrium") : nullptr;
    if (written) asks = written->boolean;
  }
  return asks;
}

}  // namespace

void read_motions(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    std::vector<MotionFields> one;
    read_list(reader, {entry}, one, resolve_motion);
    reader.names.motions.emplace(entry.name, static_cast<int>(reader.model.motions.size()));
    reader.model.motions.push_back(one.front());
  }
}

void read_outputs(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    std::vector<OutputFields> one;
    Resolved resolved;
    read_list(reader, {entry}, one, [&](Reader& r, const Value& value, const OutputFields& output) {
      resolved = resolve_output(r, value, output);
    });
    OutputFields& output = one.front();
    reader.model.outputs.push_back(
        {output.name, output.where, output.unit.empty() ? resolved.unit : output.unit, resolved.source});
  }
}

void read_initial(Reader& reader, const std::vector<Part>& parts) {
  InitialFields fields = with_defaults<InitialFields>();
  Initial& initial = reader.model.initial;
  const bool balances = asks_for_equilibrium(parts);
  reader.folds_tunable = !reader.varied.empty();  // who varies parameters finds the initial state of each value
  for (const auto& [value, scope] : parts) {
    const InScope in_scope(reader, scope);
    fields.positions = fields.velocities = nullptr;
    read_fields(reader, *value, fields);
    read_initial_values(reader, fields.positions, "positions", !balances, initial.positions);
    read_initial_values(reader, fields.velocities, "velocities", true, initial.velocities);
    if (scope != 0) fields.equilibrium = false;  // a question of the whole model
  }
  reader.folds_tunable = false;
  initial.equilibrium = fields.equilibrium;
}

void read_solver(Reader& reader, const std::vector<Part>& parts) {
  reader.model.solver = with_defaults<SolverSettings>();
  for (const Part& part : parts) read_fields(reader, *part.value, reader.model.solver);
}

}  // namespace mbgen::reading
