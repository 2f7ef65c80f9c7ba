#pragma once
// Files as text: the one function that reads them, for models and all others.

#include <cstddef>
#include <string>

namespace mbgen::reading {

/// Why a file gave no text.
enum class ReadFault {
  none,
  missing,
  directory,
  unreadable,
  too_large,
  endless,  ///< of the kernel: it may have no end, or keep its reader waiting
  no_memory
};

/// The text of a file, or why there is none.
struct FileText {
  std::string text;
  std::string problem;  ///< in words, "" where there is none
  ReadFault fault = ReadFault::none;
  int error = 0;          ///< number of the system's error, 0 without one
  std::size_t limit = 0;  ///< bytes, of a file that is too large
};

/// Limits of texts that become trees, as models and states do, and of tables.
constexpr std::size_t kMostBytesOfTree = std::size_t{64} << 20, kMostBytesOfTable = std::size_t{1} << 30;

/// Reads a file of at most `most` bytes; pipes and devices too, of which devices give at most kMostBytesOfTree. A
/// larger file is refused before it is read. Files of the kernel (/proc, /sys) are refused.
FileText read_text(const std::string& path, std::size_t most = kMostBytesOfTree);

/// The same of a model, but refuses pipes and devices: files that a model names are read again.
FileText read_regular_file(const std::string& path);

/// A limit in words: "64 MB".
std::string size_text(std::size_t bytes);

}  // namespace mbgen::reading
