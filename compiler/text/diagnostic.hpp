#pragma once
// Errors of the compiler are values: a stage returns its result or every diagnostic it found.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace mbgen {

/// Where a value of the model was written.
struct Where {
  std::string file;            ///< as given on the command line or in `include`
  int line = 0;                ///< 1-based; 0 when the text has no line (for example a missing file)
  int column = 0;              ///< 1-based, in bytes
  std::string pointer;         ///< JSON pointer (RFC 6901), "" for the whole document
  std::string line_text = {};  ///< the line of text, shown under the message; empty when unknown or very long
};

/// One problem: `file:line:column: pointer: message`, then the source line with a caret and a hint.
struct Diagnostic {
  Where where;
  std::string message;      ///< rule and value, lower case, no full stop
  std::string hint;         ///< next step; may be empty
  std::string source_line;  ///< the line of text that `where` names; when empty, where.line_text is shown
};

using Diagnostics = std::vector<Diagnostic>;

/// A name as messages show it.
inline std::string quoted(const std::string& name) { return '"' + name + '"'; }

/// Hint where there is no file of a name: the one beside it that was probably meant; empty where nothing is known.
std::string hint_of_missing(std::string_view name);

/// Text of a file as messages show it: in double quotes, without control characters, shortened when long.
std::string in_quotes(std::string_view text);

/// Number of bytes from `column` (1-based) of a line that a message about this place means: a string with its quotes, a
/// number, a name, else one character.
int marked_length(const std::string& line, int column);

/// For files and pipes, or for terminals.
enum class Style { plain, coloured };
/// `did you mean "x"?` when a candidate is near a word; else the candidates when they are few; else empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates);

/// Text of one diagnostic as people read it, with a final newline.
std::string to_text(const Diagnostic& diagnostic, Style style = Style::plain);

/// Text of all diagnostics, in order of appearance.
std::string to_text(const Diagnostics& diagnostics, Style style = Style::plain);

/// Whether two texts differ by the names of placed parts alone, "fl_wheel" and "fr_wheel": one prefix (or suffix) in
/// place of another, the same ones all through.
bool same_but_for_instance(std::string_view one, std::string_view other);

/// Diagnostics at one place whose messages are the same but for the instance become the first of them, "(and 3 more
/// like it)".
Diagnostics grouped(Diagnostics diagnostics);

/// A value, or the diagnostics that say why there is none.
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
