#include "compiler/cli/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {
namespace {

constexpr std::size_t kReadPiece = 1 << 16;

[[noreturn]] void fail_with(const std::filesystem::path& path, const char* action) {
  throw UserError(fmt::format("{}: cannot {}: {}\n", path.string(), action, std::strerror(errno)));
}

void make_directories(const std::filesystem::path& path) {
  std::error_code problem;
  std::filesystem::create_directories(path, problem);
  if (problem) {
    throw UserError(fmt::format("{}: cannot create the directory: {}\n", path.string(), problem.message()));
  }
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::FILE* stream = std::fopen(path.c_str(), "rb");
  if (stream == nullptr) fail_with(path, "read");
  std::string text;
  std::size_t taken = 0;
  do {
    const std::size_t size = text.size();
    text.resize(size + kReadPiece);
    taken = std::fread(text.data() + size, 1, kReadPiece, stream);
    text.resize(size + taken);
  } while (taken == kReadPiece);
  const int error = std::ferror(stream) != 0 ? errno : 0;
  std::fclose(stream);
  if (error != 0) {
    errno = error;
    fail_with(path, "read");
  }
  return text;
}

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
  if (std::filesystem::is_directory(path_)) {
    throw UserError(fmt::format("{}: cannot write: it is a directory\n", path_.string()));
  }
  std::string name = (path_.parent_path() / fmt::format(".{}.XXXXXX", path_.filename().string())).string();
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) fail("write");
  temporary_ = name;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, 0666 & ~mask);  // mkstemp makes the file private; its name should not change what others may do
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

void AtomicFile::fail(const char* action) const { fail_with(path_, action); }

void AtomicFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail("write");
}

void AtomicFile::close() {
  if (stream_ != nullptr && std::fclose(std::exchange(stream_, nullptr)) != 0) fail("write");
}

void AtomicFile::commit() {
  close();
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("write");
  temporary_.clear();
}

TemporaryDirectory::TemporaryDirectory(const std::filesystem::path& parent) {
  make_directories(parent);
  std::string name = (parent / "build-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) fail_with(parent, "create a directory in it");
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_files(const std::filesystem::path& directory, const std::vector<NamedText>& files) {
  make_directories(directory);
  std::vector<AtomicFile> written;
  written.reserve(files.size());
  for (const NamedText& file : files) {
    const std::filesystem::path path = directory / file.path;
    make_directories(path.parent_path());
    written.emplace_back(path);
    written.back().write(file.text);
    written.back().close();
  }
  for (AtomicFile& file : written) file.commit();
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw UserError(fmt::format("standard output: cannot write: {}\n", std::strerror(errno)));
  }
}

}  // namespace mbgen::cli
