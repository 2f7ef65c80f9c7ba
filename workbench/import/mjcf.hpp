#pragma once
// MJCF, the format of MuJoCo (https://mujoco.readthedocs.io/en/stable/XMLreference.html): the meaning of its
// elements and their places in a model.

#include <functional>
#include <limits>
#include <map>

#include "workbench/import/assembly.hpp"

namespace mbgen::importing {

/// Of the <compiler> element.
struct MjcfSettings {
  enum class InertiaFromGeom { automatic, always, never };
  bool is_in_degrees = true;
  std::string euler_sequence = "xyz";  ///< lower case turns about moving axes, upper case about fixed ones
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::automatic;
  bool balances_inertia = false;
  double bound_mass = 0, bound_inertia = 0;  ///< least mass and principal moment of a body; 0: none
  double total_mass = -1;                    ///< kg, sum that all masses are scaled to; negative: as they are
  double first_group = 0, last_group = 5;    ///< of geoms whose mass counts
  bool limits_by_range = true;               ///< a range alone makes a limit
  /// Of <option> <flag>.
  bool has_springs = true, has_dampers = true, has_friction = true, has_equalities = true, has_actuators = true;
};

/// Elements of a <default> class by their names, and the class it inherits from.
struct MjcfClass {
  std::string parent;
  std::map<std::string, const Element*, std::less<>> elements;
};

struct MjcfJoint {
  std::string coordinate;  ///< name of the joint in the model
  JointType type = JointType::revolute;
  double reference = 0;  ///< rad or m: MuJoCo's coordinate at the reference configuration
  double armature = 0;   ///< kg m^2 or kg
  double free = 0;       ///< rad or m: coordinate of the model at MuJoCo's springref
  double moved = 0;      ///< rad or m: from the reference as written to the one where loops close
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;  ///< rad or m, from the reference as written
};

/// A spring and damper of a joint by <joint springdamper>, over the inertia that the coordinate feels.
struct MjcfSpringDamper {
  std::string coordinate;
  double time_constant = 0, damping_ratio = 0, free = 0;
};

/// A sum of coordinates: a fixed tendon, or one coordinate.
struct MjcfLength {
  std::vector<std::pair<double, MjcfJoint>> parts = {};  ///< coefficients
  double reference() const {
    double sum = 0;
    for (const auto& [factor, joint] : parts) sum += factor * joint.reference;
    return sum;
  }
  /// From the reference as written to the one where loops close.
  double moved() const {
    double sum = 0;
    for (const auto& [factor, joint] : parts) sum += factor * joint.moved;
    return sum;
  }
};

/// Parts of elements that were left out: told once, at the first place.
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
  std::vector<std::string> massless = {};                           ///< bodies whose mass a mesh should give
  std::map<std::string, double, std::less<>> inertia_of = {};       ///< diagonal of the mass matrix at the reference
  std::map<std::string, double, std::less<>> felt_inertia_of = {};  ///< one over the diagonal of its inverse
};

/// Counts a loss of which one note tells; `text` follows the number of places.
void lose(Mjcf& mjcf, Spot spot, const std::string& text);

/// <compiler>, <option>, <default>.
void read_settings(Mjcf& mjcf, const Element& root);

/// An attribute of an element, of its class, of the classes that it inherits from, or nullptr.
/// childclass: the class of elements that name none.
const Attribute* inherited(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                           std::string_view name);
/// Of an element whose defaults have another name: those of <equality> and <tendon> are for all their kinds.
const Attribute* inherited_as(const Mjcf& mjcf, const Element& element, std::string_view as, std::string_view name);
double inherited_number(Mjcf& mjcf, const Element& element, const std::string& childclass, std::string_view name,
                        double fallback);
Vector3d inherited_vector(Mjcf& mjcf, const Element& element, const std::string& childclass, std::string_view name,
                          const Vector3d& fallback);
std::string inherited_text(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                           std::string_view name, std::string_view fallback);
/// Checks that the class an element names is there. Fails: with a problem.
void require_class(Mjcf& mjcf, const Element& element, std::string_view attribute_name);

/// pos and quat, axisangle, euler, xyaxes or zaxis.
Isometry3d read_pose(Mjcf& mjcf, const Element& element, const std::string& childclass);

/// Calls `visit(child, frame, childclass)` for the children of a body, those inside <frame> too; the frame is theirs in
/// the body.
using VisitChild = std::function<void(const Element&, const Isometry3d&, const std::string&)>;
void for_children(Mjcf& mjcf, const Element& body, const std::string& childclass, const VisitChild& visit);

/// The body's mass, centre of mass and inertia, by its <inertial> or its geoms.
void read_mass(Mjcf& mjcf, const Element& element, const std::string& childclass, BodyDraft& body);
/// Scales all masses where <compiler settotalmass> asks for it.
void scale_masses(Mjcf& mjcf);

/// Replaces <replicate> by frames with copies, and adds copies of the tendons, equalities and actuators that refer to
/// the copied elements. Requires: settings are read. Problems: no count, more than 2 million elements.
void expand_replicates(Mjcf& mjcf, Element& root);

/// The tree of <worldbody>.
void read_bodies(Mjcf& mjcf, const Element& world);
/// Says beside the joints where their zeros are in MuJoCo's coordinates.
void tell_references(Mjcf& mjcf);
/// Joints of a body, between it and its parent; without any it is fixed.
void read_joints(Mjcf& mjcf, const Element& element, const std::string& childclass, int parent, int body);

/// The mass matrix of the tree at the reference, with armatures: inertia_of and felt_inertia_of of hinges and slides.
/// Cost: quadratic in the depth of the tree, cubic in its freedoms.
void find_inertias(Mjcf& mjcf);
/// Springs and dampers by time constants. Requires: inertias are found.
void add_spring_dampers(Mjcf& mjcf);

/// Springs, dampers and friction of <tendon> <fixed>, after the bodies.
void read_tendons(Mjcf& mjcf, const Element& section);

/// Sums of coordinates: sum of factor times coordinate, in the model's coordinates.
std::vector<Term> terms_of(const MjcfLength& length, double factor, std::string_view prefix);

/// Joints that <connect> and <weld> become. Where they do not meet at the reference, the joints of the tree are moved
/// and the reference with them. Requires: no tendons, relations or actuators are read. Problems: equalities that stay
/// open.
void close_loops_of(Mjcf& mjcf, const Element& root);

/// Calls `visit` for the equalities that are active.
void for_equalities(const Mjcf& mjcf, const Element& root, const std::function<void(const Element&)>& visit);
/// The coefficients of an equality of joints or tendons, from the constant on.
std::vector<double> polynomial_of(Mjcf& mjcf, const Element& equality);

/// <equality> of joints and tendons, <actuator>, after the tendons.
void read_equalities(Mjcf& mjcf, const Element& section);
void read_actuators(Mjcf& mjcf, const Element& section);

/// The whole translation. Problems and notes are added.
void import_mjcf(Reading& reading, const Element& root, Assembly& assembly);

}  // namespace mbgen::importing
