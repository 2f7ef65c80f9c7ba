#include "compiler/program/identities.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/residue.hpp"

namespace mbgen {
namespace {

/// Above it a value counts as a variable of its own. A difference of two values below has a numerator of at most four
/// times this degree, twice that in the parameters of the circles: it vanishes by chance at a point modulo a prime above
/// 2^60 with 2^25 / 2^60 at most, at four with 2^-140, and 2^18 values make 2^35 differences.
constexpr double kMostDegree = 1 << 22;

/// A value is numerator times the numerators of divisors to these powers, by the divisor's number.
using Exponents = std::map<int, int>;

/// A value up to its sign, which makes the first part of its residue the smaller one.
struct Class {
  Residue residue;
  double degree = 1;  ///< of the numerator, at most
  Exponents exponents;
};

/// Number of a class; 0 is zero.
struct Element {
  int number = 0;
  bool negative = false;
  friend auto operator<=>(const Element&, const Element&) = default;
};

struct HashOfResidue {
  std::size_t operator()(const Residue& r) const { return static_cast<std::size_t>(r.parts[0]); }
};

bool is_negative(const Residue& residue) {
  const Residue opposite = -residue;
  return opposite < residue;
}

class Classes {
 public:
  Classes() { element_of({Residue{}, 0, {}}); }

  Element constant(double value) { return element_of({residue_of(value), 0, {}}); }
  Element variable() { return element_of({random_residue(variables_++), 1, {}}); }

  Element sum(Element a, Element b) {
    const Class &first = at(a), &second = at(b);
    Class result{value(a) + value(b), 0, common(first.exponents, second.exponents)};
    result.degree = std::max(raised(first, result.exponents), raised(second, result.exponents));
    return element_of(std::move(result));
  }

  Element product(Element a, Element b) {
    if (a.number == 0 || b.number == 0) return {};
    const Class &first = at(a), &second = at(b);
    return element_of({value(a) * value(b), first.degree + second.degree,
                       added(first.exponents, second.exponents, 1)});
  }

  /// A variable where the divisor is zero, which no program means.
  Element quotient(Element a, Element b) {
    if (a.number == 0 && b.number != 0) return {};
    if (!invertible(at(b).residue)) return variable();
    const Class &dividend = at(a), &divisor = at(b);
    Class result{value(a) * inverse(value(b)), dividend.degree, added(dividend.exponents, divisor.exponents, -1)};
    if (divisor.degree > 0) {
      const auto [found, is_new] = divisors_.try_emplace(b.number, static_cast<int>(degrees_.size()));
      if (is_new) degrees_.push_back(divisor.degree);
      result.exponents = added(result.exponents, {{found->second, 1}}, -1);
    }
    return element_of(std::move(result));
  }

  /// Sine or cosine: of a point of the circle that belongs to the angle, ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)).
  Element circle(Op op, Element angle) {
    const auto [found, is_new] = circles_.try_emplace(angle.number);
    if (is_new) {
      const Residue t = random_residue(variables_++), one = residue_of(1), square = t * t, scale = inverse(one + square);
      found->second.first = element_of({(t + t) * scale, 1, {}});
      found->second.second = element_of({(one - square) * scale, 1, {}});
    }
    if (op == Op::cos) return found->second.second;
    return with_sign(found->second.first, angle.negative);
  }

  /// Any other function: a variable for each of its arguments, up to sign where it is odd or even.
  Element function(Op op, std::array<Element, 3> arguments) {
    const bool is_negative = arguments[0].negative;
    if (is_odd(op) || op == Op::abs) arguments[0].negative = false;
    const auto [found, is_new] = functions_.try_emplace({op, arguments});
    if (is_new) found->second = variable();
    return with_sign(found->second, is_odd(op) && is_negative);
  }

  static Element with_sign(Element element, bool opposite) {
    return {element.number, element.number != 0 && element.negative != opposite};
  }

 private:
  const Class& at(Element element) const { return classes_[static_cast<std::size_t>(element.number)]; }
  Residue value(Element element) const { return element.negative ? -at(element).residue : at(element).residue; }
  double degree_of_divisor(int number) const { return degrees_[static_cast<std::size_t>(number)]; }

  /// a + scale b
  static Exponents added(Exponents a, const Exponents& b, int scale) {
    for (const auto& [divisor, exponent] : b)
      if ((a[divisor] += scale * exponent) == 0) a.erase(divisor);
    return a;
  }

  /// The lesser powers: those of the sum of two values.
  static Exponents common(const Exponents& a, const Exponents& b) {
    Exponents least;
    const auto take = [&](const Exponents& from, const Exponents& other) {
      for (const auto& [divisor, exponent] : from) {
        const auto found = other.find(divisor);
        const int lesser = std::min(exponent, found == other.end() ? 0 : found->second);
        if (lesser != 0) least[divisor] = lesser;
      }
    };
    take(a, b);
    take(b, a);
    return least;
  }

  /// Degree of the numerator of `value` with powers that are not higher.
  double raised(const Class& value, const Exponents& lesser) const {
    double degree = value.degree;
    for (const auto& [divisor, exponent] : added(value.exponents, lesser, -1))
      degree += exponent * degree_of_divisor(divisor);
    return degree;
  }

  /// The larger degree of numerator and denominator, all powers written out.
  double degree_of(const Class& value) const {
    double above = value.degree, below = 0;
    for (const auto& [divisor, exponent] : value.exponents)
      (exponent > 0 ? above : below) += std::abs(exponent) * degree_of_divisor(divisor);
    return std::max(above, below);
  }

  Element element_of(Class value) {
    const bool negative = is_negative(value.residue);
    if (negative) value.residue = -value.residue;
    const auto [found, is_new] = numbers_.try_emplace(value.residue, static_cast<int>(classes_.size()));
    const int number = found->second;
    if (is_new) {
      if (degree_of(value) > kMostDegree) value = {random_residue(variables_++), 1, {}};
      classes_.push_back(std::move(value));
    }
    return {number, negative};
  }

  std::vector<Class> classes_;
  std::vector<double> degrees_;  ///< of the numerators of divisors
  std::unordered_map<Residue, int, HashOfResidue> numbers_;
  std::unordered_map<int, int> divisors_;  ///< number of a divisor by its class
  std::map<int, std::pair<Element, Element>> circles_;
  std::map<std::pair<Op, std::array<Element, 3>>, Element> functions_;
  std::uint64_t variables_ = 0;
};

/// The value of one lane of an operation.
Element element_of(Classes& classes, Op op, std::span<const Element> operands) {
  switch (op) {
    case Op::add:
      return classes.sum(operands[0], operands[1]);
    case Op::subtract:
      return classes.sum(operands[0], Classes::with_sign(operands[1], true));
    case Op::multiply:
      return classes.product(operands[0], operands[1]);
    case Op::divide:
      return classes.quotient(operands[0], operands[1]);
    case Op::negate:
      return Classes::with_sign(operands[0], true);
    case Op::sin:
    case Op::cos:
      return classes.circle(op, operands[0]);
    default:
      return classes.function(op, {operands[0], operands[1], operands[2]});
  }
}

using Lanes = std::array<Element, 2>;

/// Both lanes of each value; those of a number are equal.
std::vector<Lanes> elements(const Program& program) {
  Classes classes;
  std::vector<Lanes> all(program.nodes.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    const Node& node = program.nodes[v];
    Lanes operands[3];
    for (int k = 0; k < arity(node.op); ++k) operands[k] = all[node.operands[k]];
    const auto in_lane = [&](std::size_t lane) {
      const Element of_lane[3] = {operands[0][lane], operands[1][lane], operands[2][lane]};
      return element_of(classes, node.op, of_lane);
    };
    if (node.op == Op::constant) {
      all[v].fill(classes.constant(node.constant));
    } else if (node.op == Op::input) {
      all[v].fill(classes.variable());
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

}  // namespace

std::vector<Identity> identities(const Program& program) {
  const std::vector<Lanes> all = elements(program);
  const std::vector<int> widths = widths_of(program);
  std::map<std::pair<int, Lanes>, ValueId> first;  // by width, up to the sign of the first lane
  std::vector<Identity> result(all.size());
  for (ValueId v = 0; v < result.size(); ++v) {
    if (all[v] == Lanes{}) {
      result[v] = {v, 0};
      continue;
    }
    const bool negative = all[v][0].number != 0 ? all[v][0].negative : all[v][1].negative;
    const Lanes key = {Classes::with_sign(all[v][0], negative), Classes::with_sign(all[v][1], negative)};
    const ValueId earlier = first.try_emplace({std::max(widths[v], 1), key}, v).first->second;
    const bool opposite = all[earlier] != all[v];
    result[v] = {earlier, opposite ? -1 : 1};
  }
  return result;
}

}  // namespace mbgen
