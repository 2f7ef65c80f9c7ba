#include "workbench/report/table_states.hpp"

#include <string>

#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {

std::vector<GenericState> table_states(const ReportSource& source, const std::vector<std::size_t>& rows) {
  std::vector<int> positions, velocities, auxiliary;
  for (const TreeBody& body : source.topology.bodies) {
    positions.push_back(find_column(source.results, "z." + body.coordinate));
    velocities.push_back(find_column(source.results, "zd." + body.coordinate));
  }
  for (const std::string& name : auxiliary_state_names(source.model))
    auxiliary.push_back(find_column(source.results, "x." + name));
  const std::vector<double> zeros(positions.size());
  std::vector<GenericState> states;
  for (const std::size_t row : rows) {
    GenericState& state = states.emplace_back(GenericState{zeros, zeros, initial_auxiliary_states(source.model), 0});
    const auto take = [&](const std::vector<int>& columns, std::vector<double>& values) {
      for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i] >= 0) values[i] = source.results.columns[static_cast<std::size_t>(columns[i])].values[row];
    };
    take(positions, state.z);
    take(velocities, state.zd);
    take(auxiliary, state.x);
    state.t = source.results.columns.front().values[row];
  }
  return states;
}

}  // namespace mbgen
