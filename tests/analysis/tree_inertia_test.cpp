// Inertias of a tree body by body, against the pivots of its mass matrix.

#include "compiler/analysis/tree_inertia.hpp"

#include "compiler/formulation/loop_solution.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

TEST(TreeInertia, PivotsAreThoseOfTheMassMatrix) {
  for (const char* path : {"tests/data/models/chain_7.json", "tests/data/models/skew_tree.json"}) {
    const Mechanism m = load(path);
    ASSERT_TRUE(m.topology.blocks.empty()) << path;
    NumericSystem numbers(m.model, m.topology);
    std::vector<double> z;
    for (int i = 0; i < m.topology.size(); ++i) z.push_back(0.3 + 0.1 * i);
    System<double>& system = numbers.at(z);
    const Kinematics<double> k = kinematics(system);
    const ReducedSystem<double> reduced = reduced_system(
        system, k, inertias(system, k), frozen_directions(system, k, m.analysis.blocks, m.analysis.driven),
        std::vector<double>(z.size(), 0.0));
    const std::vector<double> inertia = solve_reduced(system, reduced).inertia;
    const std::vector<int> names = free_coordinates(m.topology, m.analysis);
    const auto is_above = [&](double share, std::size_t of) {
      std::vector<double> rounding(z.size(), 0.0);
      rounding[names[of]] = share * inertia[of];
      return tree_has_inertia(m.topology, system.constants, m.analysis.driven, z, rounding);
    };
    for (std::size_t q = 0; q < names.size(); ++q) {
      EXPECT_TRUE(is_above(1 - 1e-9, q)) << path << " " << q;
      EXPECT_FALSE(is_above(1 + 1e-9, q)) << path << " " << q;
    }
  }
}

}  // namespace
}  // namespace mbgen
