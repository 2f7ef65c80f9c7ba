#include "compiler/program/rounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/program/arithmetic.hpp"

namespace mbgen {

std::vector<Rounded> rounded_values(const Program& program, std::span<const double> inputs) {
  constexpr double kUnit = std::numeric_limits<double>::epsilon();
  std::vector<Rounded> all(program.nodes.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    const Node& node = program.nodes[v];
    if (node.op == Op::input) {
      all[v].value = inputs[static_cast<std::size_t>(node.input)];
      continue;
    }
    double operands[3] = {0, 0, 0};
    const auto result = [&] {
      if (node.op == Op::constant) return node.constant;
      return node.op == Op::sample ? sample_of(*program.samples, operands[0])
                                   : apply(node.op, operands[0], operands[1], operands[2]);
    };
    for (int k = 0; k < arity(node.op); ++k) operands[k] = all[node.operands[k]].value;
    const double value = result();
    double error = kUnit * std::abs(value);
    for (int k = 0; k < arity(node.op); ++k) {
      const auto [exact, off] = all[node.operands[k]];
      double moved = 0;
      for (const double there : {exact - off, exact + off}) {
        operands[k] = there;
        moved = std::max(moved, std::abs(result() - value));
      }
      operands[k] = exact;
      error += moved;
    }
    all[v] = {value, error};
  }
  return all;
}

}  // namespace mbgen
