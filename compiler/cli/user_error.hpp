#pragma once
// What the command line throws when the user's input is at fault; main turns it into exit code 1.

#include <stdexcept>
#include <string>

#include "compiler/model/diagnostic.hpp"

namespace mbgen::cli {

/// The user's input, files or surroundings are at fault. The text is complete: lines for standard error.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Value of a result. Fails: UserError with the text of every diagnostic.
template <class Value>
Value expect(Result<Value> result) {
  if (!result) throw UserError(to_text(result.problems()));
  return std::move(*result);
}

}  // namespace mbgen::cli
