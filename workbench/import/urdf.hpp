#pragma once
// URDF: links and joints of a robot (http://wiki.ros.org/urdf/XML). Loops: by a second parent, by extensions or by a
// sidecar.

#include <limits>
#include <map>

#include "workbench/import/closing.hpp"

namespace mbgen::importing {

struct UrdfLink {
  const Element* element = nullptr;
  std::string name = {};
  int body = -1;                   ///< index into Assembly::bodies
  std::vector<int> parents = {};   ///< joints with this link as child, in file order
  std::vector<int> children = {};  ///< joints whose parent it is
  int placed_by = -1;              ///< its joint in the spanning tree; -1 for the root
  bool is_placed = false;
};

struct UrdfJoint {
  const Element* element = nullptr;
  std::string name = {};
  JointType type = JointType::fixed;
  int parent = -1, child = -1;                 ///< indices into UrdfRobot::links
  Isometry3d origin = Isometry3d::Identity();  ///< joint frame relative to the parent at zero
  Vector3d axis{1, 0, 0};                      ///< unit, joint frame
  double reference = 0;                        ///< rad or m: its position at the reference configuration
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;  ///< rad or m, by <limit>
  int leader = -1;                                                          ///< leader of <mimic>
  double multiplier = 1, offset = 0;  ///< position = multiplier * leader's + offset
  std::string coordinate = {};        ///< in the assembly, "" of a joint that has not one or closes a loop
};

struct UrdfRobot {
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::map<std::string, int, std::less<>> link_of, joint_of;
  bool is_closed_by_moving = false;                                ///< the loop's points absorb the remaining gap
  std::map<std::string, std::string, std::less<>> left_open = {};  ///< by joint or loop: remaining gap
};

/// A frame from the attributes xyz and rpy of an element, identity without them.
Isometry3d read_origin(Reading& reading, const Element& element);
/// The frame of its child <origin>.
Isometry3d read_inner_origin(Reading& reading, const Element& element);
/// A unit vector from the attribute xyz of an element, x without it.
Vector3d read_unit(Reading& reading, const Element& axis);
/// The same of the child <axis>.
Vector3d read_axis(Reading& reading, const Element& element);
/// Whether the joint has an axis of rotation or translation, or a normal.
bool has_axis(JointType type);

/// Links and joints, by name; references are resolved. Problems are added.
UrdfRobot read_robot(Reading& reading, const Element& root);

/// Fault of an open loop, or "".
std::string gap_of(const LoopEnds& ends);
/// Hint for the user.
extern const char* const kGapHint;

/// A loop given by an extension or by the sidecar instead of a second parent.
struct UrdfLoop {
  std::string name;
  Spot spot = {};             ///< of an extension's element
  std::string pointer = {};   ///< JSON pointer of a loop in the sidecar; its position in the text is unknown
  LoopEnds ends = {};         ///< frames in the links
  int from = -1, to = -1;     ///< links
  bool has_far_frame = true;  ///< else the far end coincides with the near one
};

/// Loops by <loop_joint>, <loop> and <constraint> elements.
std::vector<UrdfLoop> read_extension_loops(Reading& reading, const Element& root, const UrdfRobot& robot);
/// Loops of the sidecar; sets the positions given there in the robot.
std::vector<UrdfLoop> read_sidecar(Reading& reading, UrdfRobot& robot);
/// Reason for the remaining gap, as the end of a sentence.
std::string remains_open(const UrdfRobot& robot, const std::string& name);
/// Whether a gap at the reference is to be reported.
bool is_told(const UrdfRobot& robot, const std::string& name);
/// Couplings of followers to their leaders. Requires: the robot is assembled.
void add_mimics(Reading& reading, const UrdfRobot& robot, const std::map<int, std::string>& coordinate_of,
                Assembly& assembly);
/// Adds the joints that close loops. Requires: the robot is assembled.
void add_loops(Reading& reading, const std::vector<UrdfLoop>& loops, const UrdfRobot& robot, Assembly& assembly);

/// Frame of a joint's child in its parent's, at its reference position.
Isometry3d moved(const UrdfJoint& joint);

/// Sets the poses of all links from the root outwards. A link is placed by the first of its joints in the file; by
/// another one if the first comes from a link below it.
void place_links(UrdfRobot& robot, int root, std::vector<BodyDraft>& bodies);

/// Sets followers to the positions given by their leaders.
void follow_leaders(UrdfRobot& robot);

/// Closes loops that are open as written by moving the joints of the tree, within their limits and as little as will
/// do, and places the links anew. Where that fails all stays as it was, and left_open names what stays open. Cost: some
/// hundred factorisations of loops by joints.
void close_loops(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, int root,
                 std::vector<BodyDraft>& bodies);

/// Places every link from the root outwards and creates bodies and joints; a joint to a link that is already placed
/// closes a loop. Requires: no problems so far.
void assemble_robot(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, Assembly& assembly);

/// Adds visuals of links as shapes. Requires: the robot is assembled.
void add_visuals(Reading& reading, const Element& root, const UrdfRobot& robot, Assembly& assembly);

/// Motors of <transmission> elements with one joint and one actuator, and of joints with a command in <ros2_control>.
/// Requires: the robot is assembled.
void add_transmissions(Reading& reading, const Element& root, const UrdfRobot& robot, Assembly& assembly);

/// The whole translation. Problems and notes are added.
void import_urdf(Reading& reading, const Element& root, Assembly& assembly);

}  // namespace mbgen::importing
