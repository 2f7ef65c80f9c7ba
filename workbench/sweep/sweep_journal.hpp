#pragma once
// Finished cases of a study on disk, a line per case, so that a killed study can be resumed.

#include <filesystem>
#include <string>
#include <vector>

#include "workbench/host/journal_file.hpp"
#include "workbench/sweep/sweep_study.hpp"

namespace mbgen {

/// Share of the cases of this process: the cases with number modulo `count` equal to `index`.
struct SweepPart {
  long index = 0, count = 1;
  bool has(long index_of_case) const { return index_of_case % count == index; }
};

/// TABLE.journal of a whole study, TABLE.journal.K-of-N of a part.
std::filesystem::path journal_path(const std::string& table, const SweepPart& part);

/// All journals beside a table, sorted by name.
std::vector<std::filesystem::path> journals_of(const std::string& table);

/// Results in a journal. Incomplete or damaged lines are ignored; a missing file is empty. Fails: UserError for a
/// journal of another study; it names the entries that differ.
CaseResults read_journal(const std::filesystem::path& path, const std::string& description);

/// A journal open for appending, locked against other processes during its lifetime.
class Journal {
 public:
  /// Opens or creates it. restart: discard its lines; else an incomplete last line is cut off. Fails: UserError if it
  /// cannot be written or another process holds it, or as read_journal.
  Journal(const std::filesystem::path& path, const std::string& description, bool restart);

  /// Writes a result and syncs it to disk, safe against power failure. Fails: UserError on a write error.
  void add(long index, const CaseResult& result);

 private:
  JournalFile file_;
};

/// Whether a process holds this journal.
bool is_held(const std::filesystem::path& journal);

}  // namespace mbgen
