#pragma once
// URDF: links and joints of a robot (http://wiki.ros.org/urdf/XML), loops by two parents, by extensions or by a
// sidecar.

#include <map>

#include "compiler/import/assembly.hpp"

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
  double reference = 0;  ///< rad or m: its position at the reference configuration, of the sidecar
};

struct UrdfRobot {
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::map<std::string, int, std::less<>> link_of, joint_of;
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

/// Places every link from the root outwards and makes bodies and joints of them; a joint to a link that is placed
/// already closes a loop. Requires: no problems so far.
void assemble_robot(Reading& reading, UrdfRobot& robot, Assembly& assembly);

/// Two frames that a loop brings together, at the reference.
struct LoopEnds {
  JointType type = JointType::fixed;
  Isometry3d from = Isometry3d::Identity(), to = Isometry3d::Identity();  ///< global
  Vector3d axis{1, 0, 0};                                                 ///< unit, in both frames
};

/// Why the loop does not close as it stands, or "".
std::string gap_of(const LoopEnds& ends);
/// What to do about it.
extern const char* const kGapHint;

/// Loops by <loop_joint> and <loop> elements.
void add_extension_loops(Reading& reading, const Element& root, const UrdfRobot& robot, Assembly& assembly);

/// The sidecar: read before links are placed, its loops are added afterwards.
struct Sidecar {
  struct Loop {
    std::string name, pointer;
    LoopEnds ends = {};  ///< frames in the links
    int from = -1, to = -1;
    bool has_far_frame = false;
  };
  std::vector<Loop> loops;
};
Sidecar read_sidecar(Reading& reading, UrdfRobot& robot);
void add_sidecar_loops(Reading& reading, const Sidecar& sidecar, const UrdfRobot& robot, Assembly& assembly);

/// The whole translation. Problems and notes are added.
void import_urdf(Reading& reading, const Element& root, Assembly& assembly);

}  // namespace mbgen::importing
