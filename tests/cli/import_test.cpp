// mbgen import: what it prints for people and for machines, and how it ends. What robots become: tests/import.
#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Import : public CommandLine {
 protected:
  static std::string robot(const std::string& file) { return kSource + "/tests/import/" + file; }
};

long lines_with(const std::string& text, const std::string& word) {
  std::istringstream stream(text);
  long count = 0;
  for (std::string line; std::getline(stream, line);) count += line.find(word) != std::string::npos;
  return count;
}

TEST_F(Import, JsonSaysWhatTheModelHasAndWhatWasLost) {
  const std::string arm = robot("arm.urdf");
  const Outcome machine = mbgen("import " + arm + " --out arm.json --json");
  ASSERT_EQ(machine.exit_code, 0) << machine.err;
  EXPECT_EQ(machine.err, "");
  const Json report = Json::parse(machine.out);
  EXPECT_EQ(report["robot"], arm);
  EXPECT_EQ(report["format"], "URDF");
  EXPECT_EQ(report["file"], "arm.json");
  EXPECT_EQ(report["loops"], 0);
  const Json model = Json::parse(read("arm.json"), nullptr, true, true);
  EXPECT_EQ(report["model"], model["name"]);
  EXPECT_EQ(report["joints"], model["joints"].size());
  EXPECT_EQ(json_of("check arm.json --json")["ok"], true);
  ASSERT_FALSE(report["notes"].empty());
  for (const Json& note : report["notes"]) {
    EXPECT_EQ(note["file"], arm);
    EXPECT_GT(note["line"], 0);
    EXPECT_GT(note["column"], 0);
    EXPECT_FALSE(note["message"].get<std::string>().empty());
  }
}

TEST_F(Import, PeopleReadTheSameNotesOnStandardError) {
  const std::string arguments = "import " + robot("arm.urdf") + " --out arm.json";
  const Json report = json_of(arguments + " --json");
  const Outcome people = mbgen(arguments);
  EXPECT_EQ(people.exit_code, 0);
  EXPECT_EQ(people.out, fmt::format("arm.json: bodies {}, joints {}, of them closing loops 0, notes {}\n",
                                    report["bodies"].get<int>(), report["joints"].get<int>(), report["notes"].size()));
  EXPECT_EQ(lines_with(people.err, ": note: "), report["notes"].size());
  for (const Json& note : report["notes"])
    EXPECT_NE(
        people.err.find(fmt::format("{}:{}:{}: note: {}\n", note["file"].get<std::string>(), note["line"].get<int>(),
                                    note["column"].get<int>(), note["message"].get<std::string>())),
        std::string::npos);
}

TEST_F(Import, WithoutAFileTheModelIsPrinted) {
  const std::string arguments = "import " + robot("four_bar.urdf") + " --loops " + robot("four_bar_loops.json");
  const Outcome printed = mbgen(arguments);
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  const Json report = json_of(arguments + " --out four_bar.json --json");
  EXPECT_EQ(printed.out, read("four_bar.json"));
  EXPECT_EQ(report["loops"], 1);
  const Outcome both = mbgen(arguments + " --json");
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_EQ(both.out, "");
  EXPECT_EQ(both.err, "--json: the report takes standard output, give the model a file with --out\n");
}

TEST_F(Import, WhatIsWrongIsTheUsersFaultAndWritesNothing) {
  const auto refused = [&](const std::string& arguments) {
    const Outcome outcome = mbgen("import " + arguments);
    EXPECT_EQ(outcome.exit_code, 1) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(leftovers(), std::vector<std::string>{}) << arguments;
    return outcome.err;
  };
  const std::string circle = robot("errors/circle.urdf");
  EXPECT_EQ(refused(circle + " --out robot.json --json").find(circle + ":2:4: no link is the root"), 0u);
  EXPECT_EQ(refused("missing.urdf --out robot.json"), "missing.urdf: cannot read: No such file or directory\n");
  EXPECT_NE(refused(robot("arm.urdf") + " --loops missing.json"), "");
  EXPECT_NE(refused(robot("arm.urdf") + " --base loose"), "");
  EXPECT_NE(refused(""), "");
}

TEST_F(Import, NeverOverwritesTheRobot) {
  write("robot.urdf", "<robot name=\"r\"><link name=\"base\"/></robot>");
  const Outcome outcome = mbgen("import robot.urdf --out robot.urdf");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err, "");
  EXPECT_EQ(read("robot.urdf").find("<robot"), 0u);
}

}  // namespace
}  // namespace mbgen::cli_test
