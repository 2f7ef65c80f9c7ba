// URDF: tree of joints and loops in the form of the search that closes them.
#include <algorithm>

#include "workbench/import/urdf.hpp"

namespace mbgen::importing {
namespace {

Chain chain_of(const UrdfRobot& robot, const std::vector<UrdfLoop>& loops, const std::vector<BodyDraft>& bodies,
               std::vector<std::size_t>& written_as) {
  Chain chain;
  const auto body = [&](int link) { return robot.links[static_cast<std::size_t>(link)].body; };
  for (const BodyDraft& draft : bodies) chain.poses.push_back(draft.pose);
  std::vector<int> index_of(robot.joints.size(), -1);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    if (robot.links[static_cast<std::size_t>(joint.child)].placed_by != static_cast<int>(i)) {
      if (joint.type != JointType::free)
        chain.loops.push_back({joint.name,
                               body(joint.parent),
                               body(joint.child),
                               {joint.type, moved(joint), Isometry3d::Identity(), joint.axis}});
      continue;
    }
    index_of[i] = static_cast<int>(chain.joints.size());
    written_as.push_back(i);
    chain.joints.push_back({.name = joint.name,
                            .type = joint.type,
                            .from = body(joint.parent),
                            .to = body(joint.child),
                            .start = joint.origin,
                            .axis = joint.axis,
                            .position = joint.reference,
                            .lower = joint.lower,
                            .upper = joint.upper});
  }
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    const UrdfJoint& joint = robot.joints[written_as[k]];
    // A loop-closing joint has no coordinate, thus no followers.
    if (joint.leader < 0 || index_of[static_cast<std::size_t>(joint.leader)] < 0) continue;
    chain.joints[k].leader = index_of[static_cast<std::size_t>(joint.leader)];
    chain.joints[k].relation = {joint.offset, joint.multiplier};
  }
  for (const UrdfLoop& loop : loops) {
    if (loop.has_far_frame && loop.ends.type != JointType::free)
      chain.loops.push_back({loop.name, body(loop.from), body(loop.to), loop.ends});
  }
  return chain;
}

}  // namespace

void close_loops(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, int root,
                 std::vector<BodyDraft>& bodies) {
  std::vector<std::size_t> written_as;
  Chain chain = chain_of(robot, loops, bodies, written_as);
  Closed closed = close_chain(chain);
  robot.left_open = std::move(closed.left_open);
  robot.is_closed_by_moving = closed.has_moved;
  if (!closed.has_moved) return;
  for (std::size_t k = 0; k < written_as.size(); ++k) robot.joints[written_as[k]].reference = chain.joints[k].position;
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].pose = chain.poses[i];
  note_moves(reading, robot.links[static_cast<std::size_t>(root)].element->spot, closed,
             "the coordinates of the model are zero there; --loops FILE with \"positions\" chooses another place");
}

}  // namespace mbgen::importing
