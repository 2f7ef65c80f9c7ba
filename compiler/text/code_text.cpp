#include "workbench/engines/code_without_comments.hpp"

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

/// Position behind the literal that begins with the quotation mark at `at`.
std::size_t end_of_literal(std::string_view text, std::size_t at) {
  if (text[at] == '"' && is_raw(text, at)) {
    const std::size_t open = std::min(text.find('(', at), text.size() - 1);
    return behind(text, ")" + std::string(text.substr(at + 1, open - at - 1)) + "\"", open);
  }
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != text[at] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

/// Whether a literal begins at `at`: an apostrophe within a number or a word separates digits.
bool begins_literal(std::string_view text, std::size_t at) {
  return text[at] == '"' || (text[at] == '\'' && (at == 0 || !is_of_word(text[at - 1])));
}

/// Ends the last line of `code` without blanks; a line of blanks alone is none.
void end_line(std::string& code) {
  const std::size_t last = code.find_last_not_of(" \t\r");
  code.resize(last == std::string::npos ? 0 : last + 1);
  if (!code.empty() && code.back() != '\n') code += '\n';
}

}  // namespace

std::string code_without_comments(std::string_view text) {
  std::string code;
  code.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.substr(at, 2) == "/*") {
      at = behind(text, "*/", at + 2);
      code += ' ';
    } else if (begins_literal(text, at)) {
      const std::size_t end = end_of_literal(text, at);
      code += text.substr(at, end - at);
      at = end;
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
