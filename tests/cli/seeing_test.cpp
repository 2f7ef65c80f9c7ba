// Results and pictures on the command line: formats, plots, drawings, and what is said when something is wrong.

#include <regex>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Seeing : public CommandLine {
 protected:
  Seeing() {
    write("swing.json", R"({ "mbgen": 1, "name": "swing",
      "bodies": { "ground": { "points": { "pin": [0, 0, 0] } },
                  "rod": { "mass": 1, "com": [0, 0, -0.5], "inertia": [0.1, 0.1, 0],
                           "points": { "pin": [0, 0, 0], "tip": [0, 0, -1] } } },
      "joints": { "hinge": { "type": "revolute", "from": "ground.pin", "to": "rod.pin", "axis": "y" } },
      "outputs": { "tip_x": { "unit": "m", "point": "rod.tip", "quantity": "position", "axis": "x" },
                   "tip_z": { "unit": "m", "point": "rod.tip", "quantity": "position", "axis": "z" } },
      "initial": { "positions": { "hinge": 0.4 } } })");
  }
  /// Half a second of the swing, by the engine that needs no compiler.
  Outcome swing(const std::string& arguments) {
    return mbgen("simulate swing.json --engine generic --duration 0.5 --step 0.01 " + arguments);
  }
  /// Message of a command that must fail by the user's fault.
  std::string refusal(const std::string& command) {
    const Outcome outcome = mbgen(command);
    EXPECT_EQ(outcome.exit_code, 1) << command;
    EXPECT_EQ(outcome.out, "") << command;
    return outcome.err;
  }
};

TEST_F(Seeing, TheFileBesideATableSaysWhichRunItIs) {
  ASSERT_EQ(swing("--out swing.csv").exit_code, 0);
  const Json beside = Json::parse(read("swing.csv.run.json"));
  EXPECT_EQ(beside["mbgen_run"], 1);
  EXPECT_EQ(beside["model_file"], "swing.json");
  EXPECT_EQ(beside["rows"], 51);
  EXPECT_EQ(beside["integrator"], "rk4");
  const std::string first = read("swing.csv.run.json");
  ASSERT_EQ(swing("--out swing.csv").exit_code, 0);
  EXPECT_EQ(read("swing.csv.run.json"), first) << "nothing of when it ran";
  ASSERT_EQ(mbgen("simulate swing.json --engine generic --duration 0.5 --out /dev/null").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists("/dev/null.run.json"));
}

TEST_F(Seeing, TheModelIsFoundFromTheTablesDirectory) {
  std::filesystem::create_directory(path("results"));
  ASSERT_EQ(swing("--out results/swing.csv").exit_code, 0);
  EXPECT_EQ(Json::parse(read("results/swing.csv.run.json"))["model_file"], "../swing.json");
}

TEST_F(Seeing, FormatsAreCsvAndMat) {
  EXPECT_EQ(refusal("simulate swing.json --engine generic --out swing.csv --format xls"),
            "--format: no format \"xls\"; there are: csv, mat\n");
  EXPECT_FALSE(std::filesystem::exists(path("swing.csv")));
}

TEST_F(Seeing, PlotsHaveAPanelForEachUnit) {
  ASSERT_EQ(swing("--out swing.csv").exit_code, 0);
  const auto frames = [&](const std::string& arguments) {
    const Outcome plot = mbgen("plot swing.csv " + arguments);
    EXPECT_EQ(plot.exit_code, 0) << plot.err;
    const std::regex frame("<rect class=\"frame\"");
    return std::distance(std::sregex_iterator(plot.out.begin(), plot.out.end(), frame), std::sregex_iterator());
  };
  EXPECT_EQ(frames("--columns tip_x,tip_z"), 1);
  EXPECT_EQ(frames("--columns 'tip_*,z.hinge'"), 2);
  EXPECT_EQ(frames("--columns tip_x --columns tip_z --columns 'zd.hinge [rad/s]'"), 3);
  EXPECT_NE(mbgen("plot swing.csv --columns z.hinge --degrees").out.find(">deg</text>"), std::string::npos);
}

TEST_F(Seeing, PlotsAreOverAnyColumnAndOfSeveralTables) {
  const auto curves = [&](const std::string& arguments) {
    const Outcome plot = mbgen("plot " + arguments);
    EXPECT_EQ(plot.exit_code, 0) << plot.err;
    const std::regex curve("class=\"curve\"");
    return std::distance(std::sregex_iterator(plot.out.begin(), plot.out.end(), curve), std::sregex_iterator());
  };
  ASSERT_EQ(swing("--out swing.csv").exit_code, 0);
  ASSERT_EQ(swing("--out again.csv").exit_code, 0);
  EXPECT_EQ(curves("swing.csv again.csv --columns tip_x,tip_z"), 4);
  EXPECT_NE(mbgen("plot swing.csv again.csv --columns tip_x").out.find(">tip_x (again.csv)</text>"), std::string::npos);
  EXPECT_NE(mbgen("plot swing.csv --columns tip_z --over tip_x").out.find(">tip_x, m</text>"), std::string::npos);
  write("study.csv",
        "case,stiffness [N/m],mass [kg],lean,status\n1,50,1,100,ok\n2,50,2,,\"study: a, "
        "b\"\n3,100,1,90,ok\n4,100,2,80,ok\n");
  EXPECT_EQ(curves("study.csv --columns lean"), 1);
  EXPECT_EQ(curves("study.csv --columns lean --over stiffness --by mass"), 2);
  const Outcome study = mbgen("plot study.csv --columns lean --over stiffness --by mass");
  EXPECT_NE(study.out.find(">stiffness, N/m</text>"), std::string::npos) << study.out;
  EXPECT_NE(study.out.find(">lean, mass = 2</text>"), std::string::npos) << study.out;
  EXPECT_EQ(refusal("plot swing.csv study.csv --columns lean"),
            "--over: swing.csv is over t [s], study.csv over case; name a column that both have\n");
  EXPECT_EQ(refusal("plot swing.csv --columns tip_z --over tip"),
            "--over: swing.csv has no column \"tip\"; did you mean \"tip_x\" or \"tip_z\"?\n");
  write("broken.csv", "case,a,status\n1,two,ok\n");
  EXPECT_EQ(refusal("plot broken.csv --columns a"),
            "broken.csv:2:1: a: must be a finite number or empty, found \"two\"\n");
}

TEST_F(Seeing, WhatPlotCannotDoItSays) {
  ASSERT_EQ(swing("--out swing.csv").exit_code, 0);
  EXPECT_EQ(refusal("plot swing.csv --columns tip_y"),
            "--columns: swing.csv has no column \"tip_y\"; did you mean \"tip_x\"?\n");
  EXPECT_EQ(refusal("plot swing.csv --columns 'load*'"),
            "--columns: swing.csv has no column \"load*\"; known: z.hinge, zd.hinge, tip_x, tip_z, residual\n");
  EXPECT_EQ(refusal("plot swing.csv --columns tip_x -o ./swing.csv"),
            "./swing.csv: cannot write: it is read by this command\n");
  EXPECT_EQ(refusal("plot none.csv --columns a"), "none.csv: cannot read: No such file or directory\n");
  write("broken.csv", "t [s],a [m]\n0,1\n1,two\n");
  EXPECT_EQ(refusal("plot broken.csv --columns a"), "broken.csv:3:1: a: must be a finite number, found \"two\"\n");
}

TEST_F(Seeing, TheTopologyIsDrawnIntoAFileOrPrinted) {
  const Outcome printed = mbgen("inspect swing.json --svg -");
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_TRUE(printed.out.starts_with("<svg xmlns")) << printed.out.substr(0, 80);
  const Outcome written = mbgen("inspect swing.json --svg swing.svg");
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(read("swing.svg"), printed.out);
  EXPECT_EQ(refusal("inspect swing.json --svg swing.json"), "swing.json: cannot write: it is read by this command\n");
}

TEST_F(Seeing, AReportKnowsItsModel) {
  ASSERT_EQ(swing("--out swing.csv").exit_code, 0);
  const Outcome page = mbgen("report swing.csv -o swing.html");
  if (page.err.find("built without reports") != std::string::npos) GTEST_SKIP() << page.err;
  ASSERT_EQ(page.exit_code, 0) << page.err;
  EXPECT_EQ(page.out, "");
  EXPECT_NE(read("swing.html").find("<title>swing</title>"), std::string::npos);
  EXPECT_EQ(mbgen("report swing.csv -o -").out, read("swing.html"));

  write("swing.json", read("swing.json") + "// another model now\n");
  EXPECT_EQ(refusal("report swing.csv -o other.html"),
            "swing.json: changed since swing.csv was written; simulate again, or give --model to take it as it is\n");
  EXPECT_EQ(mbgen("report swing.csv --model swing.json -o other.html").exit_code, 0);

  const std::string table = read("swing.csv");
  write("swing.csv", table.substr(0, table.rfind('\n', table.size() - 2) + 1));
  EXPECT_EQ(refusal("report swing.csv -o other.html"),
            "swing.csv.run.json: of another table, with 51 rows instead of 50; simulate again or give --model\n");
  write("swing.csv.run.json", "{}");
  EXPECT_EQ(refusal("report swing.csv -o other.html"),
            "swing.csv.run.json: no description of a run by mbgen simulate; give --model\n");
  std::filesystem::remove(path("swing.csv.run.json"));
  EXPECT_EQ(refusal("report swing.csv -o other.html"),
            "swing.csv: nothing says which model this is of, swing.csv.run.json is missing; give --model\n");
  write("other.csv", "t [s],z.wrist [rad]\n0,1\n");
  EXPECT_EQ(refusal("report other.csv --model swing.json -o other.html"),
            "other.csv: no column \"z.hinge\": not a result of model swing\n"
            "  hint: give --model, or simulate again\n");
}

TEST_F(Seeing, AReportOfSeveralResultsHasAllOfThem) {
  ASSERT_EQ(swing("--out a.csv").exit_code, 0);
  ASSERT_EQ(swing("--out b.csv").exit_code, 0);
  const Outcome page = mbgen("report a.csv b.csv -o both.html");
  if (page.err.find("built without reports") != std::string::npos) GTEST_SKIP() << page.err;
  ASSERT_EQ(page.exit_code, 0) << page.err;
  const std::string both = read("both.html");
  EXPECT_NE(both.find(R"("label":"a.csv","others":[{"label":"b.csv","run":{"mbgen_run":1,)"), std::string::npos);
  EXPECT_NE(both.find(R"x("name":"z.hinge (b.csv)")x"), std::string::npos);
  EXPECT_EQ(refusal("report a.csv b.csv -o b.csv"), "b.csv: cannot write: it is read by this command\n");
  EXPECT_EQ(refusal("report a.csv a.csv a.csv a.csv a.csv a.csv a.csv a.csv a.csv -o nine.html"),
            "report: 9 results, a page shows at most 8; mbgen plot draws the curves of more\n");
  write("other.csv", "t [s],z.wrist [rad]\n0,1\n");
  EXPECT_EQ(refusal("report a.csv other.csv --model swing.json -o other.html"),
            "other.csv: no column \"z.hinge\": not a result of model swing\n"
            "  hint: give --model, or simulate again\n");
}

// 1 kg on 40 N/m: 1/40 m/N at rest, which the first point at 1 mHz has but for 1e-6 of it.
TEST_F(Seeing, APageOfModesHasTheFrequencyResponses) {
  write("mass.json", R"({ "mbgen": 1, "name": "mass", "gravity": [0, 0, 0], "inputs": { "force": { "unit": "N" } },
    "bodies": { "ground": { "points": { "o": [0, 0, 0], "top": [0, 0, 1] } },
      "mass": { "mass": 1, "inertia": [1, 1, 1], "points": { "o": [0, 0, 0] } } },
    "joints": { "z": { "type": "prismatic", "from": "ground.o", "to": "mass.o", "axis": "z" } },
    "springs": { "s": { "from": "ground.top", "to": "mass.o", "stiffness": 40, "damping": 0.4 } },
    "forces": { "f": { "at": "mass.o", "force": [0, 0, "force"] } },
    "outputs": { "z": { "joint": "z" }, "v": { "joint": "z", "quantity": "velocity" } } })");
  const Outcome page =
      mbgen("linearize mass.json --bode force:z --bode force:v --frequencies 0.001:10:50 --report m.html");
  if (page.err.find("built without reports") != std::string::npos) GTEST_SKIP() << page.err;
  ASSERT_EQ(page.exit_code, 0) << page.err;
  const std::string text = read("m.html");
  const std::size_t data = text.find('>', text.find("<script id=\"data\"")) + 1;
  const Json diagrams = Json::parse(text.substr(data, text.find("</script>", data) - data))["responses"];
  ASSERT_EQ(diagrams.size(), 3u) << "magnitudes by their units, then phases";
  EXPECT_EQ(diagrams[0]["title"], "Magnitude of z/force");
  EXPECT_EQ(diagrams[0]["y"]["unit"], "m/N");
  EXPECT_EQ(diagrams[0]["logarithmic"], "xy");
  EXPECT_NEAR(diagrams[0]["curves"][0]["y"][0].get<double>(), 1.0 / 40, 1e-7);
  EXPECT_EQ(diagrams[1]["y"]["unit"], "(m/s)/N");
  EXPECT_EQ(diagrams[2]["title"], "Phase");
  EXPECT_EQ(diagrams[2]["logarithmic"], "x");
  EXPECT_NEAR(diagrams[2]["curves"][1]["y"][0].get<double>(), 90, 0.1) << "the velocity leads by a quarter";
  ASSERT_EQ(mbgen("linearize mass.json --report plain.html").exit_code, 0);
  EXPECT_EQ(read("plain.html").find("\"responses\":["), std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
