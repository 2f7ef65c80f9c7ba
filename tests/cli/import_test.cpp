// mbgen import: its output for people and for machines, and its exit codes. Imported robots: tests/import.
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

constexpr const char* kTurntable = R"(<robot name="table">
  <link name="base"/>
  <link name="plate"><inertial><mass value="0.6"/><inertia ixx="0.1" iyy="0.1" izz="0.2" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="slide"><inertial><mass value="0.7"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="plate"/><origin xyz="0.1 0.2 0.3"/><axis xyz="0 0 1"/>
    <limit lower="-0.6" upper="0.7" effort="1" velocity="1"/></joint>
  <joint name="way" type="prismatic"><parent link="base"/><child link="slide"/><origin xyz="0.6 0 0"/><axis xyz="1 0 0"/>
    <limit lower="-0.1" upper="0.3" effort="1" velocity="1"/></joint>
</robot>)";

// Ranges become stops: at 0.1 beyond the range the stop pushes back by its stiffness.
TEST_F(Import, StopsHoldTheRanges) {
  write("table.urdf", kTurntable);
  const Outcome run = mbgen("import table.urdf --stops 5000 --out table.json");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err,
            "table.urdf:2:4: note: root link \"base\" is fixed to the ground\n"
            "  hint: --base floating lets it move\n"
            "table.urdf:6:6: note: <limit> (2 of them) not carried over: ranges of joints become stops, efforts and "
            "velocities stand beside the joints as comments\n");
  write("states.json", R"({ "joint_order": ["turn", "way"], "states": [
    { "z": [0.8, 0.35], "zd": [0, 0] }, { "z": [-0.7, -0.15], "zd": [0, 0] }, { "z": [0.65, 0.25], "zd": [0, 0] } ] })");
  const Json states = json_of("evaluate table.json --states states.json --engine generic")["states"];
  const double expected[][2] = {{-5000 * 0.1 / 0.2, -5000 * 0.05 / 0.7}, {2500, 5000 * 0.05 / 0.7}, {0, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(states[i]["zdd"][k].get<double>(), expected[i][k], 1e-9) << i << " " << k;
  }
  EXPECT_EQ(mbgen("import table.urdf --stops -5 --out o.json").err,
            "--stops: a stiffness above zero, in N m/rad and N/m\n");
  EXPECT_EQ(mbgen("import table.urdf --stops stiff --out o.json").err,
            "--stops: must be a number without a unit, found \"stiff\"\nRun with --help for more information.\n");
  EXPECT_FALSE(std::filesystem::exists(path("o.json")));
}

TEST_F(Import, NumbersStayAsTyped) {
  write("table.urdf", kTurntable);
  const std::string text = mbgen("import table.urdf --stops 5000").out;
  for (const char* part :
       {"\"turn\": [0.1, 0.2, 0.3]", "\"mass\": 0.6, \"inertia\": [0.1, 0.1, 0.2]", "\"way\": [0.6, 0, 0]",
        "\"turn_lower\": { \"joint\": \"turn\", \"side\": \"below\", \"clearance\": 0.6, \"stiffness\": 5000 }",
        "\"way_upper\": { \"joint\": \"way\", \"side\": \"above\", \"clearance\": 0.3, \"stiffness\": 5000 }",
        "// limits -0.6 .. 0.7 rad, effort 1 N m, velocity 1 rad/s"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  // 0.1 + 0.5 of two frames is 0.6, and no sum of binary fractions.
  write("chain.xml", R"(<mujoco model="chain"><worldbody>
    <body name="a" pos="0.1 0 0"><joint name="j" type="hinge" axis="0 0 1"/><inertial pos="0 0 0" mass="0.3" diaginertia="0.1 0.1 0.1"/>
      <body name="b" pos="0.5 0 0.2"><joint name="k" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="0.3" diaginertia="0.1 0.1 0.1"/>
    </body></body></worldbody></mujoco>)");
  const std::string chain = mbgen("import chain.xml").out;
  EXPECT_NE(chain.find("\"origin\": [0.6, 0, 0.2]"), std::string::npos) << chain;
  EXPECT_EQ(chain.find("0000000"), std::string::npos) << chain;
  EXPECT_EQ(chain.find("9999999"), std::string::npos) << chain;
}

// A tendon of length 0.5 q with a spring of 40 N/m that is slack from 0.1 to 0.3, on a hinge of 0.2 kg m^2.
TEST_F(Import, ATendonIsSlackWithinItsDeadBand) {
  write("tendon.xml", R"(<mujoco model="tendon"><compiler angle="radian"/><worldbody>
    <body name="a"><joint name="q" type="hinge" axis="0 0 1"/><inertial pos="0 0 0" mass="1" diaginertia="0.1 0.2 0.2"/></body>
  </worldbody><tendon><fixed name="cable" stiffness="40" springlength="0.1 0.3"><joint joint="q" coef="0.5"/></fixed>
  </tendon></mujoco>)");
  const Outcome run = mbgen("import tendon.xml --out tendon.json");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  write("states.json", R"({ "joint_order": ["q"], "states": [
    { "z": [1], "zd": [0] }, { "z": [0.4], "zd": [0] }, { "z": [-0.4], "zd": [0] } ] })");
  const Json states = json_of("evaluate tendon.json --states states.json --engine generic")["states"];
  const double expected[] = {-0.5 * 40 * 0.2 / 0.2, 0, 0.5 * 40 * 0.3 / 0.2};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(states[i]["zdd"][0].get<double>(), expected[i], 1e-12) << i;
}

// Elements of one kind are one note, at the first of them.
TEST_F(Import, NotesOfOneKindAreOne) {
  std::string bodies;
  for (int i = 0; i < 40; ++i)
    bodies += fmt::format(
        "<body name=\"b{0}\" pos=\"{0} 0 0\"><joint name=\"j{0}\" type=\"hinge\" axis=\"0 0 1\" margin=\"0.1\"/>"
        "<geom type=\"sphere\" size=\"0.1\" rgba=\"1 0 0 1\" friction=\"1 0 0\"/></body>\n",
        i);
  write("many.xml", "<mujoco model=\"many\"><worldbody>\n" + bodies + "</worldbody></mujoco>");
  const Outcome run = mbgen("import many.xml --out many.json");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LE(lines_with(run.err, ": note: "), 3) << run.err;
  EXPECT_NE(run.err.find("many.xml:2:"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("<geom> (40 of them): only its mass is carried over, there is no contact\n"),
            std::string::npos)
      << run.err;
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
