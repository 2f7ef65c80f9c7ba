#include "realtime.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>

namespace hil_rig {

namespace {

constexpr std::int64_t kSecond = 1000000000;  // ns

// Every page of the stack that the loop may come to, so that none faults later.
[[gnu::noinline]] void touch_stack() {
  volatile unsigned char room[256 * 1024];
  for (std::size_t i = 0; i < sizeof room; i += 1024) room[i] = 1;
}

void say(std::FILE* messages, const char* what, int error, const char* remedy) {
  std::fprintf(messages, "real time: %s: %s. Goes on without; %s.\n", what, std::strerror(error), remedy);
}

}  // namespace

void enter_realtime(const Realtime& realtime, std::FILE* messages) {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    say(messages, "memory is not locked", errno, "to permit it: ulimit -l unlimited, or CAP_IPC_LOCK");
  }
  touch_stack();
  if (realtime.cpu >= 0) {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (realtime.cpu < CPU_SETSIZE) CPU_SET(static_cast<unsigned>(realtime.cpu), &set);
    const int error = pthread_setaffinity_np(pthread_self(), sizeof set, &set);
    if (error != 0)
      say(messages, "not pinned to the processor", error, "choose one of the processors that `nproc --all` counts");
  }
  if (realtime.priority > 0) {
    sched_param parameters{};
    parameters.sched_priority = realtime.priority;
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
    if (error != 0) say(messages, "not SCHED_FIFO", error, "to permit it: ulimit -r 98, or CAP_SYS_NICE");
  }
}

int keep_awake(std::FILE* messages) {
  const int file = ::open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC);
  const std::int32_t none = 0;
  if (file >= 0 && write(file, &none, sizeof none) == sizeof none) return file;
  say(messages, "processors may sleep deeply", errno, "to forbid it: write access to /dev/cpu_dma_latency");
  if (file >= 0) close(file);
  return -1;
}

std::int64_t monotonic_now() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kSecond + now.tv_nsec;
}

void sleep_until(std::int64_t time) noexcept {
  const timespec until = {time / kSecond, time % kSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace hil_rig
