#include "workbench/host/own_directory.hpp"

#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <system_error>

#include "compiler/text/user_error.hpp"
#include "workbench/host/message.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel follows

/// A value of the environment, "" when it is not set.
std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The user, the administrator, or who owns /: in a container the administrator may have another number.
bool is_trusted(uid_t owner) {
  struct stat root = {};
  return owner == ::geteuid() || owner == 0 || (::lstat("/", &root) == 0 && owner == root.st_uid);
}

std::string name_of_user(uid_t user) {
  const passwd* entry = ::getpwuid(user);
  return entry != nullptr ? fmt::format("user {}", entry->pw_name) : fmt::format("user number {}", user);
}

/// Whether a group has the user alone in it, as the group that bears a user's name has.
bool is_private_group(gid_t group) {
  const passwd* entry = ::getpwuid(::geteuid());
  if (entry == nullptr || entry->pw_gid != group) return false;
  const std::string user = entry->pw_name;
  const struct group* members = ::getgrgid(group);
  if (members == nullptr || user != members->gr_name) return false;
  for (char** member = members->gr_mem; *member != nullptr; ++member) {
    if (user != *member) return false;
  }
  return true;
}

/// Whether others may write; an access control list that lets them shows in the bits of the group.
bool others_may_write(const struct stat& status) {
  return (status.st_mode & S_IWOTH) != 0 || ((status.st_mode & S_IWGRP) != 0 && !is_private_group(status.st_gid));
}

/// Fault of one directory or link on the way.
std::string fault_of(const fs::path& path, const struct stat& status, bool is_last, bool may_be_shared) {
  const bool is_link = S_ISLNK(status.st_mode);
  if (is_last && !may_be_shared && !is_link && status.st_uid != ::geteuid()) {
    return fmt::format("{} belongs to {}", path.string(), name_of_user(status.st_uid));
  }
  if (!is_trusted(status.st_uid)) return fmt::format("{} belongs to {}", path.string(), name_of_user(status.st_uid));
  if (is_link || !others_may_write(status)) return "";
  const bool is_sticky = (status.st_mode & S_ISVTX) != 0;
  if (is_sticky && !(is_last && !may_be_shared)) return "";
  return fmt::format("others can write in {} (mode {:04o})", path.string(), status.st_mode & 07777);
}

/// Makes the directories that are missing, each for the user alone. Result: 0, or the error's number.
int make_private(const fs::path& directory) {
  fs::path path;
  for (const fs::path& part : directory) {
    path /= part;
    if (::mkdir(path.c_str(), S_IRWXU) == 0) continue;
    const int error = errno == EEXIST ? ENOTDIR : errno;
    std::error_code problem;
    if (!fs::is_directory(path, problem)) return error;
  }
  return 0;
}

/// Puts the parts of a path before others.
void put_first(const fs::path& path, std::deque<fs::path>& parts) {
  std::deque<fs::path> all;
  for (const fs::path& part : path) {
    if (!part.empty() && part != ".") all.push_back(part);
  }
  parts.insert(parts.begin(), all.begin(), all.end());
}

/// Where the cache should be; "" when the environment names no place. The standard of the base directories ignores
/// relative paths.
fs::path cache_directory() {
  const fs::path cache = environment("XDG_CACHE_HOME");
  if (cache.is_absolute()) return cache / "mbgen";
  const fs::path home = environment("HOME");
  return home.is_absolute() ? home / ".cache" / "mbgen" : fs::path();
}

/// Why a cache cannot be used.
std::string fault_of_cache(const fs::path& directory) {
  if (const int error = make_private(directory); error != 0) return std::strerror(error);
  if (::access(directory.c_str(), W_OK | X_OK) != 0) return std::strerror(errno);
  return foreign_hand(directory, false);
}

}  // namespace

std::string foreign_hand(const fs::path& directory, bool may_be_shared) {
  std::deque<fs::path> parts;
  put_first(fs::absolute(directory), parts);
  fs::path path;
  for (int links = 0; !parts.empty();) {
    const fs::path above = path, part = parts.front();
    parts.pop_front();
    path = part == ".." ? path.parent_path() : path / part;
    struct stat status = {};
    if (::lstat(path.c_str(), &status) != 0) return fmt::format("{}: {}", path.string(), std::strerror(errno));
    const bool is_link = S_ISLNK(status.st_mode);
    if (std::string fault = fault_of(path, status, parts.empty(), may_be_shared); !fault.empty()) return fault;
    if (!is_link) continue;
    if (++links > kMostLinks) return fmt::format("{}: {}", path.string(), std::strerror(ELOOP));
    const fs::path target = fs::read_symlink(path);
    put_first(target, parts);
    path = target.is_absolute() ? fs::path() : above;
  }
  return "";
}

fs::path own_cache(bool tells) {
  const fs::path directory = cache_directory();
  if (directory.empty()) return {};
  const std::string fault = fault_of_cache(directory);
  if (fault.empty()) return directory;
  if (!tells) return {};
  print_message(
      "{}: note: nothing is kept or loaded here: {}\n"
      "  hint: name a directory that only you can write in XDG_CACHE_HOME; mbgen loads its compiled solvers "
      "from there\n",
      directory.string(), fault);
  return {};
}

bool is_own_file(const fs::path& file) {
  struct stat status = {};
  return ::lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
         !others_may_write(status);
}

fs::path temporary_parent() {
  std::error_code problem;
  fs::path directory = fs::temp_directory_path(problem);
  if (!problem) return directory;
  throw UserError(fmt::format("{}: no directory for temporary files: {}; name one in TMPDIR\n",
                              environment("TMPDIR").empty() ? "/tmp" : environment("TMPDIR"), problem.message()));
}

}  // namespace mbgen
