// Runs that a signal ends keep what they have, say how to go on, and end as by Ctrl-C; and files without end.

#include <sys/stat.h>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Interruption : public CommandLine {
 protected:
  /// Starts mbgen, sends it a signal once `ready` (a command of the shell) says so; standard output has its exit code.
  Outcome interrupted(const std::string& arguments, const std::string& ready, const std::string& signal) const {
    return shell(
        fmt::format("bash -c \"set -m; '{}' {} >/dev/null & until {}; do sleep 0.02; done; kill -{} \\$!; wait "
                    "\\$!; echo \\$?\"",
                    MBGEN_BINARY, arguments, ready, signal));
  }
};

TEST_F(Interruption, AMotionKeepsItsRows) {
  write("pendulum.json", kPendulum);
  for (const char* signal : {"INT", "TERM"}) {
    const Outcome run = interrupted("simulate pendulum.json --engine generic --duration 1e6 --step 1e-3 --out q.csv",
                                    "[ -s .q.csv.* ]", signal);
    EXPECT_EQ(run.out, "130\n") << signal << run.err;
    const Table motion = table("q.csv");
    ASSERT_GT(motion.rows.size(), 10u);
    for (std::size_t row = 0; row < motion.rows.size(); ++row) ASSERT_EQ(motion.rows[row].size(), motion.names.size());
    const std::string end = fmt::format("{:.10g}", motion.last("t [s]"));
    EXPECT_NE(run.err.find("simulate: interrupted at t = " + end +
                           " s; q.csv holds the motion up to there, run the same command again for all of it\n"),
              std::string::npos)
        << run.err;
    const Json record = Json::parse(read("q.csv.run.json"));
    EXPECT_EQ(record["status"], "interrupted");
    EXPECT_EQ(record["rows"], motion.rows.size());
    EXPECT_EQ(leftovers(), (std::vector<std::string>{"pendulum.json", "q.csv", "q.csv.run.json"}));
    std::filesystem::remove(path("q.csv"));
  }
}

TEST_F(Interruption, AStudyKeepsItsCases) {
  write("pendulum.json", kPendulum);
  for (const char* signal : {"INT", "TERM"}) {
    const Outcome run = interrupted(
        "sweep pendulum.json --vary torque=0:0.001:9 --metric 'max(height)' --engine generic --duration 2 --step 1e-3 "
        "--jobs 2 --out s.csv",
        "[ \\$(wc -l <s.csv.journal 2>/dev/null || echo 0) -ge 4 ]", signal);
    EXPECT_EQ(run.out, "130\n") << run.err;
    const std::string journal = read("s.csv.journal");
    const auto lines = std::count(journal.begin(), journal.end(), '\n');
    EXPECT_NE(
        run.err.find(fmt::format("sweep: interrupted: {} of 9001 cases are done, s.csv.journal keeps them; run the "
                                 "same command again to go on\n",
                                 lines - 1)),
        std::string::npos)
        << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("s.csv")));
    std::filesystem::remove(path("s.csv.journal"));
  }
}

TEST_F(Interruption, FilesWithoutEndAreRefusedBeforeMemoryIsGone) {
  write("large.json", "{}");
  write("large.csv", "t [s]\n");
  for (const char* name : {"large.json", "large.csv"})
    std::filesystem::resize_file(path(name), std::uintmax_t{3} << 30);
  EXPECT_EQ(mbgen("check large.json").err, "large.json: file is larger than 64 MB\n");
  EXPECT_EQ(mbgen("import large.json -o m.json").err, "large.json: cannot read: larger than 64 MB\n");
  EXPECT_EQ(mbgen("plot large.csv --columns a -o m.svg").err, "large.csv: cannot read: larger than 1 GB\n");
  EXPECT_EQ(mbgen("check /dev/zero").err, "/dev/zero: file is larger than 64 MB\n");
  EXPECT_EQ(mbgen("plot /dev/zero --columns a -o m.svg").err, "/dev/zero: cannot read: larger than 64 MB\n");
  EXPECT_EQ(mbgen("check /proc/version").err,
            "/proc/version: cannot read file, it is one of the kernel, which may have no end\n");
  EXPECT_EQ(mbgen("plot /proc/version --columns a -o m.svg").err,
            "/proc/version: cannot read: it is a file of the kernel, which may have no end\n");
  write("pendulum.json", kPendulum);
  EXPECT_EQ(mbgen("simulate pendulum.json --manoeuvre /proc/version --out q.csv").err,
            "/proc/version: cannot read file, it is one of the kernel, which may have no end\n");
}

}  // namespace
}  // namespace mbgen::cli_test
