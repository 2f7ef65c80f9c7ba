#include "workbench/cli/command_line.hpp"

#include <CLI/CLI.hpp>

namespace mbgen::cli {
namespace {

/// Refuses the empty word, the result of an unset shell variable.
CLI::Option* with_value(CLI::Option* option) {
  return option->check(
      [](const std::string& word) { return word.empty() ? std::string("must not be empty") : std::string(); });
}

/// Refuses text that is no number of a kind.
template <class Number>
CLI::Option* with_number(CLI::Option* option, const char* kind) {
  return option->check([kind](const std::string& word) {
    Number number{};
    if (CLI::detail::lexical_cast(word, number)) return std::string();
    return "must be " + std::string(kind) + ", found \"" + word + "\"";
  });
}

}  // namespace

Option Option::required() const { return Option(option_->required()); }

Option Option::one_of(const std::vector<std::string>& words) const {
  return Option(option_->check(CLI::IsMember(words)));
}

Option Option::between(int first, int last) const { return Option(option_->check(CLI::Range(first, last))); }

Option Option::with_shown_default() const { return Option(option_->capture_default_str()); }

Option Option::one_value_at_a_time() const { return Option(option_->allow_extra_args(false)); }

Option Option::separated_by(char delimiter) const { return Option(option_->delimiter(delimiter)); }

Option Option::needs(Option other) const { return Option(option_->needs(other.option_)); }

Option Option::excludes(Option other) const { return Option(option_->excludes(other.option_)); }

NamedCommand NamedCommand::add_command(const std::string& name, const std::string& description) const {
  return NamedCommand(app_->add_subcommand(name, description));
}

void NamedCommand::footer(const std::string& text) const { app_->footer(text); }

void NamedCommand::callback(const std::function<void()>& run) const { app_->callback(run); }

Option NamedCommand::add_option(const std::string& names, std::string& value, const std::string& description) const {
  return Option(with_value(app_->add_option(names, value, description)));
}

Option NamedCommand::add_option(const std::string& names, std::vector<std::string>& values,
                                const std::string& description) const {
  return Option(with_value(app_->add_option(names, values, description)));
}

Option NamedCommand::add_option(const std::string& names, int& value, const std::string& description) const {
  return Option(with_number<int>(app_->add_option(names, value, description), "a whole number"));
}

Option NamedCommand::add_option(const std::string& names, long& value, const std::string& description) const {
  return Option(with_number<long>(app_->add_option(names, value, description), "a whole number"));
}

Option NamedCommand::add_option(const std::string& names, std::optional<double>& value,
                                const std::string& description) const {
  return Option(with_number<double>(app_->add_option(names, value, description), "a number without a unit"));
}

Option NamedCommand::add_option(const std::string& names, const std::function<void(const std::string&)>& take,
                                const std::string& description) const {
  return Option(with_value(app_->add_option_function<std::string>(names, take, description)));
}

Option NamedCommand::add_flag(const std::string& names, bool& is_given, const std::string& description) const {
  return Option(app_->add_flag(names, is_given, description));
}

Option NamedCommand::add_flag(const std::string& names, const std::function<void()>& take,
                              const std::string& description) const {
  return Option(app_->add_flag_callback(names, take, description));
}

std::string NamedCommand::name() const { return app_->get_name(); }

std::string NamedCommand::description() const { return app_->get_description(); }

std::string NamedCommand::footer() const { return app_->get_footer(); }

std::vector<OptionWords> NamedCommand::options() const {
  std::vector<OptionWords> list;
  for (const CLI::Option* option : app_->get_options()) {
    list.push_back({option->get_name(), option->get_lnames(), option->get_description(), option->get_type_name(),
                    option->get_items_expected_max() > 0, option->get_positional()});
  }
  return list;
}

std::vector<NamedCommand> NamedCommand::commands() const {
  std::vector<NamedCommand> list;
  for (CLI::App* command : app_->get_subcommands({})) list.emplace_back(command);
  return list;
}

std::vector<NamedCommand> NamedCommand::chosen_commands() const {
  std::vector<NamedCommand> list;
  for (CLI::App* command : app_->get_subcommands()) list.emplace_back(command);
  return list;
}

std::vector<std::string> NamedCommand::unexpected_words() const { return app_->remaining(true); }

bool NamedCommand::is_given(const std::string& option) const { return app_->get_option(option)->count() > 0; }

CommandLine::CommandLine(const std::string& description, const std::string& name, const std::string& version)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    // `mbgen WORD --help` with an unknown command.
    const std::vector<std::string> words = app_->remaining(true);
    if (!words.empty() && app_->get_subcommands().empty()) return app_->exit(CLI::ExtrasError(words));
    return app_->exit(help);
  } catch (const CLI::ParseError& error) {
    return app_->exit(error);
  }
  return std::nullopt;
}

}  // namespace mbgen::cli
