// The stiffness of a model at rest, by differentiating its equations along the unknowns.

#include <algorithm>

#include "compiler/formulation/gradient.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "runtime/generic/balance.hpp"
#include "runtime/generic/rest_forces.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kAtOnce = 8;  // unknowns in one evaluation
using Slopes = Gradient<kAtOnce>;

/// Unknowns that are not pinned.
std::vector<Eigen::Index> loose_unknowns(const Balance& b, const Pinned& pinned, Eigen::Index unknowns) {
  std::vector<Eigen::Index> loose;
  for (Eigen::Index u = 0; u < unknowns; ++u)
    if (u < b.rz.cols() || !pinned[static_cast<std::size_t>(u - b.rz.cols())]) loose.push_back(u);
  return loose;
}

std::vector<Slopes> constants_of(const std::vector<double>& values) { return {values.begin(), values.end()}; }

/// The state in hand, to be differentiated along unknowns.
System<Slopes> system_along(const GenericEquations& equations, Annotator<Slopes>& annotator) {
  const System<double>& at = equations.at;
  System<Slopes> system{equations.model, equations.topology, equations.layout, {}, {}, {}, annotator};
  system.environment.topology = &equations.topology;
  system.environment.parameters = constants_of(at.environment.parameters);
  system.environment.inputs = constants_of(at.environment.inputs);
  system.environment.charts = constants_of(at.environment.charts);
  system.environment.t = at.environment.t;
  system.environment.z.assign(at.environment.z.size(), 0.0);
  system.environment.zd = system.environment.z;
  system.constants = make_constants(equations.model, equations.topology, system.environment);
  return system;
}

/// Derivatives of Balance::force along the unknowns that z and x of the system vary with: columns of `stiffness`.
void differentiate(System<Slopes>& system, const GenericEquations& equations, Eigen::Index first_column,
                   const std::vector<Eigen::Index>& loose, Eigen::MatrixXd& stiffness) {
  count_as_the_model(equations.model, system.environment);
  const RestForces<Slopes> rest = rest_forces(system, equations.analysis);
  const auto count =
      std::min(static_cast<Eigen::Index>(kAtOnce), static_cast<Eigen::Index>(loose.size()) - first_column);
  const auto set = [&](Eigen::Index row, const Slopes& force) {
    for (Eigen::Index i = 0; i < count; ++i)
      stiffness(row, loose[static_cast<std::size_t>(first_column + i)]) = force.slope[static_cast<std::size_t>(i)];
  };
  Eigen::Index row = 0;
  for (std::size_t g = 0; g < rest.directions.size(); ++g) {
    const std::vector<std::vector<Slopes>>& rz = rest.directions[g].rz;
    for (std::size_t q = 0; q < rz[0].size(); ++q, ++row) {
      Slopes force;
      for (std::size_t c = 0; c < rz.size(); ++c)
        force = force + rz[c][q] * rest.tree[static_cast<std::size_t>(equations.topology.groups[g].joints[c])];
      set(row, force);
    }
  }
  for (std::size_t i = static_cast<std::size_t>(slip_state_count(equations.model)); row < stiffness.rows(); ++i, ++row)
    set(row, rest.applied.xd[i] * Slopes(1 / equations.magnitudes[i]));
}

}  // namespace

Eigen::MatrixXd stiffness_by_slopes(GenericEquations& equations, const GenericState& state, const Balance& b,
                                    const Pinned& pinned) {
  equations.system(state);
  Annotator<Slopes> annotator;
  System<Slopes> system = system_along(equations, annotator);
  const Eigen::Index unknowns = unknowns_of(equations, b);
  const std::vector<Eigen::Index> loose = loose_unknowns(b, pinned, unknowns);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(b.force.size(), unknowns);
  for (std::size_t first = 0; first < loose.size(); first += kAtOnce) {
    system.environment.z = constants_of(state.z);
    system.environment.zd.assign(state.z.size(), 0.0);
    system.x = constants_of(state.x);
    for (std::size_t i = 0; i < std::min(kAtOnce, loose.size() - first); ++i) {
      const Eigen::Index u = loose[first + i];
      if (u < b.rz.cols()) {
        for (std::size_t c = 0; c < state.z.size(); ++c)
          system.environment.z[c].slope[i] = b.rz(static_cast<Eigen::Index>(c), u);
      } else {
        const auto x = static_cast<std::size_t>(u - b.rz.cols());
        system.x[x].slope[i] = equations.magnitudes[x];
      }
    }
    differentiate(system, equations, static_cast<Eigen::Index>(first), loose, stiffness);
  }
  return stiffness;
}

}  // namespace mbgen
