#pragma once
// Entries and problems of OpenCRG files.

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace mbgen {

/// Numbers of a block of the text part, by names in capitals.
using CrgEntries = std::map<std::string, double>;
inline std::optional<double> entry_of(const CrgEntries& entries, const char* name) {
  const auto found = entries.find(name);
  return found == entries.end() ? std::nullopt : std::optional(found->second);
}

/// A problem of a file, or a note on its reading: at a line of its text part, or a byte of its data.
struct CrgProblem {
  std::size_t line = 0;  ///< from 1; 0: see byte
  std::size_t byte = 0;  ///< from 0
  std::string message, hint;
  std::size_t file = 0;  ///< index of the linked file
};

}  // namespace mbgen
