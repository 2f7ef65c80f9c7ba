#pragma once
// Cases that processes of one study claim from each other, by locks in a file beside the table that all of them share.

#include <filesystem>
#include <functional>
#include <string>

namespace mbgen {

/// A lock of one byte per case, in TABLE.journal.claims: the process that has the lock computes the case. The operating
/// system frees the locks of a process that ends, however it ends. A byte that is set says that the case is finished:
/// on a network file system journals of other nodes may be seen late, the bytes of a file never after its lock.
class Claims {
 public:
  /// Takes part in the study of a table. on_first: called where no other process takes part, and none of the same `job`
  /// did before (an empty one never); others wait meanwhile. Fails: UserError if the file cannot be written; as
  /// on_first.
  Claims(const std::string& table, const std::string& job, const std::function<void()>& on_first);
  Claims(const Claims&) = delete;
  Claims& operator=(const Claims&) = delete;
  ~Claims();

  /// Whether the file system has locks; without them there are no claims.
  bool has_locks() const { return has_locks_; }
  /// Claims a case. Result: false if another process has it or has finished it. Requires: has_locks(), and this process
  /// does not have it.
  bool take(long index);
  /// Marks a claimed case as finished. Requires: its result is on the disk.
  void finish(long index);

 private:
  bool lock(short kind, long offset, bool waits);
  void start(const std::string& job, const std::function<void()>& on_first);
  std::filesystem::path path_;
  int file_ = -1;
  bool has_locks_ = true;
};

}  // namespace mbgen
