#include "compiler/text/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "compiler/text/characters.hpp"

namespace mbgen {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c); }
bool is_tail_of_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// End of the string that starts at `begin` with its quote; the end of the line for an open string.
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

/// End of the number that starts at `begin`; a sign belongs to it at its start and after an exponent's letter.
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

/// Blanks up to the column, with the line's own tabs and without continuation bytes of UTF-8, for alignment of the
/// caret.
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

/// `did you mean "front.json"?` for a file of similar name and same extension in the directory.
std::string nearest_file(const std::filesystem::path& missing) {
  constexpr int kMostEntries = 2000;  // of a directory; larger ones are not searched
  std::error_code error;
  if (std::filesystem::exists(missing, error)) return {};
  std::vector<std::string> stems;
  const std::filesystem::path directory = missing.has_parent_path() ? missing.parent_path() : ".";
  std::filesystem::directory_iterator entry(directory, error);
  for (int i = 0; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (++i > kMostEntries) return {};
    if (entry->path().extension() == missing.extension()) stems.push_back(entry->path().stem().string());
  }
  std::sort(stems.begin(), stems.end());
  const std::string stem = missing.stem().string(), hint = did_you_mean(stem, {stems.begin(), stems.end()});
  const std::size_t end = hint.rfind('"');
  const bool is_near = hint.starts_with("did you mean \"") && hint.ends_with("\"?");
  return is_near ? hint.substr(0, end) + missing.extension().string() + hint.substr(end) : "";
}

/// The parts in which two names differ.
using Parts = std::pair<std::string_view, std::string_view>;

/// "fl" and "fr" of "fl_wheel" and "fr_wheel"; nothing without a common ending.
std::optional<Parts> prefix_parts(std::string_view a, std::string_view b) {
  std::size_t shared = 0;
  while (shared < std::min(a.size(), b.size()) && a[a.size() - 1 - shared] == b[b.size() - 1 - shared]) ++shared;
  if (a.substr(a.size() - shared).find('_') == std::string_view::npos) return std::nullopt;
  return Parts{a.substr(0, a.size() - shared), b.substr(0, b.size() - shared)};
}

/// "left" and "right" of "wheel_left" and "wheel_right"; nothing without a common beginning, or for coordinates of one
/// joint: wheel_rx and wheel_ry.
std::optional<Parts> suffix_parts(std::string_view a, std::string_view b) {
  const std::size_t most = std::min(a.size(), b.size());
  const auto differ = static_cast<std::size_t>(
      std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(most), b.begin()).first - a.begin());
  const std::size_t line = a.substr(0, differ).rfind('_');
  if (line == std::string_view::npos) return std::nullopt;
  const Parts parts{a.substr(line + 1), b.substr(line + 1)};
  constexpr std::size_t kFreedom = 2;  // letters of rx, t1
  if (parts.first.size() <= kFreedom || parts.second.size() <= kFreedom) return std::nullopt;
  return parts;
}

/// Whether two texts are equal except for words that all differ by the same pair of parts.
template <class PartsOf>
bool differ_by_one_part(std::string_view one, std::string_view other, PartsOf parts_of) {
  std::optional<Parts> known;
  const auto word_at = [](std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && is_of_name(text[end])) ++end;
    return text.substr(at, end - at);
  };
  std::size_t i = 0, k = 0;
  while (i < one.size() && k < other.size()) {
    const std::string_view a = word_at(one, i), b = word_at(other, k);
    if (a.empty() || b.empty()) {
      if (one[i] != other[k]) return false;
      ++i, ++k;
      continue;
    }
    i += a.size(), k += b.size();
    if (a == b) continue;
    if (is_digit(a.front()) || is_digit(b.front())) return false;
    const std::optional<Parts> parts = parts_of(a, b);
    if (!parts || (known && *known != *parts)) return false;
    known = parts;
  }
  return i == one.size() && k == other.size();
}

/// Text within escape sequences for colours.
std::string coloured(Style style, const char* colour, const std::string& text) {
  return style == Style::plain ? text : fmt::format("\033[{}m{}\033[0m", colour, text);
}
constexpr const char *kBold = "1", *kRed = "1;31", *kGreen = "1;32", *kCyan = "36";

}  // namespace

std::string hint_of_missing(std::string_view name) {
  if (name == "-") return "standard input is /dev/stdin, a file of this name is ./-";
  return nearest_file(std::filesystem::path(name));
}

bool same_but_for_instance(std::string_view one, std::string_view other) {
  if (one == other) return true;
  return differ_by_one_part(one, other, prefix_parts) || differ_by_one_part(one, other, suffix_parts);
}

Diagnostics grouped(Diagnostics diagnostics) {
  Diagnostics firsts;
  std::vector<int> more;
  for (Diagnostic& one : diagnostics) {
    const auto says_the_same = [&](const Diagnostic& first) {
      return first.where.file == one.where.file && first.where.line == one.where.line &&
             first.where.column == one.where.column && same_but_for_instance(first.message, one.message);
    };
    const auto first = std::find_if(firsts.begin(), firsts.end(), says_the_same);
    if (one.where.line > 0 && first != firsts.end()) {
      ++more[static_cast<std::size_t>(first - firsts.begin())];
      continue;
    }
    firsts.push_back(std::move(one));
    more.push_back(0);
  }
  for (std::size_t i = 0; i < firsts.size(); ++i)
    if (more[i] > 0) firsts[i].message += fmt::format(" (and {} more like it)", more[i]);
  return firsts;
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
