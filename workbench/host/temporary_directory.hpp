#pragma once
// Directories for the work of one run.

#include <filesystem>

namespace mbgen {

/// A directory of the user alone (mode 0700) that is removed with all it holds at the end of its life. One that a
/// killed run left is removed by the next: a lock on it ends with the process.
class TemporaryDirectory {
 public:
  /// Creates it in `parent`. Fails: UserError; also where others could put another in its place.
  explicit TemporaryDirectory(const std::filesystem::path& parent);
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  ///< descriptor that holds the lock
};

}  // namespace mbgen
