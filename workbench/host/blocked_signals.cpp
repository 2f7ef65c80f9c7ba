#include "workbench/host/blocked_signals.hpp"

namespace mbgen {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{20};  // short for a person, long beside a system call

}  // namespace

BlockedSignals::BlockedSignals(int beside) : beside_(beside) {
  ::sigemptyset(&blocked_);
  if (beside != 0) ::sigaddset(&blocked_, beside);
  ::pthread_sigmask(SIG_SETMASK, nullptr, &before_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    ::sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_DFL && ::sigismember(&before_, signal) == 0) ::sigaddset(&blocked_, signal);
  }
  ::pthread_sigmask(SIG_BLOCK, &blocked_, nullptr);
}

int BlockedSignals::wait(std::chrono::nanoseconds longest) const {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(longest);
  const timespec pause{seconds.count(), (longest - seconds).count()};
  const int signal = ::sigtimedwait(&blocked_, nullptr, &pause);
  return signal > 0 && signal != beside_ ? signal : 0;
}

int BlockedSignals::taken() {
  const auto now = std::chrono::steady_clock::now();
  if (signal_ != 0 || now < next_look_.load()) return signal_;
  next_look_ = now + kBetweenLooks;
  if (const int signal = wait(std::chrono::nanoseconds(0)); signal != 0) signal_ = signal;
  return signal_;
}

}  // namespace mbgen
