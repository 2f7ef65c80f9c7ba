// Motions, outputs, initial state, solver settings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/presentation.hpp"
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

/// Kind of source of an output; index into kSources, or -1 with a complaint.
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

/// The quantity, when the source has it, else the first quantity of the source, with a complaint.
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

}  // namespace

void read_motions(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    std::vector<MotionFields> one;
    read_list(reader, {entry}, one, resolve_motion);
    const int index = static_cast<int>(reader.model.motions.size());
    if (!reader.names.motions.emplace(entry.name, index).second)
      report(reader, entry.place, fmt::format("name {} is that of the motion of a rod's length", in_quotes(entry.name)),
             "rename the motion");
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
    const InScope in_scope(reader, entry.scope);
    check_unit_of(reader, *entry.value, output.unit, resolved.unit);
    if (output.unit.empty()) output.unit = resolved.unit;
    check_presentation(reader, *entry.value, output.unit, output, {});
    reader.model.outputs.push_back({output.name, output.where, output.unit, resolved.source, std::move(output)});
  }
}

void read_solver(Reader& reader, const std::vector<Part>& parts) {
  reader.model.solver = with_defaults<SolverSettings>();
  for (const Part& part : parts) read_fields(reader, *part.value, reader.model.solver);
}

}  // namespace mbgen::reading
