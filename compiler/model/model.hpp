#pragma once
// A multibody system as data. Plain structs, SI units, radians.

#include <memory>
#include <string>
#include <vector>

#include "compiler/expressions/parameter.hpp"
#include "compiler/model/axles.hpp"
#include "compiler/model/element_kinds.hpp"
#include "compiler/model/outputs.hpp"
#include "compiler/model/relations.hpp"
#include "compiler/model/roads.hpp"
#include "compiler/model/states.hpp"
#include "compiler/model/vehicle.hpp"

namespace mbgen {

/// Description, author, version and rights of a model, for people.
struct About {
  std::string description, author, version, copyright, licence;
};

struct Input {
  std::string name;
  Where where;
  std::string unit;
  double default_value = 0;
  int derivative = -1;  ///< index into Model::inputs of its rate of change; -1: it counts as constant
  Presentation shown = {};
};

/// A value that a coordinate or its velocity is to have at the start.
struct InitialValue {
  CoordinateReference coordinate;
  double value = 0;  ///< rad or m, or per second
  Where where;
  double weight = 1;    ///< of its squared error, where the values asked for do not fit together
  bool locked = false;  ///< the start keeps it, at any error of the others
  int expression = -1;  ///< index into Model::expressions, over parameters that act at the start; -1: constant
};

/// Angular velocity of a ball joint that starts in the pole of its angles, where they have no rates.
struct InitialTurning {
  int joint = -1;                 ///< index into Model::joints
  Vector3 angular_velocity = {};  ///< rad/s, of `to` against `from`, axes of `from`
  Where where;
};

struct Initial {
  bool equilibrium = false;                         ///< start from static equilibrium, then give `velocities`
  std::vector<InitialValue> positions, velocities;  ///< the rest is zero or follows from the closures
  std::vector<InitialTurning> turnings = {};        ///< joints that have none of their rates among `velocities`
};

struct SolverSettings {
  enum class Integrator { rk4, abm4, rosenbrock };
  Integrator integrator = Integrator::rk4;
  double step = 1e-3;                ///< s
  double duration = 1;               ///< s
  double closure_tolerance = 1e-12;  ///< m or 1, largest residual that projection leaves
  double tolerance = 1e-6;           ///< relative, for importers that integrate the model with a method of their own

  /// Whether a step uses the steps before it.
  bool is_multistep() const { return integrator == Integrator::abm4; }
  /// Whether a step solves linear equations of the tangents of its force elements.
  bool is_implicit() const { return integrator == Integrator::rosenbrock; }
};

/// A multibody system as the user described it, names resolved and every number checked.
struct Model {
  std::string name;
  std::string file;                ///< as given to read_model
  std::vector<std::string> files;  ///< that and every file it includes, in the order of reading, each once
  /// 16 hex digits over the content (includes too), for the banner and manifest
  std::string hash;
  About about;
  Diagnostics notes;                         ///< entries of its files that it does not use; nothing is wrong
  Vector3Quantity gravity{0.0, 0.0, -9.81};  ///< m/s^2, global
  std::vector<Parameter> parameters;
  std::vector<Input> inputs;
  std::vector<Expression> expressions;
  /// index into bodies of the body named "ground"; -1 when there is none
  int ground = -1;
  std::vector<Point> hardpoints;  ///< by which positions were named: m, global axes at the reference
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Rod> rods;
  std::vector<Coupling> couplings;
  std::vector<PointSpring> springs;
  std::vector<JointSpring> joint_springs;
  std::vector<JointFriction> frictions;
  std::vector<SpringFriction> spring_frictions;
  std::vector<RodFriction> rod_frictions;
  std::vector<AirSpring> air_springs;
  std::vector<Bushing> bushings;
  std::vector<BumpStop> bump_stops;
  std::vector<AppliedForce> forces;
  std::vector<JointForce> joint_forces;
  std::vector<Road> roads;
  std::shared_ptr<const std::vector<double>> samples;  ///< of roads and large tables, null without; never changed
  std::vector<Tyre> tyres;
  std::vector<Axle> axles;
  std::optional<Vehicle> vehicle;
  std::vector<Motion> motions;
  std::vector<UserState> states;
  std::vector<SampledValue> sampled;
  std::vector<Output> outputs;
  std::vector<DisplayShape> shapes;
  Initial initial;
  SolverSettings solver;
};

/// The freedom that a coordinate belongs to. Requires: the reference names one.
const Freedom& freedom_of(const Model& model, const CoordinateReference& coordinate);

/// Global position of a point at the reference configuration and default parameters, m; NaN for an attachment that
/// could not be read.
Vector3 reference_position(const Model& model, const Attachment& attachment);

}  // namespace mbgen
