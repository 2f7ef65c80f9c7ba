#pragma once
// MJCF, the format of MuJoCo (https://mujoco.readthedocs.io/en/stable/XMLreference.html): its elements and their
// translation into a model.

#include <array>
#include <functional>
#include <limits>
#include <map>

#include "workbench/import/assembly.hpp"

namespace mbgen::importing {

/// Settings in the <compiler> element.
struct MjcfSettings {
  enum class InertiaFromGeom { automatic, always, never };
  bool is_in_degrees = true;
  std::string euler_sequence = "xyz";  ///< lower case: moving axes, upper case: fixed axes
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::automatic;
  bool balances_inertia = false;
  double bound_mass = 0, bound_inertia = 0;  ///< lower bounds of mass and principal moments of a body; 0: none
  double total_mass = -1;                    ///< kg, prescribed total mass; negative: none
  double first_group = 0, last_group = 5;    ///< of geoms whose mass counts
  bool limits_by_range = true;               ///< a range alone makes a limit
  /// Of <option> <flag>.
  bool has_springs = true, has_dampers = true, has_friction = true, has_equalities = true, has_actuators = true;
};

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

/// Elements of a <default> class, later ones override earlier ones, and its parent class.
struct MjcfClass {
  std::string parent;
  std::vector<const Element*> elements;
  std::size_t taken_over = kAll;  ///< elements of the parent that it takes over, those before it
};

struct MjcfJoint {
  std::string coordinate;  ///< name of the joint in the model
  JointType type = JointType::revolute;
  double reference = 0;  ///< rad or m: MuJoCo's coordinate at the reference configuration
  double armature = 0;   ///< kg m^2 or kg
  double free = 0;       ///< rad or m: coordinate of the model at MuJoCo's springref
  double moved = 0;      ///< rad or m: change of the reference when loops were closed
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;  ///< rad or m, from the reference as written
};

/// A spring and damper from <joint springdamper>, to be scaled by the inertia of the coordinate.
struct MjcfSpringDamper {
  std::string coordinate;
  double time_constant = 0, damping_ratio = 0, free = 0;
};

/// A linear combination of coordinates: a fixed tendon, or one coordinate.
struct MjcfLength {
  std::vector<std::pair<double, MjcfJoint>> parts = {};  ///< coefficients
  double reference() const {
    double sum = 0;
    for (const auto& [factor, joint] : parts) sum += factor * joint.reference;
    return sum;
  }
  /// Change of the reference when loops were closed.
  double moved() const {
    double sum = 0;
    for (const auto& [factor, joint] : parts) sum += factor * joint.moved;
    return sum;
  }
};

struct MjcfRange {
  double lower, upper;
};

/// An actuator with its defaults. Its force is gain * u + bias[0] + bias[1] * length + bias[2] * rate; its length is
/// gear times the length of its target.
struct MjcfActuator {
  std::string dynamics = "none", gain_type = "fixed", bias_type = "none";
  double gain = 1;  ///< not finite where a law without a counterpart here gave it
  std::array<double, 3> bias = {0, 0, 0};
  double time_constant = 1;  ///< s, of dynamics by a filter
  double damping_ratio = 0;  ///< instead of bias[2] where it is positive
  double gear = 1;
  std::optional<MjcfRange> control, force, activation;  ///< in force
};

/// A kind of lost part: reported once, at its first place.
struct MjcfLoss {
  Spot first;
  int count = 0;
};

struct Mjcf {
  Reading& reading;
  Assembly& assembly;
  MjcfSettings settings = {};
  std::map<std::string, MjcfClass, std::less<>> classes = {};
  std::map<std::string, int, std::less<>> body_of = {};  ///< index into Assembly::bodies
  std::map<std::string, MjcfJoint, std::less<>> joint_of = {};
  std::map<std::string, Isometry3d, std::less<>> site_of = {};  ///< in its body
  std::map<std::string, int, std::less<>> body_of_site = {};
  std::map<std::string, MjcfLoss> losses = {};  ///< by their text
  std::vector<MjcfJoint> scalar_joints = {};    ///< hinges and slides, named or not
  std::vector<MjcfSpringDamper> spring_dampers = {};
  std::map<std::string, MjcfLength, std::less<>> tendon_of = {};
  std::vector<std::string> massless = {};                           ///< bodies with a mass given by a mesh only
  std::map<std::string, double, std::less<>> inertia_of = {};       ///< diagonal of the mass matrix at the reference
  std::map<std::string, double, std::less<>> felt_inertia_of = {};  ///< reciprocal of the diagonal of its inverse
};

/// Counts a loss reported by one note; `text` follows the number of places.
void lose(Mjcf& mjcf, Spot spot, const std::string& text);

/// Checks attributes that take one of a few words. Fails: with a problem for each other word.
void check_words(Reading& reading, const Element& root);

/// <compiler>, <option>, <default>.
void read_settings(Mjcf& mjcf, const Element& root);

/// The element itself, then the elements of its classes whose names satisfy `is_shared`, the nearest first.
std::vector<const Element*> with_defaults(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                                          const std::function<bool(std::string_view)>& is_shared);
/// An attribute of an element, of its class or of a parent class, or nullptr. childclass: the class of elements without
/// a class of their own.
const Attribute* inherited(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                           std::string_view name);
/// The same for an element with its defaults under another name: <equality> and <tendon> share theirs between all
/// kinds.
const Attribute* inherited_as(const Mjcf& mjcf, const Element& element, std::string_view as, std::string_view name);
double inherited_number(Mjcf& mjcf, const Element& element, const std::string& childclass, std::string_view name,
                        double fallback);
Vector3d inherited_vector(Mjcf& mjcf, const Element& element, const std::string& childclass, std::string_view name,
                          const Vector3d& fallback);
std::string inherited_text(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                           std::string_view name, std::string_view fallback);
/// Checks that the class of an element exists. Fails: with a problem.
void require_class(Mjcf& mjcf, const Element& element, std::string_view attribute_name);

/// pos and quat, axisangle, euler, xyaxes or zaxis.
Isometry3d read_pose(Mjcf& mjcf, const Element& element, const std::string& childclass);

/// Calls `visit(child, frame, childclass)` for the children of a body, including children of <frame>; the frame is
/// relative to the body.
using VisitChild = std::function<void(const Element&, const Isometry3d&, const std::string&)>;
void for_children(Mjcf& mjcf, const Element& body, const std::string& childclass, const VisitChild& visit);

/// Mass, centre of mass and inertia of the body, from its <inertial> or its geoms.
void read_mass(Mjcf& mjcf, const Element& element, const std::string& childclass, BodyDraft& body);
/// Scales all masses to <compiler settotalmass>, if given.
void scale_masses(Mjcf& mjcf);

/// Replaces <replicate> by frames with copies, and adds copies of the tendons, equalities and actuators that refer to
/// the copied elements. Requires: settings are read. Problems: no count, more than 2 million elements.
void expand_replicates(Mjcf& mjcf, Element& root);

/// The tree of <worldbody>.
void read_bodies(Mjcf& mjcf, const Element& world);
/// Comments on joints with another zero in MuJoCo's coordinates.
void report_references(Mjcf& mjcf);
/// Joints between a body and its parent; without any it is fixed.
void read_joints(Mjcf& mjcf, const Element& element, const std::string& childclass, int parent, int body);

/// The mass matrix of the tree at the reference, with armatures: inertia_of and felt_inertia_of of hinges and slides.
/// Cost: quadratic in the depth of the tree, cubic in its freedoms.
void find_inertias(Mjcf& mjcf);
/// Springs and dampers by time constants. Requires: inertias are found.
void add_spring_dampers(Mjcf& mjcf);

/// Springs, dampers and friction of <tendon> <fixed>, after the bodies.
void read_tendons(Mjcf& mjcf, const Element& section);

/// Linear combination as terms: factor times the length, in the model's coordinates.
std::vector<Term> terms_of(const MjcfLength& length, double factor, std::string_view prefix);

/// Converts <connect> and <weld> to joints. If they are open at the reference, the joints of the tree and the reference
/// are moved. Requires: no tendons, relations or actuators are read. Problems: equalities that remain open.
void close_loops_of(Mjcf& mjcf, const Element& root);

/// Calls `visit` for the active equalities.
void for_equalities(const Mjcf& mjcf, const Element& root, const std::function<void(const Element&)>& visit);
/// The coefficients of an equality of joints or tendons, from the constant on.
std::vector<double> polynomial_of(Mjcf& mjcf, const Element& equality);

/// Actuator by its element and the defaults, which all kinds of actuators share as in MuJoCo.
MjcfActuator read_actuator(Mjcf& mjcf, const Element& element);

/// <equality> of joints and tendons, <actuator>, after the tendons.
void read_equalities(Mjcf& mjcf, const Element& section);
void read_actuators(Mjcf& mjcf, const Element& section);

/// The whole translation. Problems and notes are added.
void import_mjcf(Reading& reading, const Element& root, Assembly& assembly);

}  // namespace mbgen::importing
