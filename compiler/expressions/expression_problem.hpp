#pragma once
// A problem in the text of an expression.

#include <cstddef>
#include <string>

namespace mbgen::reading {

struct ExpressionProblem {
  std::size_t offset = 0;  ///< byte of the text
  std::string message;
  std::string hint;
};

}  // namespace mbgen::reading
