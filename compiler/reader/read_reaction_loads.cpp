// Reactions of joints and rods as normal forces.

#include "compiler/reader/output_sources.hpp"
#include "compiler/reader/reaction_loads.hpp"

namespace mbgen::reading {
namespace {

/// Direction of the normal force in a joint's reaction.
ReactionLoad::Direction pressing_direction(JointType type) {
  switch (type) {
    case JointType::revolute:
    case JointType::prismatic:
    case JointType::cylindrical:
    case JointType::point_on_line:
      return ReactionLoad::Direction::across;
    case JointType::planar:
    case JointType::point_on_plane:
    case JointType::rolling_disc:
    case JointType::rolling_ball:
    case JointType::knife_edge:
      return ReactionLoad::Direction::along;
    default:
      return ReactionLoad::Direction::whole;
  }
}

/// Whether a normal force along or across the axis of a joint is possible.
bool has_direction(const Model& model, const ReactionLoad& load) {
  return load.joint >= 0 &&
         pressing_direction(model.joints[static_cast<std::size_t>(load.joint)].type) != ReactionLoad::Direction::whole;
}

}  // namespace

ReactionLoad read_reaction(Reader& reader, const Value& value, const ReactionFields& fields) {
  const Connection connection = find_connection(reader, value, "reaction", *fields.reaction, false);
  ReactionLoad load{fields.quantity.value_or(ReactionOutput::What::force), connection.joint, connection.rod};
  if (load.rod >= 0 && load.what == ReactionOutput::What::moment)
    report(reader, *find(value, "quantity"), "a rod transmits no moment");
  const bool is_found = load.joint >= 0 || load.rod >= 0, has_one = is_found && has_direction(reader.model, load);
  if (has_one) load.direction = pressing_direction(reader.model.joints[static_cast<std::size_t>(load.joint)].type);
  if (is_found && !has_one && fields.direction.value_or(load.direction) != ReactionLoad::Direction::whole)
    report(reader, *find(value, "direction"), in_quotes(*fields.reaction) + " has no axis to act across or along",
           "leave \"direction\" out: its whole reaction counts");
  load.direction = fields.direction.value_or(load.direction);
  return load;
}

const char* unit_of(const ReactionLoad& load) { return load.what == ReactionOutput::What::force ? "N" : "N m"; }

}  // namespace mbgen::reading
