#include "compiler/analysis/sampling.hpp"

#include <random>

namespace mbgen {
namespace {

constexpr double kClosed = 1e-11;  // m or 1: Newton reaches it in a few steps from a good start
constexpr int kMostSteps = 40;
constexpr double kLongestStep = 0.3;  // rad or m per Newton step and coordinate

Environment<double> default_environment(const Model& model, const Topology& topology) {
  Environment<double> e;
  e.topology = &topology;
  for (const Parameter& p : model.parameters) e.parameters.push_back(p.value);
  for (const Input& input : model.inputs) e.inputs.push_back(input.default_value);
  e.z.assign(topology.bodies.size(), 0.0);
  e.zd.assign(topology.bodies.size(), 0.0);
  return e;
}

double largest(const Eigen::VectorXd& v) { return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff(); }

}  // namespace

NumericSystem::NumericSystem(const Model& model, const Topology& topology)
    : layout_(choose_layout(model, topology)), system_{model, topology, layout_, default_environment(model, topology),
                                                       {},    {},       scribe_} {
  system_.x.assign(2 * model.tyres.size(), 0.0);
  system_.constants = make_constants(model, topology, system_.environment);
}

System<double>& NumericSystem::at(const std::vector<double>& z) {
  system_.environment.z = z;
  return system_;
}

void evaluate_closures(NumericSystem& numbers, Configuration& configuration) {
  System<double>& system = numbers.at(configuration.z);
  const Kinematics<double> k = kinematics(system);
  const RelativeMotion<double> rest = at_rest<double>(system.topology);
  configuration.blocks.clear();
  configuration.residuals.clear();
  for (const LoopBlock& block : system.topology.blocks) {
    const BlockClosure<double> closed = closure(system, k, block, rest);
    BlockSample sample{Eigen::MatrixXd(block.equations, block.joints.size())};
    for (int e = 0; e < block.equations; ++e)
      for (std::size_t c = 0; c < block.joints.size(); ++c) sample.jacobian(e, c) = closed.jacobian[e][c];
    configuration.blocks.push_back(std::move(sample));
    configuration.residuals.push_back(Eigen::Map<const Eigen::VectorXd>(closed.residual.data(), block.equations));
  }
}

Configuration close_from(NumericSystem& numbers, std::vector<double> start) {
  Configuration configuration;
  configuration.z = std::move(start);
  const Topology& topology = numbers.at(configuration.z).topology;
  for (int step = 0;; ++step) {
    evaluate_closures(numbers, configuration);
    bool done = true;
    for (const Eigen::VectorXd& residual : configuration.residuals) done = done && largest(residual) < kClosed;
    if (done || step == kMostSteps) break;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
      const Eigen::VectorXd& residual = configuration.residuals[b];
      if (largest(residual) < kClosed * 1e-3 || !residual.allFinite()) continue;
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
      factors.setThreshold(1e-9);
      factors.compute(configuration.blocks[b].jacobian);
      Eigen::VectorXd correction = factors.solve(-residual);
      if (const double length = largest(correction); length > kLongestStep) correction *= kLongestStep / length;
      for (std::size_t c = 0; c < topology.blocks[b].joints.size(); ++c)
        configuration.z[topology.blocks[b].joints[c]] += correction[c];
    }
  }
  for (const Eigen::VectorXd& residual : configuration.residuals)
    configuration.closed.push_back(largest(residual) < kClosed);
  return configuration;
}

std::vector<Configuration> closed_configurations(NumericSystem& numbers, int wanted) {
  const std::vector<double> reference(numbers.at({}).topology.bodies.size(), 0.0);
  const Topology& topology = numbers.at(reference).topology;
  std::vector<Configuration> found{close_from(numbers, reference)};
  std::mt19937_64 random(20120401);  // fixed: two runs decide alike
  const double distances[] = {0.05, 0.2, 0.5, 1.0, 2.0};
  for (int attempt = 0; attempt < 2 * wanted && static_cast<int>(found.size()) <= wanted; ++attempt) {
    std::vector<double> start = reference;
    for (int i = 0; i < topology.size(); ++i) {
      const double unit = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
      const double reach = topology.bodies[i].kind == FreedomKind::revolute ? 1.0 : 0.2;
      start[i] = unit * reach * distances[attempt % 5];
    }
    Configuration configuration = close_from(numbers, std::move(start));
    const bool any =
        std::find(configuration.closed.begin(), configuration.closed.end(), true) != configuration.closed.end();
    if (any || topology.blocks.empty()) found.push_back(std::move(configuration));
  }
  return found;
}

}  // namespace mbgen
