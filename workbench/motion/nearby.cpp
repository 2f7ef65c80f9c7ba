#include "workbench/motion/nearby.hpp"

#include <algorithm>

#include "compiler/model/auxiliary_states.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {
namespace {

constexpr double kDifference = 1e-6;  // rad, m or per second

/// Positions and rates near a state, along the free directions of the loops. An engine closes loops by a choice of
/// coordinates of its own: only accelerations are asked of it.
struct Nearby {
  const Engine& engine;
  GenericSolver closing;
  std::vector<int> free;
  std::vector<AuxiliaryState> auxiliary;  ///< counted in parts of their magnitudes

  Nearby(const Compilation& c, const Engine& of, const std::vector<double>& inputs)
      : engine(of),
        closing(c.model, c.topology, c.analysis),
        free(free_coordinates(c.topology, c.analysis)),
        auxiliary(auxiliary_states(c.model)) {
    closing.set_inputs(inputs);
    engine.set_inputs(inputs);
  }

  Eigen::Index states(const GenericState& state) const {
    return static_cast<Eigen::Index>(2 * free.size() + state.x.size());
  }

  /// Rates of the states and all positions after a change of state j.
  bool moved(const GenericState& state, Eigen::Index j, double change, Eigen::VectorXd& rates,
             Eigen::VectorXd& positions) const {
    const auto count = static_cast<Eigen::Index>(free.size());
    LoadedState loaded{state, std::vector<double>(state.z.size(), 0.0)};
    GenericState& at = loaded.state;
    if (j < 2 * count) {
      (j < count ? at.z : at.zd)[free[static_cast<std::size_t>(j % count)]] += change;
    } else {
      const auto i = static_cast<std::size_t>(j - 2 * count);
      at.x[i] += change * magnitude_of(auxiliary[i]);
    }
    if (!closing.project(at).ok()) return false;
    GenericDerivative derivative;
    if (!engine.accelerations(loaded, derivative).ok()) return false;
    rates.resize(states(state));
    for (Eigen::Index i = 0; i < count; ++i) {
      rates[i] = at.zd[free[static_cast<std::size_t>(i)]];
      rates[count + i] = derivative.zdd[free[static_cast<std::size_t>(i)]];
    }
    for (std::size_t i = 0; i < derivative.xd.size(); ++i) {
      rates[2 * count + static_cast<Eigen::Index>(i)] = derivative.xd[i] / magnitude_of(auxiliary[i]);
    }
    positions = Eigen::Map<const Eigen::VectorXd>(at.z.data(), static_cast<Eigen::Index>(at.z.size()));
    return rates.allFinite();
  }
};

}  // namespace

LinearSystem system_near(const Compilation& compilation, const Engine& engine, const GenericState& state,
                         const std::vector<double>& inputs) {
  if (rolling_loop(compilation.topology)) return {};  // more positions are free than these coordinates tell
  const std::size_t free = free_coordinates(compilation.topology, compilation.analysis).size();
  if (2 * free + state.x.size() > kMostStatesForModes) return {};
  const Nearby nearby(compilation, engine, inputs);
  LinearSystem system;
  const Eigen::Index size = nearby.states(state);
  system.A.resize(size, size);
  system.coordinates.resize(static_cast<Eigen::Index>(state.z.size()), size);
  Eigen::VectorXd ahead, behind, positions_ahead, positions_behind;
  for (Eigen::Index j = 0; j < size; ++j) {
    if (!nearby.moved(state, j, kDifference, ahead, positions_ahead)) return {};
    if (!nearby.moved(state, j, -kDifference, behind, positions_behind)) return {};
    system.A.col(j) = (ahead - behind) / (2 * kDifference);
    system.coordinates.col(j) = (positions_ahead - positions_behind) / (2 * kDifference);
  }
  for (const auto kind : {LinearState::Kind::position, LinearState::Kind::velocity})
    for (const int i : nearby.free) system.states.push_back({kind, i});
  for (int i = 0; i < static_cast<int>(state.x.size()); ++i) system.states.push_back({LinearState::Kind::auxiliary, i});
  return system;
}

std::vector<Mode> modes_near(const Compilation& compilation, const GenericState& state,
                             const std::vector<double>& inputs) {
  return modes(system_near(compilation, make_generic_engine(compilation, {}), state, inputs));
}

std::vector<double> deviations_from(const Compilation& compilation, const GenericState& from, const GenericState& to) {
  std::vector<double> result;
  const std::vector<int> free = free_coordinates(compilation.topology, compilation.analysis);
  for (const int i : free) result.push_back(to.z[i] - from.z[i]);
  for (const int i : free) result.push_back(to.zd[i] - from.zd[i]);
  const std::vector<AuxiliaryState> auxiliary = auxiliary_states(compilation.model);
  for (std::size_t i = 0; i < to.x.size(); ++i) result.push_back((to.x[i] - from.x[i]) / magnitude_of(auxiliary[i]));
  return result;
}

}  // namespace mbgen
