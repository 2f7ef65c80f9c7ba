#pragma once
// Errors of the compiler are values: a stage returns its result or all diagnostics.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace mbgen {

/// Position of a value in the model's files.
struct Where {
  std::string file;            ///< as given on the command line or in `include`
  int line = 0;                ///< 1-based; 0 without a line (for example a missing file)
  int column = 0;              ///< 1-based, in bytes
  std::string pointer;         ///< JSON pointer (RFC 6901), "" for the whole document
  std::string line_text = {};  ///< the line of text, shown under the message; empty when unknown or very long
};

/// One problem: `file:line:column: pointer: message`, then the source line with a caret and a hint.
struct Diagnostic {
  Where where;
  std::string message;      ///< rule and value, lower case, no full stop
  std::string hint;         ///< next step; may be empty
  std::string source_line;  ///< line of text at `where`; if empty, where.line_text is shown
};

using Diagnostics = std::vector<Diagnostic>;

/// A name in quotes, for messages.
inline std::string quoted(const std::string& name) { return '"' + name + '"'; }

/// Hint for a missing file: a file beside it with a similar name; empty if there is none.
std::string hint_of_missing(std::string_view name);

/// Text of a file for messages: in double quotes, without control characters, shortened if long.
std::string in_quotes(std::string_view text);

/// Number of bytes to mark from `column` (1-based) of a line: a string with its quotes, a number, a name, else one
/// character.
int marked_length(const std::string& line, int column);

/// For files and pipes, or for terminals.
enum class Style { plain, coloured };
/// `did you mean "x"?` for a candidate similar to the word; else the candidates if they are few; else empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates);

/// One diagnostic as text, with a final newline.
std::string to_text(const Diagnostic& diagnostic, Style style = Style::plain);

/// All diagnostics as text, in order of appearance.
std::string to_text(const Diagnostics& diagnostics, Style style = Style::plain);

/// Whether two texts differ only by names of placed parts, "fl_wheel" and "fr_wheel": one prefix (or suffix) instead of
/// another, the same throughout.
bool same_but_for_instance(std::string_view one, std::string_view other);

/// Merges diagnostics at one place with messages that differ only by the instance into the first, "(and 3 more like
/// it)".
Diagnostics grouped(Diagnostics diagnostics);

/// A value, or the diagnostics of the failure.
template <class Value>
class Result {
 public:
  Result(Value value) : content_(std::move(value)) {}
  Result(Diagnostics problems) : content_(std::move(problems)) {}
  Result(Diagnostic problem) : content_(Diagnostics{std::move(problem)}) {}

  explicit operator bool() const { return content_.index() == 0; }
  /// Requires: the result holds a value.
  const Value& operator*() const { return std::get<0>(content_); }
  Value& operator*() { return std::get<0>(content_); }
  const Value* operator->() const { return &std::get<0>(content_); }
  Value* operator->() { return &std::get<0>(content_); }
  /// Requires: the result holds diagnostics.
  const Diagnostics& problems() const { return std::get<1>(content_); }

 private:
  std::variant<Value, Diagnostics> content_;
};

}  // namespace mbgen
