#include "compiler/analysis/sampling.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "compiler/analysis/freedom_walk.hpp"

namespace mbgen {

std::vector<Configuration> closed_configurations(NumericSystem& numbers, int wanted) {
  const Topology& topology = numbers.topology();
  const std::vector<double> reference(topology.bodies.size(), 0.0);
  std::vector<std::vector<int>> equations;
  for (const LoopBlock& block : topology.blocks) {
    equations.emplace_back(block.equations);
    std::iota(equations.back().begin(), equations.back().end(), 0);
  }
  std::vector<Configuration> found{close_equations(numbers, reference, equations)};
  std::vector<FreedomWalk> walks = start_walks(numbers, found[0], equations);
  std::mt19937_64 random(20120401);  // fixed: two runs decide alike
  const double distances[] = {0.05, 0.2, 0.5, 1.0, 2.0};
  for (int attempt = 0; attempt < 2 * wanted && static_cast<int>(found.size()) <= wanted; ++attempt) {
    std::vector<double> start = reference;
    for (int i = 0; i < topology.size(); ++i) {
      const double unit = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
      const double reach = topology.bodies[i].kind == FreedomKind::revolute ? 1.0 : 0.2;
      start[i] = unit * reach * distances[attempt % 5];
    }
    for (FreedomWalk& walk : walks) put_next_position(topology, found, attempt, walk, start);
    Configuration configuration = close_equations(numbers, std::move(start), equations);
    const bool any =
        std::find(configuration.closed.begin(), configuration.closed.end(), true) != configuration.closed.end();
    if (any || topology.blocks.empty()) found.push_back(std::move(configuration));
  }
  return found;
}

}  // namespace mbgen
