#pragma once
// Reading and writing of files for the command line: whole, or not at all.

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/text/read_text.hpp"

namespace mbgen {

/// Content of a file, as reading::read_text. Fails: UserError if it cannot be read or is larger than `most` bytes.
std::string read_text(const std::filesystem::path& path, std::size_t most = reading::kMostBytesOfTable);

/// Fails: UserError if `output` is one of the files read: writing would destroy it. Every writing function here calls
/// this; a long command calls it before its work. Empty names among `inputs` are ignored.
void require_other_file(const std::filesystem::path& output, const std::vector<std::string>& inputs);

/// Whether two paths lead to one file, which need not exist.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// One file that a command writes, and the option, or the words, that name it.
struct WrittenFile {
  std::string option, path;
};

/// Fails: UserError if two of the files that a command writes are one: the last would replace the others. Empty paths
/// and devices are ignored.
void require_written_apart(const std::vector<WrittenFile>& files);

/// Whether a name is standard output: "-". A file of that name is "./-".
bool is_standard_output(const std::filesystem::path& path);

/// Whether a path is standard output, a device, pipe or socket: no file may replace it.
bool is_special(const std::filesystem::path& path);

/// A file that replaces the old one atomically: written as `.NAME.XXXXXX` in the same directory until `commit`; a
/// killed process leaves only this one. A symbolic link is kept; devices, pipes and standard output ("-") are written
/// directly.
class AtomicFile {
 public:
  /// Creates the temporary file. read: files read by the command. Fails: UserError if the directory is missing or not
  /// writable, or the path is one of these files.
  AtomicFile(const std::filesystem::path& path, const std::vector<std::string>& read);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  /// Removes the temporary file unless it was committed.
  ~AtomicFile();

  /// Fails: UserError on a write error.
  void write(std::string_view text);
  /// Completes the temporary file. Fails: as write.
  void close();
  /// Renames the file to its final name. Fails: UserError.
  void commit();

 private:
  [[noreturn]] void fail(const char* action) const;
  std::filesystem::path path_, temporary_;
  std::FILE* stream_ = nullptr;
};

/// A file of a set, `path` relative to the set's directory.
struct NamedText {
  std::string path;
  std::string text;
};

/// Writes a set of files; creates directories. All files are written before the first is renamed, and renamed in the
/// given order: a new last file means that all are new. read: files read by the command. Fails: UserError; the old
/// files are then unchanged.
void write_files(const std::filesystem::path& directory, const std::vector<NamedText>& files,
                 const std::vector<std::string>& read);

/// Writes to standard output; control characters of terminals are shown as `?` (terminal_text). Fails: UserError on a
/// write error.
void print(std::string_view text);

/// Prints messages beside a result: to standard error if `result` is standard output, which then contains the result
/// alone. Fails: as print.
void print_beside(const std::filesystem::path& result, std::string_view text);

/// Name of a result for messages.
std::string shown_name(const std::filesystem::path& result);

/// Writes a file atomically. read: files read by the command. Fails: UserError.
void write_file(const std::filesystem::path& path, std::string_view text, const std::vector<std::string>& read);

}  // namespace mbgen
