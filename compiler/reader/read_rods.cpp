// Rods, and coordinates of rods with a length that depends on time or inputs, or that an actuator moves.
#include <fmt/format.h>

#include <cmath>

#include "compiler/model/element_access.hpp"
#include "compiler/reader/carried_body.hpp"
#include "compiler/reader/elements/actuator.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kSmallestLength = 1e-6;  // m
constexpr std::string_view kDriveSuffix = "_length";

/// Whether a value changes during a run, apart from tunable parameters.
bool moves(const Model& model, const Quantity& quantity) {
  return mentions(model, quantity.expression, {ExpressionNode::Kind::time, ExpressionNode::Kind::input});
}

/// Whether the names of the drive's body, joint and motion are unused.
bool has_free_names(Reader& reader, const Entry& entry, const std::string& name) {
  const Names& names = reader.names;
  const bool is_taken = names.bodies.contains(name) || names.joints.contains(name) || names.rods.contains(name);
  if (is_taken)
    report(reader, entry.place,
           fmt::format("the length of rod {} is the coordinate {}, and another element has this name",
                       in_quotes(entry.name), in_quotes(name)),
           "rename one of them");
  if (!is_taken && !is_valid_name(name))
    report(reader, entry.place, "invalid name " + in_quotes(name) + " of the coordinate of the rod's length",
           kNameRule);
  return !is_taken && is_valid_name(name);
}

/// Adds a massless slide at the rod's first end, along the rod at the reference; its coordinate is the difference to
/// the reference length. Result: the slide's name, "" where it is taken.
std::string add_slide(Reader& reader, const Entry& entry, double distance, Rod& rod) {
  Model& model = reader.model;
  Entry named = entry;
  named.written += kDriveSuffix;
  named.name = full_name(current_scope(reader).visible.front(), named.written);
  if (!has_free_names(reader, entry, named.name)) return "";
  const Vector3 a = reference_position(model, rod.from), b = reference_position(model, rod.to);
  Joint joint;
  joint.name = named.name;
  joint.where = rod.where;
  joint.type = JointType::prismatic;
  joint.from = rod.from;
  joint.to = add_carried_body(reader, named.name, rod.where, rod.from, entry.scope);
  for (std::size_t i = 0; i < 3; ++i) joint.axis[i] = (b[i] - a[i]) / distance;
  joint.freedoms = {{named.name, FreedomKind::prismatic, joint.axis}};
  rod.drive = static_cast<int>(model.joints.size());
  rod.length = distance;
  add_coordinates(reader, named, joint, rod.drive);
  reader.names.joints.emplace(named.name, rod.drive);
  model.joints.push_back(std::move(joint));
  return named.name;
}

/// Drives the slide of a rod by a motion.
void add_drive(Reader& reader, const Quantity& length, double distance, const std::string& slide, const Rod& rod) {
  Model& model = reader.model;
  Motion motion;
  motion.name = slide;
  motion.where = rod.where;
  motion.joint = {rod.drive, 0};
  motion.position = combination(reader, {1, 0, 0}, {length, 0.0, 0.0}, -distance);
  reader.names.motions.emplace(slide, static_cast<int>(model.motions.size()));
  model.motions.push_back(std::move(motion));
}

bool is_massless(const Rod& rod) { return rod.mass.expression < 0 && rod.mass.value == 0; }

}  // namespace

void read_rods(Reader& reader, const Entries& entries, const Entries& actuators) {
  for (const Entry& entry : entries) {
    reader.names.rods.emplace(entry.name, static_cast<int>(reader.names.rods.size()));
  }
  const std::set<int> actuated = actuated_rods(reader, actuators);
  for (const Entry& entry : entries) {
    double distance = kUnreadable;
    std::vector<RodFields> one;
    read_list(reader, {entry}, one, [&](Reader& r, const Value& value, const RodFields& rod) {
      distance = check_ends(r, value, rod.from, rod.to);
      if (distance < kSmallestLength)
        report(r, *find(value, "to"), fmt::format("ends of a rod must be apart, the distance is {:.6g} m", distance));
      const bool is_actuated = actuated.contains(static_cast<int>(r.model.rods.size()));
      if (is_actuated && rod.written_length)
        report(r, *find(value, "length"), "an actuator moves this rod, and its length is given",
               fmt::format(
                   "leave out one of them; where it starts is \"initial\": {{ \"positions\": {{ \"{}{}\": ... }} }}",
                   entry.written, kDriveSuffix));
      const bool changes = is_actuated || (rod.written_length && moves(r.model, *rod.written_length));
      if (changes && !is_massless(rod))
        report(r, *find(value, "mass"), "a rod whose length changes has no mass",
               "leave out \"mass\", or give it to the bodies at its ends");
    });
    Rod& rod = one.front();
    const std::optional<Quantity>& length = one.front().written_length;
    const bool is_actuated = actuated.contains(static_cast<int>(reader.model.rods.size()));
    if (!is_actuated && (!length || !moves(reader.model, *length))) {
      rod.length = length;
    } else if (distance >= kSmallestLength) {
      const InScope in_scope(reader, entry.scope);
      const std::string slide = add_slide(reader, entry, distance, rod);
      if (!is_actuated && !slide.empty()) add_drive(reader, *length, distance, slide, rod);
    }
    reader.model.rods.push_back(rod);
  }
}

}  // namespace mbgen::reading
