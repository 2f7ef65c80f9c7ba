// Motions, outputs, initial state, solver settings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/output_sources.hpp"
#include "compiler/reader/presentation.hpp"

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

/// Kind of source of an output; index into kOutputSources, or -1 with a problem.
int source_of(Reader& reader, const Value& value) {
  int source = -1;
  for (std::size_t i = 0; i < kOutputSources.size(); ++i) {
    const Member* member = find_member(value, kOutputSources[i]);
    if (!member) continue;
    if (source >= 0) {
      report(reader, member->place,
             fmt::format("output has both {} and {}", in_quotes(kOutputSources[static_cast<std::size_t>(source)]),
                         in_quotes(kOutputSources[i])));
      return -1;
    }
    source = static_cast<int>(i);
  }
  if (source < 0) {
    report(reader, value, fmt::format("output needs one of {}", fmt::join(kOutputSources, ", ")));
  }
  return source;
}

constexpr std::array kReactionQuantities = {Quantities::force, Quantities::moment};

Resolved joint_output(Reader& reader, const Value& value, const OutputFields& output) {
  if (is_of_wheel(output.quantity)) return wheel_output(reader, value, output, *output.quantity);
  for (const std::string_view key : {"relative_to", "steering_axis"}) refuse(reader, value, key, "joint");
  const Quantities quantity = quantity_of(reader, value, output, kMotionQuantities, "coordinate");
  const bool rotation = output.joint->joint >= 0 && is_rotation(reader.model, *output.joint);
  return {CoordinateOutput{offset<CoordinateOutput::What>(quantity, Quantities::position), *output.joint},
          motion_unit(rotation, quantity)};
}

Resolved tyre_output(Reader& reader, const Value& value, const OutputFields& output) {
  if (is_of_wheel(output.quantity)) return wheel_output(reader, value, output, *output.quantity);
  for (const std::string_view key : {"relative_to", "steering_axis"})
    refuse(reader, value, key, output.quantity ? find(value, "quantity")->text : "load");
  return element_output(reader, value, output, "tyre");
}

Resolved motion_output(Reader& reader, const Value& value) {
  const int motion = find_element(reader, value, "motion", reader.names.motions);
  const CoordinateReference joint =
      motion < 0 ? CoordinateReference{} : reader.model.motions[static_cast<std::size_t>(motion)].joint;
  return {DriveOutput{motion}, joint.joint >= 0 && is_rotation(reader.model, joint) ? "N m" : "N"};
}

}  // namespace

Connection find_connection(Reader& reader, const Value& value, std::string_view key, const std::string& name,
                           bool couplings) {
  struct Kind {
    std::string_view what;
    const NameMap<int>& names;
    int Connection::*index;
  };
  const Kind kinds[] = {{"coupling", reader.names.couplings, &Connection::coupling},
                        {"joint", reader.names.joints, &Connection::joint},
                        {"rod", reader.names.rods, &Connection::rod}};
  const Value& written = *find(value, key);
  if (written.kind != Value::Kind::text) return {};
  Connection connection;
  std::vector<std::string> found;
  NameMap<int> known;
  for (const Kind& kind : std::span(kinds).subspan(couplings ? 0 : 1)) {
    known.insert(kind.names.begin(), kind.names.end());
    const auto element = find_visible(kind.names, name, current_scope(reader).visible);
    if (element == kind.names.end()) continue;
    connection.*kind.index = element->second;
    found.push_back(fmt::format("a {}", kind.what));
  }
  if (found.size() == 1) return connection;
  if (found.empty())
    report(reader, written, "unknown joint or rod " + in_quotes(name), suggestion(reader, name, known));
  else
    report(reader, written, fmt::format("{} is {}", in_quotes(name), fmt::join(found, " and ")), "rename one of them");
  return {};
}

namespace {

Resolved reaction_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, kReactionQuantities, "reaction");
  require(reader, value, "axis", "reaction");
  const Connection connection = find_connection(reader, value, "reaction", *output.reaction, false);
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

/// Index of the equation given by number or name; 0 with a problem.
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
  const Connection connection = find_connection(reader, value, "multiplier", name, true);
  MultiplierOutput multiplier{connection.joint, connection.rod, 0, connection.coupling};
  const auto& unreadable = reader.names.unreadable_joints;
  if (std::find(unreadable.begin(), unreadable.end(), name) != unreadable.end()) return {multiplier, ""};
  std::span<const ClosureRow> rows;
  std::string of;
  if (connection.coupling >= 0) {
    rows = {&kCouplingRow, 1};
    of = "coupling " + in_quotes(name);
  } else if (connection.rod >= 0) {
    rows = {&kRodRow, 1};
    of = "rod " + in_quotes(name);
  } else if (connection.joint >= 0) {
    rows = closure_rows(reader.model.joints[static_cast<std::size_t>(connection.joint)].type);
    of = "joint " + in_quotes(name);
    if (rows.empty()) report(reader, *find(value, "multiplier"), of + " is free and closes nothing");
  }
  if (rows.empty()) return {multiplier, ""};
  multiplier.equation = equation_of(reader, value, output.equation, rows, of);
  if (connection.coupling >= 0) {  // a curve has the unit of its coordinate
    const Coupling& coupling = reader.model.couplings[static_cast<std::size_t>(connection.coupling)];
    if (coupling.curve && coupling.joint && coupling.joint->joint >= 0)
      return {multiplier, is_rotation(reader.model, *coupling.joint) ? "N m" : "N"};
  }
  return {multiplier, std::string(rows[static_cast<std::size_t>(multiplier.equation)].unit)};
}

/// Fields of an output beside its source, and those of sources; elements: see taken_by_source.
constexpr std::string_view kDetails[] = {"quantity", "axis", "frame", "axes_of",       "relative_to", "observer",
                                         "sequence", "turn", "about", "steering_axis", "end",         "equation"};
constexpr std::pair<std::string_view, std::string_view> kTaken[] = {
    {"expression", ""},
    {"point", "quantity axis frame axes_of relative_to observer"},
    {"points", "quantity"},
    {"body", "quantity axis frame axes_of relative_to observer sequence turn about"},
    {"bodies", "quantity axis axes_of about"},
    {"joint", "quantity relative_to steering_axis"},
    {"tyre", "quantity relative_to steering_axis"},
    {"elements", "quantity"},
    {"motion", ""},
    {"reaction", "quantity axis frame end"},
    {"multiplier", "equation"},
};

std::string_view taken_by_source(std::string_view source) {
  for (const auto& [name, taken] : kTaken)
    if (name == source) return taken;
  bool has_axis = false;
  each_kind([&](auto kind) {
    for (const ElementQuantity& quantity : kind.quantities)
      has_axis = has_axis || (source_key(kind) == source && quantity.components > 1);
  });
  return has_axis ? "quantity axis" : "quantity";
}

Resolved resolve_output(Reader& reader, const Value& value, const OutputFields& output) {
  const int source = source_of(reader, value);
  if (source < 0) return {};
  const std::string_view name = kOutputSources[static_cast<std::size_t>(source)];
  const std::string taken = fmt::format(" {} ", taken_by_source(name));
  for (const std::string_view key : kDetails)
    if (taken.find(fmt::format(" {} ", key)) == std::string::npos) refuse(reader, value, key, name);
  if (output.axis == Letter::w && output.quantity != Quantities::quaternion)
    report(reader, *find(value, "axis"), "only a quaternion has a component w");
  if (name == "expression") return {ExpressionOutput{*output.expression}, ""};
  if (name == "point") return point_output(reader, value, output);
  if (name == "points") return points_output(reader, value, output);
  if (name == "body") return body_output(reader, value, output);
  if (name == "bodies") return bodies_output(reader, value, output);
  if (name == "joint") return joint_output(reader, value, output);
  if (name == "tyre") return tyre_output(reader, value, output);
  if (name == "elements") return elements_output(reader, value, output);
  if (name == "reaction") return reaction_output(reader, value, output);
  if (name == "multiplier") return multiplier_output(reader, value, output);
  if (name == "motion") return motion_output(reader, value);
  return element_output(reader, value, output, name);
}

}  // namespace

void read_motions(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    std::vector<MotionFields> one;
    read_list(reader, {entry}, one, resolve_motion);
    const int index = static_cast<int>(reader.model.motions.size());
    if (!reader.names.motions.emplace(entry.name, index).second)
      report(reader, entry.place, fmt::format("name {} belongs to the motion of a rod's length", in_quotes(entry.name)),
             "rename the motion");
    const int joint = one.front().joint.joint;
    reader.model.motions.push_back(one.front());
    if (joint >= 0 && reader.model.joints[static_cast<std::size_t>(joint)].cut == CutMark::cut)
      drive_at_cut(reader, entry, joint);
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
