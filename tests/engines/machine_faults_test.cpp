// Faults of the machine and hands of others: damaged solvers, full places, files that are read, texts that command.

#include <fcntl.h>

#include <chrono>
#include <thread>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShortRun = "simulate pendulum.json --duration 0.1 --step 1e-2 --out o.csv";

class MachineFaults : public CommandLine {
 protected:
  MachineFaults() {
    set("XDG_CACHE_HOME", path("cache").string());
    write("pendulum.json", kPendulum);
  }
  /// The solver that the cache keeps. Requires: one.
  fs::path kept() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(path("cache/mbgen"))) {
      if (entry.path().extension() == ".so") return entry.path();
    }
    ADD_FAILURE() << "nothing is kept";
    return {};
  }
};

TEST_F(MachineFaults, DamagedSolversAreCompiledAgain) {
  ASSERT_EQ(mbgen(kShortRun).exit_code, 0);
  const fs::path solver = kept();
  const auto size = fs::file_size(solver);
  for (const std::uintmax_t left : {std::uintmax_t{0}, std::uintmax_t{100}, size / 2, size - 1}) {
    fs::resize_file(solver, left);
    const Outcome run = mbgen(kShortRun);
    EXPECT_EQ(run.exit_code, 0) << left << run.err;
    EXPECT_EQ(fs::file_size(solver), size) << left;
  }
  std::fstream(solver, std::ios::in | std::ios::out | std::ios::binary).seekp(5000) << "damage";
  EXPECT_EQ(mbgen(kShortRun).exit_code, 0);
  EXPECT_EQ(fs::file_size(solver), size);
}

TEST_F(MachineFaults, ADirectoryInThePlaceOfASolverIsToldAndTheMotionRuns) {
  ASSERT_EQ(mbgen(kShortRun).exit_code, 0);
  const fs::path solver = kept();
  fs::remove(solver);
  fs::create_directories(solver / "inside");
  const Outcome run = mbgen(kShortRun);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find(solver.string() + ": note: the solver is not kept under this name: Is a directory\n"
                                           "  hint: remove what stands there, or name another directory in "
                                           "XDG_CACHE_HOME\n"),
            std::string::npos)
      << run.err;
}

TEST_F(MachineFaults, ACompilerThatWritesNothingIsNone) {
  set("CXX", "/bin/true");
  const Outcome run = mbgen(kShortRun);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "no C++ compiler: `/bin/true` ended well and wrote no code; name another one in CXX\n");
}

TEST_F(MachineFaults, AFullDiskUnderTheCompilerIsTheMachines) {
  write("compiler",
        "#!/bin/sh\n[ \"$1\" = --version ] && exec c++ --version\n"
        "echo 'fatal error: error writing to x.s: No space left on device'; exit 1\n");
  fs::permissions(path("compiler"), fs::perms::owner_all);
  set("CXX", path("compiler").string());
  const Outcome run = mbgen(kShortRun);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err.find("defect of mbgen"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("the compiler was stopped by this machine (exit code 1)"), std::string::npos) << run.err;
}

TEST_F(MachineFaults, DirectoriesOfKilledRunsAreCollected) {
  fs::create_directories(path("cache/mbgen/mbgen-build-abcdef/inside"));
  fs::create_directories(path("cache/mbgen/mbgen-build-newone"));
  fs::permissions(path("cache/mbgen"), fs::perms::owner_all);
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(path("cache/mbgen/mbgen-build-abcdef"), old);
  const fs::path held = path("cache/mbgen/mbgen-build-inwork");
  fs::create_directories(held);
  fs::last_write_time(held, old);
  const Outcome run = shell(fmt::format("flock -n '{}' '{}' {}", held.string(), MBGEN_BINARY, kShortRun));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(fs::exists(path("cache/mbgen/mbgen-build-abcdef")));
  EXPECT_TRUE(fs::exists(path("cache/mbgen/mbgen-build-newone")));
  EXPECT_TRUE(fs::exists(held));
}

TEST_F(MachineFaults, ClosedOutputsEndNothing) {
  const std::string check = fmt::format("'{}' check pendulum.json", MBGEN_BINARY);
  EXPECT_EQ(shell("sh -c \"" + check + " >&- 2>&-; echo \\$?\"").out, "1\n");
  EXPECT_EQ(shell("sh -c \"" + check + " 2>&-; echo \\$?\"").out.find("pendulum.json: ok"), 0u);
  const std::string wrong = fmt::format("'{}' check missing.json", MBGEN_BINARY);
  EXPECT_EQ(shell("sh -c \"" + wrong + " >&- 2>&-; echo \\$?\"").out, "1\n");
}

TEST_F(MachineFaults, NoCommandWritesOverAFileThatItReads) {
  ASSERT_EQ(mbgen("simulate pendulum.json --engine generic --duration 0.1 --step 1e-2 --out k.csv").exit_code, 0);
  const std::string states = R"({"states": [{"z": [0.5], "zd": [0]}]})";
  write("s.json", states);
  const std::string run = read("k.csv.run.json"), rows = read("k.csv");
  const auto refuses = [&](const std::string& command, const std::string& file) {
    const Outcome outcome = mbgen(command);
    EXPECT_EQ(outcome.exit_code, 1) << command;
    EXPECT_TRUE(outcome.err.ends_with(file + ": cannot write: it is read by this command\n")) << command << outcome.err;
  };
  refuses("linearize pendulum.json --states s.json --out s.json", "s.json");
  refuses("linearize pendulum.json --result k.csv --out k.csv", "k.csv");
  refuses("linearize pendulum.json --result k.csv --out k.csv.run.json", "k.csv.run.json");
  refuses("plot k.csv --columns height -o k.csv.run.json", "k.csv.run.json");
  write("q.csv.run.json", kPendulum);
  refuses("simulate q.csv.run.json --engine generic --duration 0.1 --step 1e-2 --out q.csv", "q.csv.run.json");
  EXPECT_EQ(read("s.json"), states);
  EXPECT_EQ(read("k.csv"), rows);
  EXPECT_EQ(read("k.csv.run.json"), run);
  EXPECT_EQ(read("q.csv.run.json"), kPendulum);
}

TEST_F(MachineFaults, LinksToFilesStillToBeWrittenStayLinks) {
  fs::create_directories(path("elsewhere"));
  fs::create_symlink("elsewhere/new.json", path("link.json"));
  ASSERT_EQ(mbgen("equilibrium pendulum.json --out link.json").exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(path("link.json")));
  EXPECT_TRUE(fs::is_regular_file(path("elsewhere/new.json")));
  fs::create_symlink("round.json", path("round.json"));
  EXPECT_EQ(mbgen("equilibrium pendulum.json --out round.json").err,
            "round.json: cannot write: Too many levels of symbolic links\n");
}

TEST_F(MachineFaults, FilesThatAreNoneOfAModelsStayUnread) {
  write("secret", "root:x:0:0:root\n");
  write("model.json", R"({"mbgen": 1, "name": "m", "include": ["secret"]})");
  const Outcome included = mbgen("check model.json");
  EXPECT_EQ(included.exit_code, 1);
  EXPECT_EQ(included.err, "secret:1:1: file is no model, which begins with {\n");
  std::string table(kPendulum);
  table.replace(table.find("\"joint_forces\""), 0,
                R"("joint_springs": { "s": { "joint": "pin", "torque": { "csv": "secret" } } }, )");
  write("table.json", table);
  EXPECT_EQ(mbgen("check table.json").err.find("root"), std::string::npos);
}

TEST_F(MachineFaults, TextsOfModelsCommandNoTerminalAndBreakNoTable) {
  std::string model(kPendulum);
  model.replace(model.find("\"unit\": \"m\""), 11, R"("unit": "m\u001b[31m\n\u202ex\uffff")");
  write("loud.json", model);
  const Outcome run = mbgen("simulate loud.json --engine generic --duration 0.1 --step 1e-2 --out l.csv");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const std::string& text :
       {run.out, run.err, mbgen("inspect loud.json").out, mbgen("check loud.json --json").out,
        mbgen("simulate loud.json --engine generic --duration 0.1 --step 1e-2 --json --out m.csv").out}) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
    EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos) << text;
  }
  EXPECT_EQ(mbgen("plot l.csv --columns height -o l.svg").exit_code, 0);
  EXPECT_EQ(read("l.svg").find("\xEF\xBF\xBF"), std::string::npos);
  EXPECT_EQ(read("l.svg").find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
