// mbgen completion: what shells complete, from the table of commands and options itself.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/files.hpp"

namespace mbgen::cli {
namespace {

struct CompletionOptions {
  std::string shell;
};

/// --words of a command, with their first line of description.
struct CompletedOption {
  std::string word, description;
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::vector<CompletedOption> options_of(const CLI::App& command) {
  std::vector<CompletedOption> list;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames())
      list.push_back({"--" + name, first_line(option->get_description())});
  }
  return list;
}

std::vector<const CLI::App*> commands_of(const CLI::App& application) {
  return application.get_subcommands([](const CLI::App*) { return true; });
}

/// Options of a command on each of its lines, then files; commands for the first word.
std::string bash_text(const CLI::App& application) {
  std::string cases, names;
  for (const CLI::App* command : commands_of(application)) {
    std::vector<std::string> words;
    for (const CompletedOption& option : options_of(*command)) words.push_back(option.word);
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), fmt::join(words, " "));
    names += (names.empty() ? "" : " ") + command->get_name();
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

std::string zsh_text(const CLI::App& application) {
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

std::string fish_text(const CLI::App& application) {
  std::string text = "# fish completion for mbgen: keep it in ~/.config/fish/completions/mbgen.fish\n";
  for (const CLI::App* command : commands_of(application)) {
    text += fmt::format("complete -c mbgen -n __fish_use_subcommand -f -a {} -d {}\n", command->get_name(),
                        fish_quoted(first_line(command->get_description())));
  }
  for (const CLI::App* command : commands_of(application)) {
    for (const CompletedOption& option : options_of(*command)) {
      text += fmt::format("complete -c mbgen -n '__fish_seen_subcommand_from {}' -l {} -d {}\n", command->get_name(),
                          option.word.substr(2), fish_quoted(option.description));
    }
  }
  return text;
}

}  // namespace

void add_completion(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<CompletionOptions>();
  CLI::App* command = application.add_subcommand("completion", "print what a shell needs to complete mbgen's words");
  command->footer("Example: source <(mbgen completion bash)");
  command->add_option("SHELL", options->shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([options, &application, &exit_code] {
    print(options->shell == "bash"  ? bash_text(application)
          : options->shell == "zsh" ? zsh_text(application)
                                    : fish_text(application));
    exit_code = kDone;
  });
}

}  // namespace mbgen::cli
