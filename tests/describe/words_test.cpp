// Texts of mbgen on itself: explanations, the man page, completions, help.

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

TEST_F(CommandLine, ExplainTellsLeftFromRight) {
  EXPECT_NE(mbgen("explain " + kSource + "/models/coach_mechanism.json")
                .out.find("\nLeft and right\n--------------\n"
                          "In the plane y = 0, these are mirror images, with their joints: lower_arm_left and "
                          "lower_arm_right;\n"),
            std::string::npos);
  const char* scooter = R"({"mbgen": 1, "name": "scooter", "bodies": {
      "ground": {"points": {"left": [0, 0.4, 0], "middle": [0, 0, 0], "right": [0, -0.4, 0]}},
      "left": {"mass": 1, "com": [0.1, 0.4, 0], "inertia": [1, 1, 1], "points": {"pin": [0, 0.4, 0]}},
      "post": {"mass": 2, "com": [0, 0.1, 0], "inertia": [1, 1, 1], "points": {"pin": [0, 0, 0]}},
      "right": {"mass": 1, "com": [0.1, -0.4, 0.01], "inertia": [1, 1, 1], "points": {"pin": [0, -0.4, 0]}}},
    "joints": {
      "left": {"type": "revolute", "axis": "y", "from": "ground.left", "to": "left.pin"},
      "post": {"type": "revolute", "axis": "z", "from": "ground.middle", "to": "post.pin"},
      "right": {"type": "revolute", "axis": "y", "from": "ground.right", "to": "right.pin"}}})";
  write("scooter.json", scooter);
  EXPECT_NE(mbgen("explain scooter.json")
                .out.find("In the plane y = 0, these are mirror images, with their joints: left and right.\n"
                          "Mass, centre of mass or inertia are not mirrored: left and right; post.\n"),
            std::string::npos)
      << mbgen("explain scooter.json").out;
  write("pendulum.json", kPendulum);
  EXPECT_EQ(mbgen("explain pendulum.json").out.find("Left and right"), std::string::npos);
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

// "-" is standard output: the result and nothing else; messages go to standard error.
TEST_F(CommandLine, StandardOutputTakesAResult) {
  write("pendulum.json", kPendulum);
  const Outcome run = mbgen("simulate pendulum.json --engine generic --duration 0.1 --step 0.01 --out -");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.out.starts_with("t [s],z.pin [rad],")) << run.out;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 12);
  EXPECT_NE(run.err.find("  table                     standard output (11 rows, every step)\n"), std::string::npos)
      << run.err;
  ASSERT_EQ(mbgen("simulate pendulum.json --engine generic --duration 0.1 --step 0.01 --out o.csv").exit_code, 0);
  EXPECT_EQ(run.out, read("o.csv"));
  const Outcome linear = mbgen("linearize pendulum.json --out -");
  EXPECT_EQ(Json::parse(linear.out)["states"].size(), 2u);
  EXPECT_NE(linear.err.find("eigenvalue"), std::string::npos) << linear.err;
  EXPECT_EQ(Json::parse(mbgen("equilibrium pendulum.json --out -").out)["mbgen"], 1);
  EXPECT_TRUE(mbgen("new pendulum --out -").out.starts_with("// "));
  EXPECT_EQ(mbgen("new pendulum --out -").exit_code, 0);
  for (const char* refused :
       {"sweep pendulum.json --vary torque=1,2 --metric 'max(height)' --engine generic --out -",
        "export pendulum.json --fmi 2 --sources-only --out -", "generate pendulum.json --out -"}) {
    const Outcome refusal = mbgen(refused);
    EXPECT_EQ(refusal.exit_code, 1) << refused;
    EXPECT_NE(refusal.err.find("name a "), std::string::npos) << refusal.err;
  }
  EXPECT_FALSE(std::filesystem::exists(path("-")));
  EXPECT_FALSE(std::filesystem::exists(path("-.run.json")));
  EXPECT_EQ(
      mbgen("check -").err,
      "-: cannot read file, it does not exist\n  hint: standard input is /dev/stdin, a file of this name is ./-\n");
}

// A variable of the shell that is not set leaves an empty word.
TEST_F(CommandLine, EmptyWordsAreRefused) {
  write("pendulum.json", kPendulum);
  for (const char* command :
       {"check", "inspect", "explain", "equilibrium", "generate --out g", "simulate --out o.csv"}) {
    EXPECT_EQ(mbgen(std::string(command) + " ''").err,
              "MODEL: must not be empty\nRun with --help for more information.\n")
        << command;
  }
  for (const char* option : {"--out", "--input-table", "--set", "--engine", "--format"}) {
    const Outcome run = mbgen(fmt::format("simulate pendulum.json --out o.csv --duration 0.1 {} ''", option));
    EXPECT_EQ(run.exit_code, 1) << option;
    EXPECT_NE(run.err.find(fmt::format("{}: must not be empty", option)), std::string::npos) << run.err;
  }
  EXPECT_EQ(mbgen("simulate pendulum.json --out o.csv --duration 1s").err,
            "--duration: must be a number without a unit, found \"1s\"\nRun with --help for more information.\n");
}

// A file of another kind is named with the place of its first byte that is no text; its bytes are not printed.
TEST_F(CommandLine, BinaryFilesAreNoTables) {
  write("pendulum.json", kPendulum);
  write("t.csv", std::string("\x7f"
                             "ELF\x02\x01\0\0,\x1b[31m\n",
                             14));
  const std::string place = "t.csv:1:1: must be text, found a byte 0x7f\n";
  for (const char* command :
       {"plot t.csv --columns height -o p.svg", "report t.csv -o p.html", "linearize pendulum.json --result t.csv",
        "simulate pendulum.json --engine generic --input-table t.csv -o o.csv"}) {
    const Outcome run = mbgen(command);
    if (run.err.find("built without reports") != std::string::npos) continue;
    EXPECT_EQ(run.exit_code, 1) << command;
    EXPECT_TRUE(run.err.starts_with(place)) << command << "\n" << run.err;
    EXPECT_NE(run.err.find("  hint: "), std::string::npos) << command;
    EXPECT_EQ(run.err.find_first_of("\x1b\x7f"), std::string::npos) << command;
  }
  write("t.csv", "case,\x1b[31m\n1,2\n");
  EXPECT_TRUE(mbgen("plot t.csv --columns x -o p.svg").err.starts_with("t.csv:1:6: must be text, found a byte 0x1b\n"));
  // A model in place of a result: its first line is no header.
  EXPECT_EQ(mbgen("plot pendulum.json --columns x -o p.svg").err,
            "pendulum.json:1:1: the first column must be \"t\", found \"{\"\n  hint: a result is a table of "
            "mbgen simulate\n");
}

TEST_F(CommandLine, HelpOnAWordThatIsNoCommandIsAnError) {
  const Outcome help = mbgen("simulat --help");
  EXPECT_EQ(help.exit_code, 1);
  EXPECT_NE(help.err.find("simulat"), std::string::npos) << help.err;
  EXPECT_NE(help.err.find("hint: did you mean \"simulate\"?"), std::string::npos) << help.err;
  EXPECT_EQ(mbgen("--help").exit_code, 0);
}

TEST_F(CommandLine, NamesOfInstancesParametersAndInputsAreProposed) {
  std::string model(kPendulum);
  model.replace(model.find("\"inputs\""), 0,
                R"("parameters": { "fl_f_spring": { "value": 1, "tunable": true }, "speed": { "value": 2 } }, )");
  write("placed.json", model);
  const std::string run = " placed.json --engine generic --duration 0.1 --step 1e-2 --out o.csv";
  EXPECT_EQ(mbgen("simulate --set f_spring=2" + run).err,
            "--set: the model has no parameter \"f_spring\"; did you mean \"fl_f_spring\"?\n");
  EXPECT_EQ(mbgen("simulate --set torque=2" + run).err,
            "--set: the model has no parameter \"torque\"; it is an input: --input torque=VALUE\n");
  EXPECT_EQ(mbgen("simulate --input speed=2" + run).err,
            "--input: the model has no input \"speed\"; its inputs: torque\n"
            "  hint: it is a parameter: --set speed=VALUE\n");
  EXPECT_EQ(mbgen("sweep --vary f_spring=1,2 --metric 'max(height)'" + run).err,
            "--vary \"f_spring=1,2\": the model has no parameter or input \"f_spring\"; did you mean "
            "\"fl_f_spring\"?\n");
}

}  // namespace
}  // namespace mbgen::cli_test
