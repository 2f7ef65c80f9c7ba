#pragma once
// Files as text.

#include <string>

namespace mbgen::reading {

/// The text of a file, or why there is none.
struct FileText {
  std::string text;
  std::string problem;
};

/// Reads a file of at most kMaximumBytes; pipes and devices too.
FileText read_text(const std::string& path);

/// The same, but refuses pipes and devices: files that a model names are read again.
FileText read_regular_file(const std::string& path);

}  // namespace mbgen::reading
