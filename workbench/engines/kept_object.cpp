#include "workbench/engines/kept_object.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/message.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "mbgen-object 1\n";

/// The bytes behind an object: mark, size and hash, of one length whatever the object.
std::string seal_of(std::string_view object) {
  Hash hash;
  hash.add(object);
  return fmt::format("{}{:016x}\n{}\n", kMark, object.size(), hash.text());
}

std::string bytes_of_file(const fs::path& path) {
  std::error_code missing;
  const std::uintmax_t size = fs::file_size(path, missing);
  std::string bytes(missing ? 0 : size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

[[noreturn]] void fail(const fs::path& path) {
  throw UserError(fmt::format("{}: cannot write: {}\n", path.string(), std::strerror(errno)));
}

}  // namespace

void seal(const fs::path& object) {
  const std::string text = seal_of(bytes_of_file(object));
  const int file = ::open(object.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file < 0) fail(object);
  const bool is_written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const bool is_synchronised = is_written && ::fsync(file) == 0;
  if (!is_synchronised) {
    ::close(file);
    fail(object);
  }
  if (::close(file) != 0) fail(object);
}

std::string sealed(std::string content) {
  content += seal_of(content);
  return content;
}

std::optional<std::string> content_of_sealed(const fs::path& file) {
  std::string bytes = bytes_of_file(file);
  const std::size_t length = seal_of({}).size();
  if (bytes.size() < length) return std::nullopt;
  const std::string_view content = std::string_view(bytes).substr(0, bytes.size() - length);
  if (std::string_view(bytes).substr(content.size()) != seal_of(content)) return std::nullopt;
  bytes.resize(content.size());
  return bytes;
}

bool is_sealed(const fs::path& object) { return content_of_sealed(object).has_value(); }

bool keep(const fs::path& object, const fs::path& kept) {
  std::error_code problem;
  fs::permissions(object, fs::perms::owner_all, problem);  // whatever the umask leaves to others
  if (!problem) fs::rename(object, kept, problem);  // atomic, and onto the same bytes when another mbgen was faster
  if (!problem) return true;
  print_message(
      "{}: note: the solver is not kept under this name: {}\n"
      "  hint: remove what stands there, or name another directory in XDG_CACHE_HOME\n",
      kept.string(), problem.message());
  return false;
}

}  // namespace mbgen
