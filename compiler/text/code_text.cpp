#include "compiler/text/code_text.hpp"

#include <algorithm>
#include <cctype>

namespace mbgen {
namespace {

bool is_of_word(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Position behind the next `end` from `from` on, the end of the text without one.
std::size_t behind(std::string_view text, std::string_view end, std::size_t from) {
  const std::size_t found = text.find(end, from);
  return found == std::string_view::npos ? text.size() : found + end.size();
}

bool is_raw(std::string_view text, std::size_t quote) { return quote > 0 && text[quote - 1] == 'R'; }

/// Ends the last line of `code` without blanks; a line of blanks alone is none.
void end_line(std::string& code) {
  const std::size_t last = code.find_last_not_of(" \t\r");
  code.resize(last == std::string::npos ? 0 : last + 1);
  if (!code.empty() && code.back() != '\n') code += '\n';
}

}  // namespace

std::size_t end_of_comment(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
  return text.substr(at, 2) == "/*" ? behind(text, "*/", at + 2) : at;
}

std::size_t end_of_literal(std::string_view text, std::size_t at) {
  const char quote = text[at];
  // An apostrophe within a number separates digits.
  if (quote != '"' && (quote != '\'' || (at > 0 && is_of_word(text[at - 1])))) return at;
  if (quote == '"' && is_raw(text, at)) {
    const std::size_t open = std::min(text.find('(', at), text.size() - 1);
    return behind(text, ")" + std::string(text.substr(at + 1, open - at - 1)) + "\"", open);
  }
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != quote && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

std::string code_without_comments(std::string_view text) {
  std::string code;
  code.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t behind_comment = end_of_comment(text, at); behind_comment != at) {
      if (text[at + 1] == '*') code += ' ';
      at = behind_comment;
    } else if (const std::size_t behind_literal = end_of_literal(text, at); behind_literal != at) {
      code += text.substr(at, behind_literal - at);
      at = behind_literal;
    } else if (text[at] == '\n') {
      end_line(code);
      ++at;
    } else {
      code += text[at++];
    }
  }
  end_line(code);
  return code;
}

}  // namespace mbgen
