#pragma once
// A mechanism as foreign solvers want it: plain numbers, everything in global axes at the reference configuration,
// where all coordinates are zero and all body frames are taken as parallel to the global one.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace mbgen {
struct Model;
struct Topology;
}  // namespace mbgen

namespace mbgen::foreign {

// As in topology.hpp. This header is C++17 and knows nothing of mbgen's, because foreign libraries are no C++20.
constexpr int kGround = -1;
enum class FreedomKind { revolute, prismatic };
enum class ClosureKind {
  spherical,
  revolute,
  prismatic,
  universal,
  cylindrical,
  planar,
  fixed,
  rod,
  point_on_line,
  point_on_plane,
  parallel_axes,
  orientation,
  homokinetic,
  coupling,
  rolling_disc,
  rolling_ball,
  knife_edge
};

/// Mass of all that moves with a tree body. No mass: com is the pin.
struct RigidMass {
  double mass = 0;                                    ///< kg
  Eigen::Vector3d com = Eigen::Vector3d::Zero();      ///< m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about com, kg m^2
};

/// A body of the spanning tree with its input joint of one freedom, indices as in Topology::bodies.
struct ReferenceBody {
  std::string name;
  int parent = kGround;
  int joint = -1;       ///< index into Model::joints
  int model_body = -1;  ///< -1 for a body inside a joint
  FreedomKind kind = FreedomKind::revolute;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d pin = Eigen::Vector3d::Zero();
  RigidMass mass;
  bool reversed = false;                            ///< the joint's `to` body is the parent
  Eigen::Vector3d at_to = Eigen::Vector3d::Zero();  ///< the joint's point on its `to` body
};

/// Relation that a coupling keeps at zero.
struct ReferenceRelation {
  std::vector<int> coordinates;  ///< tree bodies
  /// Its derivative by some of the coordinates (places in that list, at most two) at their positions.
  std::function<double(const std::vector<double>& positions, const std::vector<int>& by)> derivative;
};

/// A cut joint, a rod or a coupling, indices as in Topology::loops.
struct ReferenceClosure {
  std::string name;
  ClosureKind kind = ClosureKind::spherical;
  int from = kGround, to = kGround;  ///< tree bodies
  int ancestor = kGround;            ///< their lowest common ancestor
  Eigen::Vector3d at_from = Eigen::Vector3d::Zero(), at_to = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();         ///< on `from`; of a universal joint the first
  Eigen::Vector3d second_axis = Eigen::Vector3d::UnitZ();  ///< on `to`; of other joints `axis`
  double length = 0, mass = 0;                             ///< of a rod, m and kg
  double radius = 0;                                       ///< of a rolling disc or ball, m
  int carriage = kGround;  ///< of a rolling disc in planar motion: tree body on which its contact does not move
  ReferenceRelation relation = {};  ///< of a coupling
};

struct ReferenceMechanism {
  std::string name;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  std::vector<ReferenceBody> bodies;
  std::vector<ReferenceClosure> closures;
};

/// Bodies, joints, closures, rods and gravity of a model at its default parameters and inputs. Force elements, tyres
/// and motions are not looked at: see force_elements_of.hpp.
ReferenceMechanism reference_mechanism(const Model& model, const Topology& topology);

/// A point of a model body on the tree.
struct ReferencePoint {
  int body = kGround;     ///< tree body
  Eigen::Vector3d place;  ///< m, global at the reference
  Eigen::Matrix3d axes;   ///< of the model body there
};
/// body, point: as in an Attachment.
ReferencePoint reference_point(const Model& model, const Topology& topology, int body, int point);

/// Two unit vectors perpendicular to a unit axis and to each other, right-handed with it.
struct Perpendiculars {
  Eigen::Vector3d first, second;
};
Perpendiculars perpendiculars(const Eigen::Vector3d& axis);

/// Position and velocity of a mechanism's coordinates with joint forces, in the order of Topology::bodies.
struct ForeignState {
  std::vector<double> z, zd, tau;
  double t = 0;
};

}  // namespace mbgen::foreign
