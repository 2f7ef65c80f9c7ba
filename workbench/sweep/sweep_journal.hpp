#pragma once
// The finished cases of a study, on disk: a line a case, so that a study that was killed goes on where it was.

#include <filesystem>
#include <string>
#include <vector>

#include "workbench/sweep/sweep_study.hpp"

namespace mbgen {

/// Which part of the cases this process computes: the cases whose number leaves the remainder `index` when divided by
/// `count`.
struct SweepPart {
  long index = 0, count = 1;
  bool has(long index_of_case) const { return index_of_case % count == index; }
};

/// TABLE.journal of a whole study, TABLE.journal.K-of-N of a part.
std::filesystem::path journal_path(const std::string& table, const SweepPart& part);

/// All journals beside a table, in the order of their names.
std::vector<std::filesystem::path> journals_of(const std::string& table);

/// The results that a journal holds. A line that is not complete or damaged does not count; a file that is not there
/// holds nothing.
/// Fails: UserError when the journal is of another study: says in which words they differ.
CaseResults read_journal(const std::filesystem::path& path, const std::string& description);

/// A journal that is open for more lines. Locked against other processes as long as it lives.
class Journal {
 public:
  /// Opens or creates it. restart: forget its lines; else a torn last line is cut off.
  /// Fails: UserError when it cannot be written, another process holds it, or as read_journal.
  Journal(const std::filesystem::path& path, const std::string& description, bool restart);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  /// Writes a result so that not even a failure of power loses it. Fails: UserError when the disk does not take it.
  void add(long index, const CaseResult& result);

 private:
  void append(const std::string& line);
  std::filesystem::path path_;
  int file_ = -1;
};

/// Whether a process holds this journal.
bool is_held(const std::filesystem::path& journal);

}  // namespace mbgen
