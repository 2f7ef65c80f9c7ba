#include "workbench/host/temporary_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <system_error>

#include "compiler/text/user_error.hpp"
#include "workbench/host/own_directory.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "mbgen-build-";
constexpr std::time_t kNewborn = 60;  // s, in which a directory may still wait for the lock of its owner

/// A lock on a directory, negative when another process has it or nothing can be opened.
int lock_of(const fs::path& directory) {
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

bool is_own_and_old(const fs::path& directory) {
  struct stat status = {};
  return ::lstat(directory.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::geteuid() &&
         status.st_mtime + kNewborn < std::time(nullptr);
}

void remove_abandoned(const fs::path& parent) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, ignored)) {
    if (!entry.path().filename().string().starts_with(kPrefix) || !is_own_and_old(entry.path())) continue;
    const int lock = lock_of(entry.path());
    if (lock < 0) continue;
    fs::remove_all(entry.path(), ignored);
    ::close(lock);
  }
}

}  // namespace

TemporaryDirectory::TemporaryDirectory(const fs::path& parent) {
  if (const std::string fault = foreign_hand(parent, true); !fault.empty()) {
    throw UserError(
        fmt::format("{}: not used for temporary files, others could exchange the files that are compiled there: {}\n"
                    "  hint: name a directory of your own in TMPDIR, or make this one sticky (chmod +t)\n",
                    parent.string(), fault));
  }
  remove_abandoned(parent);
  std::string name = (parent / kPrefix).string() + "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    throw UserError(fmt::format("{}: cannot create a directory in it: {}\n", parent.string(), std::strerror(errno)));
  }
  path_ = name;
  lock_ = lock_of(path_);
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace mbgen
