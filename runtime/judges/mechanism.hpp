#pragma once
// A mechanism for the Cartesian equations: its numbers, the positions of its equations, and its forces at a state.

#include <utility>
#include <vector>

#include "runtime/judges/bodies.hpp"
#include "runtime/judges/joint_coordinates.hpp"
#include "runtime/judges/tyre_contact.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {
namespace cartesian {

/// Order of the equations: joints of the model, then rods, then one per motion, then one per coupling.
struct FirstRows {
  std::vector<int> joints, rods;  ///< first row of each, and the end of the last
  int motions = 0, couplings = 0, end = 0;
  std::vector<int> loop_of;  ///< per equation: index into Topology::loops, or -1
};

FirstRows first_rows(const Parts& parts, const Model& model, const Topology& topology);

/// A wrench on a body.
struct Load {
  int body = 0;
  Vector6d wrench;  ///< about the centre of mass, global axes
};

/// A coordinate of a coupling, and the derivative of the relation by it.
struct CoupledCoordinate {
  JointCoordinate coordinate;
  double slope = 0;
};

/// A spring at this instant: m, m/s, tension including friction, and of its law alone, N.
struct LineAtWork {
  double length = 0, rate = 0, force = 0, own = 0;
};

/// Forces of the model's elements at one state.
struct Forces {
  std::vector<Load> loads;     ///< springs, applied forces, tyres; also on ground
  std::vector<double> joints;  ///< per tree coordinate, N or N m
  std::vector<double> xd;      ///< rates of the auxiliary states
  std::vector<double> hold;    ///< per place of hold_names
  std::vector<LineAtWork> springs;
  std::vector<TyreResult<double>> tyres;
  std::vector<double> observed;  ///< of Model::observed, without those over accelerations
};

}  // namespace cartesian

struct CartesianMechanism {
  Model model;
  Topology topology;
  cartesian::CoordinateTable table;
  std::vector<double> inputs, parameters;
  cartesian::Parts parts;
  cartesian::FirstRows first;

  CartesianMechanism(const Model& model, const Topology& topology);
  /// Updates the parts for the present parameters and inputs.
  void refresh();

  cartesian::Values values(const GenericState& z, double t) const {
    return {model, table, parameters, inputs, t, &z.z, &z.zd};
  }
  int moving() const { return parts.ground(); }

  /// Bodies with ground as the last, at rest.
  std::vector<cartesian::Moving> bodies(const CartesianState& state) const;
  std::vector<cartesian::Row> equations_at(const std::vector<cartesian::Moving>& bodies,
                                           const cartesian::Values& values) const;
  /// Coordinates of a joint of the model.
  std::vector<cartesian::JointCoordinate> coordinates_of(int joint, const std::vector<cartesian::Moving>& bodies,
                                                         const std::vector<double>& guess) const {
    return joint_coordinates(parts.joints[joint], parts.bodies, bodies, guess);
  }
  /// Derivative of a coupling's relation by each of its coordinates, in their order, at the bodies.
  std::vector<cartesian::CoupledCoordinate> coupled_coordinates(const Coupling& coupling,
                                                                const std::vector<cartesian::Moving>& bodies,
                                                                const cartesian::Values& values) const;
  /// Values with states and lengths.
  cartesian::Values complete(cartesian::Values values, const std::vector<cartesian::Moving>& bodies,
                             const std::vector<double>& x) const;
  /// Sets the observed outputs of a round in values. Requires: forces of the elements of this round and before.
  void observe(const std::vector<cartesian::Moving>& bodies, const std::vector<double>& x,
               const cartesian::Forces& forces, int round, cartesian::Values& values) const;
  /// Sets the sampled values whose instant is at the start of a step of h seconds, in x; any: whether there are such
  /// values. loads: per value, for reactions; observed: of Model::observed. Fails: sample_inside_step,
  /// auxiliary_not_a_number; x is then unchanged.
  Status sample(const std::vector<cartesian::Moving>& bodies, const cartesian::Values& values,
                const std::vector<double>& loads, std::vector<double> observed, double h, bool& any,
                std::vector<double>& x) const;
  cartesian::Forces forces(const std::vector<cartesian::Moving>& bodies, const std::vector<double>& x,
                           const cartesian::Values& values) const;
};

}  // namespace mbgen
