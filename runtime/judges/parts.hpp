#pragma once
// The numbers of a model as the Cartesian equations use them: everything in the axes of its body, from its centre of
// mass.

#include <Eigen/Dense>
#include <vector>

#include "compiler/topology/topology.hpp"
#include "runtime/judges/values.hpp"

namespace mbgen::cartesian {

/// A rigid body. Ground is one too, with its centre at the origin.
struct Part {
  double mass = 0;                                     ///< kg
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< about the centre of mass, body axes, kg m^2
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< body axes in global axes at the reference configuration
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< centre of mass, global, at the reference configuration
  bool is_rod = false;                                 ///< body x axis from its `from` to its `to` end
};

/// A point of a body, from its centre of mass in body axes, m.
struct Place {
  int body = 0;
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();
};

/// One freedom of a joint of the tree.
struct PartFreedom {
  FreedomKind kind = FreedomKind::revolute;
  Eigen::Vector3d axis;  ///< global axes at the reference configuration
  int coordinate = -1;   ///< tree index
};

struct PartJoint {
  JointType type = JointType::revolute;
  Place from, to;
  Eigen::Matrix3d triad_from, triad_to;  ///< columns: two perpendiculars and the axis, body axes of either body
  std::vector<PartFreedom> freedoms;     ///< translations first; empty for cut joints, which have no coordinates
  double radius = 0;                     ///< m, of a rolling disc or ball
};

struct PartRod {
  Place from, to;
  double length = 0, mass = 0;
  int body = -1;    ///< index into Parts::bodies, -1 for a massless rod
  int motion = -1;  ///< index into Model::motions: what it adds to the length; -1 for a constant length
};

/// The places of an element by its connection.
struct ElementPart {
  Place from, to;                                  ///< of an element on one body `from` alone
  double reference = 0;                            ///< m, distance at the reference configuration
  Eigen::Matrix3d axes_from, axes_to;              ///< columns: axes of a frame, in the axes of either body
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  ///< body axes of `from`; zero: along the line
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();   ///< from `from` to `to` at the reference, body axes of `from`, m
};

struct PartTyre {
  Place centre;
  Eigen::Vector3d axis;  ///< spin axis, body axes
};

/// Indices run as in the model, but for the bodies: those that move, the massive rods, ground.
struct Parts {
  std::vector<Part> bodies;
  std::vector<int> index_of;  ///< per Model::bodies: index into `bodies`
  std::vector<PartJoint> joints;
  std::vector<PartRod> rods;
  std::array<std::vector<ElementPart>, ElementKinds::count> elements;  ///< per kind as in the model
  std::vector<PartTyre> tyres;
  Eigen::Vector3d gravity;
  int ground() const { return static_cast<int>(bodies.size()) - 1; }
};

/// Two perpendiculars to a unit axis and the axis itself, as columns of a right-handed triad. For a coordinate axis the
/// next two, turned with its sign; else the first is the axis times the coordinate axis it is least along. This choice
/// is shared with the closures of the recursive formulation, so that multipliers compare.
Eigen::Matrix3d triad(const Eigen::Vector3d& axis);

/// A point of a body of the model.
Place place_of(const Parts& parts, const Attachment& at, const Values& value);

/// Evaluates every constant at the values' parameters and inputs.
Parts make_parts(const Model& model, const Topology& topology, const Values& values);

}  // namespace mbgen::cartesian
