#include "compiler/analysis/configuration.hpp"

#include <algorithm>
#include <limits>

#include "compiler/algebra/dense.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/solver/newton.hpp"

namespace mbgen {
namespace {

constexpr double kLeastDamping = 1e-14;
/// Share of the largest singular value below which a row of velocities alone repeats rows of positions, also where
/// those are open: it would ask for a long way.
constexpr double kRepeats = 0.01;

Environment<double> default_environment(const Model& model, const Topology& topology) {
  Environment<double> e;
  e.topology = &topology;
  for (const Parameter& p : model.parameters) e.parameters.push_back(p.value);
  for (const Input& input : model.inputs) e.inputs.push_back(input.default_value);
  e.z.assign(topology.bodies.size(), 0.0);
  e.zd.assign(topology.bodies.size(), 0.0);
  return e;
}

double largest(const Eigen::VectorXd& v) {
  if (!v.allFinite()) return std::numeric_limits<double>::infinity();
  return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff();
}

}  // namespace

NumericSystem::NumericSystem(const Model& model, const Topology& topology)
    : layout_(choose_layout(model, topology)), system_{model, topology, layout_,   default_environment(model, topology),
                                                       {},    {},       annotator_} {
  system_.x.assign(static_cast<std::size_t>(auxiliary_state_count(model)), 0.0);
  system_.constants = make_constants(model, topology, system_.environment, Origins::of_joints);
  for (const LoopBlock& block : topology.blocks) velocity_rows_.push_back(mbgen::velocity_rows(model, topology, block));
}

System<double>& NumericSystem::at(const std::vector<double>& z) {
  system_.environment.z = z;
  return system_;
}

Vector<double> NumericSystem::reference_position(const Attachment& at) const {
  return mbgen::reference_position(system_.model, at.body, system_.model.bodies[at.body].points[at.point].position,
                                   system_.environment);
}

Eigen::MatrixXd BlockSample::part(const std::vector<int>& rows, const std::vector<int>& columns) const {
  if (sparse.empty()) return jacobian(rows, columns);
  Eigen::MatrixXd result(rows.size(), columns.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c) result(r, c) = sparse[rows[r]].at(columns[c]);
  return result;
}

Eigen::VectorXd residual_left(const Configuration& configuration, std::size_t b) {
  const BlockSample& block = configuration.blocks[b];
  const Eigen::VectorXd& correction = configuration.corrections[b];
  if (block.sparse.empty()) return configuration.residuals[b] + block.jacobian * correction;
  Eigen::VectorXd left = configuration.residuals[b];
  for (std::size_t r = 0; r < block.sparse.size(); ++r)
    for (std::size_t i = 0; i < block.sparse[r].columns.size(); ++i)
      left[static_cast<Eigen::Index>(r)] += block.sparse[r].values[i] * correction[block.sparse[r].columns[i]];
  return left;
}

void evaluate_closures(NumericSystem& numbers, Configuration& configuration) {
  evaluate_closures(numbers, configuration, std::vector<bool>(numbers.topology().blocks.size(), true));
}

void evaluate_closures(NumericSystem& numbers, Configuration& configuration, const std::vector<bool>& moved) {
  System<double>& system = numbers.at(configuration.z);
  const Kinematics<double> k = kinematics(system);
  const RelativeMotion<double> rest = at_rest<double>(system.topology);
  configuration.blocks.resize(moved.size());
  configuration.residuals.resize(moved.size());
  for (std::size_t b = 0; b < moved.size(); ++b) {
    if (!moved[b]) continue;
    const LoopBlock& block = system.topology.blocks[b];
    SparseClosure<double> closed = sparse_closure(system, k, block, rest);
    BlockSample sample;
    if (is_large(block)) {
      sample.sparse = std::move(closed.jacobian);
    } else {
      sample.jacobian = Eigen::MatrixXd::Zero(block.equations, static_cast<Eigen::Index>(block.joints.size()));
      for (int e = 0; e < block.equations; ++e)
        for (std::size_t i = 0; i < closed.jacobian[e].columns.size(); ++i)
          sample.jacobian(e, closed.jacobian[e].columns[i]) = closed.jacobian[e].values[i];
    }
    configuration.blocks[b] = std::move(sample);
    configuration.residuals[b] = Eigen::Map<const Eigen::VectorXd>(closed.residual.data(), block.equations);
  }
}

namespace {

Eigen::VectorXd to_eigen(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Newton step of a large block towards its chosen equations; coordinates without pivot stay. late: of velocities
/// alone.
Eigen::VectorXd sparse_newton_step(const SparseRows& jacobian, const Eigen::VectorXd& residual, std::size_t coordinates,
                                   const std::vector<int>& equations, const std::vector<int>& late) {
  LoopPartition partition;
  partition.pivots = eliminate({&jacobian}, equations, std::vector<bool>(coordinates, false), late).pivots;
  std::vector<double> open(residual.size());
  for (Eigen::Index e = 0; e < residual.size(); ++e) open[e] = -residual[e];
  return to_eigen(solve_frozen(factorise_frozen(jacobian, partition, coordinates), partition, open, coordinates));
}

/// Least-squares Newton step of one block towards its chosen equations. Rows of velocities alone are never open; where
/// they repeat rows of positions, they would hold those back.
Eigen::VectorXd newton_step(const NumericSystem& numbers, const Configuration& configuration, std::size_t b,
                            const std::vector<int>& equations, Newton newton) {
  const auto coordinates = static_cast<Eigen::Index>(numbers.topology().blocks[b].joints.size());
  const std::vector<int>& late = numbers.velocity_rows(b);
  const BlockSample& block = configuration.blocks[b];
  const Eigen::VectorXd& residual = configuration.residuals[b];
  if (equations.empty() || !residual.allFinite()) return Eigen::VectorXd::Zero(coordinates);
  if (!block.sparse.empty()) return sparse_newton_step(block.sparse, residual, coordinates, equations, late);
  std::vector<int> of_positions, of_velocities;
  for (const int e : equations)
    (std::binary_search(late.begin(), late.end(), e) ? of_velocities : of_positions).push_back(e);
  const Eigen::MatrixXd jacobian = block.jacobian(of_positions, Eigen::all);
  const Eigen::VectorXd open = residual(of_positions);
  if (newton == Newton::damped) {
    Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += std::max(open.norm(), kLeastDamping);
    return solved(normal, -jacobian.transpose() * open);
  }
  if (of_positions.empty()) return Eigen::VectorXd::Zero(coordinates);
  Eigen::VectorXd step = least_squares(jacobian, -open, kIndifferentShare);
  if (of_velocities.empty()) return step;
  const Eigen::MatrixXd free = indifferent_directions(jacobian, kIndifferentShare);
  if (free.cols() == 0) return step;
  const Eigen::MatrixXd rolling = block.jacobian(of_velocities, Eigen::all);
  return step + free * least_squares(rolling * free, -rolling * step, kRepeats);
}

}  // namespace

Configuration close_equations(NumericSystem& numbers, std::vector<double> start,
                              const std::vector<std::vector<int>>& equations, Newton newton) {
  Configuration configuration;
  configuration.z = std::move(start);
  const Topology& topology = numbers.topology();
  const auto open = [&](std::size_t b) { return largest(configuration.residuals[b](equations[b])); };
  std::vector<bool> moved(topology.blocks.size(), true);
  for (int step = 0;; ++step) {
    evaluate_closures(numbers, configuration, moved);
    moved.assign(moved.size(), false);
    bool done = true;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) done = done && open(b) < kClosedForRank;
    if (done || step == kSearchIterations) break;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
      if (const double here = open(b); here < kClosedForRank * 1e-3 || !std::isfinite(here)) continue;
      moved[b] = true;
      Eigen::VectorXd correction = newton_step(numbers, configuration, b, equations[b], newton);
      correction *= shortening(largest(correction), kLargestSearchStep);
      for (std::size_t c = 0; c < topology.blocks[b].joints.size(); ++c)
        configuration.z[topology.blocks[b].joints[c]] += correction[c];
    }
  }
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    configuration.closed.push_back(open(b) < kClosedForRank);
    configuration.corrections.push_back(newton_step(numbers, configuration, b, equations[b], newton));
  }
  return configuration;
}

}  // namespace mbgen
