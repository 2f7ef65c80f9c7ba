#pragma once
// A multibody system as data. Plain structs, SI units, radians.

#include <memory>
#include <string>
#include <vector>

#include "compiler/expressions/parameter.hpp"
#include "compiler/model/axles.hpp"
#include "compiler/model/beams.hpp"
#include "compiler/model/element_kinds.hpp"
#include "compiler/model/outputs.hpp"
#include "compiler/model/relations.hpp"
#include "compiler/model/roads.hpp"
#include "compiler/model/states.hpp"
#include "compiler/model/vehicle.hpp"
#include "mbgen/turns.hpp"

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
  int derivative = -1;  ///< index into Model::inputs of its rate of change; -1: constant
  Presentation shown = {};
};

/// Initial value of a coordinate or its velocity.
struct InitialValue {
  CoordinateReference coordinate;
  double value = 0;  ///< rad or m, or per second
  Where where;
  double weight = 1;    ///< weight of its squared error, for values that are not consistent
  bool locked = false;  ///< the value is exact, whatever the errors of others
  int expression = -1;  ///< index into Model::expressions, over start parameters; -1: constant
};

/// Angular velocity of a ball joint with initial angles at their pole, where rates of angles are undefined.
struct InitialTurning {
  int joint = -1;                 ///< index into Model::joints
  Vector3 angular_velocity = {};  ///< rad/s, of `to` relative to `from`, axes of `from`
  Where where;
};

struct Initial {
  bool equilibrium = false;                         ///< start from static equilibrium, then set `velocities`
  std::vector<InitialValue> positions, velocities;  ///< all others are zero or follow from the closures
  std::vector<InitialTurning> turnings = {};        ///< for joints without rates in `velocities`
};

struct SolverSettings {
  enum class Integrator { rk4, abm4, rosenbrock };
  Integrator integrator = Integrator::rk4;
  double step = 1e-3;                ///< s
  double duration = 1;               ///< s
  double closure_tolerance = 1e-12;  ///< m or 1, largest residual after projection
  double tolerance = 1e-6;           ///< relative, for importers with an integrator of their own

  /// Whether a step uses previous steps.
  bool is_multistep() const { return integrator == Integrator::abm4; }
  /// Whether a step solves linear equations with the tangents of its force elements.
  bool is_implicit() const { return integrator == Integrator::rosenbrock; }
};

/// Largest rotation within a step, rad, accepted by an integrator: see mbgen/turns.hpp.
constexpr double largest_turn(SolverSettings::Integrator integrator) {
  using Integrator = SolverSettings::Integrator;
  return integrator == Integrator::rk4 ? kRk4Turn : integrator == Integrator::abm4 ? kAbm4Turn : kRosenbrockTurn;
}

/// A multibody system as described by the user, names resolved and every number checked.
struct Model {
  std::string name;
  std::string file;                ///< as given to read_model
  std::vector<std::string> files;  ///< the main file and every included file, in the order of reading, each once
  /// 16 hex digits over the content (includes too), for the banner and manifest
  std::string hash;
  About about;
  Diagnostics notes;                         ///< unused entries of its files; no errors
  Vector3Quantity gravity{0.0, 0.0, -9.81};  ///< m/s^2, global
  std::vector<Parameter> parameters;
  std::vector<Input> inputs;
  std::vector<Expression> expressions;
  /// index into bodies of the body named "ground"; -1 if there is none
  int ground = -1;
  std::vector<Point> hardpoints;  ///< named positions in its files: m, global axes at the reference
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Rod> rods;
  std::vector<Beam> beams;  ///< their bodies, joints and bushings are in the lists of these
  std::vector<Coupling> couplings;
  std::vector<PointSpring> springs;
  std::vector<JointSpring> joint_springs;
  std::vector<JointFriction> frictions;
  std::vector<SpringFriction> spring_frictions;
  std::vector<RodFriction> rod_frictions;
  std::vector<AirSpring> air_springs;
  std::vector<Bushing> bushings;
  std::vector<BumpStop> bump_stops;
  std::vector<Rope> ropes;
  std::vector<SurfaceContact> contacts;
  std::vector<Actuator> actuators;
  std::vector<AppliedForce> forces;
  std::vector<JointForce> joint_forces;
  std::vector<Road> roads;
  std::shared_ptr<const std::vector<double>> samples;  ///< of roads and large tables, null if there are none; immutable
  std::vector<Tyre> tyres;
  std::vector<Axle> axles;
  std::optional<Vehicle> vehicle;
  std::vector<Motion> motions;
  std::vector<UserState> states;
  std::vector<SampledValue> sampled;
  std::vector<Output> outputs;
  std::vector<ObservedOutput> observed;  ///< each after the ones in its expression or law
  std::vector<DisplayShape> shapes;
  Initial initial;
  SolverSettings solver;

  // Defined in model.cpp: every file that holds a model would compile copies of all its lists.
  Model();
  Model(const Model& other);
  Model(Model&& other) noexcept;
  Model& operator=(const Model& other);
  Model& operator=(Model&& other) noexcept;
  ~Model();
};

/// The freedom of a coordinate. Requires: a valid reference.
const Freedom& freedom_of(const Model& model, const CoordinateReference& coordinate);

/// Global position of a point at the reference configuration and default parameters, m; NaN for an unreadable
/// attachment.
Vector3 reference_position(const Model& model, const Attachment& attachment);

}  // namespace mbgen
