#pragma once
// Characters of text that people write, in UTF-8.

#include <string>
#include <string_view>
#include <vector>

namespace mbgen {

struct Character {
  std::string_view bytes;
  /// No control character, end of a line, control of the direction of writing (it makes code look other than it is), or
  /// byte that belongs to no character.
  bool is_plain = true;
};

/// The characters of a text, in order. The views are into the text.
std::vector<Character> characters_of(std::string_view text);

/// Text on one line: characters that are not plain become spaces. For comments, fields of tables, titles.
std::string line_text(std::string_view text);

/// Text without blanks, tabs and returns at its ends.
std::string_view without_blanks(std::string_view text);

/// Text that cannot command a terminal: `?` for characters that are not plain, but for ends of lines and tabs.
std::string terminal_text(std::string_view text);

/// Text on one line between tags of XML or HTML, or as the value of an attribute.
std::string xml_text(std::string_view text);

/// JSON that a terminal can show: characters that are not plain are escaped (\u202e); they stand in strings only.
/// Requires: JSON in UTF-8.
std::string json_shown(std::string_view json);

}  // namespace mbgen
