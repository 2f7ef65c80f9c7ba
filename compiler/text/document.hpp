#pragma once
// JSON with positions: a tree in which every value and key has its position in the text.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/text/diagnostic.hpp"

namespace mbgen::reading {

constexpr std::size_t kMaximumBytes = std::size_t{64} << 20;
constexpr std::size_t kMaximumValues = 2'000'000;
constexpr int kMaximumDepth = 64;

/// A position in a file of the model.
struct Place {
  std::uint32_t file = 0;    ///< index into Documents
  std::uint32_t offset = 0;  ///< bytes from the start of the text
};

struct Member;

/// A JSON value and its position.
struct Value {
  enum class Kind : std::uint8_t { null, boolean, number, text, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  Place place;
  double number = 0;
  std::string text;
  std::vector<Value> items;     ///< of an array
  std::vector<Member> members;  ///< of an object, in order of appearance
};

struct Member {
  std::string key;
  Place place;  ///< of the key's opening quote
  Value value;
};

/// One file.
struct Document {
  std::string file;
  std::string text;
  std::string identity;  ///< canonical path: a file used several times is parsed once
  bool parsed = false;   ///< without problems of syntax
  bool is_shown = true;  ///< false for a file of the wrong kind named by a model: messages do not show its text
  std::vector<std::uint32_t> line_starts;
  Value root;
};

/// The main file, then its includes in order of reading. A deque: pointers to values stay valid while files are added.
using Documents = std::deque<Document>;

struct Problem {
  Place place;
  std::string message;
  std::string hint;
  std::string instance = {};  ///< path of this file's instance, as "front.left"; empty for the model's own
};
using Problems = std::vector<Problem>;

/// Parses text with comments into `document.root`. Fails (false, with problems added): syntax, size, nesting deeper
/// than kMaximumDepth. Duplicate keys are problems too, but parsing continues.
bool parse_document(Document& document, std::uint32_t index, Problems& problems);

/// Sets document.line_starts from its text.
void find_lines(Document& document);

/// Value of the member, or nullptr; the first one for a duplicate key.
const Value* find(const Value& object, std::string_view key);
/// The member, or nullptr.
const Member* find_member(const Value& object, std::string_view key);
/// Position of an item that a text counts from 0; nothing for other texts and beyond the end.
std::optional<std::size_t> find_item(const Value& array, std::string_view text);

/// File, line, column, pointer and line of text of a position.
Where where_of(const Documents& documents, Place place);

/// "12:5", or "file.json:12:5" for a position in another file than `from`.
std::string place_text(const Documents& documents, Place place, Place from);

/// Position of byte `index` of the decoded string `value`, with escapes in the source taken into account.
Place place_in_text(const Documents& documents, const Value& value, std::size_t index);

/// Problems sorted by file and position, as diagnostics; a problem common to several instances of one file is reported
/// once.
Diagnostics to_diagnostics(const Documents& documents, Problems problems);

/// Description of a value for messages: `3.5`, `"abc"`, `an array of 2`, `an object`.
std::string describe(const Value& value);

}  // namespace mbgen::reading
