#pragma once
// Files as the command line reads and writes them: whole, or not at all.

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/text/read_text.hpp"

namespace mbgen {

/// Content of a file, as reading::read_text. Fails: UserError when it cannot be read, or has more than `most` bytes.
std::string read_text(const std::filesystem::path& path, std::size_t most = reading::kMostBytesOfTable);

/// Fails: UserError when `output` is one of the files that are read: writing would destroy it. Every function here that
/// writes asks this; a long command asks it before it starts. Empty names among `inputs` are no files.
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
  /// Creates the temporary file. read: the files that the command reads. Fails: UserError when the directory is missing
  /// or not writable, or the path is a file that is read.
  AtomicFile(const std::filesystem::path& path, const std::vector<std::string>& read);
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

/// A file of a set, `path` relative to the set's directory.
struct NamedText {
  std::string path;
  std::string text;
};

/// Writes a set of files; directories are created. No file gets its name before all are written; then they do in the
/// order given, so that the last one is new only where all are.
/// read: the files that the command reads. Fails: UserError; files that were there before are then as they were.
void write_files(const std::filesystem::path& directory, const std::vector<NamedText>& files,
                 const std::vector<std::string>& read);

/// Writes to standard output; characters that would command a terminal are shown as `?` (terminal_text). Fails:
/// UserError when it does not take the text.
void print(std::string_view text);

/// Prints messages beside a result: to standard error where `result` is standard output, which then holds
/// the result and nothing else. Fails: as print.
void print_beside(const std::filesystem::path& result, std::string_view text);

/// The name of a result for a message.
std::string shown_name(const std::filesystem::path& result);

/// Writes a file whole. read: the files that the command reads. Fails: UserError.
void write_file(const std::filesystem::path& path, std::string_view text, const std::vector<std::string>& read);

}  // namespace mbgen
