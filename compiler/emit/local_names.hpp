#pragma once
// Names of the values of one program, and of the model's numbers in the text of one file.

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/names.hpp"
#include "compiler/emit/scalar.hpp"
#include "compiler/solver/programs.hpp"

namespace mbgen {

/// Unique names for the values of a program.
class LocalNames : public UniqueNames {
 public:
  explicit LocalNames(const Program& program) : program_(program) {}
  /// From now on a value without a label that one other value alone needs is named as a part of that: Fz_tyre_part_2.
  /// results: per value the name of the result that it is, or "".
  void name_parts(const std::vector<std::string>& results);
  /// Name by the label of the value, else as a part, else by the number of its step and a number in it: s3_12.
  std::string of_value(ValueId value);

 private:
  const Program& program_;
  std::vector<std::string> whole_;    ///< per value: the name of the value that it is a part of, or ""
  std::map<std::string, int> parts_;  ///< numbers given so far, by name of the whole
  std::map<int, int> leftovers_;      ///< likewise, by step
};

/// Identifiers of named constants, one table for all programs of a file.
class ConstantNames {
 public:
  /// The constants of all programs, in the order of the programs and of their first uses.
  explicit ConstantNames(const WrittenPrograms& programs);
  /// Identifiers for a program: each stands for one value in the whole file; a second value with the same name gets a
  /// number.
  std::vector<std::string> identifiers(const Program& program);
  /// The constant as an expression: its identifier, or the negative of it.
  std::string text(const Program& program, const Node& node);
  /// The uses by texts that were written with a copy of these names beside each other.
  void add_uses(const ConstantNames& copy);
  /// `constexpr double m_crank = 0.8;` for each constant that a text has used; empty without any. In programs for
  /// reading a folded one by its operation, after its operands: `constexpr double m_axle = m_beam + m_hub;  // 310.0`.
  /// scalar: doubles or floats.
  std::string declarations(Scalar scalar);

 private:
  struct Entry {
    std::string identifier;  ///< empty: an anonymous fold that no text has used
    NamedConstant constant;  ///< `labels` are indices into entries_
    bool is_used = false;
    bool is_declared = false;
  };
  /// Number of the entry of a program's constant; its operands have entries too.
  std::int32_t entry_of(const Program& program, std::int32_t label);
  /// Name of an anonymous fold by its operation: half_m_arm, mp_arm_x, sum_of_m_a_and_m_b; by its kind where that is
  /// long.
  std::string name_of_fold(const Entry& entry) const;
  /// The operand of a fold by name, "" for a number without one.
  std::string name_of_operand(const Entry& entry, int k) const;
  /// Writes the declaration of an entry after those of its operands.
  void declare(Entry& entry, Scalar scalar, std::string& text);
  /// The operation of a fold, anonymous operands within it.
  Phrase operation_of(const Entry& entry, Scalar scalar) const;
  bool is_written_out(const Entry& entry) const { return entry.identifier.empty(); }
  /// Whether a constant expression of C++ can compute the fold.
  bool is_arithmetic(const Entry& entry) const;

  using FoldKey = std::tuple<Op, double, double, std::int32_t, std::int32_t>;
  std::vector<Entry> entries_;
  std::map<std::pair<std::string, double>, std::int32_t> index_;
  std::map<FoldKey, std::int32_t> fold_index_;
  UniqueNames names_;
};

}  // namespace mbgen
