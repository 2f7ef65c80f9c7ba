#include "compiler/text/characters.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

namespace mbgen {
namespace {

/// Number of bytes of the first UTF-8 character of a text, 0 for an invalid one. Requires: a text that is not empty.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xC2 ? 0 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
  if (size > text.size() || byte(0) > 0xF4) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return 0;
  }
  // Overlong encodings, surrogates, and values beyond U+10FFFF.
  const bool refused = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F) ||
                       (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F);
  return refused ? 0 : size;
}

/// Characters not allowed in code: control characters, line ends, controls of writing direction (displayed code would
/// differ from the actual code), and U+FFFE and U+FFFF, which XML excludes.
bool is_control(std::string_view character) {
  const auto last = static_cast<unsigned char>(character.back());
  if (character.size() == 1) return last < 0x20 || last == 0x7f;
  if (character.size() == 2) return (character[0] == '\xC2' && last < 0xA0) || character == "\xD8\x9C";
  if (character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF") return true;
  const std::string_view start = character.substr(0, 2);
  if (start == "\xE2\x80") return last == 0x8E || last == 0x8F || (last >= 0xA8 && last <= 0xAE);
  return start == "\xE2\x81" && last >= 0xA6 && last <= 0xA9;
}

/// Code point of a character of at most three bytes. Requires: UTF-8.
unsigned code_point(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(character[i])); };
  if (character.size() == 1) return byte(0);
  if (character.size() == 2) return (byte(0) & 0x1Fu) << 6 | (byte(1) & 0x3Fu);
  return (byte(0) & 0x0Fu) << 12 | (byte(1) & 0x3Fu) << 6 | (byte(2) & 0x3Fu);
}

}  // namespace

std::vector<Character> characters_of(std::string_view text) {
  std::vector<Character> characters;
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    const std::string_view bytes = text.substr(0, size == 0 ? 1 : size);
    characters.push_back({bytes, size > 0 && !is_control(bytes)});
    text.remove_prefix(bytes.size());
  }
  return characters;
}

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char letter : text)
    if (letter == separator)
      parts.emplace_back();
    else
      parts.back() += letter;
  return parts;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

std::string line_text(std::string_view text) {
  std::string result;
  for (const auto& [character, is_plain] : characters_of(text)) result += is_plain ? character : " ";
  return result;
}

std::string terminal_text(std::string_view text) {
  std::string result;
  for (const auto& [character, is_plain] : characters_of(text)) {
    result += is_plain || character == "\n" || character == "\t" ? character : "?";
  }
  return result;
}

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : line_text(text)) {
    const char* escaped = c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : nullptr;
    result += escaped == nullptr ? std::string(1, c) : escaped;
  }
  return result;
}

std::string json_shown(std::string_view json) {
  std::string result;
  for (const auto& [character, is_plain] : characters_of(json)) {
    if (is_plain || character == "\n" || character.size() > 3) {
      result += character;
    } else {
      fmt::format_to(std::back_inserter(result), "\\u{:04x}", code_point(character));
    }
  }
  return result;
}

}  // namespace mbgen
