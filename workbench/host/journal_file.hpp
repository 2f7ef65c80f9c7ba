#pragma once
// A file of finished work, a line each, with which a killed process goes on: locked, synced, its lines hashed.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mbgen {

/// The text up to the last line end: a killed process leaves an incomplete line.
std::string whole_lines(const std::string& text);

/// A line of a journal: hash of the content, the content, a line end.
std::string journal_line(const std::string& content);

/// The content of a line without its end, none of a damaged one.
std::optional<std::string> content_of_line(std::string_view line);

/// A journal open for appending, locked against other processes during its lifetime.
class JournalFile {
 public:
  /// Opens or creates it. command: that writes it, for messages; restart: its lines are of no use. Fails: UserError if
  /// it cannot be written or another process holds it.
  JournalFile(const std::filesystem::path& path, const std::string& command, bool restart);
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;
  ~JournalFile();

  /// Its whole lines when it was opened, "" for a new one.
  const std::string& kept() const { return kept_; }
  /// Cuts off all but the kept lines, and gives a new journal its first line.
  void begin(const std::string& first_line);
  /// Writes text and syncs it to disk, safe against power failure. Fails: UserError on a write error.
  void append(const std::string& text);

 private:
  std::filesystem::path path_;
  int file_ = -1;
  std::string kept_;
};

}  // namespace mbgen
