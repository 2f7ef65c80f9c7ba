#include "workbench/host/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "compiler/text/characters.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/own_directory.hpp"

namespace mbgen {
namespace {

constexpr int kMostLinksFollowed = 40;  // as the kernel follows

[[noreturn]] void fail_with(const std::filesystem::path& path, const char* action) {
  throw UserError(fmt::format("{}: cannot {}: {}\n", path.string(), action, std::strerror(errno)));
}

/// Target of a path through its symbolic links, which are kept; the target need not exist. Fails: UserError for
/// circular links.
std::filesystem::path behind_links(std::filesystem::path path) {
  std::error_code problem;
  for (int links = 0; std::filesystem::is_symlink(path, problem); ++links) {
    if (links == kMostLinksFollowed) {
      throw UserError(fmt::format("{}: cannot write: {}\n", path.string(), std::strerror(ELOOP)));
    }
    path = path.parent_path() / std::filesystem::read_symlink(path);
  }
  return path;
}

void make_directories(const std::filesystem::path& path) {
  std::error_code problem;
  std::filesystem::create_directories(path, problem);
  if (problem) {
    throw UserError(fmt::format("{}: cannot create the directory: {}\n", path.string(), problem.message()));
  }
}

}  // namespace

bool is_standard_output(const std::filesystem::path& path) { return path == "-"; }

bool is_special(const std::filesystem::path& path) {
  if (is_standard_output(path)) return true;
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(path, problem);
  return !problem && std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

std::string read_text(const std::filesystem::path& path, std::size_t most) {
  using reading::ReadFault;
  reading::FileText content = reading::read_text(path.string(), most);
  if (content.fault == ReadFault::none) return std::move(content.text);
  const std::string hint = content.fault == ReadFault::missing ? hint_of_missing(path.string()) : "";
  std::string reason = content.problem;
  if (content.error != 0) reason = std::strerror(content.error);
  if (content.fault == ReadFault::too_large) reason = "larger than " + reading::size_text(content.limit);
  if (content.fault == ReadFault::endless) reason = "it is a file of the kernel, which may have no end";
  if (content.fault == ReadFault::no_memory) reason = "larger than the memory that is left";
  throw UserError(fmt::format("{}: cannot read: {}\n{}", path.string(), reason,
                              hint.empty() ? "" : fmt::format("  hint: {}\n", hint)));
}

void require_other_file(const std::filesystem::path& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (is_standard_output(output)) return;
    std::error_code problem;
    if (input.empty() || !std::filesystem::equivalent(output, input, problem) || problem) continue;
    throw UserError(fmt::format("{}: cannot write: it is read by this command\n", output.string()));
  }
}

bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
  const auto place = [](const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal();
  };
  std::error_code problem;
  return place(one) == place(other) || std::filesystem::equivalent(one, other, problem);
}

void require_written_apart(const std::vector<WrittenFile>& files) {
  for (auto one = files.begin(); one != files.end(); ++one) {
    if (one->path.empty() || (is_special(one->path) && !is_standard_output(one->path))) continue;
    for (auto other = std::next(one); other != files.end(); ++other) {
      if (other->path.empty() || !is_same_file(one->path, other->path)) continue;
      throw UserError(fmt::format("{}: {} and {} must be two files\n", other->path, one->option, other->option));
    }
  }
}

AtomicFile::AtomicFile(const std::filesystem::path& path, const std::vector<std::string>& read)
    : path_(behind_links(path)) {
  require_other_file(path_, read);
  if (is_standard_output(path_)) {
    std::fflush(stdout);
    stream_ = ::fdopen(::dup(STDOUT_FILENO), "wb");
    if (stream_ == nullptr) fail("write");
    return;
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(path_, ignored)) {
    throw UserError(fmt::format("{}: cannot write: it is a directory\n", path_.string()));
  }
  if (is_special(path_)) {
    stream_ = std::fopen(path_.c_str(), "wb");
    if (stream_ == nullptr) fail("write");
    return;
  }
  std::string name = (path_.parent_path() / fmt::format(".{}.XXXXXX", path_.filename().string())).string();
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) fail("write");
  temporary_ = name;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, 0666 & ~mask);  // mkstemp makes the file private: restore the usual permissions
  stream_ = ::fdopen(descriptor, "wb");
  if (stream_ == nullptr) fail("write");
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      stream_(std::exchange(other.stream_, nullptr)) {}

AtomicFile::~AtomicFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::fail(const char* action) const { fail_with(shown_name(path_), action); }

void AtomicFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail("write");
}

void AtomicFile::close() {
  if (stream_ != nullptr && std::fclose(std::exchange(stream_, nullptr)) != 0) fail("write");
}

void AtomicFile::commit() {
  close();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("write");
  temporary_.clear();
}

void write_files(const std::filesystem::path& directory, const std::vector<NamedText>& files,
                 const std::vector<std::string>& read) {
  make_directories(directory);
  std::vector<AtomicFile> written;
  written.reserve(files.size());
  for (const NamedText& file : files) {
    const std::filesystem::path path = directory / file.path;
    make_directories(path.parent_path());
    written.emplace_back(path, read);
    written.back().write(file.text);
    written.back().close();
  }
  for (AtomicFile& file : written) file.commit();
}

void print(std::string_view any_text) {
  const std::string text = terminal_text(any_text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw UserError(fmt::format("standard output: cannot write: {}\n", std::strerror(errno)));
  }
}

void write_file(const std::filesystem::path& path, std::string_view text, const std::vector<std::string>& read) {
  AtomicFile file(path, read);
  file.write(text);
  file.commit();
}

void print_beside(const std::filesystem::path& result, std::string_view text) {
  if (!is_standard_output(result)) return print(text);
  print_message("{}", text);
}

std::string shown_name(const std::filesystem::path& result) {
  return is_standard_output(result) ? "standard output" : result.string();
}

}  // namespace mbgen
