#include "workbench/engines/host_compiler.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "compiler/emit/emit.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/progress.hpp"

namespace mbgen {
namespace {

/// From here on a compilation on a terminal is worth advice; lines of a log come later.
constexpr std::chrono::duration<double> kLongCompilation{3};

constexpr std::size_t kMessageTail = 2000;  // characters of the compiler's messages that a person still reads

/// Words of compilers and of the kernel for a machine that has too little of something.
constexpr const char* kShortages[] = {"No space left on device", "Disk quota exceeded", "File too large",
                                      "Cannot allocate memory",  "out of memory",       "virtual memory exhausted"};

/// Whether a compiler ended for want of memory or room on a disk, or was killed, which the kernel does for memory.
bool is_short_of_something(const std::string& messages, int code) {
  if (code == 128 + SIGKILL || messages.find("Killed") != std::string::npos) return true;
  return std::any_of(std::begin(kShortages), std::end(kShortages),
                     [&](const char* words) { return messages.find(words) != std::string::npos; });
}

/// The line of /proc/cpuinfo that lists the processor's instruction sets: code made for one processor may not run on
/// another.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("flags") || line.starts_with("Features")) return line;
  }
  return "";
}

[[noreturn]] void reject(const Command& command, int code) {
  std::string messages = read_text(command.log);
  if (is_short_of_something(messages, code)) {
    throw UserError(fmt::format("the compiler was stopped by this machine (exit code {}): {}\n{}", code,
                                command.arguments.front(),
                                messages.substr(messages.size() - std::min(messages.size(), kMessageTail))));
  }
  if (messages.size() > kMessageTail) messages = "...\n" + messages.substr(messages.size() - kMessageTail);
  throw std::runtime_error(
      fmt::format("the compiler rejects the generated code: {}\n{}", fmt::join(command.arguments, " "), messages));
}

/// Fails: UserError where a program that ended well has not made its file.
void require_result(const Command& command) {
  if (command.result.empty()) return;
  std::error_code missing;
  const auto size = std::filesystem::file_size(command.result, missing);
  if (!missing && size > 0) return;
  throw UserError(fmt::format("no C++ compiler: `{}` ended well and wrote no code; name another one in CXX\n",
                              command.arguments.front()));
}

/// Parts of a source that are compiled together.
struct PartRange {
  int first = 0, last = 0;
};

/// The part that runs at every step alone, and the others on as many further processors as there are: every compilation
/// reads the headers and the whole file once more, half a second.
std::vector<PartRange> ranges_of(int rare_parts) {
  std::vector<PartRange> ranges = {{0, 0}};
  const int others = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  const int groups = std::min(rare_parts, others);
  for (int g = 0; g < groups; ++g) ranges.push_back({1 + g * rare_parts / groups, (g + 1) * rare_parts / groups});
  return ranges;
}

}  // namespace

std::string key_of(const HostCompiler& compiler) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}", fmt::join(compiler.words, " "), fmt::join(compiler.flags, " "),
                     fmt::join(compiler.hot_flags, " "), fmt::join(compiler.rare_flags, " "), compiler.version,
                     processor());
}

HostCompiler find_cross_compiler(const std::filesystem::path& scratch, const CrossTarget& target) {
  HostCompiler compiler;
  const char* chosen = std::getenv(target.variable.c_str());
  compiler.words = split_words(chosen == nullptr ? "" : chosen);
  if (compiler.words.empty()) compiler.words = {target.compiler};
  std::vector<std::string> question = compiler.words;
  question.push_back("--version");
  const std::filesystem::path answer = scratch / "version";
  if (run_side_by_side({{question, answer}})[0] != 0) {
    throw UserError(fmt::format(
        "no C++ compiler{}{}: `{}` does not run; install one (apt-get install {}), name it in the environment "
        "variable {}, {}\n",
        target.platform.empty() ? "" : " for ", target.platform, fmt::join(compiler.words, " "), target.package,
        target.variable, target.otherwise));
  }
  compiler.version = read_text(answer);
  compiler.is_clang = compiler.version.find("clang") != std::string::npos;
  const CompilerFamily family = compiler.is_clang ? CompilerFamily::clang : CompilerFamily::gnu;
  compiler.flags = solver_compile_flags(family);
  compiler.rare_flags = rare_compile_flags(family);
  return compiler;
}

HostCompiler find_compiler(const std::filesystem::path& scratch, const std::string& processor,
                           [[maybe_unused]] int lanes) {
  HostCompiler compiler = find_cross_compiler(
      scratch,
      {"", "c++", "CXX", "g++", "or do without: --engine generic, generate without --measure, export --sources-only"});
#if defined(__x86_64__)
  if (!compiler.is_clang && lanes > 0) {
    for (std::string& flag : lane_flags_of_gnu_on_x86()) compiler.flags.push_back(std::move(flag));
  }
#endif
  if (!processor.empty()) compiler.flags.push_back(processor);
  return compiler;
}

std::vector<std::string> compilation_of(const HostCompiler& compiler,
                                        const std::vector<std::filesystem::path>& directories) {
  std::vector<std::string> words = compiler.words;
  words.insert(words.end(), compiler.flags.begin(), compiler.flags.end());
  for (const std::filesystem::path& directory : directories) words.insert(words.end(), {"-I", directory.string()});
  return words;
}

void run_all(const std::vector<Command>& commands, const std::string& product, const std::string& advice) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  StatusLine line;
  const std::vector<int> codes = run_side_by_side(commands, [&](std::size_t ended) {
    if (!line.is_due()) return;
    const std::chrono::duration<double> since = Clock::now() - start;
    const bool is_long = !line.is_terminal() || since > kLongCompilation;
    line.show(fmt::format("compiling {}: {} of {} parts, {}{}", product, ended, commands.size(),
                          time_text(since.count()), is_long ? advice : ""));
  });
  line.clear();
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (codes[i] != 0) reject(commands[i], codes[i]);
  }
  for (const Command& command : commands) require_result(command);
}

std::vector<std::string> compile_sources(const HostCompiler& compiler,
                                         const std::vector<std::filesystem::path>& directories,
                                         const std::vector<Source>& sources, const std::filesystem::path& objects,
                                         const std::string& product, const std::string& advice) {
  std::vector<Command> compilations, rare;
  std::vector<std::string> names;
  for (const Source& source : sources) {
    const std::vector<PartRange> ranges = ranges_of(source.rare_parts);
    for (const PartRange& parts : ranges) {
      const bool is_part = parts.first > 0;
      const std::string base =
          (objects / source.path.filename()).string() + (is_part ? fmt::format(".{}", parts.first) : "");
      names.push_back(base + ".o");
      Command compilation{compilation_of(compiler, directories), base + ".log", names.back()};
      std::vector<std::string>& words = compilation.arguments;
      const std::vector<std::string>& further = source.is_rare || is_part ? compiler.rare_flags : compiler.hot_flags;
      words.insert(words.end(), further.begin(), further.end());
      if (source.rare_parts > 0) words.push_back(fmt::format("-DMBGEN_PART={}", parts.first));
      if (parts.last > parts.first) words.push_back(fmt::format("-DMBGEN_LAST_PART={}", parts.last));
      const bool takes_user = &parts == &ranges.back() && !source.user.empty();
      if (takes_user) words.insert(words.end(), {"-include", source.path.string()});
      words.insert(words.end(), {"-c", (takes_user ? source.user : source.path).string(), "-o", names.back()});
      (is_part ? rare : compilations).push_back(std::move(compilation));
    }
  }
  // The first part of a large file takes longest, so that it starts first.
  compilations.insert(compilations.end(), rare.begin(), rare.end());
  run_all(compilations, product, advice);
  return names;
}

}  // namespace mbgen
