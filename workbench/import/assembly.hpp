#pragma once
// A mechanism on its way from a robot's file to a model: bodies at the reference configuration, joints in global axes,
// so that written points meet at the reference for any frames of the format.

#include <Eigen/Geometry>
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

constexpr int kGroundDraft = 0;  ///< index of the ground in Assembly::bodies

struct BodyDraft {
  std::string name;
  Isometry3d pose = Isometry3d::Identity();                   ///< body frame in the global one at the reference
  double mass = 0;                                            ///< kg
  Vector3d com = Vector3d::Zero();                            ///< m, body frame
  Matrix3d inertia = Matrix3d::Zero();                        ///< kg m^2 about the centre of mass, body axes
  std::vector<std::pair<std::string, Vector3d>> points = {};  ///< m, body frame
  std::string comment = {};
  std::string title = {};        ///< as messages call it: link "arm"
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
};

struct SpringDraft {
  std::string coordinate;
  double stiffness = 0, damping = 0, free = 0;
};

struct FrictionDraft {
  std::string coordinate;
  double coulomb = 0;
};

/// How a body looks, or a part of it.
struct ShapeDraft {
  std::string name = {}, type = {};  ///< box, cylinder or sphere
  int body = kGroundDraft;
  Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();  ///< m, body frame; no `to` of a sphere
  double radius = 0;                                        ///< m; none of a box
  std::string colour = {};
};

/// An input that sets forces on coordinates.
struct InputDraft {
  std::string name, unit;
};

/// A generalised force by an expression.
struct JointForceDraft {
  std::string name, coordinate, force;
};

/// A relation between coordinates: an expression that stays zero.
struct CouplingDraft {
  std::string name, relation;
};

/// A state of its own, zero at the start, by its derivative.
struct StateDraft {
  std::string name, derivative, unit;
};

/// An end of a coordinate's range.
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
  std::vector<CouplingDraft> couplings;
  std::vector<StateDraft> states;
  std::vector<StopDraft> stops;
  double stop_stiffness = 0;  ///< N m/rad or N/m
  std::vector<ShapeDraft> shapes;
  std::set<std::string> body_names{"ground"}, coordinate_names, shape_names, force_names, coupling_names, stop_names;
  /// Expressions know these as something else.
  std::set<std::string> input_names{"pi",   "t",    "z",    "zd",    "sqrt", "sin",   "cos",  "tan",
                                    "asin", "acos", "atan", "atan2", "exp",  "log",   "tanh", "abs",
                                    "min",  "max",  "pow",  "sign",  "step", "select"};
};

/// A speed at which Coulomb friction is half smoothed: rad/s or m/s. Robots' formats have none.
constexpr double kFrictionVelocity = 1e-3;

/// The text as a name of the model format that none of `taken` is; it is added to them. Characters other than letters
/// and digits become _.
std::string unique_name(std::string_view text, std::set<std::string>& taken);
std::string valid_name(std::string_view text);

/// A name for a joint, such that its coordinates have names of their own.
std::string unique_joint_name(Assembly& assembly, std::string_view text);

/// Adds a point to a body, under this name or one like it. Result: its name.
std::string add_point(BodyDraft& body, std::string_view name, const Vector3d& position);

/// Spring, damper and friction of a coordinate, where they are not zero.
void add_joint_forces(Assembly& assembly, const std::string& coordinate, double stiffness, double damping, double free,
                      double friction);

/// Stops at the ends of a coordinate's range, where the request asks for them; an end that is not finite has none.
void add_stops(const ImportRequest& request, Assembly& assembly, const std::string& coordinate, double lower,
               double upper);

/// The inertia that a geared rotor adds to one coordinate (kg m^2 or kg) and to nothing else: a disc that hangs on the
/// ground by its centre and turns as the coordinate moves.
void add_rotor(Assembly& assembly, const std::string& coordinate, double inertia);

/// A factor of a name in an expression.
struct Term {
  double factor = 0;
  std::string name = {};  ///< empty: the number alone
};
/// The sum as text, without terms of factor zero; "0" where none is left.
std::string sum_text(const std::vector<Term>& terms);

/// The number as a person would type it: without the last digits that products of decimals leave.
std::string number_text(double value);

/// At most three of the names in quotes, and the number of the others: "a", "b", "c" and 4 more.
std::string few_names(const std::vector<std::string>& names);

/// Says of inertias that no rigid body has why they may stand: bodies that fixed joints hold together count together,
/// and bodies fixed to the ground do not matter. Fails (with problems): where the mass matrix would be indefinite.
void check_inertias(Reading& reading, Assembly& assembly);

/// Text of the model.
std::string model_text(const Assembly& assembly);

}  // namespace mbgen::importing
