#pragma once
// Exception of the command line for faults of the user's input; main returns exit code 1.

#include <stdexcept>
#include <string>

#include "compiler/text/diagnostic.hpp"

namespace mbgen {

/// Fault of the user's input, files or environment. The text is complete: lines for standard error.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// Faults of a model, place by place.
  explicit UserError(Diagnostics problems) : std::runtime_error(to_text(problems)), problems_(std::move(problems)) {}

  /// Faults of the model; none where the surroundings are at fault.
  const Diagnostics& problems() const { return problems_; }

  /// The text for a terminal or a pipe.
  std::string text(Style style) const { return problems_.empty() ? what() : to_text(problems_, style); }

 private:
  Diagnostics problems_;
};

/// Value of a result. Fails: UserError with every diagnostic.
template <class Value>
Value expect(Result<Value> result) {
  if (!result) throw UserError(result.problems());
  return std::move(*result);
}

}  // namespace mbgen
