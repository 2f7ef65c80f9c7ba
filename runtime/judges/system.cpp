#include "runtime/judges/system.hpp"

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"
#include "runtime/judges/mechanism.hpp"

namespace mbgen {

using namespace cartesian;
using Eigen::Matrix3d;
using Eigen::Vector3d;

CartesianSystem::CartesianSystem(const Model& model, const Topology& topology)
    : mechanism_(std::make_unique<CartesianMechanism>(model, topology)) {}
CartesianSystem::~CartesianSystem() = default;
CartesianSystem::CartesianSystem(CartesianSystem&&) noexcept = default;

const Model& CartesianSystem::model() const { return mechanism_->model; }
int CartesianSystem::coordinates() const { return 6 * mechanism_->moving(); }
int CartesianSystem::equations() const { return mechanism_->first.end; }
int CartesianSystem::loop_of(int equation) const { return mechanism_->first.loop_of[equation]; }

void CartesianSystem::set_inputs(const std::vector<double>& inputs) {
  mechanism_->inputs = inputs;
  mechanism_->refresh();
}

void CartesianSystem::set_parameters(const std::vector<double>& tunable_parameters) {
  std::size_t next = 0;
  for (std::size_t p = 0; p < mechanism_->parameters.size(); ++p)
    if (mechanism_->model.parameters[p].tunable) mechanism_->parameters[p] = tunable_parameters[next++];
  mechanism_->refresh();
}

namespace {

/// Mass, gravity and gyroscopic moment of every body.
void add_inertia(const Parts& parts, const std::vector<Moving>& bodies, CartesianTerms& terms) {
  for (Eigen::Index b = 0; b < parts.ground(); ++b) {
    const Part& part = parts.bodies[b];
    const Matrix3d inertia = bodies[b].axes * part.inertia * bodies[b].axes.transpose();
    terms.mass.block<3, 3>(6 * b, 6 * b).diagonal().setConstant(part.mass);
    terms.mass.block<3, 3>(6 * b + 3, 6 * b + 3) = 0.5 * (inertia + inertia.transpose());
    terms.force.segment<3>(6 * b) += part.mass * parts.gravity;
    terms.force.segment<3>(6 * b + 3) -= bodies[b].spin.cross(inertia * bodies[b].spin);
  }
}

void add_equations(const Parts& parts, const std::vector<Moving>& bodies, const std::vector<Row>& rows,
                   CartesianTerms& terms) {
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Row& row = rows[r];
    terms.residual[r] = row.residual;
    terms.bias[r] = row.bias;
    terms.velocity[r] = -row.rate;
    if (row.of_velocities) terms.late.push_back(static_cast<int>(r));
    const auto add = [&](Eigen::Index body, const Vector6d& columns) {
      if (body == parts.ground()) return;
      terms.jacobian.block<1, 6>(r, 6 * body) += columns.transpose();
      terms.velocity[r] += columns.head<3>().dot(bodies[body].velocity) + columns.tail<3>().dot(bodies[body].spin);
    };
    add(row.from, row.on_from);
    add(row.to, row.on_to);
    for (const auto& [body, block] : row.further) add(body, block);
  }
}

}  // namespace

CartesianTerms CartesianSystem::terms(const CartesianState& state, const GenericState& z,
                                      const std::vector<double>& tau) const {
  const CartesianMechanism& c = *mechanism_;
  const std::vector<Moving> bodies = c.bodies(state);
  const Values values = c.values(z, state.t);
  const int n = coordinates(), m = equations();
  CartesianTerms terms{Eigen::MatrixXd::Zero(n, n),
                       Eigen::VectorXd::Zero(n),
                       Eigen::MatrixXd::Zero(m, n),
                       Eigen::VectorXd::Zero(m),
                       Eigen::VectorXd::Zero(m),
                       Eigen::VectorXd::Zero(m),
                       {},
                       {},
                       {}};
  add_inertia(c.parts, bodies, terms);
  add_equations(c.parts, bodies, c.equations_at(bodies, values), terms);
  Forces forces = c.forces(bodies, state.x, values);
  const auto apply = [&](Eigen::Index body, const Vector6d& wrench) {
    if (body != c.moving()) terms.force.segment<6>(6 * body) += wrench;
  };
  for (const Load& load : forces.loads) apply(load.body, load.wrench);
  for (std::size_t j = 0; j < c.parts.joints.size(); ++j)
    for (const JointCoordinate& coordinate : c.coordinates_of(static_cast<int>(j), bodies, z.z)) {
      const double force = tau[coordinate.index] + forces.joints[coordinate.index];
      apply(coordinate.row.from, force * coordinate.row.on_from);
      apply(coordinate.row.to, force * coordinate.row.on_to);
    }
  terms.xd = std::move(forces.xd);
  terms.hold = std::move(forces.hold);
  return terms;
}

bool CartesianSystem::takes_reactions() const { return mbgen::takes_reactions(mechanism_->model); }

Status CartesianSystem::sample(CartesianState& state, const GenericState& z, const Eigen::VectorXd& qdd,
                               const Eigen::VectorXd& lambda, double h, bool& any) const {
  const std::vector<Moving> bodies = mechanism_->bodies(state);
  const Values values = mechanism_->values(z, state.t);
  if (takes_reactions())
    return mechanism_->sample(bodies, values, reaction_loads(state, z, lambda), observed(state, z, qdd, lambda), h, any,
                              state.x);
  const bool looks = !mechanism_->model.observed.empty();
  return mechanism_->sample(bodies, values, {},
                            looks ? mechanism_->forces(bodies, state.x, values).observed : std::vector<double>(), h,
                            any, state.x);
}

void CartesianSystem::set_friction_loads(const CartesianState& state, const Eigen::VectorXd& lambda,
                                         GenericState& z) const {
  const std::vector<double> loads = reaction_loads(state, z, lambda);
  const auto first = static_cast<std::size_t>(first_sampled_value(mechanism_->model));
  each_friction(mechanism_->model, [&](const FrictionLaw& friction) {
    if (friction.load < 0) return;
    const auto load = static_cast<std::size_t>(friction.load);
    z.x[first + load] = loads[load];
  });
}

}  // namespace mbgen
