#pragma once
// Intermediate form of a mechanism between a robot's file and a model: bodies in the reference configuration, joints in
// global axes. Points written from it coincide at the reference for any frames of the format.

#include <Eigen/Geometry>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/model/model.hpp"
#include "workbench/import/xml.hpp"

namespace mbgen::importing {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The turn by roll, pitch and yaw, rad: about the fixed axes x, y and z, in this order (URDF, SDF).
inline Matrix3d turn_of(const Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy[1], Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy[0], Vector3d::UnitX()))
      .toRotationMatrix();
}

constexpr int kGroundDraft = 0;  ///< index of the ground in Assembly::bodies

struct BodyDraft {
  std::string name;
  Isometry3d pose = Isometry3d::Identity();  ///< body frame relative to the global frame at the reference
  double mass = 0;                           ///< kg
  Vector3d com = Vector3d::Zero();           ///< m, body frame
  Matrix3d inertia = Matrix3d::Zero();       ///< kg m^2 about the centre of mass, body axes
  std::vector<std::pair<std::string, Vector3d>> points = {};  ///< m, body frame
  std::string comment = {};
  std::string title = {};        ///< in messages: link "arm"
  Spot inertia_spot = {};        ///< where its inertia is given
  bool accepts_inertia = false;  ///< though no rigid body has it
};

struct JointDraft {
  std::string name;
  JointType type = JointType::fixed;
  int from = kGroundDraft, to = kGroundDraft;  ///< indices into Assembly::bodies
  Vector3d at = Vector3d::Zero();              ///< m, global at the reference
  Vector3d axis = Vector3d::Zero();            ///< global at the reference; zero for joints without an axis
  bool cut = false;
  std::string comment = {};
  Vector3d axis2 = Vector3d::Zero();  ///< of a universal joint, likewise
};

struct SpringDraft {
  std::string coordinate;
  double stiffness = 0, damping = 0, free = 0;
};

struct FrictionDraft {
  std::string coordinate;
  double coulomb = 0;
};

/// Shape of a body, or of a part of it.
struct ShapeDraft {
  std::string name = {}, type = {};  ///< box, cylinder or sphere
  int body = kGroundDraft;
  Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();  ///< m, body frame; no `to` of a sphere
  double radius = 0;                                        ///< m; none of a box
  std::string colour = {};
};

/// An input for forces on coordinates.
struct InputDraft {
  std::string name, unit;
};

/// A generalised force as an expression.
struct JointForceDraft {
  std::string name, coordinate, force;
};

/// A motor on a coordinate.
struct ActuatorDraft {
  std::string name, coordinate;
  double gear = 1;
  double limit = std::numeric_limits<double>::infinity();  ///< of the motor, N m or N
};

/// A constraint between coordinates: an expression equal to zero.
struct CouplingDraft {
  std::string name, relation;
};

/// An auxiliary state with its derivative, zero at the start.
struct StateDraft {
  std::string name, derivative, unit;
};

/// A stop at an end of a coordinate's range.
struct StopDraft {
  std::string name, coordinate;
  bool is_above = true;
  double clearance = 0;  ///< rad or m from the reference to the contact
};

struct Assembly {
  std::string name, comment;
  Vector3d gravity{0, 0, -9.81};
  double step = 0;  ///< s; 0: the format's default
  std::vector<BodyDraft> bodies{{.name = "ground"}};
  std::vector<JointDraft> joints;
  std::vector<SpringDraft> springs;
  std::vector<FrictionDraft> frictions;
  std::vector<InputDraft> inputs;
  std::vector<JointForceDraft> joint_forces;
  std::vector<ActuatorDraft> actuators;
  std::vector<CouplingDraft> couplings;
  std::vector<StateDraft> states;
  std::vector<StopDraft> stops;
  double stop_stiffness = 0;  ///< N m/rad or N/m
  std::vector<ShapeDraft> shapes;
  std::set<std::string> body_names{"ground"}, coordinate_names, shape_names, force_names, coupling_names, stop_names;
  /// Names with another meaning in expressions.
  std::set<std::string> input_names{"pi",   "t",    "z",    "zd",    "sqrt", "sin",   "cos",  "tan",
                                    "asin", "acos", "atan", "atan2", "exp",  "log",   "tanh", "abs",
                                    "min",  "max",  "pow",  "sign",  "step", "select"};
};

/// Regularisation speed of Coulomb friction, rad/s or m/s. Robots' formats have none.
constexpr double kFrictionVelocity = 1e-3;

/// The text as a valid name of the model format not in `taken`; it is added there. Characters other than letters and
/// digits become _.
std::string unique_name(std::string_view text, std::set<std::string>& taken);
std::string valid_name(std::string_view text);

/// A joint name that gives its coordinates unique names.
std::string unique_joint_name(Assembly& assembly, std::string_view text);

/// Adds a point to a body, under this name or a similar one. Result: its name.
std::string add_point(BodyDraft& body, std::string_view name, const Vector3d& position);

/// Spring, damper and friction of a coordinate, if not zero.
void add_joint_forces(Assembly& assembly, const std::string& coordinate, double stiffness, double damping, double free,
                      double friction);

/// Stops at the finite ends of a coordinate's range, if the request asks for them.
void add_stops(const ImportRequest& request, Assembly& assembly, const std::string& coordinate, double lower,
               double upper);

/// A note on a range without width, or with its ends the wrong way round: no stops come of it. hint: how the joint is
/// held where both ends are one.
void note_narrow(Reading& reading, Spot spot, const std::string& joint, double lower, double upper,
                 const std::string& unit, const std::string& hint);

/// Reflected inertia of a geared rotor on one coordinate (kg m^2 or kg): a disc on the ground, supported at its centre,
/// with the coordinate as its angle.
void add_rotor(Assembly& assembly, const std::string& coordinate, double inertia);

/// A term of a linear expression: factor and name.
struct Term {
  double factor = 0;
  std::string name = {};  ///< empty: the number alone
};
/// The sum as text, without terms of factor zero; "0" where none is left.
std::string sum_text(const std::vector<Term>& terms);

/// The number as typed by a person: without trailing digits from rounding of decimal products.
std::string number_text(double value);

/// At most three of the names in quotes, and the number of others: "a", "b", "c" and 4 more.
std::string few_names(const std::vector<std::string>& names);

/// Notes on physically impossible inertias that are harmless: rigidly connected bodies count together, and bodies fixed
/// to the ground do not matter. Fails (with problems): for an indefinite mass matrix.
void check_inertias(Reading& reading, Assembly& assembly);

/// Text of the model.
std::string model_text(const Assembly& assembly);

}  // namespace mbgen::importing
