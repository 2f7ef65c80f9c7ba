#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// A program that is being extended by derivatives of its values.
struct Derivation {
  const Program& source;
  ProgramBuilder builder;
  std::vector<ValueId> value;  ///< per node of `source`: the same value in `builder`

  explicit Derivation(const Program& program) : source(program), builder(ProgramBuilder::like(program)) {
    value.reserve(program.nodes.size());
    for (const Node& node : program.nodes) value.push_back(builder.copy(program, node, value));
  }
};

// d(sqrt x) = dx / (2 sqrt x)    d(sin x) = cos x dx            d(cos x) = -sin x dx
// d(tan x)  = (1 + tan^2 x) dx   d(asin x) = dx / sqrt(1 - x^2)  d(acos x) = -d(asin x)
// d(atan x) = dx / (1 + x^2)     d(exp x) = exp x dx            d(log x) = dx / x
// d(tanh x) = (1 - tanh^2 x) dx  d|x| = select(x, dx, -dx)      d(-x) = -dx
// floor and sample are constant between their jumps
Expr derive_unary(Op op, const Expr& x, const Expr& dx, const Expr& result) {
  switch (op) {
    case Op::negate:
      return -dx;
    case Op::sqrt:
      return 0.5 * dx / result;
    case Op::sin:
      return cos(x) * dx;
    case Op::cos:
      return -(sin(x) * dx);
    case Op::tan:
      return (1 + result * result) * dx;
    case Op::asin:
      return dx / sqrt(1 - x * x);
    case Op::acos:
      return -(dx / sqrt(1 - x * x));
    case Op::atan:
      return dx / (1 + x * x);
    case Op::exp:
      return result * dx;
    case Op::log:
      return dx / x;
    case Op::tanh:
      return (1 - result * result) * dx;
    case Op::abs:
      return select(x, dx, -dx);
    case Op::floor:
    case Op::sample:
      return 0.0;
    default:
      throw std::logic_error(fmt::format("no derivative of {}", op_name(op)));
  }
}

// d(x^y) = y x^(y-1) dx + x^y log x dy, each term only where its factor varies: x <= 0 is sound for a constant exponent
Expr derive_power(const Expr& x, const Expr& dx, const Expr& y, const Expr& dy, const Expr& result) {
  const auto vanishes = [](const Expr& a) { return a.is_constant() && a.constant() == 0; };
  Expr sum = 0.0;
  if (!vanishes(dx)) sum += y * pow(x, y - 1) * dx;
  if (!vanishes(dy)) sum += result * log(x) * dy;
  return sum;
}

// d(x + y) = dx + dy             d(x - y) = dx - dy              d(x y) = dx y + x dy
// d(x / y) = (dx - (x/y) dy) / y  d(atan2(y, x)) = (x dy - y dx) / (x^2 + y^2)
// d(min(x, y)) = select(y - x, dx, dy)                           d(max(x, y)) = select(x - y, dx, dy)
Expr derive_binary(Op op, const Expr& x, const Expr& dx, const Expr& y, const Expr& dy, const Expr& result) {
  switch (op) {
    case Op::add:
      return dx + dy;
    case Op::subtract:
      return dx - dy;
    case Op::multiply:
      return dx * y + x * dy;
    case Op::divide:
      return (dx - result * dy) / y;
    case Op::pow:
      return derive_power(x, dx, y, dy, result);
    case Op::atan2:
      return (y * dx - x * dy) / (x * x + y * y);
    case Op::min:
      return select(y - x, dx, dy);
    case Op::max:
      return select(x - y, dx, dy);
    default:
      throw std::logic_error(fmt::format("no derivative of {}", op_name(op)));
  }
}

/// Derivative of one value; `derivatives` holds the derivatives of all earlier values.
Expr derive(Derivation& derivation, std::size_t index, const std::vector<Expr>& derivatives) {
  const Node& node = derivation.source.nodes[index];
  Expr operand[3], derivative[3];
  bool varies = false;
  for (int i = 0; i < arity(node.op); ++i) {
    operand[i] = Expr(derivation.builder, derivation.value[node.operands[i]]);
    derivative[i] = derivatives[node.operands[i]];
    varies = varies || !derivative[i].is_constant() || derivative[i].constant() != 0;
  }
  if (!varies) return 0.0;
  derivation.builder.set_origin(node);
  const Expr result(derivation.builder, derivation.value[index]);
  // d(select(c, x, y)) = select(c, dx, dy)
  if (node.op == Op::select) return select(operand[0], derivative[1], derivative[2]);
  // d(x y + z) = dx y + x dy + dz and its like
  if (node.op == Op::multiply_add) return derivative[0] * operand[1] + operand[0] * derivative[1] + derivative[2];
  if (node.op == Op::multiply_subtract) return derivative[0] * operand[1] + operand[0] * derivative[1] - derivative[2];
  if (node.op == Op::subtract_product) {
    return derivative[0] - (derivative[1] * operand[2] + operand[1] * derivative[2]);
  }
  if (arity(node.op) == 1) return derive_unary(node.op, operand[0], derivative[0], result);
  return derive_binary(node.op, operand[0], derivative[0], operand[1], derivative[1], result);
}

/// Derivatives of all values. seeds: one per input of the source.
std::vector<Expr> derive_all(Derivation& derivation, const std::vector<Expr>& seeds) {
  const std::vector<Node>& nodes = derivation.source.nodes;
  std::vector<Expr> derivatives(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].op == Op::input) {
      derivatives[i] = seeds[static_cast<std::size_t>(nodes[i].input)];
    } else if (nodes[i].op != Op::constant) {
      derivatives[i] = derive(derivation, i, derivatives);
    }
  }
  return derivatives;
}

}  // namespace

std::vector<int> seeds_of(const Program& program, std::span<const DirectionGroup> groups) {
  std::vector<int> seeds;
  for (const Slot& slot : program.inputs) {
    int first = 0, seed = -1;
    for (const DirectionGroup& group : groups) {
      if (group.group == slot.group) seed = first + slot.index;
      first += group.size;
    }
    seeds.push_back(seed);
  }
  return seeds;
}

Program differentiate(const Program& program, std::span<const int> seed_of_input) {
  if (seed_of_input.size() != program.inputs.size()) {
    throw std::invalid_argument(fmt::format("program {} has {} inputs, {} seeds given", program.name,
                                            program.inputs.size(), seed_of_input.size()));
  }
  Derivation derivation(program);
  std::vector<Expr> seeds;
  for (const int seed : seed_of_input) {
    seeds.push_back(seed < 0 ? Expr(0.0) : Expr(derivation.builder, derivation.builder.input(Array::seed, seed)));
  }
  const std::vector<Expr> derivatives = derive_all(derivation, seeds);
  std::set<Slot> taken;
  for (const auto& [slot, value] : program.outputs) {
    derivation.builder.output(slot.group, slot.index, derivation.value[value]);
    taken.insert(slot);
  }
  for (const auto& [slot, value] : program.outputs) {
    const Slot derivative = {derivative_of(slot.group), slot.index};
    if (taken.contains(derivative)) continue;
    derivation.builder.output(derivative.group, derivative.index, derivatives[value].value(derivation.builder));
  }
  return derivation.builder.finish_in_canonical_order();
}

}  // namespace mbgen
