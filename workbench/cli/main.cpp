// mbgen: compiler from a JSON description of a multibody system to a specialised C++ solver.

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/emit/emit.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"

namespace mbgen::cli {
namespace {

/// Colours on a terminal that supports them, unless NO_COLOR is set (no-color.org).
Style style_of_errors() {
  const char* refused = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool is_refused = refused != nullptr && *refused != 0;
  const bool is_dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return isatty(STDERR_FILENO) == 1 && !is_refused && !is_dumb ? Style::coloured : Style::plain;
}

/// Long names of a command's options.
std::vector<std::string> option_names(const NamedCommand& command) {
  std::vector<std::string> names;
  for (const OptionWords& option : command.options()) {
    for (const std::string& name : option.long_names) names.push_back("--" + name);
  }
  return names;
}

/// Hint with the nearest name for the first unknown word.
std::string hint_of(const NamedCommand& application) {
  const std::vector<NamedCommand> chosen = application.chosen_commands();
  std::vector<std::string> commands;
  for (const NamedCommand& one : application.commands()) commands.push_back(one.name());
  for (const std::string& word : application.unexpected_words()) {
    if (word.starts_with("-")) {
      return nearest_hint(word.substr(0, word.find('=')), option_names(chosen.empty() ? application : chosen.front()));
    }
    if (chosen.empty()) return nearest_hint(word, commands);
  }
  return {};
}

/// Programs are made, rewritten and dropped dozens of times: their memory stays with the process, which otherwise
/// spends a sixth of its time on getting it back page by page.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int kKept = 256 << 20, kLargestKept = 32 << 20;  // bytes
  mallopt(M_TRIM_THRESHOLD, kKept);
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
#endif
}

int run(int argc, char** argv) {
  CommandLine line("mbgen makes a specialised C++ solver from a description of a multibody system.", "mbgen",
                   std::string("mbgen ") + kMbgenVersion);
  int exit_code = kDone;
  line.application().footer(
      "Each command explains itself: mbgen simulate --help\n"
      "--out - writes a result to standard output, and all messages to standard error.\n"
      "Exit codes: 0 done, 1 the input is at fault, 2 mbgen is at fault, 130 interrupted.");
  for (const auto add : {add_new,      add_check,  add_explain,    add_inspect,  add_generate,    add_export,
                         add_simulate, add_plot,   add_report,     add_evaluate, add_equilibrium, add_linearize,
                         add_kc,       add_sweep,  add_fit,        add_optimise, add_bench,       add_cache,
                         add_import,   add_schema, add_completion, add_manual}) {
    add(line.application(), exit_code);
  }
  const std::optional<int> refused = line.parse(argc, argv);
  if (!refused) return exit_code;
  if (*refused != 0) print_message("{}", hint_of(line.application()));
  return *refused == 0 ? kDone : kUserFault;
}

}  // namespace
}  // namespace mbgen::cli

int main(int argc, char** argv) {
  using namespace mbgen::cli;
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is a write error instead of the end of the process
  keep_memory();
  try {
    return run(argc, argv);
  } catch (const mbgen::UserError& error) {
    mbgen::print_styled(error.text(style_of_errors()));
    return kUserFault;
  } catch (const mbgen::Interrupted& interrupted) {
    if (interrupted.signal == SIGTERM) return kInterrupted;  // as the shell has it after Ctrl-C
    std::raise(interrupted.signal);
  } catch (const std::bad_alloc&) {
    mbgen::print_message("mbgen: not enough memory\n  hint: simplify the model, or run it on a larger machine\n");
    return kUserFault;
  } catch (const std::filesystem::filesystem_error& error) {
    mbgen::print_message("{}: {}\n", error.path1().string(), error.code().message());
    return kUserFault;
  } catch (const std::exception& error) {
    mbgen::print_message("mbgen: a defect of mbgen, please report it with the model: {}\n", error.what());
  } catch (...) {
    mbgen::print_message("mbgen: a defect of mbgen, please report it with the model\n");
  }
  return kOurDefect;
}
