#include "compiler/program/rules.hpp"

#include <cmath>
#include <utility>

#include "compiler/program/arithmetic.hpp"

namespace mbgen {
namespace {

/// A value of the form -x; a negative constant is one too, so that c and -c share.
bool is_negation(const ProgramBuilder& builder, ValueId value) {
  const Node& node = builder.node(value);
  return node.op == Op::negate || (node.op == Op::constant && node.constant < 0);
}

/// x of the value -x.
ValueId negated(ProgramBuilder& builder, ValueId negation) {
  const Node& node = builder.node(negation);
  return node.op == Op::negate ? node.operands[0] : builder.constant(-node.constant, node.label);
}

// 0 + x    -> x
// x + (-y) -> x - y
// (-x) + y -> y - x
ValueId simplify_add(ProgramBuilder& builder, ValueId x, ValueId y) {
  if (builder.is_constant(x, 0)) return y;
  if (is_negation(builder, y)) return builder.append(Op::subtract, x, negated(builder, y));
  if (is_negation(builder, x)) return builder.append(Op::subtract, y, negated(builder, x));
  return kNoValue;
}

// x - 0    -> x
// 0 - x    -> -x
// x - x    -> 0
// x - (-y) -> x + y
// (-x) - y -> -(x + y)
ValueId simplify_subtract(ProgramBuilder& builder, ValueId x, ValueId y) {
  if (builder.is_constant(y, 0)) return x;
  if (builder.is_constant(x, 0)) return builder.append(Op::negate, y);
  if (x == y) return builder.constant(0);
  if (is_negation(builder, y)) return builder.append(Op::add, x, negated(builder, y));
  if (is_negation(builder, x)) return builder.append(Op::negate, builder.append(Op::add, negated(builder, x), y));
  return kNoValue;
}

// (-x) o (-y) -> x o y
// (-x) o y    -> -(x o y)
// x o (-y)    -> -(x o y)      o is * or /
ValueId pull_out_signs(ProgramBuilder& builder, Op op, ValueId x, ValueId y) {
  const bool negative_x = is_negation(builder, x), negative_y = is_negation(builder, y);
  if (!negative_x && !negative_y) return kNoValue;
  const ValueId result = builder.append(op, negative_x ? negated(builder, x) : x, negative_y ? negated(builder, y) : y);
  return negative_x == negative_y ? result : builder.append(Op::negate, result);
}

// 0 * x  -> 0
// 1 * x  -> x
// -1 * x -> -x
ValueId simplify_multiply(ProgramBuilder& builder, ValueId x, ValueId y) {
  if (builder.is_constant(x, 0)) return x;
  if (builder.is_constant(x, 1)) return y;
  if (builder.is_constant(x, -1)) return builder.append(Op::negate, y);
  return pull_out_signs(builder, Op::multiply, x, y);
}

/// 1/value has no rounding: value is a power of two and its reciprocal neither overflows nor is subnormal.
bool has_exact_reciprocal(double value) {
  int exponent = 0;
  return std::abs(std::frexp(value, &exponent)) == 0.5 && std::isnormal(value) && std::isnormal(1 / value);
}

// 0 / x  -> 0
// x / 1  -> x
// x / -1 -> -x
// x / c  -> x * (1/c)      c a constant with an exact reciprocal
ValueId simplify_divide(ProgramBuilder& builder, ValueId x, ValueId y) {
  if (builder.is_constant(x, 0)) return x;
  if (builder.is_constant(y, 1)) return x;
  if (builder.is_constant(y, -1)) return builder.append(Op::negate, x);
  if (builder.is_constant(y) && has_exact_reciprocal(builder.node(y).constant)) {
    return builder.append(Op::multiply, x, builder.constant(1 / builder.node(y).constant));
  }
  return pull_out_signs(builder, Op::divide, x, y);
}

// pow(x, 0) -> 1
// pow(x, 1) -> x
// pow(x, 2) -> x * x
ValueId simplify_power(ProgramBuilder& builder, ValueId x, ValueId exponent) {
  if (builder.is_constant(exponent, 0)) return builder.constant(1);
  if (builder.is_constant(exponent, 1)) return x;
  if (builder.is_constant(exponent, 2)) return builder.append(Op::multiply, x, x);
  return kNoValue;
}

// select(c, a, b) -> a or b, by the sign of the constant c
// select(x, a, a) -> a
ValueId simplify_select(ProgramBuilder& builder, ValueId condition, ValueId a, ValueId b) {
  if (builder.is_constant(condition)) return builder.node(condition).constant >= 0 ? a : b;
  return a == b ? a : kNoValue;
}

// f(-x) -> -f(x)      f odd
// f(-x) -> f(x)       f is cos or abs
// --x   -> x
ValueId simplify_unary(ProgramBuilder& builder, Op op, ValueId operand) {
  if (!is_negation(builder, operand)) return kNoValue;
  const ValueId x = negated(builder, operand);
  if (op == Op::negate) return x;
  if (op == Op::cos || op == Op::abs) return builder.append(op, x);
  if (is_odd(op)) return builder.append(Op::negate, builder.append(op, x));
  return kNoValue;
}

// pack(c, c)                            -> c, a constant counts for every lane
// pack(-x, -y)                          -> -pack(x, y)
// pack(first_lane(p), second_lane(p))   -> p
ValueId simplify_pack(ProgramBuilder& builder, ValueId x, ValueId y) {
  const Node &first = builder.node(x), &second = builder.node(y);
  if (builder.is_constant(x) && builder.is_constant(y, first.constant)) return x;
  if (first.op == Op::negate && second.op == Op::negate)
    return builder.append(Op::negate, builder.append(Op::pack, first.operands[0], second.operands[0]));
  const bool is_whole =
      first.op == Op::first_lane && second.op == Op::second_lane && first.operands[0] == second.operands[0];
  return is_whole ? first.operands[0] : kNoValue;
}

// first_lane(c)             -> c
// first_lane(pack(x, y))    -> x, second_lane likewise
// first_lane(-p)            -> -first_lane(p)
ValueId simplify_lane(ProgramBuilder& builder, Op op, ValueId pair) {
  const Node node = builder.node(pair);
  if (node.op == Op::constant) return pair;
  if (node.op == Op::pack) return node.operands[op == Op::first_lane ? 0 : 1];
  if (node.op == Op::negate) return builder.append(Op::negate, builder.append(op, node.operands[0]));
  return kNoValue;
}

}  // namespace

void order_operands(const std::vector<Node>& nodes, Op op, ValueId (&operands)[3]) {
  if (!is_commutative(op)) return;
  const auto place = [&](ValueId value) { return std::pair(nodes[value].op != Op::constant, value); };
  if (place(operands[1]) < place(operands[0])) std::swap(operands[0], operands[1]);
}

ValueId simplify(ProgramBuilder& builder, Op op, ValueId first, ValueId second, ValueId third) {
  switch (op) {
    case Op::add:
      return simplify_add(builder, first, second);
    case Op::subtract:
      return simplify_subtract(builder, first, second);
    case Op::multiply:
      return simplify_multiply(builder, first, second);
    case Op::divide:
      return simplify_divide(builder, first, second);
    case Op::pow:
      return simplify_power(builder, first, second);
    case Op::select:
      return simplify_select(builder, first, second, third);
    case Op::pack:
      return simplify_pack(builder, first, second);
    case Op::first_lane:
    case Op::second_lane:
      return simplify_lane(builder, op, first);
    default:
      return arity(op) == 1 ? simplify_unary(builder, op, first) : kNoValue;
  }
}

}  // namespace mbgen
