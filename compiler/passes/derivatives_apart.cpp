#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "compiler/passes/derivative_sums.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/program/kinds.hpp"
#include "compiler/program/rewrite.hpp"

namespace mbgen {
namespace {

/// The two programs while they are made. A derivative is a value of `along`, kNoValue where it is 0.
class DerivativesOf {
 public:
  DerivativesOf(const Program& program, const std::function<bool(const Slot&)>& moves)
      : program_(program),
        widths_(widths_of(program)),
        values_(ProgramBuilder::like(program)),
        along_(program.name),
        derivative_(program.nodes.size(), {kNoValue, kNoValue}) {
    one();  // before all that it may stand beside: commuted operands are ordered
    for (ValueId v = 0; v < program.nodes.size(); ++v) {
      const Node& node = program.nodes[v];
      value_.push_back(values_.copy(program, node, value_));
      along_.set_origin(node);
      if (node.op == Op::input) {
        const Slot& slot = program.inputs[static_cast<std::size_t>(node.input)];
        if (moves(slot)) derivative_[v] = both(along_.input(derivative_of(slot.group), slot.index));
      } else if (node.op == Op::pack) {
        derivative_[v] = {derivative_[node.operands[0]][0], derivative_[node.operands[1]][0]};
      } else if (node.op == Op::first_lane || node.op == Op::second_lane) {
        derivative_[v] = both(derivative_[node.operands[0]][node.op == Op::second_lane ? 1 : 0]);
      } else if (node.op != Op::constant) {
        derive(v);
      }
    }
  }

  DerivativesApart finish(const std::function<bool(const Slot&)>& is_wanted, double slope_cost) {
    for (const auto& [slot, value] : program_.outputs) {
      values_.output(slot.group, slot.index, value_[value]);
      if (is_wanted(slot) && derivative_[value][0] != kNoValue)
        along_.output(derivative_of(slot.group), slot.index, derivative_[value][0]);
    }
    Program along = shortened(optimise(remove_dead_values(along_.finish())), slope_cost);
    for (const auto& [number, slope] : slopes_) values_.output(Array::slope, slope, number);
    DerivativesApart apart{values_.finish(), std::move(along), 0};
    number_slopes(apart);
    return apart;
  }

 private:
  using Lanes = std::array<ValueId, 2>;
  static Lanes both(ValueId value) { return {value, value}; }

  // --- slopes ---

  ValueId one() { return values_.constant(1); }
  ValueId reciprocal(ValueId value) { return values_.append(Op::divide, one(), value); }
  ValueId product(ValueId a, ValueId b) { return values_.append(Op::multiply, a, b); }
  ValueId square(ValueId value) { return product(value, value); }
  ValueId negative(ValueId value) { return values_.append(Op::negate, value); }
  ValueId sum(ValueId a, ValueId b) { return values_.append(Op::add, a, b); }
  ValueId difference(ValueId a, ValueId b) { return values_.append(Op::subtract, a, b); }
  /// `slope`, and 0 where `factor` is 0.
  ValueId unless_zero(ValueId factor, ValueId slope) {
    const ValueId condition = negative(values_.append(Op::abs, factor));
    return values_.append(Op::select, condition, values_.constant(0), slope);
  }
  /// (1 - x) (1 + x)
  ValueId without_square(ValueId x) {
    const ValueId less = difference(one(), x), more = sum(one(), x);
    return product(less, more);
  }

  // sqrt' = 1 / (2 sqrt)   asin' = 1 / sqrt((1 - x)(1 + x))   acos' = -asin'   tan' = 1 + tan^2
  // atan' = 1 / (1 + x^2)  tanh' = (1 - tanh)(1 + tanh)       |x|' = 1 or -1
  ValueId slope_of(Op op, ValueId x, ValueId result) {
    switch (op) {
      case Op::negate:
        return values_.constant(-1);
      case Op::sqrt:
        return values_.append(Op::divide, values_.constant(0.5), result);
      case Op::sin:
        return values_.append(Op::cos, x);
      case Op::cos:
        return negative(values_.append(Op::sin, x));
      case Op::tan:
        return sum(one(), square(result));
      case Op::asin:
        return reciprocal(values_.append(Op::sqrt, without_square(x)));
      case Op::acos:
        return negative(reciprocal(values_.append(Op::sqrt, without_square(x))));
      case Op::atan:
        return reciprocal(sum(one(), square(x)));
      case Op::exp:
        return result;
      case Op::log:
        return reciprocal(x);
      case Op::tanh:
        return without_square(result);
      case Op::abs:
        return values_.append(Op::select, x, one(), values_.constant(-1));
      default:
        return kNoValue;  // floor and sample are constant between their jumps
    }
  }

  bool may_be_unbounded(const Node& node) const {
    if (node.op == Op::sqrt) return !is_positive(node.operands[0]);
    return node.op == Op::asin || node.op == Op::acos || node.op == Op::log || node.op == Op::pow;
  }

  /// Whether a value of the program is above 0 by its form: a sum of squares and of a positive number.
  bool is_positive(ValueId v) const {
    const Node& node = program_.nodes[v];
    if (node.op == Op::constant) return node.constant > 0;
    const bool squares = node.op == Op::multiply_add && node.operands[0] == node.operands[1];
    return squares && is_positive(node.operands[2]);
  }

  /// Slopes of x^y by x and by y.
  Lanes slopes_of_power(ValueId x, ValueId y, ValueId result) {
    const ValueId below = values_.append(Op::pow, x, difference(y, one()));
    const ValueId by_x = product(y, below), by_y = product(result, values_.append(Op::log, x));
    const ValueId bounded = values_.is_constant(y) ? by_x : unless_zero(y, by_x);
    return {bounded, unless_zero(result, by_y)};
  }

  /// Slopes of atan2(y, x) by y and by x; the direction of the origin does not move.
  Lanes slopes_of_direction(ValueId y, ValueId x) {
    const ValueId x_squared = square(x), y_squared = square(y), squares = sum(x_squared, y_squared);
    const ValueId part = unless_zero(squares, reciprocal(squares)), by_y = product(x, part);
    return {by_y, negative(product(y, part))};
  }

  // --- values of `along` ---

  /// A lane of a value of `values` in `along`: a constant, an input, or else a slope.
  ValueId taken(ValueId value, std::size_t lane) { return taken(along_, value, lane); }
  ValueId taken(ProgramBuilder& along, ValueId value, std::size_t lane) {
    const Node node = values_.node(value);
    if (node.op == Op::constant) return along.constant(node.constant);
    if (node.op == Op::pack) return taken(along, node.operands[lane], 0);
    if (node.op == Op::input) {
      const Slot& slot = program_.inputs[static_cast<std::size_t>(node.input)];
      return along.input(slot.group, slot.index);
    }
    if (width(value) == 2) value = values_.append(lane == 0 ? Op::first_lane : Op::second_lane, value);
    const auto slope = slopes_.try_emplace(value, static_cast<int>(slopes_.size())).first;
    return along.input(Array::slope, slope->second);
  }

  int width(ValueId value) {
    const auto found = width_.find(value);
    if (found != width_.end()) return found->second;
    const Node node = values_.node(value);
    const bool is_lane = node.op == Op::first_lane || node.op == Op::second_lane;
    int widest = node.op == Op::pack ? 2 : node.op == Op::input || is_lane ? 1 : 0;
    for (int k = 0; widest == 0 && k < arity(node.op); ++k) widest = std::max(widest, width(node.operands[k]));
    return width_[value] = widest;
  }

  ValueId times(ValueId slope, std::size_t lane, ValueId derivative) {
    if (slope == kNoValue || derivative == kNoValue) return kNoValue;
    return nonzero(along_.append(Op::multiply, taken(slope, lane), derivative));
  }
  ValueId added(ValueId a, ValueId b) {
    if (a == kNoValue || b == kNoValue) return a == kNoValue ? b : a;
    return nonzero(along_.append(Op::add, a, b));
  }
  ValueId subtracted(ValueId a, ValueId b) {
    if (b == kNoValue) return a;
    return a == kNoValue ? along_.append(Op::negate, b) : nonzero(along_.append(Op::subtract, a, b));
  }
  ValueId nonzero(ValueId derivative) { return along_.is_constant(derivative, 0) ? kNoValue : derivative; }
  /// The product, and 0 where the derivative is 0 and the slope has no bound.
  ValueId times_where_moved(ValueId slope, std::size_t lane, ValueId derivative) {
    const ValueId moved = times(slope, lane, derivative);
    if (moved == kNoValue || along_.is_constant(taken(slope, lane))) return moved;
    const ValueId stays = along_.append(Op::negate, along_.append(Op::abs, derivative));
    return along_.append(Op::select, stays, along_.constant(0), moved);
  }
  /// One of two derivatives by the sign of a value.
  ValueId chosen(ValueId condition, std::size_t lane, ValueId a, ValueId b) {
    if (a == b) return a;
    const auto number = [&](ValueId derivative) { return derivative == kNoValue ? along_.constant(0) : derivative; };
    const ValueId of_condition = taken(condition, lane), first = number(a), second = number(b);
    return nonzero(along_.append(Op::select, of_condition, first, second));
  }

  // --- derivatives ---

  void derive(ValueId v) {
    const Node& node = program_.nodes[v];
    values_.set_origin(node);
    const bool moves = std::ranges::any_of(
        node.operands, [&](ValueId operand) { return operand != kNoValue && derivative_[operand] != both(kNoValue); });
    if (!moves) return;
    const Lanes slopes = slopes_of(node, v);
    for (std::size_t lane = 0; lane < (widths_[v] == 2 ? 2 : 1); ++lane)
      derivative_[v][lane] = derivative_of_lane(node, slopes, lane);
    if (widths_[v] != 2) derivative_[v][1] = derivative_[v][0];
  }

  /// Slopes of a value that is neither a sum nor a product, or the condition of its choice.
  Lanes slopes_of(const Node& node, ValueId v) {
    const auto operand = [&](int k) { return value_[node.operands[k]]; };
    switch (node.op) {
      case Op::divide: {
        const ValueId part = values_.is_constant(operand(0), 1) ? value_[v] : reciprocal(operand(1));
        const ValueId by_divisor = negative(product(value_[v], part));
        return {part, by_divisor};
      }
      case Op::pow:
        return slopes_of_power(operand(0), operand(1), value_[v]);
      case Op::atan2:
        return slopes_of_direction(operand(0), operand(1));
      case Op::min:
        return both(difference(operand(1), operand(0)));
      case Op::max:
        return both(difference(operand(0), operand(1)));
      default:
        return arity(node.op) == 1 ? both(slope_of(node.op, operand(0), value_[v])) : both(kNoValue);
    }
  }

  ValueId derivative_of_lane(const Node& node, const Lanes& slopes, std::size_t lane) {
    const auto d = [&](int k) { return derivative_[node.operands[k]][lane]; };
    const auto value = [&](int k) { return value_[node.operands[k]]; };
    // Statements, not nested calls: compilers evaluate the arguments of a call in orders of their own.
    const auto of_product = [&](int a, int b) {
      const ValueId first = times(value(b), lane, d(a)), second = times(value(a), lane, d(b));
      return added(first, second);
    };
    const auto by_slopes = [&] {
      const ValueId first = times(slopes[0], lane, d(0)), second = times(slopes[1], lane, d(1));
      return added(first, second);
    };
    switch (node.op) {
      case Op::add:
        return added(d(0), d(1));
      case Op::subtract:
        return subtracted(d(0), d(1));
      case Op::multiply:
        return of_product(0, 1);
      case Op::multiply_add: {
        const ValueId first = times(value(1), lane, d(0)), second = times(value(0), lane, d(1));
        return added(first, added(second, d(2)));
      }
      case Op::multiply_subtract:
        return subtracted(of_product(0, 1), d(2));
      case Op::subtract_product: {
        const ValueId first = times(value(2), lane, d(1)), second = times(value(1), lane, d(2));
        return subtracted(subtracted(d(0), first), second);
      }
      case Op::select:
        return chosen(value(0), lane, d(1), d(2));
      case Op::min:
      case Op::max:
        return chosen(slopes[0], lane, d(0), d(1));
      case Op::divide:
      case Op::atan2:
        return by_slopes();
      case Op::pow: {
        const ValueId by_base = times_where_moved(slopes[0], lane, d(0));
        return added(by_base, times_where_moved(slopes[1], lane, d(1)));
      }
      default:
        return may_be_unbounded(node) ? times_where_moved(slopes[0], lane, d(0)) : times(slopes[0], lane, d(0));
    }
  }

  /// The program `along` in its shortest sums, with its operations on slopes alone left to `values`.
  Program shortened(const Program& along, double slope_cost) {
    std::vector<ValueId> of_slope(slopes_.size()), still(along.nodes.size(), kNoValue);
    for (const auto& [number, slope] : slopes_) of_slope[static_cast<std::size_t>(slope)] = number;
    for (ValueId v = 0; v < along.nodes.size(); ++v) still[v] = still_value(along, along.nodes[v], still, of_slope);
    SlopeArithmetic slopes(values_);
    DerivativeSums sums(along, still, slopes);
    sums.shorten(slope_cost);
    return sums.program([&](ProgramBuilder& builder, ValueId slope) { return taken(builder, slope, 0); });
  }

  /// The value in `values` of a node without derivatives, kNoValue for others.
  ValueId still_value(const Program& along, const Node& node, const std::vector<ValueId>& still,
                      const std::vector<ValueId>& of_slope) {
    if (node.op == Op::constant) return values_.constant(node.constant);
    if (node.op == Op::input) {
      const Slot& slot = along.inputs[static_cast<std::size_t>(node.input)];
      if (slot.group.derivative > 0) return kNoValue;
      return slot.group == SlotGroup(Array::slope) ? of_slope[static_cast<std::size_t>(slot.index)]
                                                   : values_.input(slot.group, slot.index);
    }
    ValueId operands[3] = {kNoValue, kNoValue, kNoValue};
    for (int k = 0; k < arity(node.op); ++k) {
      operands[k] = still[node.operands[k]];
      if (operands[k] == kNoValue) return kNoValue;
    }
    values_.set_origin(node);
    return values_.append(node.op, operands[0], operands[1], operands[2]);
  }

  /// Leaves the slopes that `along` takes and numbers them in its order.
  static void number_slopes(DerivativesApart& apart) {
    std::map<int, int> number;
    for (Slot& slot : apart.along.inputs)
      if (slot.group == SlotGroup(Array::slope))
        slot.index = number.try_emplace(slot.index, static_cast<int>(number.size())).first->second;
    std::erase_if(apart.values.outputs, [&](const OutputValue& output) {
      return output.slot.group == SlotGroup(Array::slope) && !number.contains(output.slot.index);
    });
    for (OutputValue& output : apart.values.outputs)
      if (output.slot.group == SlotGroup(Array::slope)) output.slot.index = number.at(output.slot.index);
    apart.values = remove_dead_values(std::move(apart.values));
    apart.slopes = static_cast<int>(number.size());
  }

  const Program& program_;
  std::vector<int> widths_;
  ProgramBuilder values_, along_;
  std::vector<ValueId> value_;     ///< per value of the program, in `values_`
  std::vector<Lanes> derivative_;  ///< likewise per lane, in `along_`
  std::map<ValueId, int> slopes_;  ///< index of each value of `values_` that is given as a slope
  std::map<ValueId, int> width_;   ///< of values of `values_`
};

}  // namespace

DerivativesApart take_derivatives_apart(const Program& program, const std::function<bool(const Slot&)>& moves,
                                        const std::function<bool(const Slot&)>& is_wanted, double slope_cost) {
  DerivativesApart apart = DerivativesOf(program, moves).finish(is_wanted, slope_cost);
  apart.along = contract(apart.along);
  return apart;
}

Program adjoint(const Program& program, const std::function<bool(const Slot&)>& moves,
                const std::function<bool(const Slot&)>& is_weighted, const std::function<bool(const Slot&)>& is_kept) {
  const DerivativesApart apart = DerivativesOf(program, moves).finish(is_weighted, 1);
  std::vector<SlotPlace> rows, columns;
  for (const OutputValue& output : apart.along.outputs) rows.push_back({output.slot, output.slot});
  for (const Slot& slot : apart.along.inputs)
    if (slot.group.derivative > 0) columns.push_back({slot, slot});
  const Program weights = contract(transposed(apart.along, rows, columns));

  ProgramBuilder joined = ProgramBuilder::like(program);
  const std::vector<ValueId> of_values = put_in(joined, apart.values, [](const Slot&) { return kNoValue; });
  std::vector<ValueId> slopes(static_cast<std::size_t>(apart.slopes), kNoValue);
  for (const auto& [slot, value] : apart.values.outputs) {
    if (slot.group == SlotGroup(Array::slope)) slopes[static_cast<std::size_t>(slot.index)] = of_values[value];
    if (is_kept(slot)) joined.output(slot.group, slot.index, of_values[value]);
  }
  const std::vector<ValueId> of_weights = put_in(joined, weights, [&](const Slot& slot) {
    return slot.group == SlotGroup(Array::slope) ? slopes[static_cast<std::size_t>(slot.index)] : kNoValue;
  });
  for (const auto& [slot, value] : weights.outputs) joined.output(slot.group, slot.index, of_weights[value]);
  return remove_dead_values(joined.finish());
}

}  // namespace mbgen
