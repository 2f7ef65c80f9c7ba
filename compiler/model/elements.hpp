#pragma once
// Elements that act on the bodies of a model: springs, friction, forces, tyres and motions.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/expressions/table.hpp"
#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A characteristic: factor times argument, or a table over the argument.
using Law = std::variant<Quantity, Table>;

/// Spring and damper between two points, tension positive:
/// f = stiffness(l - l0) + damping(dl/dt) + preload + force(length, rate).
struct PointSpring {
  std::string name;
  Where where;
  Attachment from, to;
  std::optional<Law> stiffness;         ///< N/m, or a table of N over m
  std::optional<Law> damping;           ///< N s/m, or a table of N over m/s
  std::optional<Quantity> free_length;  ///< m; without it the reference distance
  Quantity preload;                     ///< N, tension positive
  /// expression; local 0 `length` (m), local 1 `rate` (m/s); N, tension positive
  std::optional<int> force;
};

/// Spring and damper on a coordinate, or on the difference of two (anti-roll bar):
/// x = z - z(relative_to), force on the coordinate, opposite on `relative_to`:
/// f = -(stiffness(x - free) + damping(dx/dt) + preload + force(x, dx/dt)).
struct JointSpring {
  std::string name;
  Where where;
  CoordinateReference joint;
  std::optional<CoordinateReference> relative_to;
  std::optional<Law> stiffness;  ///< N m/rad or N/m
  std::optional<Law> damping;    ///< N m s/rad or N s/m
  Quantity free;                 ///< rad or m
  Quantity preload;              ///< N m or N
  std::optional<int> force;      ///< expression; local 0 `position`, local 1 `rate`
};

/// Law of a friction between two parts that slide on each other, v their speed, F_n the force that presses them, or 1.
/// Level: g(v) = F_n (coulomb + (stiction - coulomb) exp(-(v/v_stribeck)^2)).
///   smooth          f = -g(v) tanh(v/velocity) - viscous v: creeps at rest
///   elasto_plastic, lugre: a bristle of deflection b, an auxiliary state, see mbgen/bristle.hpp;
///                   f = -(stiffness b + damping db/dt) - viscous v: holds at rest
struct FrictionLaw {
  enum class Kind { smooth, elasto_plastic, lugre };
  Kind kind = Kind::smooth;
  Quantity coulomb;   ///< N m or N; with `normal` 1 or m
  Quantity stiction;  ///< as coulomb; the reader sets it to coulomb when absent
  Quantity viscous;   ///< N m s/rad or N s/m
  Quantity velocity;  ///< rad/s or m/s over which the sign of smooth friction is smoothed, > 0
  /// rad/s or m/s, > 0; the reader sets it to 10 * velocity when absent, or of a bristle without stiction to 1
  Quantity stribeck_velocity;
  Quantity stiffness;         ///< of a bristle, N m/rad or N/m, > 0
  Quantity damping;           ///< of a bristle, N m s/rad or N s/m
  Quantity elastic;           ///< share of the largest deflection up to which a bristle does not slide, 0 to below 1
  std::optional<double> lag;  ///< s: a bristle follows no faster; the reader sets it to the step of the solver
  int normal = -1;            ///< index into Model::springs of the spring that presses the parts together, -1 for none
  int load = -1;              ///< index into Model::sampled of the reaction that presses them, -1 for none

  /// Of a model whose programs are differentiated, and nothing else: see open_bristle in mbgen/bristle.hpp.
  bool is_for_slopes = false;

  bool has_bristle() const { return kind != Kind::smooth; }
};

/// Friction on a coordinate.
struct JointFriction : FrictionLaw {
  std::string name;
  Where where;
  CoordinateReference joint;
};

/// Friction along the line of a spring between two points: its leaves, its bush.
struct SpringFriction : FrictionLaw {
  std::string name;
  Where where;
  int spring = -1;  ///< index into Model::springs
};

/// Friction in the ball at an end of a rod, against the turn of the body there relative to the rod's line; smooth.
struct RodFriction : FrictionLaw {
  std::string name;
  Where where;
  int rod = -1;          ///< index into Model::rods
  bool at_from = false;  ///< the ball is on the body of `from`, else on that of `to`
};

/// Polytropic air spring between two points: p V^n = const; the force (p - p_ambient) A(l) pushes the points apart.
struct AirSpring {
  std::string name;
  Where where;
  Attachment from, to;
  Quantity pressure;               ///< Pa absolute, at the reference length
  Quantity ambient;                ///< Pa absolute
  Quantity exponent;               ///< polytropic exponent
  std::optional<Quantity> length;  ///< m, reference length; without it the reference distance
  Law area;                        ///< m^2: constant, or a table over length (m)
  /// m^3 over length (m); without it volume0 + area(length0) * (l - length0)
  std::optional<Table> volume;
  Quantity volume0;  ///< m^3 at the reference length (used without `volume`)
};

/// Force and torque on a body at a point.
struct AppliedForce {
  std::string name;
  Where where;
  Attachment at;
  Vector3Quantity force;      ///< N
  Vector3Quantity torque;     ///< N m
  bool in_body_axes = false;  ///< components in body axes, else in global axes
};

/// Generalised force on a coordinate.
struct JointForce {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity force;  ///< N m or N
};

enum class TyreModel { pac89, pac2002, mf61 };

/// Forces of slip along and across together: by the set, or by a friction ellipse, as pac89 always has it.
enum class CombinedSlip { set, ellipse };

/// An enveloping contact: four cams with the outline of a superellipse, a rear and a front one below the middle of each
/// half of the tyre's width, |s / length|^order + |z / height|^order = 1. Lengths in unloaded radii of the tyre.
struct TyreEnvelope {
  double base = 0;                           ///< distance of the front cams from the rear ones, > 0
  double length = 0, height = 0, order = 0;  ///< half axes along and down, > 0; exponent, >= 1
  double width = 0;                          ///< of the tyre on the road, > 0
  double steps = 0;                          ///< places that are looked at between wheel and cam centre, whole, >= 1

  /// Places at spacing() * i, i = -last_sample() ... last_sample(), are looked at.
  double spacing() const { return 0.5 * base / steps; }
  int last_sample() const;
};

/// "enveloping, base 0.4, ...", for those who read.
std::string to_text(const TyreEnvelope& envelope);

/// The patch of a tyre that turns about the road's normal, as of TyreProperties in tyre.hpp.
struct TyrePatch {
  Quantity stiffness;  ///< N m/rad, against turning under `load`, > 0
  Quantity radius;     ///< m, moment of a patch that turns over its friction under `load`, > 0
  Quantity load;       ///< N, > 0
};

/// Tyre of a wheel body on a road, or on a flat horizontal one (normal = global z).
struct Tyre {
  std::string name;
  Where where;
  Attachment centre;  ///< wheel centre, a point of the wheel body on its spin axis
  /// unit spin axis, GLOBAL axes at the reference; forward rolling is positive about it when it points left
  Vector3 axis{0, 1, 0};
  TyreModel model = TyreModel::pac2002;
  /// in the order of kPac2002Fields or kMf61Fields, or a0.. b0.. c0.. of pac89 (runtime header tyre.hpp)
  std::vector<Quantity> coefficients;
  /// +1: coefficients used as they are, -1: mirrored (tyre measured on the other side)
  double side = 1;
  double count = 1;                      ///< 2 for twin tyres: all forces times count
  Quantity radius;                       ///< m, unloaded
  Quantity stiffness;                    ///< N/m, vertical, one tyre
  Quantity damping;                      ///< N s/m, vertical, one tyre
  int road = -1;                         ///< index into Model::roads, -1: flat and horizontal
  std::optional<TyreEnvelope> envelope;  ///< none: contact in one point
  Quantity road_height;  ///< m, global z of the flat road; what is added to the height of one of Model::roads
  Quantity friction;     ///< scales the friction (1 is the measured one)
  /// 1: moment = -coefficient * load * radius * tanh(speed / low_speed); of mf61 its QSY1
  Quantity rolling_resistance;
  Quantity pressure;                              ///< Pa, of inflation; of mf61 alone
  Quantity relaxation_x, relaxation_y;            ///< m, relaxation lengths of the slips, at nominal load
  bool over_load_x = false, over_load_y = false;  ///< the set gives them over the load
  Quantity low_speed;                             ///< m/s, below it slip is damped so that the wheel comes to rest
  std::optional<TyrePatch> parking;               ///< none: turning gives no moment, and there is no state of it
  CombinedSlip combined_slip = CombinedSlip::set;
  bool turn_slip = false;  ///< the set's turn slip acts; of mf61 alone, then there is `parking`
};

/// A relation between coordinates that always holds: the value of an expression over them stays zero, or one of them
/// is a curve over another.
struct Coupling {
  std::string name;
  Where where;
  Quantity relation;                           ///< over positions and parameters; zero; without a curve
  std::optional<CoordinateReference> joint;    ///< of a curve: z(joint) = curve(z(follows))
  std::optional<CoordinateReference> follows;  ///< of a curve
  std::optional<Table> curve;                  ///< cubic or spline, rad or m over rad or m
  /// that stand in it, each once, as they come; of a curve `joint` and `follows`
  std::vector<CoordinateReference> coordinates;
};

/// A driven coordinate: z(t) prescribed; first and second derivatives come from the expression.
struct Motion {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity position;  ///< rad or m, of t, parameters, inputs
};

}  // namespace mbgen
