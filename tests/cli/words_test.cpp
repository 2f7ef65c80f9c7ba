// What mbgen says of itself: explanations, the man page, completions, help.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// Commands as `mbgen --help` lists them.
std::vector<std::string> commands_of(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.starts_with("  ")) {
    if (line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

TEST_F(CommandLine, EveryCommandHasAnExample) {
  const std::vector<std::string> commands = commands_of(mbgen("--help").out);
  EXPECT_GE(commands.size(), 10u);
  for (const std::string& command : commands) {
    const Outcome help = mbgen(command + " --help");
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_NE(help.out.find("\nExample: "), std::string::npos) << command;
  }
}

TEST_F(CommandLine, ManualHasEveryCommandAndLayoutProgramsTakeIt) {
  const Outcome manual = mbgen("manual");
  EXPECT_EQ(manual.exit_code, 0);
  for (const std::string& command : commands_of(mbgen("--help").out)) {
    EXPECT_NE(manual.out.find(".SS \"mbgen " + command + "\""), std::string::npos) << command;
  }
  write("mbgen.1", manual.out);
  if (std::system("command -v groff >/dev/null 2>&1") != 0) GTEST_SKIP() << "groff is not installed";
  EXPECT_EQ(shell("groff -man -Tutf8 -ww -z mbgen.1").err, "");
}

TEST_F(CommandLine, BashCompletesCommandsOptionsAndFiles) {
  write("model.json", "{}");
  write("complete.sh",
        mbgen("completion bash").out +
            "complete_words() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _mbgen; echo \"${COMPREPLY[@]}\"; }\n"
            "complete_words mbgen gene\n"
            "complete_words mbgen simulate --dur\n"
            "complete_words mbgen check mod\n"
            "complete_words mbgen nothing --\n");
  EXPECT_EQ(shell("bash complete.sh").out, "generate\n--duration\nmodel.json\n\n");
  EXPECT_EQ(mbgen("completion tcsh").exit_code, 1);
}

TEST_F(CommandLine, ExplainSaysWhyEquationsAreLeftOut) {
  const std::string text = mbgen("explain " + kSource + "/models/four_bar.json").out;
  EXPECT_TRUE(text.starts_with(
      "four_bar is made of 3 moving bodies, 4 joints and no rods. mbgen describes where they are by 3\n"
      "relative coordinates and closes 1 loop by 5 equations, of which 2 are independent: 1 freedom\nremains.\n"))
      << text;
  for (const char* part :
       {"  ground\n    crank: turns by crank_pin\n      coupler: turns by coupler_pin\n    rocker: turns by "
        "rocker_pin\n",
        "3 of them say nothing new in any of the 25 closed positions", "its pins are parallel, so it cannot leave",
        "  coupler_pin [rad], rotation of joint coupler_pin\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST_F(CommandLine, ColoursAreForTerminalsOnly) {
  write("bad.json", R"({ "mbgen": 1, "bodys": {} })");
  EXPECT_EQ(mbgen("check bad.json").err.find('\033'), std::string::npos);
  // `script` runs a command on a terminal of its own.
  if (std::system("command -v script >/dev/null 2>&1") != 0) GTEST_SKIP() << "script is not installed";
  const std::string on_terminal = fmt::format("TERM=xterm script -qec '{} check bad.json' /dev/null", MBGEN_BINARY);
  EXPECT_NE(shell(on_terminal).out.find("\033[1;31m"), std::string::npos);
  EXPECT_EQ(shell("NO_COLOR=1 " + on_terminal).out.find('\033'), std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
