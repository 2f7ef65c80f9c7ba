#include "compiler/model/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/model/characters.hpp"

namespace mbgen {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c); }
bool is_tail_of_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// Place behind the string that starts at `begin` with its quote; the end of the line when it does not end there.
std::size_t end_of_string(const std::string& line, std::size_t begin) {
  for (std::size_t i = begin + 1; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '"') {
      return i + 1;
    }
  }
  return line.size();
}

/// Place behind the number that starts at `begin`; a sign belongs to it at its start and after an exponent's letter.
std::size_t end_of_number(const std::string& line, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < line.size()) {
    const bool is_sign = line[end] == '-' || line[end] == '+';
    const bool after_exponent = line[end - 1] == 'e' || line[end - 1] == 'E';
    if (!is_digit(line[end]) && line[end] != '.' && line[end] != 'e' && line[end] != 'E' &&
        !(is_sign && after_exponent))
      break;
    ++end;
  }
  return end;
}

/// Blanks up to the column, with the line's own tabs and without the tails of UTF-8 characters, so that the caret
/// aligns.
std::string padding(const std::string& line, int column) {
  std::string blanks;
  for (int i = 0; i + 1 < column && i < static_cast<int>(line.size()); ++i) {
    const char byte = line[static_cast<std::size_t>(i)];
    if (is_tail_of_character(byte)) continue;
    blanks += byte == '\t' ? '\t' : ' ';
  }
  return blanks;
}

/// A caret under the first character of the value, and tildes under the rest of it.
std::string mark(const std::string& line, int column) {
  const int length = marked_length(line, column);
  int characters = 0;
  for (int i = 0; i < length; ++i) {
    const auto place = static_cast<std::size_t>(column - 1 + i);
    if (place >= line.size() || !is_tail_of_character(line[place])) ++characters;
  }
  std::string text(static_cast<std::size_t>(std::max(characters, 1)), '~');
  text.front() = '^';
  return text;
}

/// Escape sequences of terminals around a text.
std::string coloured(Style style, const char* colour, const std::string& text) {
  return style == Style::plain ? text : fmt::format("\033[{}m{}\033[0m", colour, text);
}
constexpr const char *kBold = "1", *kRed = "1;31", *kGreen = "1;32", *kCyan = "36";

}  // namespace

std::string hint_of_missing(std::string_view name) {
  return name == "-" ? "standard input is /dev/stdin, a file of this name is ./-" : "";
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::string result = "\"";
  for (const auto& [character, is_plain] : characters_of(text.substr(0, kLongest)))
    result += is_plain ? character : "?";
  if (text.size() > kLongest) result += "...";
  result += '"';
  return result;
}

int marked_length(const std::string& line, int column) {
  if (column < 1 || static_cast<std::size_t>(column) > line.size()) return 1;
  const auto begin = static_cast<std::size_t>(column - 1);
  std::size_t end = begin + 1;
  const char first = line[begin];
  const bool is_negative = first == '-' && end < line.size() && is_digit(line[end]);
  if (first == '"') {
    end = end_of_string(line, begin);
  } else if (is_digit(first) || is_negative) {
    end = end_of_number(line, begin);
  } else if (is_of_name(first)) {
    while (end < line.size() && is_of_name(line[end])) ++end;
  } else {
    while (end < line.size() && is_tail_of_character(line[end])) ++end;
  }
  return static_cast<int>(end - begin);
}

std::string to_text(const Diagnostic& diagnostic, Style style) {
  const Where& where = diagnostic.where;
  std::string place = terminal_text(where.file);
  if (where.line > 0) place += fmt::format(":{}:{}", where.line, where.column);
  std::string text = coloured(style, kBold, place + ":") + " ";
  if (!where.pointer.empty()) text += terminal_text(where.pointer) + ": ";
  text += coloured(style, kRed, terminal_text(diagnostic.message)) + "\n";
  const std::string& line = diagnostic.source_line.empty() ? where.line_text : diagnostic.source_line;
  if (!line.empty()) {
    text += "  " + terminal_text(line) + "\n  " + padding(line, where.column) +
            coloured(style, kGreen, mark(line, where.column)) + "\n";
  }
  if (!diagnostic.hint.empty())
    text += "  " + coloured(style, kCyan, "hint:") + " " + terminal_text(diagnostic.hint) + "\n";
  return text;
}

std::string to_text(const Diagnostics& diagnostics, Style style) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += to_text(diagnostic, style);
  return text;
}

}  // namespace mbgen
