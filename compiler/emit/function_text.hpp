#pragma once
// Functions and structs around the statements of a program.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/emit/shapes.hpp"

namespace mbgen {

/// A struct of values that cross the parts of a program: an argument of the parts, and its members.
struct CrossingStruct {
  std::string argument;  ///< "w1", "w2", ...
  int number;            ///< of the struct, from 1 on
  struct Place {
    std::string type;
    std::vector<std::string> names;  ///< declarators of the values that follow one another there
  };
  std::vector<Place> places = {};
};

using CrossingStructs = std::vector<CrossingStruct>;

/// Statements of one part, and data for its function.
struct PartText {
  std::string body;
  std::string indent = "  ";          ///< of the lines that come next
  std::set<std::string> arguments;    ///< names that the body uses, those of `crossing` and "result" among them
  std::vector<std::string> sections;  ///< titles, each once, in the order of their first lines
  std::optional<int> ended_step;      ///< number of the step that ends with this part
};

/// Adds a statement.
void add_line(PartText& part, const std::string& statement);

/// Adds words as a comment of its own lines.
void add_comment(PartText& part, const std::string& words);

/// Start of the definition of a program's function, all of its arguments used.
std::string function_declaration(const ProgramShape& shape);

/// Struct of the result (if the shape has members), struct of the values that cross parts (if there are any), one
/// static function per part and the function that calls them; a single part is that function itself. crossing: structs
/// of the values that cross parts. law_part: see Schedule. In a file with parts, the parts that only call the function
/// see the struct of its result and a declaration.
std::string function_text(const ProgramShape& shape, const std::vector<PartText>& parts,
                          const CrossingStructs& crossing, std::size_t law_part);

}  // namespace mbgen
