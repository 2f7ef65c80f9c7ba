#pragma once
// Commands and their options as typed. CLI11 is included in command_line.cpp only: it adds six seconds of compile time
// per file.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace mbgen::cli {

/// An option, or a positional argument, of a command. A handle: copies refer to the same option.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;
  /// Restricts the value to these words.
  Option one_of(const std::vector<std::string>& words) const;
  /// Restricts the value to whole numbers from first to last.
  Option between(int first, int last) const;
  /// Shows the current value of the variable as default in the help.
  Option with_shown_default() const;
  /// Takes one value each time the option is typed.
  Option one_value_at_a_time() const;
  /// Splits one word into several values at this character.
  Option separated_by(char delimiter) const;
  Option needs(Option other) const;
  Option excludes(Option other) const;

 private:
  CLI::Option* option_;
};

/// An option in help, manual and completion.
struct OptionWords {
  std::string name;                     ///< all its names, "-o,--out"
  std::vector<std::string> long_names;  ///< without dashes
  std::string description, value_type;
  bool takes_value, is_argument;
};

/// A command, or the application, whose subcommands are the commands. A handle: copies refer to the same command. The
/// variable of an option must outlive the parsing of the command line.
class NamedCommand {
 public:
  explicit NamedCommand(CLI::App* app) : app_(app) {}

  NamedCommand add_command(const std::string& name, const std::string& description) const;
  /// Sets the text after the options in the help.
  void footer(const std::string& text) const;
  /// Sets the function called when the command line names the command.
  void callback(const std::function<void()>& run) const;

  // names: "-o,--out"; without dashes: an argument.
  Option add_option(const std::string& names, std::string& value, const std::string& description) const;
  Option add_option(const std::string& names, std::vector<std::string>& values, const std::string& description) const;
  Option add_option(const std::string& names, int& value, const std::string& description) const;
  Option add_option(const std::string& names, long& value, const std::string& description) const;
  Option add_option(const std::string& names, std::optional<double>& value, const std::string& description) const;
  /// take: called with the typed word.
  Option add_option(const std::string& names, const std::function<void(const std::string&)>& take,
                    const std::string& description) const;
  Option add_flag(const std::string& names, bool& is_given, const std::string& description) const;
  Option add_flag(const std::string& names, const std::function<void()>& take, const std::string& description) const;

  std::string name() const;
  std::string description() const;
  std::string footer() const;
  std::vector<OptionWords> options() const;
  std::vector<NamedCommand> commands() const;
  /// Commands named on the command line.
  std::vector<NamedCommand> chosen_commands() const;
  /// Unexpected words, also of the named commands.
  std::vector<std::string> unexpected_words() const;
  bool is_given(const std::string& option) const;

 private:
  CLI::App* app_;
};

/// The application with its commands.
class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& name, const std::string& version);
  ~CommandLine();

  NamedCommand application() const { return NamedCommand(app_.get()); }
  /// Runs the named command. Returns nothing after a run, else the exit code of CLI11 with the message printed, 0 after
  /// --help.
  std::optional<int> parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace mbgen::cli
