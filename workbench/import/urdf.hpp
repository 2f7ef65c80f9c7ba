#pragma once
// URDF: links and joints of a robot (http://wiki.ros.org/urdf/XML), loops by two parents, by extensions or by a
// sidecar.

#include <limits>
#include <map>

#include "workbench/import/closing.hpp"

namespace mbgen::importing {

struct UrdfLink {
  const Element* element = nullptr;
  std::string name = {};
  int body = -1;                   ///< index into Assembly::bodies
  std::vector<int> parents = {};   ///< joints whose child it is, in the order of the file
  std::vector<int> children = {};  ///< joints whose parent it is
  int placed_by = -1;              ///< joint of the spanning tree that places it; -1 for the root
  bool is_placed = false;
};

struct UrdfJoint {
  const Element* element = nullptr;
  std::string name = {};
  JointType type = JointType::fixed;
  int parent = -1, child = -1;                 ///< indices into UrdfRobot::links
  Isometry3d origin = Isometry3d::Identity();  ///< joint frame in the parent's at zero
  Vector3d axis{1, 0, 0};                      ///< unit, joint frame
  double reference = 0;                        ///< rad or m: its position at the reference configuration
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;  ///< rad or m, by <limit>
  int leader = -1;                                                          ///< joint that it follows, of <mimic>
  double multiplier = 1, offset = 0;  ///< position = multiplier * leader's + offset
};

struct UrdfRobot {
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::map<std::string, int, std::less<>> link_of, joint_of;
  bool is_closed_by_moving = false;                                ///< the loop's points take up the rest of its gap
  std::map<std::string, std::string, std::less<>> left_open = {};  ///< by joint or loop: how far no position closes it
};

/// A frame by the attributes xyz and rpy of an element, identity where they are absent.
Isometry3d read_origin(Reading& reading, const Element& element);
/// The same of its child <origin>.
Isometry3d read_inner_origin(Reading& reading, const Element& element);
/// A unit direction by the attribute xyz of the child <axis>, x where it is absent.
Vector3d read_axis(Reading& reading, const Element& element);
/// Whether the joint turns about or slides along an axis, or has a normal.
bool has_axis(JointType type);

/// Links and joints, by name; references are resolved. Problems are added.
UrdfRobot read_robot(Reading& reading, const Element& root);

/// Why the loop does not close as it stands, or "".
std::string gap_of(const LoopEnds& ends);
/// The next step for the user.
extern const char* const kGapHint;

/// A loop that is no second parent: of an extension or of the sidecar.
struct UrdfLoop {
  std::string name;
  Spot spot = {};             ///< of an extension's element
  std::string pointer = {};   ///< of a loop of the sidecar, where it stands in the text is not known
  LoopEnds ends = {};         ///< frames in the links
  int from = -1, to = -1;     ///< links
  bool has_far_frame = true;  ///< else the far end is where the near one is
};

/// Loops by <loop_joint> and <loop> elements.
std::vector<UrdfLoop> read_extension_loops(Reading& reading, const Element& root, const UrdfRobot& robot);
/// Loops of the sidecar; positions that it names are set in the robot.
std::vector<UrdfLoop> read_sidecar(Reading& reading, UrdfRobot& robot);
/// Why it stays open, as an end of the sentence about its gap.
std::string remains_open(const UrdfRobot& robot, const std::string& name);
/// Whether a loop with a gap at the reference is to be told.
bool is_told(const UrdfRobot& robot, const std::string& name);
/// Couplings of joints that follow others. Requires: the robot is assembled.
void add_mimics(Reading& reading, const UrdfRobot& robot, const std::map<int, std::string>& coordinate_of,
                Assembly& assembly);
/// Adds joints that close them. Requires: the robot is assembled.
void add_loops(Reading& reading, const std::vector<UrdfLoop>& loops, const UrdfRobot& robot, Assembly& assembly);

/// The frame of a joint's child in its parent's, at its position at the reference.
Isometry3d moved(const UrdfJoint& joint);

/// Walks from the root and sets the poses of all links. A link is placed by the first of its joints in the file, by
/// another only where that one comes from a link below it.
void place_links(UrdfRobot& robot, int root, std::vector<BodyDraft>& bodies);

/// Puts joints that follow others where their leaders want them.
void follow_leaders(UrdfRobot& robot);

/// Closes loops that are open as written by moving the joints of the tree, within their limits and as little as will
/// do, and places the links anew. Where that fails all stays as it was, and left_open names what stays open. Cost: some
/// hundred factorisations of loops by joints.
void close_loops(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, int root,
                 std::vector<BodyDraft>& bodies);

/// Places every link from the root outwards and makes bodies and joints of them; a joint to a link that is placed
/// already closes a loop. Requires: no problems so far.
void assemble_robot(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, Assembly& assembly);

/// Looks of links as shapes. Requires: the robot is assembled.
void add_visuals(Reading& reading, const Element& root, const UrdfRobot& robot, Assembly& assembly);

/// The whole translation. Problems and notes are added.
void import_urdf(Reading& reading, const Element& root, Assembly& assembly);

}  // namespace mbgen::importing
