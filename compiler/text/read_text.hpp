#pragma once
// Reading of text files: the only function for it, for models and all others.

#include <cstddef>
#include <string>

namespace mbgen::reading {

/// Reason for a failed read.
enum class ReadFault {
  none,
  missing,
  directory,
  unreadable,
  too_large,
  endless,  ///< of the kernel: possibly endless or blocking
  no_memory
};

/// Text of a file, or the reason for its absence.
struct FileText {
  std::string text;
  std::string problem;  ///< in words, "" without one
  ReadFault fault = ReadFault::none;
  int error = 0;          ///< number of the system's error, 0 without one
  std::size_t limit = 0;  ///< bytes, for a file that is too large
};

/// Size limits of files parsed to trees (models, states), and of tables.
constexpr std::size_t kMostBytesOfTree = std::size_t{64} << 20, kMostBytesOfTable = std::size_t{1} << 30;

/// Reads a file of at most `most` bytes, also a pipe or device; a device up to kMostBytesOfTree. A larger file is
/// refused before reading. Files of the kernel (/proc, /sys) are refused.
FileText read_text(const std::string& path, std::size_t most = kMostBytesOfTree);

/// Reads a file of a model; refuses pipes and devices, since these files are read again.
FileText read_regular_file(const std::string& path);

/// A limit as text: "64 MB".
std::string size_text(std::size_t bytes);

}  // namespace mbgen::reading
