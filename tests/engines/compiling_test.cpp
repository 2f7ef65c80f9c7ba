// The compilation of a solver: what a terminal shows of it, what becomes of one that fails or is interrupted.

#include <chrono>
#include <set>
#include <thread>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRun = "simulate pendulum.json --duration 0.1 --step 1e-2 --out o.csv";

class Compiling : public CommandLine {
 protected:
  /// A compiler that tells its version and then does as the script says.
  void use_compiler(const std::string& script) {
    write("pendulum.json", kPendulum);
    write("compiler", "#!/bin/sh\n[ \"$1\" = --version ] && exec c++ --version\n" + script);
    fs::permissions(path("compiler"), fs::perms::owner_all);
    set("CXX", path("compiler").string());
    set("XDG_CACHE_HOME", path("cache").string());
  }

  /// Output of `mbgen ARGUMENTS` on a terminal.
  std::string on_terminal(const std::string& arguments) const {
    return shell(fmt::format("script -qec \"'{}' {}\" /dev/null </dev/null", MBGEN_BINARY, arguments)).out;
  }

  /// Whether the cache has nothing but decisions about models, which need no compiler.
  bool has_no_solver() const {
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(path("cache/mbgen"), missing))
      if (entry.path().extension() != ".decisions") return false;
    return true;
  }
};

/// Whether a process exists and has not ended.
bool is_at_work(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  std::string number, name, state;
  return (file >> number >> name >> state) && state != "Z";
}

TEST_F(Compiling, IsToldOnATerminalAlone) {
  use_compiler("sleep 0.3; echo this compiler is broken; exit 1\n");
  const std::pair<std::string, std::string> commands[] = {
      {kRun, "the solver of pendulum"},
      {"sweep pendulum.json --vary torque=0,1 --metric 'm=max(height)' --duration 0.1 --step 1e-2 --out s.csv",
       "the solver of pendulum"},
      {"export pendulum.json --fmi 3 --out o.fmu", "the unit of pendulum for "}};
  for (const auto& [command, product] : commands) {
    const std::string shown = on_terminal(command);
    const std::size_t told = shown.find("\rcompiling " + product), gone = shown.find("\r\x1b[K", told);
    ASSERT_NE(told, std::string::npos) << shown;
    EXPECT_NE(shown.find(" parts, 0 s\x1b[K", told), std::string::npos) << shown;
    ASSERT_NE(gone, std::string::npos) << shown;
    EXPECT_EQ(shown.find("compiling", gone), std::string::npos) << shown;
    EXPECT_NE(shown.find("this compiler is broken", gone), std::string::npos) << shown;
    const Outcome piped = mbgen(command);
    EXPECT_EQ(piped.err.find("compiling"), std::string::npos) << piped.err;
    EXPECT_NE(piped.err.find("this compiler is broken"), std::string::npos) << piped.err;
  }
}

TEST_F(Compiling, IsNotToldOfAKeptSolver) {
  write("pendulum.json", kPendulum);
  ASSERT_EQ(mbgen(kRun).exit_code, 0);
  const std::string shown = on_terminal(kRun);
  EXPECT_EQ(shown.find("compiling"), std::string::npos) << shown;
  EXPECT_NE(shown.find("o.csv"), std::string::npos) << shown;
}

TEST_F(Compiling, TakesLargeSolversInPartsAndNamesThePartThatFails) {
  use_compiler(
      "echo \"$*\" >>\"$(dirname \"$0\")/commands\"\n"
      "case \"$*\" in *-DMBGEN_PART=1*) echo part one is broken; exit 1;; esac\n"
      "for word; do [ \"$last\" = -o ] && : >\"$word\"; last=$word; done\n");
  const Outcome run = mbgen("simulate '" + kSource + "/models/coach.json' --duration 0.1 --step 1e-2 --out o.csv");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("part one is broken"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("-DMBGEN_PART=1 "), std::string::npos) << run.err;
  EXPECT_TRUE(has_no_solver());
  std::istringstream commands(read("commands"));
  std::set<std::string> parts;
  for (std::string words; std::getline(commands, words);) {
    const std::size_t at = words.find("-DMBGEN_PART=");
    const std::string part = at == std::string::npos ? "" : words.substr(at + 13, 1);
    parts.insert(part);
    EXPECT_NE(words.find(" -O1 "), std::string::npos) << words;
    EXPECT_EQ(words.find(" -fexpensive-optimizations ") != std::string::npos, part <= "0") << words;
  }
  EXPECT_TRUE(parts.contains("0") && parts.contains("1"));
}

TEST_F(Compiling, TimesSolversAsTheirBuildFileCompilesThem) {
  write("pendulum.json", kPendulum);
  use_compiler(
      "echo \"$*\" >>\"$(dirname \"$0\")/commands\"\n"
      "case \"$*\" in *-c*) exit 1;; esac\n");
  EXPECT_EQ(mbgen(kRun).exit_code, 2);
  EXPECT_NE(read("commands").find(" -O1 "), std::string::npos);
  std::filesystem::remove(path("commands"));
  EXPECT_EQ(mbgen("bench pendulum.json").exit_code, 2);
  const std::string commands = read("commands");
  EXPECT_NE(commands.find(" -O2 "), std::string::npos) << commands;
  EXPECT_EQ(commands.find(" -O1 "), std::string::npos) << commands;
}

TEST_F(Compiling, LeavesNoFilesAndNoProcessesWhenItIsInterrupted) {
  use_compiler("sleep 60 & echo $! $$ >>\"$(dirname \"$0\")/processes\"\nwait\n");
  const Outcome run =
      shell(fmt::format("sh -c \"'{}' {} & while [ ! -s processes ]; do sleep 0.02; done; kill -TERM \\$!; wait \\$!; "
                        "echo \\$?\"",
                        MBGEN_BINARY, kRun));
  EXPECT_EQ(run.out, "130\n") << run.err;
  EXPECT_TRUE(has_no_solver());
  EXPECT_FALSE(fs::exists(path("o.csv")));
  std::istringstream processes(read("processes"));
  for (std::string process; processes >> process;) {
    for (int i = 0; i < 200 && is_at_work(process); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(is_at_work(process)) << process;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
