#include "compiler/base/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <sstream>

namespace mbgen::cli {
namespace {

constexpr pid_t kNoProcess = -1;

pid_t start(const Command& command) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, command.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::vector<std::string> words = command.arguments;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = kNoProcess;
  const int error = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? process : kNoProcess;
}

int wait_for(pid_t process) {
  if (process == kNoProcess) return kNotStarted;
  int state = 0;
  while (::waitpid(process, &state, 0) < 0) {
    if (errno != EINTR) return kNotStarted;
  }
  return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

}  // namespace

std::vector<int> run_side_by_side(const std::vector<Command>& commands) {
  std::vector<pid_t> processes;
  for (const Command& command : commands) processes.push_back(start(command));
  std::vector<int> codes;
  for (const pid_t process : processes) codes.push_back(wait_for(process));
  return codes;
}

std::vector<std::string> split_words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace mbgen::cli
