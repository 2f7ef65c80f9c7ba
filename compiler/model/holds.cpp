#include "compiler/model/rope_places.hpp"

namespace mbgen {
namespace {

/// Appends the names of the places of a rope by its first span, none for a further one.
void add_names(const Model& model, std::size_t first, std::vector<std::string>& names) {
  const auto& rope = model.ropes[first];
  if (rope.path.empty()) return;
  const std::string own = rope.spans > 1 ? rope.name.substr(0, rope.name.size() - 2) : rope.name;  // without _1
  const auto at = [&](std::size_t station) {
    const Attachment& place = rope.path[station].at;
    const Body& body = model.bodies[static_cast<std::size_t>(place.body)];
    return body.name + "." + body.points[static_cast<std::size_t>(place.point)].name;
  };
  const std::vector<RopeLeg> legs = legs_of(rope);
  for (const RopeLeg& leg : legs) names.push_back(own + " from " + at(leg.from) + " to " + at(leg.to));
  for (const RopeLeg& leg : legs)
    if (rope.path[leg.to].kind == RopeStation::Kind::pulley) names.push_back(own + " at " + at(leg.to));
  for (int g = 0; g < rope.spans; ++g) names.push_back(model.ropes[first + static_cast<std::size_t>(g)].name);
}

}  // namespace

std::vector<std::string> rope_place_names(const Model& model) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.ropes.size(); ++i) add_names(model, i, names);
  return names;
}

}  // namespace mbgen
