#pragma once
// States in the layout of the table in mbgen/driver.hpp.

#include <cstddef>
#include <vector>

#include "mbgen/driver.hpp"
#include "runtime/state/state.hpp"

namespace mbgen::testing {

/// z, zd, x, t and the balls' charts; those that the state does not tell are 0.
inline std::vector<double> flat(const SolverTable& table, const GenericState& state) {
  std::vector<double> values;
  for (const std::vector<double>* part : {&state.z, &state.zd, &state.x})
    values.insert(values.end(), part->begin(), part->end());
  values.push_back(state.t);
  values.insert(values.end(), state.charts.begin(), state.charts.end());
  values.resize(static_cast<std::size_t>(table.state_size), 0.0);
  return values;
}

inline GenericState unflat(const SolverTable& table, const std::vector<double>& values) {
  const auto z = values.begin(), zd = z + table.coordinates, x = zd + table.coordinates, t = x + table.auxiliary_states;
  return {{z, zd}, {zd, x}, {x, t}, *t, {t + 1, values.end()}};
}

}  // namespace mbgen::testing
