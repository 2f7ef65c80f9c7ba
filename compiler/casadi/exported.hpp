#pragma once
// The functions that CasADi finds by name, with the patterns of their arguments and results.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/casadi/casadi_function.hpp"
#include "compiler/emit/context_values.hpp"

namespace mbgen {

/// The patterns of all functions, each once.
class PatternTable {
 public:
  /// Name of its array.
  std::string name_of(const Pattern& pattern);
  FrameRows rows() const { return rows_; }

 private:
  std::map<std::string, std::string> names_;
  FrameRows rows_;
};

/// A function with its arguments and results, each with its pattern. call: its value in C.
struct Exported {
  std::string name, call;
  std::vector<std::pair<std::string, Pattern>> inputs, outputs;
};

FrameValues exported_row(const Exported& exported, PatternTable& patterns);

/// A function and its derivatives, as CasADi 3.6 names them and orders their arguments. table: its data in C.
std::vector<Exported> exported_functions(const CasadiFunction& function, const CasadiArguments& arguments,
                                         const std::string& table);

}  // namespace mbgen
