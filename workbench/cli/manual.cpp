// mbgen manual: the man page, from the table of commands and options.

#include <fmt/format.h>

#include <sstream>

#include "compiler/emit/emit.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/host/files.hpp"

namespace mbgen::cli {
namespace {

/// Text escaped for troff: no escapes, no hyphens turned into dashes, no lines that begin a request.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += std::string("\\&") + c;
    } else {
      result += c;
    }
  }
  return result;
}

std::string options_text(const NamedCommand& command) {
  std::string text;
  for (const OptionWords& option : command.options()) {
    if (option.long_names == std::vector<std::string>{"help"}) continue;
    const bool has_value = option.takes_value && !option.is_argument;
    const std::string value = has_value ? " \\fI" + roff(option.value_type) + "\\fR" : "";
    text += ".TP\n\\fB" + roff(option.name) + "\\fR" + value + "\n" + roff(option.description) + "\n";
  }
  return text;
}

/// Lines after a command's options, its example first, verbatim.
std::string footer_text(const NamedCommand& command) {
  std::string text = ".PP\n.nf\n";
  std::istringstream lines(command.footer());
  for (std::string line; std::getline(lines, line);) text += roff(line) + "\n";
  return text + ".fi\n";
}

std::string manual_text(const NamedCommand& application) {
  std::string text = fmt::format(
      ".TH MBGEN 1 \"\" \"mbgen {}\" \"User Commands\"\n"
      ".SH NAME\nmbgen \\- specialised C++ solvers for multibody systems\n"
      ".SH SYNOPSIS\n\\fBmbgen\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n"
      ".SH DESCRIPTION\n{}\n.PP\n"
      "Each command prints its result on standard output and nothing else there; messages go to standard error.\n"
      ".SH COMMANDS\n",
      kMbgenVersion, roff(application.description()));
  for (const NamedCommand& command : application.commands()) {
    text += fmt::format(".SS \"mbgen {}\"\n{}.\n{}{}", command.name(), roff(command.description()),
                        options_text(command), footer_text(command));
  }
  return text +
         ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n1\nThe input is at fault.\n.TP\n2\nmbgen is at "
         "fault.\n.TP\n130\nInterrupted.\n"
         ".SH ENVIRONMENT\n.TP\nCXX\nThe compiler of solvers; default c++.\n.TP\nNO_COLOR\nNo colours on terminals.\n";
}

}  // namespace

void add_manual(NamedCommand application, int& exit_code) {
  NamedCommand command = application.add_command("manual", "print the man page of mbgen");
  command.footer("Example: mbgen manual | man -l -");
  command.callback([application, &exit_code] {
    print(manual_text(application));
    exit_code = kDone;
  });
}

}  // namespace mbgen::cli
