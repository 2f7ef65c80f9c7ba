#include "workbench/host/journal_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"

namespace mbgen {
namespace {

[[noreturn]] void fail_to_write_journal(const std::filesystem::path& path) {
  throw UserError(fmt::format("{}: cannot write: {}\n", path.string(), std::strerror(errno)));
}

std::string hash_of_content(std::string_view content) {
  Hash hash;
  hash.add(content);
  return hash.text();
}

}  // namespace

std::string whole_lines(const std::string& text) {
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? "" : text.substr(0, end + 1);
}

std::string journal_line(const std::string& content) { return hash_of_content(content) + " " + content + "\n"; }

std::optional<std::string> content_of_line(std::string_view line) {
  const std::size_t blank = line.find(' ');
  if (blank == std::string_view::npos || hash_of_content(line.substr(blank + 1)) != line.substr(0, blank)) return {};
  return std::string(line.substr(blank + 1));
}

JournalFile::JournalFile(const std::filesystem::path& path, const std::string& command, bool restart) : path_(path) {
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail_to_write_journal(path);
  try {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      throw UserError(fmt::format("{}: another mbgen {} is at work on it\n", path.string(), command));
    if (!restart) kept_ = whole_lines(read_text(path));
  } catch (...) {
    ::close(file_);
    throw;
  }
}

JournalFile::~JournalFile() { ::close(file_); }

void JournalFile::begin(const std::string& first_line) {
  if (::ftruncate(file_, static_cast<off_t>(kept_.size())) != 0) fail_to_write_journal(path_);
  if (kept_.empty()) append(first_line + "\n");
}

void JournalFile::append(const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = ::write(file_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_write_journal(path_);
    written += static_cast<std::size_t>(count);
  }
  if (::fsync(file_) != 0 && errno != EINVAL) fail_to_write_journal(path_);
}

}  // namespace mbgen
