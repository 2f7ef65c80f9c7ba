// Forces from multipliers: closures of the tree, driving forces, reactions of the joints.

#include "runtime/judges/mechanism.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {
namespace {

using namespace cartesian;
using Eigen::Vector3d;

/// Axes that a tree body had in common with the global ones at the reference configuration.
Eigen::Matrix3d frame_of(const Topology& topology, const Parts& parts, const std::vector<Moving>& bodies, int tree) {
  if (tree == kGround) return Eigen::Matrix3d::Identity();
  const int b = parts.index_of[topology.bodies[tree].model_body];
  return bodies[b].axes * parts.bodies[b].axes.transpose();
}

bool has_point(JointType type) {
  return type == JointType::spherical || type == JointType::revolute || type == JointType::universal ||
         type == JointType::fixed || type == JointType::homokinetic;
}

/// Multiplier of a massive rod's distance when its mass is split among its ends (theory.md section 5): half the
/// difference of the forces at its ends, and (m_jj - m_jk) / 2 times the acceleration of one end towards the other.
double rod_tension(const PartRod& rod, const Moving& body, const Vector3d& at_from, const Vector3d& at_to) {
  return 0.5 * (at_to - at_from).dot(body.axes.col(0)) + rod.mass * rod.length * body.spin.squaredNorm() / 12;
}

/// A wrench about the centre of mass, seen about a point at `arm` from it.
CartesianWrench about(const Vector3d& arm, const Vector6d& wrench) {
  return {wrench.head<3>(), wrench.tail<3>() - arm.cross(wrench.head<3>())};
}

}  // namespace

std::vector<double> CartesianSystem::loop_multipliers(const CartesianState& state,
                                                      const Eigen::VectorXd& lambda) const {
  const CartesianMechanism& c = *mechanism_;
  const std::vector<Moving> bodies = c.bodies(state);
  std::vector<double> result;
  std::vector<int> base(c.topology.loops.size(), kGround);
  for (const LoopBlock& block : c.topology.blocks)
    for (int l : block.loops) base[l] = block.base;
  for (std::size_t l = 0; l < c.topology.loops.size(); ++l) {
    const Loop& loop = c.topology.loops[l];
    if (loop.coupling >= 0) {
      result.push_back(lambda[c.first.couplings + loop.coupling]);
      continue;
    }
    const int first = loop.rod >= 0 ? c.first.rods[loop.rod] : c.first.joints[loop.joint];
    if (loop.rod >= 0) {
      const PartRod& rod = c.parts.rods[loop.rod];
      result.push_back(
          rod.body < 0 ? lambda[first]
                       : rod_tension(rod, bodies[rod.body], lambda.segment<3>(first), lambda.segment<3>(first + 3)));
      continue;
    }
    Eigen::VectorXd values = lambda.segment(first, loop.equations);
    if (has_point(c.model.joints[loop.joint].type))
      values.head<3>() = (frame_of(c.topology, c.parts, bodies, base[l]).transpose() * values.head<3>()).eval();
    result.insert(result.end(), values.begin(), values.end());
  }
  return result;
}

std::vector<double> CartesianSystem::driving_forces(const Eigen::VectorXd& lambda) const {
  std::vector<double> result;
  for (std::size_t k = 0; k < mechanism_->model.motions.size(); ++k)
    result.push_back(-lambda[mechanism_->first.motions + static_cast<int>(k)]);
  // A motion that makes a rod longer pushes against its tension.
  for (std::size_t r = 0; r < mechanism_->parts.rods.size(); ++r)
    if (const int motion = mechanism_->parts.rods[r].motion; motion >= 0)
      result[motion] -= lambda[mechanism_->first.rods[r]];
  return result;
}

std::vector<CartesianWrench> CartesianSystem::joint_reactions(const CartesianState& state, const GenericState& z,
                                                              const std::vector<double>& tau,
                                                              const Eigen::VectorXd& lambda) const {
  const CartesianMechanism& c = *mechanism_;
  const std::vector<Moving> bodies = c.bodies(state);
  const Values values = c.values(z, state.t);
  const std::vector<Row> rows = c.equations_at(bodies, values);
  const Forces forces = c.forces(bodies, state.x, values);
  std::vector<CartesianWrench> result;
  std::vector<Vector6d> on_to(c.parts.joints.size(), Vector6d::Zero());
  for (std::size_t j = 0; j < on_to.size(); ++j) {
    for (int r = c.first.joints[j]; r < c.first.joints[j + 1]; ++r) on_to[j] -= lambda[r] * rows[r].on_to;
    for (const JointCoordinate& coordinate : c.coordinates_of(static_cast<int>(j), bodies, z.z))
      on_to[j] += (tau[coordinate.index] + forces.joints[coordinate.index]) * coordinate.row.on_to;
  }
  for (std::size_t k = 0; k < c.model.motions.size(); ++k) {
    const int r = c.first.motions + static_cast<int>(k);
    on_to[c.model.motions[k].joint.joint] -= lambda[r] * rows[r].on_to;
  }
  for (std::size_t k = 0; k < c.model.couplings.size(); ++k) {
    const Coupling& coupling = c.model.couplings[k];
    const std::vector<CoupledCoordinate> coupled = c.coupled_coordinates(coupling, bodies, values);
    const double multiplier = lambda[c.first.couplings + static_cast<int>(k)];
    for (std::size_t i = 0; i < coupled.size(); ++i)
      on_to[coupling.coordinates[i].joint] -= multiplier * coupled[i].slope * coupled[i].coordinate.row.on_to;
  }
  for (std::size_t j = 0; j < on_to.size(); ++j)
    result.push_back(about(end_of(bodies, c.parts.joints[j].to).arm, on_to[j]));
  return result;
}

std::vector<double> CartesianSystem::reaction_loads(const CartesianState& state, const GenericState& z,
                                                    const Eigen::VectorXd& lambda) const {
  const CartesianMechanism& c = *mechanism_;
  const std::vector<Moving> bodies = c.bodies(state);
  const std::vector<CartesianWrench> joints = joint_reactions(state, z, std::vector<double>(z.z.size(), 0.0), lambda);
  const std::vector<Vector3d> rods = rod_forces(state, lambda, ReactionOutput::End::to);
  std::vector<double> loads;
  for (const SampledValue& sampled : c.model.sampled) {
    loads.push_back(0);
    if (!sampled.load) continue;
    const ReactionLoad& load = *sampled.load;
    Vector3d vector;
    if (load.rod >= 0) {
      vector = rods[static_cast<std::size_t>(load.rod)];
    } else {
      const CartesianWrench& wrench = joints[static_cast<std::size_t>(load.joint)];
      vector = load.what == ReactionOutput::What::force ? wrench.force : wrench.moment;
    }
    if (load.direction == ReactionLoad::Direction::whole) {
      loads.back() = vector.norm();
      continue;
    }
    const PartJoint& joint = c.parts.joints[static_cast<std::size_t>(load.joint)];
    const Vector3d axis = bodies[static_cast<std::size_t>(joint.from.body)].axes * joint.triad_from.col(2);
    const double along = axis.dot(vector);
    loads.back() = load.direction == ReactionLoad::Direction::along ? std::abs(along) : (vector - along * axis).norm();
  }
  return loads;
}

std::vector<Vector3d> CartesianSystem::rod_forces(const CartesianState& state, const Eigen::VectorXd& lambda,
                                                  ReactionOutput::End end) const {
  const CartesianMechanism& c = *mechanism_;
  const std::vector<Moving> bodies = c.bodies(state);
  const bool at_to = end == ReactionOutput::End::to;
  std::vector<Vector3d> on_end;
  for (std::size_t r = 0; r < c.parts.rods.size(); ++r) {
    const PartRod& rod = c.parts.rods[r];
    const int first = c.first.rods[r];
    if (rod.body >= 0) {
      on_end.push_back(-lambda.segment<3>(at_to ? first + 3 : first));
    } else {
      const Vector3d gap = end_of(bodies, rod.from).position - end_of(bodies, rod.to).position;
      on_end.push_back((at_to ? 1 : -1) * lambda[first] / (rod.motion < 0 ? rod.length : gap.norm()) * gap);
    }
  }
  return on_end;
}

}  // namespace mbgen
