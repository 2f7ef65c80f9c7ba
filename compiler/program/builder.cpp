#include "compiler/program/operations.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace mbgen {
namespace {

std::uint64_t bits(double value) {
  std::uint64_t result;
  std::memcpy(&result, &value, sizeof result);
  return result;
}

std::uint64_t hash(const Node& node) {
  std::uint64_t h = 1469598103934665603ull;
  const auto mix = [&](std::uint64_t value) { h = (h ^ value) * 1099511628211ull, h ^= h >> 29; };
  mix(static_cast<std::uint64_t>(node.op));
  for (ValueId operand : node.operands) mix(operand);
  mix(bits(node.constant));
  return h;
}

bool same(const Node& a, const Node& b) {
  return a.op == b.op && std::equal(a.operands, a.operands + 3, b.operands) && bits(a.constant) == bits(b.constant);
}

/// Whether division by a constant is exactly a multiplication: the divisor is a power of two.
bool exact_reciprocal(double divisor) {
  int exponent = 0;
  return std::abs(std::frexp(divisor, &exponent)) == 0.5 && std::isnormal(1 / divisor);
}

std::uint16_t place_of(std::vector<std::string>& titles, const std::string& title) {
  const auto found = std::find(titles.begin(), titles.end(), title);
  if (found != titles.end()) return static_cast<std::uint16_t>(found - titles.begin());
  titles.push_back(title);
  return static_cast<std::uint16_t>(titles.size() - 1);
}

}  // namespace

ProgramBuilder::ProgramBuilder(std::string name) {
  program_.name = std::move(name);
  program_.sections = {""};
  program_.blocks = {""};
}

bool ProgramBuilder::is_constant(ValueId value, double constant) const {
  const Node& n = program_.nodes[value];
  return n.op == Op::constant && n.constant == constant;
}

ValueId ProgramBuilder::push(Node node) {
  const std::uint64_t key = hash(node);
  const auto [first, last] = shared_.equal_range(key);
  for (auto it = first; it != last; ++it)
    if (same(program_.nodes[it->second], node)) return it->second;
  program_.nodes.push_back(node);
  const auto id = static_cast<ValueId>(program_.nodes.size() - 1);
  shared_.emplace(key, id);
  return id;
}

ValueId ProgramBuilder::constant(double value) {
  Node node;
  node.op = Op::constant;
  node.constant = value == 0 ? 0.0 : value;   // one zero
  return push(node);
}

ValueId ProgramBuilder::input(const std::string& group, int index) {
  const std::string key = group + "[" + std::to_string(index) + "]";
  if (const auto found = input_of_.find(key); found != input_of_.end()) return found->second;
  Node node;
  node.op = Op::input;
  node.input = static_cast<std::int32_t>(program_.inputs.size());
  program_.inputs.push_back({group, index});
  program_.nodes.push_back(node);
  return input_of_[key] = static_cast<ValueId>(program_.nodes.size() - 1);
}

void ProgramBuilder::output(const std::string& group, int index, ValueId value) {
  program_.outputs.push_back({{group, index}, value});
}

void ProgramBuilder::set_section(const std::string& title) { section_ = place_of(program_.sections, title); }

void ProgramBuilder::set_block(const std::string& title) { block_ = place_of(program_.blocks, title); }

void ProgramBuilder::label(ValueId value, const std::string& name) {
  Node& node = program_.nodes[value];
  if (node.label >= 0 || node.op == Op::constant || node.op == Op::input) return;
  node.label = static_cast<std::int32_t>(program_.labels.size());
  program_.labels.push_back(name);
}

ValueId ProgramBuilder::append(Op op, ValueId first, ValueId second, ValueId third) {
  if (const ValueId folded = fold(op, first, second, third); folded != kNoValue) return folded;
  if (commutes(op)) {
    const bool swap = node(second).op == Op::constant ? node(first).op != Op::constant
                                                      : node(first).op != Op::constant && second < first;
    if (swap) std::swap(first, second);
  }
  Node node;
  node.op = op;
  node.operands[0] = first;
  node.operands[1] = second;
  node.operands[2] = third;
  node.section = section_;
  node.block = block_;
  return push(node);
}

ValueId ProgramBuilder::fold(Op op, ValueId a, ValueId b, ValueId c) {
  const int count = arity(op);
  const auto known = [&](ValueId v) { return node(v).op == Op::constant; };
  const auto negated = [&](ValueId v) { return node(v).op == Op::negate; };
  const auto inside = [&](ValueId v) { return node(v).operands[0]; };
  const auto negate = [&](ValueId v) { return append(Op::negate, v); };
  const auto value = [&](ValueId v) { return v == kNoValue ? 0.0 : node(v).constant; };
  if (known(a) && (count < 2 || known(b)) && (count < 3 || known(c)))
    if (const double result = apply(op, value(a), value(b), value(c)); std::isfinite(result)) return constant(result);
  switch (op) {
    case Op::add:                                                           // x + 0 = x
      if (is_constant(a, 0)) return b;
      if (is_constant(b, 0)) return a;
      if (negated(b)) return append(Op::subtract, a, inside(b));            // x + (-y) = x - y
      if (negated(a)) return append(Op::subtract, b, inside(a));            // (-x) + y = y - x
      break;
    case Op::subtract:
      if (is_constant(b, 0)) return a;                                      // x - 0 = x
      if (is_constant(a, 0)) return negate(b);                              // 0 - x = -x
      if (a == b) return constant(0);                                       // x - x = 0
      if (negated(b)) return append(Op::add, a, inside(b));                 // x - (-y) = x + y
      if (negated(a)) return negate(append(Op::add, inside(a), b));         // (-x) - y = -(x + y)
      break;
    case Op::multiply:
      if (is_constant(a, 0) || is_constant(b, 0)) return constant(0);       // x 0 = 0
      if (is_constant(a, 1)) return b;                                      // x 1 = x
      if (is_constant(b, 1)) return a;
      if (is_constant(a, -1)) return negate(b);                             // x (-1) = -x
      if (is_constant(b, -1)) return negate(a);
      if (known(a) && value(a) < 0) return negate(append(op, constant(-value(a)), b));   // (-k) x = -(k x)
      if (known(b) && value(b) < 0) return negate(append(op, a, constant(-value(b))));
      if (negated(a)) return negate(append(op, inside(a), b));              // (-x) y = -(x y)
      if (negated(b)) return negate(append(op, a, inside(b)));
      break;
    case Op::divide:
      if (is_constant(a, 0)) return a;                                      // 0 / x = 0
      if (is_constant(b, 1)) return a;                                      // x / 1 = x
      if (is_constant(b, -1)) return negate(a);                             // x / (-1) = -x
      if (negated(a)) return negate(append(op, inside(a), b));              // (-x) / y = -(x / y)
      if (negated(b)) return negate(append(op, a, inside(b)));
      if (known(b) && exact_reciprocal(value(b))) return append(Op::multiply, a, constant(1 / value(b)));
      break;
    case Op::negate:
      if (negated(a)) return inside(a);                                     // -(-x) = x
      if (node(a).op == Op::subtract) return append(Op::subtract, node(a).operands[1], node(a).operands[0]);   // -(x - y) = y - x
      break;
    case Op::sin:
      if (negated(a)) return negate(append(op, inside(a)));                 // sin(-x) = -sin x
      break;
    case Op::cos: case Op::abs:
      if (negated(a)) return append(op, inside(a));                         // cos(-x) = cos x, |-x| = |x|
      break;
    case Op::select:
      if (known(a)) return value(a) >= 0 ? b : c;                           // select(k, x, y) = x or y
      if (b == c) return b;
      break;
    default: break;
  }
  return kNoValue;
}

Program ProgramBuilder::finish() {
  if (const std::string fault = verify(program_); !fault.empty()) throw std::logic_error("program " + program_.name + ": " + fault);
  return std::move(program_);
}

}  // namespace mbgen
