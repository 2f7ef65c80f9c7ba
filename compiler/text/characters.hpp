#pragma once
// UTF-8 characters of text from people.

#include <string>
#include <string_view>
#include <vector>

namespace mbgen {

struct Character {
  std::string_view bytes;
  /// No control character, line end, control of writing direction (displayed code would differ from the actual code),
  /// or invalid byte.
  bool is_plain = true;
};

/// The characters of a text, in order. The views are into the text.
std::vector<Character> characters_of(std::string_view text);

/// Text on one line: characters that are not plain become spaces. For comments, fields of tables, titles.
std::string line_text(std::string_view text);

/// The parts between separators, one more than there are of these.
std::vector<std::string> split_at(std::string_view text, char separator);

/// Text without blanks, tabs and returns at its ends.
std::string_view without_blanks(std::string_view text);

/// Text that is safe on a terminal: `?` for characters that are not plain, except line ends and tabs.
std::string terminal_text(std::string_view text);

/// Text on one line, escaped for XML or HTML, content or value of an attribute.
std::string xml_text(std::string_view text);

/// JSON that is safe on a terminal: characters that are not plain are escaped (\u202e); they occur in strings only.
/// Requires: JSON in UTF-8.
std::string json_shown(std::string_view json);

}  // namespace mbgen
