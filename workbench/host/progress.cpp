#include "workbench/host/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "compiler/text/characters.hpp"
#include "workbench/host/message.hpp"

namespace mbgen {
namespace {

constexpr int kBarWidth = 40;
constexpr std::size_t kUsualWidth = 80;  // of a terminal of unknown width
constexpr std::chrono::duration<double> kInterval{0.1};
constexpr double kLongInSeconds = 180;  // beyond it minutes are told

/// Usable columns of the terminal: a character in the last one would move the cursor to the next line.
std::size_t columns() {
  winsize size = {};
  const bool tells = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return (tells ? size.ws_col : kUsualWidth) - 1;
}

}  // namespace

double seconds_between_lines() {
  const char* text = std::getenv("MBGEN_PROGRESS");
  if (text == nullptr || *text == 0) return kSecondsBetweenLines;
  char* end = nullptr;
  const double seconds = std::strtod(text, &end);
  return *end == 0 && seconds >= 0 ? seconds : kSecondsBetweenLines;
}

StatusLine::StatusLine()
    : is_terminal_(::isatty(STDERR_FILENO) == 1),
      interval_(is_terminal_ ? kInterval : std::chrono::duration<double>(seconds_between_lines())),
      last_(Clock::now()) {}

bool StatusLine::is_due() const { return interval_.count() > 0 && Clock::now() - last_ >= interval_; }

void StatusLine::show(const std::string& text) {
  last_ = Clock::now();
  if (!is_terminal_) {
    print_message("{}\n", text);
    return;
  }
  is_shown_ = true;
  print_styled(fmt::format("\r{}\x1b[K", terminal_text(text).substr(0, columns())));
}

void StatusLine::clear() {
  if (!is_shown_) return;
  print_styled("\r\x1b[K");
  is_shown_ = false;
}

std::string time_text(double seconds) {
  return seconds < kLongInSeconds ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

void Progress::show(long done, long of) {
  if (!line_.is_due()) return;
  const double part = static_cast<double>(done) / static_cast<double>(of);
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start_;
  const std::string left = part > 0 ? fmt::format(", about {} left", time_text(since.count() * (1 - part) / part)) : "";
  if (!line_.is_terminal()) {
    line_.show(fmt::format("{}: {:.0f} %{}", task_, 100 * part, left));
    return;
  }
  line_.show(fmt::format("[{:<{}}] {:3.0f} %{}", std::string(static_cast<std::size_t>(part * kBarWidth), '#'),
                         kBarWidth, 100 * part, left));
}

}  // namespace mbgen
