#include "workbench/host/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <map>
#include <sstream>
#include <thread>

#include "workbench/host/blocked_signals.hpp"

namespace mbgen {
namespace {

constexpr pid_t kNoProcess = -1;
constexpr std::chrono::milliseconds kLongestPause{50};  // a person sees no delay

/// Starts a program in a new process group, which its child processes inherit.
pid_t start(const Command& command, const sigset_t& signals) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, command.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setsigmask(&attributes, &signals);
  std::vector<std::string> words = command.arguments;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = kNoProcess;
  const int error = posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? process : kNoProcess;
}

/// Exit code of a program, negative while it runs.
int ask(pid_t process, int options) {
  int state = 0;
  pid_t ended = 0;
  do {
    ended = ::waitpid(process, &state, options);
  } while (ended < 0 && errno == EINTR);
  if (ended == 0) return -1;
  if (ended < 0) return kNotStarted;
  return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

/// Running programs, by index in the list.
using Running = std::map<std::size_t, pid_t>;

void end_all(const Running& running) {
  for (const auto& [place, process] : running) ::kill(-process, SIGTERM);
  for (const auto& [place, process] : running) ask(process, 0);
}

}  // namespace

std::vector<int> run_side_by_side(const std::vector<Command>& commands,
                                  const std::function<void(std::size_t ended)>& watch) {
  const BlockedSignals signals(SIGCHLD);
  const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
  std::vector<int> codes(commands.size(), kNotStarted);
  Running running;
  std::size_t next = 0;
  bool has_failed = false;
  while (true) {
    for (; running.size() < most && next < commands.size() && !has_failed; ++next) {
      const pid_t process = start(commands[next], signals.before());
      if (process == kNoProcess)
        has_failed = true;
      else
        running[next] = process;
    }
    if (running.empty()) return codes;
    if (watch) watch(next - running.size());
    if (const int signal = signals.wait(kLongestPause); signal != 0) {
      end_all(running);
      throw Interrupted{signal};
    }
    std::erase_if(running, [&](const auto& one) {
      const int code = ask(one.second, WNOHANG);
      if (code < 0) return false;
      codes[one.first] = code;
      has_failed = has_failed || code != 0;
      return true;
    });
  }
}

std::vector<std::string> split_words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace mbgen
