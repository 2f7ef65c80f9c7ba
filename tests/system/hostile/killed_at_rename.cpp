// Loaded before the C library: kills the process where it would give a file its name for the n-th time, n from the
// variable KILLED_AT_RENAME of the environment.
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

extern "C" int rename(const char* from, const char* to) noexcept {
  static int calls = 0;
  const char* last = std::getenv("KILLED_AT_RENAME");
  if (last != nullptr && ++calls == std::atoi(last)) ::kill(::getpid(), SIGKILL);
  return ::renameat(AT_FDCWD, from, AT_FDCWD, to);
}
