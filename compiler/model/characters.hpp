#pragma once
// Characters of text that people write, in UTF-8.

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

}  // namespace mbgen
