#include "compiler/emit/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "compiler/emit/mapped.hpp"
#include "compiler/text/characters.hpp"

namespace mbgen {
namespace {

/// Shortest decimal text that reads back as the same number.
template <class Number>
std::string shortest_text(Number value) {
  if (std::isnan(value)) return "NAN";
  if (std::isinf(value)) return value > 0 ? "INFINITY" : "-INFINITY";
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  std::string text(buffer, end);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

std::string number_text(double value) { return shortest_text(value); }

std::string number_text(double value, Scalar scalar) {
  if (scalar != Scalar::floats || !std::isfinite(value)) return shortest_text(value);
  return shortest_text(static_cast<float>(value)) + "f";
}

std::string number_or_none(const std::optional<double>& number) { return number ? number_text(*number) : ""; }

std::string size_text(int size) { return std::to_string(std::max(size, 1)); }

std::string string_literal(std::string_view text) {
  std::string literal = "\"";
  for (const auto& [character, is_plain] : characters_of(text)) {
    // A second question mark could make a trigraph.
    const bool is_escaped = character == "\"" || character == "\\" || (character == "?" && literal.back() == '?');
    if (is_escaped) literal += '\\';
    if (is_plain) literal += character;
    // Three octal digits: a hexadecimal escape would swallow the digits after it.
    for (const char c : is_plain ? std::string_view() : character)
      literal += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return literal + "\"";
}

std::string comment_text(std::string_view text) {
  std::string result = line_text(text);
  // Both would join the next line to the comment.
  if (result.ends_with('\\') || result.ends_with("?\?/")) result += '.';
  return result;
}

std::string joined(const std::vector<std::string>& texts, std::string_view separator) {
  return fmt::format("{}", fmt::join(texts, separator));
}

std::string wrapped_list(const std::vector<std::string>& items, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string result = margin;
  std::size_t column = indent;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
    const bool first_on_line = column == indent;
    if (!first_on_line && column + 1 + item.size() > kLineWidth) {
      result += "\n" + margin;
      column = indent;
    } else if (!first_on_line) {
      result += ' ';
      ++column;
    }
    result += item;
    column += item.size();
  }
  return result;
}

std::string braced_list(const std::string& head, const std::vector<std::string>& items, const std::string& tail) {
  const std::string single = head + "{" + wrapped_list(items, 0) + "}" + tail;
  if (single.size() <= kLineWidth && single.find('\n') == std::string::npos) return single;
  const std::size_t indent = head.find_first_not_of(' ');
  return head + "{\n" + wrapped_list(items, (indent == std::string::npos ? 0 : indent) + 4) + "}" + tail;
}

std::string array_text(const std::string& head, std::vector<std::string> items, const std::string& filler) {
  if (items.empty()) items.push_back(filler);
  return braced_list(head + "[] = ", items, ";");
}

std::vector<std::string> number_texts(const std::vector<double>& values, Scalar scalar) {
  return mapped(values, [&](double value) { return number_text(value, scalar); });
}

std::vector<std::string> member_places(const std::string& structure, const std::vector<std::string>& members) {
  return mapped(members, [&](const std::string& member) { return "&" + structure + "::" + member; });
}

std::string wrapped_statement(const std::string& line) {
  const std::size_t indent = line.find_first_not_of(' ');
  const std::string margin(indent == std::string::npos ? 4 : indent + 4, ' ');
  std::string result;
  std::string rest = line;
  while (rest.size() > kLineWidth) {
    // Breaks after a comma if the line is then at least half full, else at any space, else beyond the limit.
    const std::size_t comma = rest.rfind(", ", kLineWidth - 1);
    std::size_t cut = comma != std::string::npos && comma > kLineWidth / 2 ? comma + 1 : rest.rfind(' ', kLineWidth);
    if (cut == std::string::npos || cut <= margin.size()) cut = rest.find(' ', kLineWidth);
    if (cut == std::string::npos) break;
    result += rest.substr(0, cut) + "\n";
    rest = margin + rest.substr(cut + 1);
  }
  return result + rest;
}

std::string wrapped_words(const std::string& words, const std::string& margin) {
  std::string result, line = margin;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    const bool is_first = line.size() == margin.size();
    if (!is_first && line.size() + 1 + word.size() > kLineWidth) {
      result += line + "\n";
      line = margin + word;
    } else {
      line += (is_first ? "" : " ") + word;
    }
  }
  return result + line;
}

std::string word_of_member(const std::string& member) {
  std::string word;
  for (std::size_t i = 0; i < member.size(); ++i) {
    if (member[i] == ']') continue;
    if (member[i] != '[') {
      word += member[i] == '.' ? '_' : member[i];
      continue;
    }
    const std::size_t end = member.find(']', i), scope = member.rfind("::", end);
    if (scope != std::string::npos && scope > i) i = scope + 1;
    word += '_';
  }
  return word;
}

}  // namespace mbgen
