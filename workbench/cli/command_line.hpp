#pragma once
// Commands and their options as typed. CLI11 stays behind command_line.cpp: a file that includes it compiles for six
// seconds longer.

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

/// An option of a command, or an argument without a name. A handle: copies mean the same option.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;
  /// The value is one of these words.
  Option one_of(const std::vector<std::string>& words) const;
  /// The value is a whole number between these two, which count.
  Option between(int first, int last) const;
  /// The help names the value that the variable has now.
  Option with_shown_default() const;
  /// One value each time that the option is typed.
  Option one_value_at_a_time() const;
  /// One word may hold several values with this between them.
  Option separated_by(char delimiter) const;
  Option needs(Option other) const;
  Option excludes(Option other) const;

 private:
  CLI::Option* option_;
};

/// An option as help, manual and completion tell it.
struct OptionWords {
  std::string name;                     ///< all its names, "-o,--out"
  std::vector<std::string> long_names;  ///< without dashes
  std::string description, value_type;
  bool takes_value, is_argument;
};

/// A command, or the application, whose subcommands are the commands. A handle: copies mean the same command. The
/// variable that an option fills must live until the command line is parsed.
class NamedCommand {
 public:
  explicit NamedCommand(CLI::App* app) : app_(app) {}

  NamedCommand add_command(const std::string& name, const std::string& description) const;
  /// The text after the options of the help.
  void footer(const std::string& text) const;
  /// Runs when the command line names the command.
  void callback(const std::function<void()>& run) const;

  // names: "-o,--out"; without dashes: an argument.
  Option add_option(const std::string& names, std::string& value, const std::string& description) const;
  Option add_option(const std::string& names, std::vector<std::string>& values, const std::string& description) const;
  Option add_option(const std::string& names, int& value, const std::string& description) const;
  Option add_option(const std::string& names, long& value, const std::string& description) const;
  Option add_option(const std::string& names, std::optional<double>& value, const std::string& description) const;
  /// take: called with the word typed.
  Option add_option(const std::string& names, const std::function<void(const std::string&)>& take,
                    const std::string& description) const;
  Option add_flag(const std::string& names, bool& is_given, const std::string& description) const;
  Option add_flag(const std::string& names, const std::function<void()>& take, const std::string& description) const;

  std::string name() const;
  std::string description() const;
  std::string footer() const;
  std::vector<OptionWords> options() const;
  std::vector<NamedCommand> commands() const;
  /// The commands that the command line named.
  std::vector<NamedCommand> chosen_commands() const;
  /// Words that nobody expected, of chosen commands too.
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
  /// Runs the command that is named. Returns nothing when it ran, else the exit code of CLI11, 0 after --help, the
  /// message being printed.
  std::optional<int> parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace mbgen::cli
