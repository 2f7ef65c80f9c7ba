#pragma once
// A program that is linear in derivatives, as sums of products of a slope and a derivative: the graph in which
// derivatives on the way are passed over where that is shorter.

#include <array>
#include <functional>
#include <set>
#include <span>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Operations on slopes, appended to the program of values. An operation on the same lane of pairs is done on the
/// pairs.
class SlopeArithmetic {
 public:
  explicit SlopeArithmetic(ProgramBuilder& values) : values_(values) {}

  ValueId append(Op op, ValueId a, ValueId b, ValueId c = kNoValue);
  /// a b, which takes no operation where one of them is 1.
  ValueId product(ValueId a, ValueId b);
  ValueId one() { return values_.constant(1); }
  ValueId negative(ValueId slope) { return values_.append(Op::negate, slope); }
  void set_origin(const Node& node) { values_.set_origin(node); }
  bool is_one(ValueId slope) const { return values_.is_constant(slope, 1); }
  bool is_zero(ValueId slope) const { return values_.is_constant(slope, 0); }
  /// Operations of a product or a sum, half of one where pairs share it.
  double cost_of_product(ValueId a, ValueId b) const;
  double cost_of_sum(ValueId a, ValueId b) const;

  /// A slope without its sign.
  struct Signed {
    ValueId slope = kNoValue;
    bool is_negative = false;
  };
  Signed without_sign(ValueId slope);

 private:
  bool is_constant(ValueId slope) const { return values_.is_constant(slope); }
  bool share_lane(std::span<const ValueId> slopes) const;

  ProgramBuilder& values_;
};

/// Times slope times the derivative `from`, added or subtracted.
struct DerivativeTerm {
  std::size_t from = 0;
  ValueId slope = kNoValue;
  bool is_negative = false;
};

/// A derivative: an input, a sum of terms, or an operation that is no sum.
struct Derivative {
  ValueId node = kNoValue;  ///< of the linear program
  bool is_sum = false;
  std::vector<DerivativeTerm> terms;  ///< at most one from each derivative
  std::set<std::size_t> users;        ///< sums with a term from it
  int other_users = 0;                ///< outputs, and operations that are no sums
};

/// The derivatives of a linear program. slope_of: the slope of each of its values, in the program of values, kNoValue
/// for derivatives.
class DerivativeSums {
 public:
  DerivativeSums(const Program& linear, std::span<const ValueId> slope_of, SlopeArithmetic& slopes);

  /// Passes over derivatives where the users' sums over what these follow from are shorter. slope_cost: of an operation
  /// on slopes, over one on derivatives.
  ///   dy = a dx; dz = b dy + c dx   =>   dz = (b a + c) dx
  void shorten(double slope_cost);

  /// The program of the sums. taken: the value of a slope there.
  Program program(const std::function<ValueId(ProgramBuilder&, ValueId)>& taken) const;

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  /// The derivative that another one is a multiple of, kNone with the slope 0 for the constant 0.
  struct Multiple {
    std::size_t of = kNone;
    ValueId slope = kNoValue;
  };

  void read(ValueId v);
  void add_term(std::size_t sum, DerivativeTerm term);
  bool passes_over(std::size_t d, double slope_cost, double least_gain);
  double gain(std::size_t d, double slope_cost) const;
  double gain_in(std::size_t user, const Derivative& passed, const DerivativeTerm& term, double slope_cost) const;
  double length(std::span<const DerivativeTerm> terms) const;
  bool choose_slopes();
  Multiple multiple(ValueId operand);
  ValueId written_sum(ProgramBuilder& builder, const Derivative& sum, std::span<const ValueId> written,
                      const std::function<ValueId(ProgramBuilder&, ValueId)>& taken) const;

  const Program& linear_;
  std::span<const ValueId> slope_of_;
  SlopeArithmetic& slopes_;
  std::vector<Derivative> derivatives_;
  std::vector<std::size_t> derivative_of_;  ///< per value of the linear program, kNone for slopes
};

}  // namespace mbgen
