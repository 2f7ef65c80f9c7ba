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

#include "compiler/program/number_table.hpp"
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
  std::optional<Element> known_difference(Element a, Element b) const {
    const std::uint64_t part = first_part_of_sum(part_of(a), part_of(with_sign(b, true)));
    return may_be_known(part) ? known_difference(a, b, part) : std::nullopt;
  }
  std::optional<Element> known_quotient(Element a, Element b);

  std::size_t size() const { return residues_.size(); }
  /// Makes room for so many functions.
  void reserve(std::size_t count);

 private:
  struct Power {
    int divisor = 0, exponent = 0;  ///< not 0
    friend bool operator==(const Power&, const Power&) = default;
  };
  /// A value is numerator times the numerators of divisors to these powers, in the order of their numbers: a run of
  /// powers_, which values share where they have the same.
  struct Exponents {
    std::uint32_t first = 0, count = 0;
  };
  /// A function in the making, up to its sign, which makes the residue the smaller one.
  struct Function {
    Residue key = {};   ///< as it came up
    double degree = 1;  ///< of the numerator, at most
    Exponents exponents = {};
  };
  struct Numerator {
    double degree = 1;
    Exponents exponents = {};
  };

  const Numerator& at(Element element) const { return numerators_[static_cast<std::size_t>(element.number)]; }
  Residue residue(Element element) const {
    const Residue& of_number = residues_[static_cast<std::size_t>(element.number)];
    return element.negative ? -of_number : of_number;
  }
  std::span<const Power> powers(Exponents exponents) const {
    return std::span(powers_).subspan(exponents.first, exponents.count);
  }
  /// Part of the first prime.
  std::uint64_t part_of(Element element) const {
    const std::uint64_t part = residues_[static_cast<std::size_t>(element.number)].parts[0];
    return element.negative && part != 0 ? kFirstPrime - part : part;
  }
  bool may_be_known(std::uint64_t first_part) const { return seen_parts_[first_part & (seen_parts_.size() - 1)]; }
  bool are_same(Exponents a, Exponents b) const;
  Exponents alone(int divisor);
  template <class Combine>
  Exponents combined(Exponents a, Exponents b, const Combine& combine);
  Exponents added(Exponents a, Exponents b, int scale);
  Exponents common(Exponents a, Exponents b);
  double raised(const Numerator& value, Exponents lesser) const;
  double degree_of(const Function& value) const;
  Element element_of(Function value);
  int number_of(std::uint64_t first_part) const;  ///< -1: none
  std::optional<Element> known_difference(Element a, Element b, std::uint64_t first_part) const;
  std::optional<Element> up_to_sign(int number, const Residue& key) const;

  void invert_first_parts();
  void mark_seen(std::uint64_t part);

  Element sum(Element a, Element b);
  Element product(Element a, Element b);
  Element quotient(Element a, Element b);
  Element circle(Op op, Element angle);
  Element other(Op op, std::array<Element, 3> arguments);

  // Per function, in the order in which they came up: neighbours in a program are neighbours here.
  std::vector<Residue> residues_;      ///< its key, or a variable's
  std::vector<Numerator> numerators_;  ///< of the same
  std::vector<std::uint64_t> parts_;   ///< first parts of keys
  std::vector<Power> powers_;
  std::size_t kept_powers_ = 0;                ///< of them those of functions; the others are of one in the making
  std::unordered_map<int, Residue> replaced_;  ///< keys of functions that count as variables
  NumberTable numbers_;                        ///< by the first parts of keys
  /// First parts that came up, by their last bits: unlike numbers_ it fits a cache.
  std::vector<bool> seen_parts_;
  std::vector<double> degrees_;               ///< of the numerators of divisors
  std::unordered_map<int, int> divisors_;     ///< number of a divisor by its function
  std::vector<std::uint64_t> inverse_parts_;  ///< first_parts_of_inverses of the functions so far
  std::unordered_map<int, std::pair<Element, Element>> circles_;
  std::map<std::pair<Op, std::array<Element, 3>>, Element> others_;
  std::uint64_t variables_ = 0;
};

/// Both lanes of each value of a program; those of a number are equal. inputs: in the order of program.inputs.
std::vector<std::array<Element, 2>> elements_of(const Program& program, FunctionField& field,
                                                std::span<const Element> inputs);

/// A variable for each input of a program.
std::vector<Element> input_variables(const Program& program, FunctionField& field);

}  // namespace mbgen
