#include "compiler/text/read_text.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

namespace mbgen::reading {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;

/// An open file, closed at the end.
class OpenFile {
 public:
  explicit OpenFile(const std::string& path) : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

/// Whether the kernel generates the file's content on reading.
bool is_of_kernel(int file) {
  struct statfs system = {};
  if (::fstatfs(file, &system) != 0) return false;
  constexpr std::array kKernel = {PROC_SUPER_MAGIC, SYSFS_MAGIC, DEBUGFS_MAGIC, TRACEFS_MAGIC};
  return std::ranges::find(kKernel, static_cast<long>(system.f_type)) != kKernel.end();
}

FileText refused(ReadFault fault, std::string problem, int error = 0) {
  return {{}, std::move(problem), fault, error, 0};
}

FileText too_large(std::size_t most) {
  return {{}, "file is larger than " + size_text(most), ReadFault::too_large, 0, most};
}

/// Content of an open file of `size` bytes, if known.
FileText content_of(int file, std::size_t size, std::size_t most) {
  std::string text;
  text.reserve(size + 1);
  while (text.size() <= most) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    const ssize_t taken = ::read(file, text.data() + before, kPiece);
    const int error = taken < 0 ? errno : 0;
    text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(taken, 0)));
    if (error == EINTR) continue;
    if (error != 0) return refused(ReadFault::unreadable, "cannot read file", error);
    if (taken == 0) return {.text = std::move(text), .problem = {}};
  }
  return too_large(most);
}

}  // namespace

std::string size_text(std::size_t bytes) {
  constexpr std::size_t kMega = std::size_t{1} << 20, kGiga = std::size_t{1} << 30;
  return bytes % kGiga == 0 ? fmt::format("{} GB", bytes / kGiga) : fmt::format("{} MB", bytes / kMega);
}

FileText read_text(const std::string& path, std::size_t most) {
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    return refused(ReadFault::missing, "cannot read file, it does not exist", ignored ? ignored.value() : ENOENT);
  const OpenFile file(path);
  struct stat status = {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0)
    return refused(ReadFault::unreadable, "cannot read file", errno);
  if (S_ISDIR(status.st_mode)) return refused(ReadFault::directory, "cannot read file, it is a directory", EISDIR);
  if (S_ISREG(status.st_mode) && is_of_kernel(file.number()))
    return refused(ReadFault::endless, "cannot read file, it is one of the kernel, which may have no end");
  if (S_ISCHR(status.st_mode)) most = std::min(most, kMostBytesOfTree);
  const std::size_t size = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  if (size > most) return too_large(most);
  try {
    return content_of(file.number(), size, most);
  } catch (const std::bad_alloc&) {
    return refused(ReadFault::no_memory, "cannot read file, it is larger than the memory that is left");
  }
}

FileText read_regular_file(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool is_special = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  return is_special ? refused(ReadFault::unreadable, "cannot read file, it is a device or pipe") : read_text(path);
}

}  // namespace mbgen::reading
