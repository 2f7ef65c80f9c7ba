// mbgen completion: shell scripts from the table of commands and options.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "workbench/cli/commands.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"

namespace mbgen::cli {
namespace {

struct CompletionOptions {
  std::string shell;
};

/// --words of a command, with the first line of their description.
struct CompletedOption {
  std::string word, description;
};

std::vector<CompletedOption> options_of(const NamedCommand& command) {
  std::vector<CompletedOption> list;
  for (const OptionWords& option : command.options()) {
    for (const std::string& name : option.long_names) list.push_back({"--" + name, first_line(option.description)});
  }
  return list;
}

/// Options of a command on each of its lines, then files; commands for the first word.
std::string bash_text(const NamedCommand& application) {
  std::string cases, names;
  for (const NamedCommand& command : application.commands()) {
    std::vector<std::string> words;
    for (const CompletedOption& option : options_of(command)) words.push_back(option.word);
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command.name(), fmt::join(words, " "));
    names += (names.empty() ? "" : " ") + command.name();
  }
  return "# bash completion for mbgen: source this file, or keep it in /usr/share/bash-completion/completions/mbgen\n"
         "_mbgen() {\n"
         "  local words current=${COMP_WORDS[COMP_CWORD]}\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         names +
         " --help --version\" -- \"$current\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "    *) words=\"\" ;;\n"
         "  esac\n"
         "  case $current in\n"
         "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$current\")) ;;\n"
         "    *) COMPREPLY=($(compgen -f -- \"$current\")) ;;\n"
         "  esac\n"
         "}\n"
         "complete -o filenames -F _mbgen mbgen\n";
}

std::string zsh_text(const NamedCommand& application) {
  return "#compdef mbgen\n"
         "# zsh completion for mbgen: source this file after compinit\n"
         "autoload -U +X bashcompinit && bashcompinit\n" +
         bash_text(application);
}

/// A word of fish in single quotes.
std::string fish_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string fish_text(const NamedCommand& application) {
  std::string text = "# fish completion for mbgen: keep it in ~/.config/fish/completions/mbgen.fish\n";
  for (const NamedCommand& command : application.commands()) {
    text += fmt::format("complete -c mbgen -n __fish_use_subcommand -f -a {} -d {}\n", command.name(),
                        fish_quoted(first_line(command.description())));
  }
  for (const NamedCommand& command : application.commands()) {
    for (const CompletedOption& option : options_of(command)) {
      text += fmt::format("complete -c mbgen -n '__fish_seen_subcommand_from {}' -l {} -d {}\n", command.name(),
                          option.word.substr(2), fish_quoted(option.description));
    }
  }
  return text;
}

}  // namespace

void add_completion(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<CompletionOptions>();
  NamedCommand command =
      application.add_command("completion", "print the script by which a shell completes mbgen's words");
  command.footer("Example: source <(mbgen completion bash)");
  command.add_option("SHELL", options->shell, "bash, zsh or fish").required().one_of({"bash", "zsh", "fish"});
  command.callback([options, application, &exit_code] {
    print(options->shell == "bash"  ? bash_text(application)
          : options->shell == "zsh" ? zsh_text(application)
                                    : fish_text(application));
    exit_code = kDone;
  });
}

}  // namespace mbgen::cli
