#pragma once
// Text of an expression and its words. A part of parse_expression.

#include <string_view>

#include "compiler/expressions/expression_nodes.hpp"
#include "compiler/expressions/names.hpp"

namespace mbgen::reading {

/// The text, read from at_ on.
class ExpressionText : protected ExpressionNodes {
 protected:
  explicit ExpressionText(std::string_view text) : text_(text) {}

  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  bool accept(char wanted) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  std::string_view word() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    return text_.substr(start, at_ - start);
  }

  /// The name in quotes that stands first in the brackets of a table; empty with a problem.
  std::string_view quoted_name() {
    skip_space();
    const std::size_t start = at_;
    const bool is_quoted = at_ < text_.size() && (text_[at_] == '\'' || text_[at_] == '"');
    const std::size_t end = is_quoted ? text_.find(text_[start], start + 1) : std::string_view::npos;
    if (end == std::string_view::npos) {
      fail(start, "table takes its name in quotes first", "table('NAME', x), of a map table('NAME', x, y)");
      return {};
    }
    at_ = end + 1;
    return text_.substr(start + 1, end - start - 1);
  }

  std::string_view text_;
};

}  // namespace mbgen::reading
