#pragma once
// Names of the values of one program, and of the model's numbers in the text of one file.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/emit/names.hpp"
#include "compiler/emit/scalar.hpp"
#include "compiler/solver/programs.hpp"

namespace mbgen {

/// Unique names for the values of a program.
class LocalNames : public UniqueNames {
 public:
  explicit LocalNames(const Program& program) : program_(program) {}
  /// Name by the label of the value, or by the number of its step and a number in it: s3_12.
  std::string of_value(ValueId value);

 private:
  const Program& program_;
  std::map<int, int> leftovers_;  ///< numbers given so far, by step
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
  /// `constexpr double m_crank = 0.8;` for each constant that a text has used; empty without any. scalar: doubles or
  /// floats.
  std::string declarations(Scalar scalar) const;

 private:
  struct Entry {
    std::string identifier;
    NamedConstant constant;
    bool is_used = false;
  };
  Entry& entry_of(const NamedConstant& constant);
  std::vector<Entry> entries_;
  std::map<std::pair<std::string, double>, std::size_t> index_;
  UniqueNames names_;
};

}  // namespace mbgen
