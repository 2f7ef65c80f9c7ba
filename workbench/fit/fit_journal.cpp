#include "workbench/fit/fit_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>

#include "compiler/text/characters.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"

namespace mbgen::fit {
namespace {

// Format of a journal: this line with a description appended, then one line per evaluation: hash of the rest of the
// line, arguments, a bar, numbers.
constexpr std::string_view kFirstLine = "mbgen fit journal 1 ", kAnyJournal = "mbgen fit journal ";

std::string hash_of_text(std::string_view text) {
  Hash hash;
  hash.add(text);
  return hash.text();
}

[[noreturn]] void fail_to_write(const std::filesystem::path& path) {
  throw UserError(fmt::format("{}: cannot write: {}\n", path.string(), std::strerror(errno)));
}

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const char *place = text.data(), *end = text.data() + text.size();
  while (place < end) {
    double value = 0;
    const auto [next, error] = std::from_chars(place, end, value);
    if (error != std::errc()) return {};
    numbers.push_back(value);
    place = next + 1;
  }
  return numbers;
}

/// The text up to the last line end: a killed process leaves an incomplete line.
std::string complete_lines(const std::string& text) {
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? "" : text.substr(0, end + 1);
}

}  // namespace

FitJournal::FitJournal(const std::filesystem::path& path, const std::string& description, bool restart) : path_(path) {
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail_to_write(path);
  try {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      throw UserError(fmt::format("{}: another mbgen fit is at work on it\n", path.string()));
    const std::string kept = restart ? "" : complete_lines(read_text(path));
    read(kept, description);
    if (::ftruncate(file_, static_cast<off_t>(kept.size())) != 0) fail_to_write(path);
    if (kept.empty()) append(fmt::format("{}{}\n", kFirstLine, description));
  } catch (...) {
    ::close(file_);
    throw;
  }
}

FitJournal::~FitJournal() { ::close(file_); }

void FitJournal::read(const std::string& text, const std::string& description) {
  if (text.empty()) return;
  const std::size_t end = text.find('\n');
  const std::string first = text.substr(0, end);
  if (!first.starts_with(kAnyJournal))
    throw UserError(fmt::format("{}: is not a journal of mbgen fit; choose another --out\n", path_.string()));
  if (first != fmt::format("{}{}", kFirstLine, description))
    throw UserError(
        fmt::format("{}: belongs to another fit: its model, data or options differ\n  hint: run with the "
                    "words of before to go on with it, with --restart to begin anew, or with another "
                    "--out\n",
                    path_.string()));
  for (const std::string& line : split_at(std::string_view(text).substr(end + 1), '\n')) {
    const std::size_t blank = line.find(' '), bar = line.find(" | ");
    if (blank == std::string::npos || bar == std::string::npos || bar <= blank) continue;
    if (hash_of_text(std::string_view(line).substr(blank + 1)) != line.substr(0, blank)) continue;
    lines_[line.substr(blank + 1, bar - blank - 1)] = numbers_in(std::string_view(line).substr(bar + 3));
  }
  known_ = static_cast<long>(lines_.size());
}

const std::vector<double>* FitJournal::find(const std::string& arguments) const {
  const auto found = lines_.find(arguments);
  return found == lines_.end() ? nullptr : &found->second;
}

void FitJournal::append(const std::string& line) {
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t count = ::write(file_, line.data() + written, line.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_write(path_);
    written += static_cast<std::size_t>(count);
  }
  if (::fsync(file_) != 0 && errno != EINVAL) fail_to_write(path_);
}

void FitJournal::add(const std::string& arguments, const std::vector<double>& numbers) {
  std::string content = arguments + " |";
  for (const double number : numbers) content += fmt::format(" {}", number);
  append(fmt::format("{} {}\n", hash_of_text(content), content));
  lines_[arguments] = numbers;
}

}  // namespace mbgen::fit
