#include "compiler/program/function_field.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/mixed_words.hpp"

namespace mbgen {
namespace {

/// Above it a value counts as a variable of its own. A difference of three values below has a numerator of at most six
/// times this degree, twice that in the parameters of the circles: it vanishes by chance at a point modulo a prime
/// above 2^60 with 2^26 / 2^60 at most, at four with 2^-136, and 2^17 values make 2^34 differences.
constexpr double kMostDegree = 1 << 22;

constexpr std::size_t kPlacesOfAPart =
    16;  ///< for each function, a power of 2: one number in 16 is taken for one that came up

bool is_negative(const Residue& residue) {
  const Residue opposite = -residue;
  return opposite < residue;
}

std::uint64_t hash_of_part(std::uint64_t part) { return mixed_word(0, part); }

}  // namespace

FunctionField::FunctionField() : seen_parts_(kPlacesOfAPart) { element_of({.degree = 0}); }

void FunctionField::reserve(std::size_t count) {
  residues_.reserve(count);
  numerators_.reserve(count);
  parts_.reserve(count);
  numbers_.reserve(count);
}

Element FunctionField::constant(double value) { return element_of({.key = residue_of(value), .degree = 0}); }

Element FunctionField::variable() { return element_of({.key = random_residue(variables_++)}); }

Element FunctionField::sum(Element a, Element b) {
  const Numerator &first = at(a), &second = at(b);
  Function result{.key = residue(a) + residue(b), .exponents = common(first.exponents, second.exponents)};
  result.degree = std::max(raised(first, result.exponents), raised(second, result.exponents));
  return element_of(std::move(result));
}

Element FunctionField::product(Element a, Element b) {
  if (a.number == 0 || b.number == 0) return {};
  const Numerator &first = at(a), &second = at(b);
  return element_of({.key = residue(a) * residue(b),
                     .degree = first.degree + second.degree,
                     .exponents = added(first.exponents, second.exponents, 1)});
}

// A variable where the divisor is zero, which no program means.
Element FunctionField::quotient(Element a, Element b) {
  if (a.number == 0 && b.number != 0) return {};
  if (!invertible(residues_[static_cast<std::size_t>(b.number)])) return variable();
  const Numerator &dividend = at(a), &divisor = at(b);
  Function result{.key = residue(a) * inverse(residue(b)),
                  .degree = dividend.degree,
                  .exponents = added(dividend.exponents, divisor.exponents, -1)};
  if (divisor.degree > 0) {
    const auto [found, is_new] = divisors_.try_emplace(b.number, static_cast<int>(degrees_.size()));
    if (is_new) degrees_.push_back(divisor.degree);
    result.exponents = added(result.exponents, alone(found->second), -1);
  }
  return element_of(std::move(result));
}

// A point of the circle belongs to the angle: ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)).
Element FunctionField::circle(Op op, Element angle) {
  const auto [found, is_new] = circles_.try_emplace(angle.number);
  if (is_new) {
    const Residue t = random_residue(variables_++), one = residue_of(1), square = t * t, scale = inverse(one + square);
    found->second.first = element_of({.key = (t + t) * scale});
    found->second.second = element_of({.key = (one - square) * scale});
  }
  if (op == Op::cos) return found->second.second;
  return with_sign(found->second.first, angle.negative);
}

Element FunctionField::other(Op op, std::array<Element, 3> arguments) {
  const bool negative = arguments[0].negative;
  if (is_odd(op) || op == Op::abs) arguments[0].negative = false;
  const auto [found, is_new] = others_.try_emplace({op, arguments});
  if (is_new) found->second = variable();
  return with_sign(found->second, is_odd(op) && negative);
}

Element FunctionField::value(Op op, std::span<const Element> operands) {
  switch (op) {
    case Op::add:
      return sum(operands[0], operands[1]);
    case Op::subtract:
      return sum(operands[0], with_sign(operands[1], true));
    case Op::multiply:
      return product(operands[0], operands[1]);
    case Op::divide:
      return quotient(operands[0], operands[1]);
    case Op::negate:
      return with_sign(operands[0], true);
    case Op::sin:
    case Op::cos:
      return circle(op, operands[0]);
    default:
      return other(op, {operands[0], operands[1], operands[2]});
  }
}

void FunctionField::mark_seen(std::uint64_t part) {
  if (kPlacesOfAPart * (size() + 1) > seen_parts_.size()) {
    seen_parts_.assign(2 * seen_parts_.size(), false);
    for (const std::uint64_t seen : parts_) seen_parts_[seen & (seen_parts_.size() - 1)] = true;
  }
  seen_parts_[part & (seen_parts_.size() - 1)] = true;
}

int FunctionField::number_of(std::uint64_t part) const {
  if (!may_be_known(part)) return -1;
  const std::uint32_t found =
      numbers_.find(hash_of_part(part), [&](std::uint32_t number) { return parts_[number] == part; });
  return found == NumberTable::kNone ? -1 : static_cast<int>(found);
}

std::optional<Element> FunctionField::up_to_sign(int number, const Residue& key) const {
  const auto among = [&](const Residue& known) -> std::optional<Element> {
    if (known == key) return Element{number, false};
    if (-known == key) return Element{number, true};
    return {};
  };
  if (const auto element = among(residues_[static_cast<std::size_t>(number)])) return element;
  const auto replaced = replaced_.find(number);
  return replaced == replaced_.end() ? std::nullopt : among(replaced->second);
}

std::optional<Element> FunctionField::known_difference(Element a, Element b, std::uint64_t first_part) const {
  const int number = number_of(first_part);
  if (number < 0) return {};
  return up_to_sign(number, residue(a) - residue(b));
}

std::optional<Element> FunctionField::known_quotient(Element a, Element b) {
  const Residue &dividend = residues_[static_cast<std::size_t>(a.number)],
                &divisor = residues_[static_cast<std::size_t>(b.number)];
  if (!invertible(divisor)) return {};
  if (inverse_parts_.size() < size()) invert_first_parts();
  const int number = number_of(first_part_of_quotient(dividend, inverse_parts_[static_cast<std::size_t>(b.number)]));
  if (number < 0) return {};
  const Residue product = residue({number, false}) * residue(b);
  if (product == residue(a)) return Element{number, false};
  if (-product == residue(a)) return Element{number, true};
  return {};
}

void FunctionField::invert_first_parts() { inverse_parts_ = first_parts_of_inverses(residues_); }

bool FunctionField::are_same(Exponents a, Exponents b) const {
  return (a.first == b.first && a.count == b.count) || std::ranges::equal(powers(a), powers(b));
}

// Exponents of one divisor alone.
FunctionField::Exponents FunctionField::alone(int divisor) {
  powers_.push_back({divisor, 1});
  return {static_cast<std::uint32_t>(powers_.size() - 1), 1};
}

/// Combines exponents one by one; missing ones are 0.
template <class Combine>
FunctionField::Exponents FunctionField::combined(Exponents a, Exponents b, const Combine& combine) {
  Exponents result{static_cast<std::uint32_t>(powers_.size()), 0};
  const std::size_t most = powers_.size() + a.count + b.count;  // the operands stand in the same array
  if (most > powers_.capacity()) powers_.reserve(2 * most);
  const std::span<const Power> of_a = powers(a), of_b = powers(b);
  auto x = of_a.begin(), y = of_b.begin();
  while (x != of_a.end() || y != of_b.end()) {
    const bool from_a = y == of_b.end() || (x != of_a.end() && x->divisor <= y->divisor);
    const bool from_b = x == of_a.end() || (y != of_b.end() && y->divisor <= x->divisor);
    const int divisor = from_a ? x->divisor : y->divisor;
    const int exponent = combine(from_a ? x->exponent : 0, from_b ? y->exponent : 0);
    if (exponent != 0) powers_.push_back({divisor, exponent});
    if (from_a) ++x;
    if (from_b) ++y;
  }
  result.count = static_cast<std::uint32_t>(powers_.size()) - result.first;
  for (const Exponents& given : {a, b}) {
    if (!are_same(result, given)) continue;
    powers_.resize(result.first);
    return given;
  }
  return result;
}

// a + scale b
FunctionField::Exponents FunctionField::added(Exponents a, Exponents b, int scale) {
  if (b.count == 0) return a;
  if (a.count == 0 && scale == 1) return b;
  return combined(a, b, [&](int x, int y) { return x + scale * y; });
}

// The lesser powers: those of the sum of two values.
FunctionField::Exponents FunctionField::common(Exponents a, Exponents b) {
  if (a.first == b.first && a.count == b.count) return a;
  return combined(a, b, [](int x, int y) { return std::min(x, y); });
}

// Degree of the numerator of `value` with powers that are not higher.
double FunctionField::raised(const Numerator& value, Exponents lesser) const {
  double degree = value.degree;
  auto less = powers(lesser).begin();
  const auto end = powers(lesser).end();
  const auto add = [&](int divisor, int exponent) { degree += exponent * degrees_[static_cast<std::size_t>(divisor)]; };
  for (const auto& [divisor, exponent] : powers(value.exponents)) {
    for (; less != end && less->divisor < divisor; ++less) add(less->divisor, -less->exponent);
    const bool both = less != end && less->divisor == divisor;
    add(divisor, exponent - (both ? less->exponent : 0));
    if (both) ++less;
  }
  for (; less != end; ++less) add(less->divisor, -less->exponent);
  return degree;
}

// The larger degree of numerator and denominator, all powers written out.
double FunctionField::degree_of(const Function& value) const {
  double above = value.degree, below = 0;
  for (const auto& [divisor, exponent] : powers(value.exponents))
    (exponent > 0 ? above : below) += std::abs(exponent) * degrees_[static_cast<std::size_t>(divisor)];
  return std::max(above, below);
}

// Functions that share a first part by chance are told apart, and the later one is not found again.
Element FunctionField::element_of(Function value) {
  const std::uint64_t part = first_part(value.key);
  const int known = number_of(part);
  if (known >= 0)
    if (const auto element = up_to_sign(known, value.key)) {
      powers_.resize(kept_powers_);
      return *element;
    }
  const int number = static_cast<int>(size());
  const bool negative = is_negative(value.key);
  if (negative) value.key = -value.key;
  if (known < 0) numbers_.insert(hash_of_part(part), static_cast<std::uint32_t>(number));
  Residue residue = value.key;
  if (degree_of(value) > kMostDegree) {
    replaced_.emplace(number, value.key);
    residue = random_residue(variables_++);
    value.degree = 1;
    value.exponents = {};
    powers_.resize(kept_powers_);
  }
  kept_powers_ = powers_.size();
  mark_seen(part);
  residues_.push_back(residue);
  numerators_.push_back({value.degree, value.exponents});
  parts_.push_back(part);
  return {number, negative};
}

std::vector<Element> input_variables(const Program& program, FunctionField& field) {
  std::vector<Element> variables;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) variables.push_back(field.variable());
  return variables;
}

std::vector<std::array<Element, 2>> elements_of(const Program& program, FunctionField& field,
                                                std::span<const Element> inputs) {
  using Lanes = std::array<Element, 2>;
  std::vector<Lanes> all(program.nodes.size());
  field.reserve(field.size() + program.nodes.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    const Node& node = program.nodes[v];
    Lanes operands[3];
    for (int k = 0; k < arity(node.op); ++k) operands[k] = all[node.operands[k]];
    const auto in_lane = [&](std::size_t lane) {
      const Element of_lane[3] = {operands[0][lane], operands[1][lane], operands[2][lane]};
      return field.value(node.op, of_lane);
    };
    if (node.op == Op::constant) {
      all[v].fill(field.constant(node.constant));
    } else if (node.op == Op::input) {
      all[v].fill(inputs[static_cast<std::size_t>(node.input)]);
    } else if (node.op == Op::pack) {
      all[v] = {operands[0][0], operands[1][0]};
    } else if (node.op == Op::first_lane || node.op == Op::second_lane) {
      all[v].fill(operands[0][node.op == Op::first_lane ? 0 : 1]);
    } else {
      all[v][0] = in_lane(0);
      const bool are_alike = std::ranges::all_of(operands, [](const Lanes& lanes) { return lanes[0] == lanes[1]; });
      all[v][1] = are_alike ? all[v][0] : in_lane(1);
    }
  }
  return all;
}

}  // namespace mbgen
