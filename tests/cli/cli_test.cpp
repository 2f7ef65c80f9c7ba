// Commands that ask a model without running it: help, exit codes, check, inspect, generate, dumps, schema.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

using Names = std::vector<std::string>;

const char* const kCommands[] = {"check", "inspect", "generate", "simulate", "evaluate", "bench", "schema"};

TEST_F(CommandLine, EveryCommandExplainsItselfWithAnExample) {
  for (const char* command : kCommands) {
    const Outcome run = mbgen(fmt::format("{} --help", command));
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_NE(run.out.find(fmt::format("Example: mbgen {}", command)), std::string::npos) << run.out;
    EXPECT_EQ(run.err, "") << command;
  }
  const Outcome run = mbgen("--help");
  EXPECT_EQ(run.exit_code, 0);
  for (const char* command : kCommands) EXPECT_NE(run.out.find(command), std::string::npos) << command;
}

TEST_F(CommandLine, UnknownWordsAreTheUsersFault) {
  for (const char* arguments : {"", "frobnicate", "check", "check --nonsense x.json", "simulate x.json"}) {
    const Outcome run = mbgen(arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err, "") << arguments;
  }
}

TEST_F(CommandLine, CheckSaysOkAndWhatTheModelHas) {
  write("pendulum.json", kPendulum);
  const Outcome run = mbgen("check pendulum.json");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "pendulum.json: ok\n  bodies 1, freedoms 1, of them driven 0, notes 0\n");
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(json_of("check pendulum.json --json"), Json({{"model", "pendulum.json"},
                                                         {"ok", true},
                                                         {"bodies", 1},
                                                         {"freedoms", 1},
                                                         {"driven", 0},
                                                         {"problems", Json::array()},
                                                         {"notes", Json::array()}}));
}

TEST_F(CommandLine, CheckAndExplainSayWhatOfATyreFileIsNotUsed) {
  write("tyre.tir",
        "PROPERTY_FILE_FORMAT = 'PAC2002'\nUNLOADED_RADIUS = 0.5\nFNOMIN = 4e3\nPECP1 = 1\n"
        "PCX1 = 1.6\nPDX1 = 1\nPKX1 = 20\nPCY1 = 1.3\nPDY1 = 0.9\nPKY1 = -15\nPKY2 = 2\n"
        "RBX1 = 12\nRCX1 = 1\nRBY1 = 10\nRCY1 = 1\n");
  write("wheel.json", R"({ "mbgen": 1, "bodies": { "ground": { "points": { "c": [0, 0, 0.5] } },
      "wheel": { "mass": 1, "inertia": [1, 1, 1], "points": { "c": [0, 0, 0.5] } } },
    "joints": { "wheel": { "type": "free", "from": "ground.c", "to": "wheel.c" } },
    "tyres": { "tyre": { "centre": "wheel.c", "tir": "tyre.tir", "stiffness": 1e5 } } })");
  const std::string said = "the model does not use turn slip (PECP1)";
  const Outcome run = mbgen("check wheel.json");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "wheel.json: ok\n  bodies 1, freedoms 6, of them driven 0, notes 1\n");
  EXPECT_EQ(run.err, "tyre.tir:4:1: note: " + said + "\n");
  const Json report = json_of("check wheel.json --json");
  EXPECT_TRUE(report["ok"]);
  EXPECT_TRUE(report["problems"].empty());
  EXPECT_EQ(report["notes"], Json::array({{{"file", "tyre.tir"},
                                           {"line", 4},
                                           {"column", 1},
                                           {"length", 5},
                                           {"pointer", ""},
                                           {"message", said},
                                           {"hint", ""}}}));
  EXPECT_NE(mbgen("explain wheel.json").out.find("\nNotes\n-----\ntyre.tir:4:1: note: " + said + "\n"),
            std::string::npos);
}

TEST_F(CommandLine, CheckReportsEveryProblemWithItsPlace) {
  std::string text = kPendulum;
  text.replace(text.find("\"mass\": 3"), 9, "\"mass\": -3");
  text.replace(text.find("bob.O"), 5, "bob.P");
  write("bad.json", text);
  const Outcome run = mbgen("check bad.json");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("bad.json:6:"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("bad.json:8:"), std::string::npos) << run.err;

  const Outcome machine = mbgen("check bad.json --json");
  EXPECT_EQ(machine.exit_code, 1);
  const Json report = Json::parse(machine.out);
  EXPECT_FALSE(report["ok"]);
  ASSERT_EQ(report["problems"].size(), 2u);
  EXPECT_EQ(report["problems"][0]["line"], 6);
  EXPECT_EQ(report["problems"][0]["pointer"], "/bodies/bob/mass");
}

TEST_F(CommandLine, BadFilesAreTheUsersFaultForEveryCommand) {
  write("empty.json", "");
  write("broken.json", "{ \"mbgen\": 1,");
  for (const char* file : {"missing.json", "empty.json", "broken.json", "."}) {
    for (const char* command : {"check {}", "inspect {} --json", "generate {} --out d", "simulate {} --out o.csv",
                                "evaluate {} --states s.json", "bench {}", "inspect {} --dump=code"}) {
      const Outcome run = mbgen(fmt::format(fmt::runtime(command), file));
      EXPECT_EQ(run.exit_code, 1) << command << " " << file << "\n" << run.err;
      EXPECT_EQ(run.out, "") << command << " " << file;
      EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
    }
  }
  EXPECT_EQ(leftovers(), (Names{"broken.json", "empty.json"}));
}

TEST_F(CommandLine, InspectCountsAPendulum) {
  write("pendulum.json", kPendulum);
  const Json report = json_of("inspect pendulum.json --json");
  EXPECT_EQ(report["name"], "pendulum");
  EXPECT_EQ(report["bodies"], 2);
  EXPECT_EQ(report["massless_bodies"], 0);
  EXPECT_EQ(report["joints"], 1);
  EXPECT_EQ(report["cut_joints"], 0);
  EXPECT_EQ(report["relative_coordinates"], 1);
  EXPECT_EQ(report["constraint_equations"], 0);
  EXPECT_EQ(report["degrees_of_freedom"], 1);
  EXPECT_EQ(report["loop_blocks"].size(), 0u);
  EXPECT_EQ(report["path_matrix"], Json({{1}}));
}

TEST_F(CommandLine, InspectFindsTheRedundancyOfAFourBar) {
  write("four_bar.json", kFourBar);
  const Json report = json_of("inspect four_bar.json --json");
  EXPECT_EQ(report["bodies"], 4);
  EXPECT_EQ(report["joints"], 4);
  EXPECT_EQ(report["tree_joints"], 3);
  EXPECT_EQ(report["cut_joints"], 1);
  EXPECT_EQ(report["cut_joint_names"][0]["name"], "tip");
  EXPECT_EQ(report["rods"], 0);
  EXPECT_EQ(report["constraint_equations"], 5);
  EXPECT_EQ(report["independent_equations"], 2);
  EXPECT_EQ(report["degrees_of_freedom"], 1);
  ASSERT_EQ(report["loop_blocks"].size(), 1u);
  const Json& block = report["loop_blocks"][0];
  EXPECT_EQ(block["joints"], 3);
  EXPECT_EQ(block["equations"], 5);
  EXPECT_EQ(block["rank"], 2);
  EXPECT_EQ(block["dependent"].size(), 2u);
  EXPECT_EQ(block["independent"].size(), 1u);
  EXPECT_EQ(block["redundant"].size(), 3u);
  const Json& certificate = block["certificate"];
  EXPECT_EQ(certificate["closed_configurations"], 25);
  EXPECT_EQ(certificate["ranks"], Json::parse(R"([{"rank": 2, "configurations": 25}])"));
  EXPECT_EQ(certificate["degrees_of_freedom"], 1);
  EXPECT_EQ(certificate["redundant"].size(), 3u);
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_EQ(certificate["redundant"][e]["name"], block["redundant"][e]);
    EXPECT_EQ(certificate["redundant"][e]["joint"], "tip");
    EXPECT_LT(certificate["redundant"][e]["residual"].get<double>(), 1e-12);
  }
  int ones = 0;
  for (const Json& row : report["path_matrix"]) {
    for (const Json& entry : row) ones += entry.get<int>();
  }
  EXPECT_EQ(ones, 4);  // crank, crank and coupler, rocker
  long total = 0;
  const Json& counted = report["operations"]["accelerations"];
  for (const Json& section : counted["sections"]) total += section["total"].get<long>();
  EXPECT_EQ(total, counted["total"]["total"].get<long>());
  EXPECT_GT(total, 0);
}

TEST_F(CommandLine, InspectPrintsTables) {
  write("four_bar.json", kFourBar);
  const Outcome run = mbgen("inspect four_bar.json");
  EXPECT_EQ(run.exit_code, 0);
  for (const char* part :
       {"bodies, with ground                  4", "crank_pin", "Loop blocks", "Path matrix",
        "1: 5 equations, rank 2 in 25 of 25 closed configurations, 1 degree of freedom", "axis tilt about"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
  }
}

TEST_F(CommandLine, DumpsEveryStageAndNothingElse) {
  write("four_bar.json", kFourBar);
  const std::map<std::string, std::string> marks = {{"model", "coupler"},        {"topology", "loop blocks"},
                                                    {"analysis", "rank 2 of 5"}, {"program", "input z[0]"},
                                                    {"optimised", "input z[0]"}, {"code", "namespace four_bar"}};
  for (const auto& [stage, mark] : marks) {
    const Outcome run = mbgen(fmt::format("generate four_bar.json --dump={}", stage));
    EXPECT_EQ(run.exit_code, 0) << stage << run.err;
    EXPECT_NE(run.out.find(mark), std::string::npos) << stage;
    EXPECT_EQ(mbgen(fmt::format("inspect four_bar.json --dump={}", stage)).out, run.out);
  }
  ASSERT_EQ(mbgen("generate four_bar.json --out made --no-runtime").exit_code, 0);
  EXPECT_NE(mbgen("inspect four_bar.json --dump=code").out.find(read("made/four_bar.cpp")), std::string::npos);
  // The dump equals the generated code, in the form and for the instances that are asked for.
  ASSERT_EQ(mbgen("generate four_bar.json --out made --no-runtime --form matrix --batch 4").exit_code, 0);
  const std::string code = mbgen("generate four_bar.json --dump=code --form matrix --batch 4").out;
  EXPECT_NE(code.find(read("made/four_bar.cpp")), std::string::npos);
  EXPECT_NE(code.find(read("made/four_bar_batch.cpp")), std::string::npos);
  const std::string passes = mbgen("inspect four_bar.json --dump=passes").out;
  for (const char* stage : {"topology", "derived-constants", "contraction"})
    EXPECT_NE(passes.find(stage), std::string::npos) << passes;
  std::filesystem::remove_all(path("made"));
  const Outcome run = mbgen("check four_bar.json --dump=everything");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(
      run.err.find("model, topology, analysis, program, dead-values, equal-values, shorter-forms, divisions, pairs, "
                   "sums, optimised, equal-sums, shorter-sums, pairs-kept, derived-constants, contraction, code, "
                   "passes"),
      std::string::npos)
      << run.err;
  EXPECT_EQ(leftovers(), Names{"four_bar.json"});
}

// Savings of passes are of one spelling of the accelerations: laws that go into functions of their own save nothing.
TEST_F(CommandLine, SavingsOfPassesLeadToTheOperations) {
  const Json report = json_of("inspect '" + kSource + "/models/coach.json' --json");
  Json last;
  for (const Json& saving : report["savings"]) {
    if (!saving["treatment"].get<std::string>().starts_with("pass ")) continue;
    if (!last.is_null()) {
      EXPECT_EQ(saving["without"], last["with"]) << saving;
    }
    last = saving;
  }
  ASSERT_FALSE(last.is_null());
  EXPECT_EQ(last["with"], report["operations"]["accelerations"]["total"]["total"]);
}

TEST_F(CommandLine, GenerateWritesTheSolverAndListsItsFiles) {
  write("four_bar.json", kFourBar);
  const Json report = json_of("generate four_bar.json --out made/here --json");
  EXPECT_EQ(report["model"], "four_bar");
  for (const Json& file : report["files"]) {
    EXPECT_TRUE(std::filesystem::exists(path(file.get<std::string>()))) << file;
  }
  for (const char* file :
       {"four_bar.hpp", "four_bar.cpp", "four_bar.json", "four_bar_cost.txt", "CMakeLists.txt", "mbgen/solver.hpp"}) {
    EXPECT_TRUE(std::filesystem::exists(path("made/here") / file)) << file;
  }
  const Outcome bare = mbgen("generate four_bar.json --out bare --no-runtime");
  EXPECT_EQ(bare.exit_code, 0) << bare.err;
  EXPECT_EQ(std::count(bare.out.begin(), bare.out.end(), '\n'), 5) << bare.out;
  EXPECT_FALSE(std::filesystem::exists(path("bare/mbgen")));
  EXPECT_EQ(read("bare/four_bar.cpp"), read("made/here/four_bar.cpp"));
}

TEST_F(CommandLine, GenerateTakesAnotherName) {
  write("four_bar.json", kFourBar);
  ASSERT_EQ(mbgen("generate four_bar.json --name left --no-runtime --out made").exit_code, 0);
  EXPECT_NE(read("made/left.hpp").find("namespace left {"), std::string::npos);
  EXPECT_NE(read("made/left.cpp").find("#include \"left.hpp\""), std::string::npos);
  for (const auto& [name, possible] : std::map<std::string, std::string>{
           {"double", "double_"}, {"front-axle", "front_axle"}, {"../up", "up"}, {"2nd", "n_2nd"}}) {
    const Outcome run = mbgen(fmt::format("generate four_bar.json --name {} --out other", name));
    EXPECT_EQ(run.exit_code, 1) << name;
    EXPECT_EQ(run.err,
              fmt::format("--name: \"{}\" cannot name files and a C++ namespace; \"{}\" can\n", name, possible));
  }
  EXPECT_EQ(leftovers(), (Names{"four_bar.json", "made"}));
}

TEST_F(CommandLine, GenerateTellsBuildToolsWhatItRead) {
  std::filesystem::create_directory(path("parts"));
  write("parts/linkage.json", kFourBar);
  write("a #1 $.json", R"({ "mbgen": 1, "name": "top", "include": ["parts/linkage.json"] })");
  ASSERT_EQ(mbgen("generate 'a #1 $.json' --no-runtime --out 'made here' --depfile rule.d").exit_code, 0);
  EXPECT_EQ(read("rule.d"), "made\\ here/top.json: \\\n  a\\ \\#1\\ $$.json \\\n  parts/linkage.json\n");
  const Outcome lost = mbgen("generate parts/linkage.json --no-runtime --out other --depfile missing/rule.d");
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_NE(lost.err.find("missing/rule.d"), std::string::npos) << lost.err;
  EXPECT_EQ(leftovers(), (Names{"a #1 $.json", "made here", "parts", "rule.d"}));
}

TEST_F(CommandLine, GenerateLeavesNothingWhereItCannotWrite) {
  write("four_bar.json", kFourBar);
  write("file", "");
  std::filesystem::create_directories(path("taken/four_bar.cpp"));  // a directory where a file has to go
  for (const char* directory : {"file", "file/deeper", "taken"}) {
    const Outcome run = mbgen(fmt::format("generate four_bar.json --out {}", directory));
    EXPECT_EQ(run.exit_code, 1) << directory;
    EXPECT_EQ(run.out, "") << directory;
    EXPECT_NE(run.err.find(directory), std::string::npos) << run.err;
  }
  EXPECT_EQ(mbgen("generate four_bar.json").exit_code, 1);
  EXPECT_EQ(leftovers(), (Names{"file", "four_bar.json", "taken"}));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path("taken"))) {
    EXPECT_TRUE(entry.is_directory()) << entry.path();
  }
}

TEST_F(CommandLine, SchemaIsJson) {
  const Json schema = json_of("schema");
  ASSERT_TRUE(schema.is_object());
  EXPECT_TRUE(schema.contains("$schema"));
  EXPECT_TRUE(schema["properties"].contains("joints"));
}

TEST_F(CommandLine, FullStandardOutputIsReported) {
  write("pendulum.json", kPendulum);
  const Outcome run = mbgen("inspect pendulum.json --json", "/dev/full");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("standard output: cannot write"), std::string::npos) << run.err;
}

TEST_F(CommandLine, CoachMechanismHasTheCountsOfThePaper) {
  const std::string model = std::string(MBGEN_SOURCE_DIR) + "/models/coach_mechanism.json";
  const Json report = json_of(fmt::format("inspect '{}' --json", model));
  const std::map<std::string, int> counts = {{"bodies", 33},
                                             {"massless_bodies", 14},
                                             {"joints", 34},
                                             {"relative_coordinates", 32},
                                             {"constraint_equations", 17},
                                             {"rods", 11},
                                             {"degrees_of_freedom", 15}};
  for (const auto& [key, count] : counts) EXPECT_EQ(report[key], count) << key;
  ASSERT_EQ(report["loop_blocks"].size(), 2u);
  EXPECT_EQ(report["loop_blocks"][0]["joints"], 14);
  EXPECT_EQ(report["loop_blocks"][0]["equations"], 11);
  EXPECT_EQ(report["loop_blocks"][1]["joints"], 8);
  EXPECT_EQ(report["loop_blocks"][1]["equations"], 6);
}

}  // namespace
}  // namespace mbgen::cli_test
