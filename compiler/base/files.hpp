#pragma once
// Files as the command line reads and writes them: whole, or not at all.

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/read_text.hpp"

namespace mbgen {

/// Content of a file, as reading::read_text. Fails: UserError when it cannot be read, or has more than `most` bytes.
std::string read_text(const std::filesystem::path& path, std::size_t most = reading::kMostBytesOfTable);

/// Fails: UserError when `output` is one of the files that are read: writing would destroy it.
void require_other_file(const std::filesystem::path& output, const std::vector<std::string>& inputs);

/// Whether a name means standard output: "-". A file of that name is "./-".
bool is_standard_output(const std::filesystem::path& path);

/// Whether a path is standard output, a device, pipe or socket, which no file may replace.
bool is_special(const std::filesystem::path& path);

/// A file that appears under its name when it is complete: written beside it as `.NAME.XXXXXX` until `commit`, which is
/// all that a process killed before leaves behind. A symbolic link stays one; devices, pipes and standard output ("-")
/// are written directly.
class AtomicFile {
 public:
  /// Creates the temporary file. Fails: UserError when the directory is missing or not writable.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  /// Removes the temporary file when it was not committed.
  ~AtomicFile();

  /// Fails: UserError when the disk does not take it.
  void write(std::string_view text);
  /// Completes the temporary file. Fails: as write.
  void close();
  /// Gives the file its name, in the place of an older one. Fails: UserError.
  void commit();

 private:
  [[noreturn]] void fail(const char* action) const;
  std::filesystem::path path_, temporary_;
  std::FILE* stream_ = nullptr;
};

/// A directory of the user alone (mode 0700) that is removed with all it holds at the end of its life.
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
};

/// A file of a set, `path` relative to the set's directory.
struct NamedText {
  std::string path;
  std::string text;
};

/// Writes a set of files; directories are created. No file gets its name before all are written; then they do in the
/// order given, so that the last one is new only where all are.
/// Fails: UserError; files that were there before are then as they were.
void write_files(const std::filesystem::path& directory, const std::vector<NamedText>& files);

/// Writes to standard output. Fails: UserError when it does not take the text.
void print(std::string_view text);

/// Prints messages beside a result: to standard error where `result` is standard output, which then holds
/// the result and nothing else. Fails: as print.
void print_beside(const std::filesystem::path& result, std::string_view text);

/// The name of a result for a message.
std::string shown_name(const std::filesystem::path& result);

/// Writes a file whole. Fails: UserError.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace mbgen
