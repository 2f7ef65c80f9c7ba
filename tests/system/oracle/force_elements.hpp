#pragma once
// Force elements and motions as foreign solvers want them: where they act, and their laws as functions of plain
// numbers. The values of a law come from mbgen's own expressions and tables; all geometry and mechanics is left to the
// foreign solver.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tests/system/oracle/reference_mechanism.hpp"

namespace mbgen::foreign {

/// Pulls two points together along the line between them.
struct LineElement {
  std::string name;
  int from = kGround, to = kGround;  ///< tree bodies
  Eigen::Vector3d at_from, at_to;    ///< m, global at the reference
  /// N, tension positive, of length (m) and its rate (m/s)
  std::function<double(double length, double rate, const ForeignState&)> tension;
};

/// Acts between two frames that have the same axes at the reference. Deflections: displacements of the point of `to`
/// from that of `from` in the axes on `from` (m), then the rotation vector of the frame on `to` (rad).
struct FrameElement {
  std::string name;
  int from = kGround, to = kGround;  ///< tree bodies
  Eigen::Vector3d at_from, at_to;    ///< m, global at the reference
  Eigen::Matrix3d axes;              ///< columns, global at the reference
  /// N and N m against the deflections, of these and their rates
  std::function<std::array<double, 6>(const std::array<double, 6>&, const std::array<double, 6>&, const ForeignState&)>
      forces;
};

/// The same with a foreign solver's own law: constants per direction, displacements first (N/m, N m/rad; N s/m, N m s).
struct LinearFrameElement {
  FrameElement frames;  ///< without forces
  std::array<double, 6> stiffness, damping;
};

/// Force and torque on a body at a point.
struct BodyLoad {
  std::string name;
  int body = kGround;         ///< tree body
  Eigen::Vector3d at;         ///< m, global at the reference
  bool in_body_axes = false;  ///< components in the axes of the tree body, else global
  std::function<Eigen::Vector3d(const ForeignState&)> force, torque;  ///< N, N m
};

/// Generalised force on a coordinate.
struct CoordinateLoad {
  std::string name;
  int coordinate = -1;                               ///< tree index
  std::function<double(const ForeignState&)> force;  ///< N or N m
};

/// A coordinate that is prescribed: its position, velocity and acceleration at a time.
struct PrescribedCoordinate {
  std::string name;
  int coordinate = -1;  ///< tree index
  std::function<std::array<double, 3>(double t)> motion;
};

/// All that acts on a mechanism, in the order of the model. The functions keep what they need alive.
struct ForceElements {
  std::vector<LineElement> lines;
  std::vector<FrameElement> frames;
  std::vector<LinearFrameElement> linear_frames;  ///< nothing of a model becomes one: tests ask for them
  std::vector<BodyLoad> loads;
  std::vector<CoordinateLoad> coordinates;
  std::vector<PrescribedCoordinate> motions;
};

}  // namespace mbgen::foreign
