#pragma once
// Values as rational functions of variables, told apart by residues at random points.

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/program/program.hpp"
#include "compiler/program/residue.hpp"

namespace mbgen {

/// A function up to its sign; number 0 is zero.
struct Element {
  int number = 0;
  bool negative = false;
  friend auto operator<=>(const Element&, const Element&) = default;
};

inline Element with_sign(Element element, bool opposite) {
  return {element.number, element.number != 0 && element.negative != opposite};
}

/// All functions that came up, each once. Method: docs/method/identities.md.
class FunctionField {
 public:
  FunctionField();

  Element constant(double value);
  Element variable();
  /// Of one lane of an operation; one of an unknown function is a variable for each of its arguments.
  Element value(Op op, std::span<const Element> operands);

  /// a - b and a / b where they came up already.
  std::optional<Element> known_difference(Element a, Element b) const;
  std::optional<Element> known_quotient(Element a, Element b);

  std::size_t size() const { return functions_.size(); }

 private:
  struct Power {
    int divisor = 0, exponent = 0;  ///< not 0
  };
  /// A value is numerator times the numerators of divisors to these powers, in the order of their numbers.
  using Exponents = std::vector<Power>;
  /// Up to its sign, which makes the residue the smaller one.
  struct Function {
    Residue key = {};      ///< as it came up
    Residue residue = {};  ///< the same, or the residue of a variable in its place
    double degree = 1;     ///< of the numerator, at most
    Exponents exponents = {};
  };

  const Function& at(Element element) const { return functions_[static_cast<std::size_t>(element.number)]; }
  Residue residue(Element element) const { return element.negative ? -at(element).residue : at(element).residue; }
  template <class Combine>
  static Exponents combined(const Exponents& a, const Exponents& b, const Combine& combine);
  static Exponents added(const Exponents& a, const Exponents& b, int scale);
  static Exponents common(const Exponents& a, const Exponents& b);
  double raised(const Function& value, const Exponents& lesser) const;
  double degree_of(const Function& value) const;
  Element element_of(Function value);
  int number_of(std::uint64_t first_part) const;  ///< -1: none
  std::optional<Element> up_to_sign(int number, const Residue& key) const;

  void invert_first_parts();

  Element sum(Element a, Element b);
  Element product(Element a, Element b);
  Element quotient(Element a, Element b);
  Element circle(Op op, Element angle);
  Element other(Op op, std::array<Element, 3> arguments);

  std::vector<Function> functions_;
  std::vector<double> degrees_;                     ///< of the numerators of divisors
  std::unordered_map<std::uint64_t, int> numbers_;  ///< by the first parts of keys
  std::unordered_map<int, int> divisors_;           ///< number of a divisor by its function
  std::vector<std::uint64_t> inverse_parts_;        ///< first_parts_of_inverses of the functions so far
  std::vector<bool> seen_parts_;                    ///< first parts that came up, by their last bits
  std::map<int, std::pair<Element, Element>> circles_;
  std::map<std::pair<Op, std::array<Element, 3>>, Element> others_;
  std::uint64_t variables_ = 0;
};

/// Both lanes of each value of a program; those of a number are equal. inputs: in the order of program.inputs.
std::vector<std::array<Element, 2>> elements_of(const Program& program, FunctionField& field,
                                                std::span<const Element> inputs);

/// A variable for each input of a program.
std::vector<Element> input_variables(const Program& program, FunctionField& field);

}  // namespace mbgen
