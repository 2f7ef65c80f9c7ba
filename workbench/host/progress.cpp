#include "workbench/host/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "compiler/text/characters.hpp"
#include "workbench/host/message.hpp"

namespace mbgen {
namespace {

constexpr int kBarWidth = 40;
constexpr std::size_t kUsualWidth = 80;  // of a terminal of unknown width
constexpr std::chrono::milliseconds kInterval{100};

/// Usable columns of the terminal: a character in the last one would move the cursor to the next line.
std::size_t columns() {
  winsize size = {};
  const bool tells = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return (tells ? size.ws_col : kUsualWidth) - 1;
}

}  // namespace

StatusLine::StatusLine() : is_terminal_(::isatty(STDERR_FILENO) == 1), last_(Clock::now()) {}

bool StatusLine::is_due() const { return is_terminal_ && Clock::now() - last_ >= kInterval; }

void StatusLine::show(const std::string& text) {
  last_ = Clock::now();
  is_shown_ = true;
  print_styled(fmt::format("\r{}\x1b[K", terminal_text(text).substr(0, columns())));
}

void StatusLine::clear() {
  if (!is_shown_) return;
  print_styled("\r\x1b[K");
  is_shown_ = false;
}

void Progress::show(long done, long of) {
  if (!line_.is_due()) return;
  const double part = static_cast<double>(done) / static_cast<double>(of);
  line_.show(fmt::format("[{:<{}}] {:3.0f} %", std::string(static_cast<std::size_t>(part * kBarWidth), '#'), kBarWidth,
                         100 * part));
}

}  // namespace mbgen
