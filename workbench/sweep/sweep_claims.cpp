#include "workbench/sweep/sweep_claims.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// Bytes beyond those of all cases: the job of the process that began, and the lock that every process shares.
constexpr long kJob = 1L << 24, kPresence = 1L << 32;
constexpr std::size_t kMostOfJob = 128;

[[noreturn]] void fail_to_claim(const std::filesystem::path& path) {
  throw UserError(fmt::format("{}: cannot write: {}\n", path.string(), std::strerror(errno)));
}

}  // namespace

Claims::Claims(const std::string& table, const std::string& job, const std::function<void()>& on_first)
    : path_(table + ".journal.claims") {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) fail_to_claim(path_);
  try {
    start(job, on_first);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

Claims::~Claims() { ::close(file_); }

void Claims::start(const std::string& job, const std::function<void()>& on_first) {
  const bool is_alone = lock(F_WRLCK, kPresence, false);
  if (!has_locks_) return;
  if (is_alone) {
    std::array<char, kMostOfJob> text{};
    const ssize_t count = ::pread(file_, text.data(), text.size(), kJob);
    const std::string before(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    const std::string own = job.substr(0, kMostOfJob);
    if (own.empty() || before != own) {
      // Only journals count: the bytes of an earlier run may refer to journals that are gone.
      if (::ftruncate(file_, 0) != 0) fail_to_claim(path_);
      on_first();
      if (::pwrite(file_, own.data(), own.size(), kJob) < 0) fail_to_claim(path_);
    }
  }
  if (!lock(F_RDLCK, kPresence, true)) fail_to_claim(path_);
}

bool Claims::lock(short kind, long offset, bool waits) {
  struct flock wanted {};
  wanted.l_type = kind;
  wanted.l_whence = SEEK_SET;
  wanted.l_start = offset;
  wanted.l_len = 1;
  int state = 0;
  do {
    state = ::fcntl(file_, waits ? F_OFD_SETLKW : F_OFD_SETLK, &wanted);
  } while (state != 0 && errno == EINTR);
  if (state == 0) return true;
  if (errno != EAGAIN && errno != EACCES) has_locks_ = false;
  return false;
}

bool Claims::take(long index) {
  if (!lock(F_WRLCK, index, false)) return false;
  char is_finished = 0;
  if (::pread(file_, &is_finished, 1, index) != 1 || is_finished == 0) return true;
  lock(F_UNLCK, index, false);
  return false;
}

void Claims::finish(long index) {
  const char is_finished = 1;
  if (::pwrite(file_, &is_finished, 1, index) != 1) fail_to_claim(path_);
  lock(F_UNLCK, index, false);
}

}  // namespace mbgen
