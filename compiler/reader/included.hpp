#pragma once
// Changes of included files by the file that includes them: items and sections that it removes or replaces.

#include <optional>
#include <string>
#include <vector>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// An entry of `include` that is an object.
struct IncludeFields {
  std::optional<std::string> file;
  const Value *remove = nullptr, *replace = nullptr;
};

/// One change of an included file and of all files that it includes.
struct Change {
  std::string pointer;                   ///< JSON Pointer (RFC 6901), as typed
  std::vector<std::string> steps;        ///< its parts, unescaped
  Place place;                           ///< where it is written
  const Value* value = nullptr;          ///< instead of the old one; null: removed
  bool is_made = false;                  ///< in a file
  std::size_t reached = 0;               ///< most steps that a file has of it
  std::vector<std::string> nearby = {};  ///< keys of the objects at the first step that no file has
};
using Changes = std::vector<Change>;

/// The changes of an entry. Reports pointers that are none, twice there, or inside of another.
Changes read_changes(Reader& reader, const IncludeFields& include);

/// The content of a file with the changes that it has a place for: `root` itself, or a copy that the reader keeps.
const Value& with_changes(Reader& reader, const Value& root, Changes& changes);

/// Reports the changes that no file had a place for. file: as included.
void report_unmade(Reader& reader, const std::string& file, const Changes& changes);

}  // namespace mbgen::reading
