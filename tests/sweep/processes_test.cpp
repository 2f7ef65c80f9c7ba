// mbgen sweep on several processors and processes, killed, resumed: always the same bytes, nothing done twice.

#include <fcntl.h>
#include <signal.h>

#include <chrono>
#include <optional>
#include <random>
#include <thread>

#include "tests/sweep/sweep_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A study whose cases take a few milliseconds each.
const std::string kStudy = std::string(kGrid) + kMetrics + "--duration 2 --step 1e-3 --engine generic ";

class SweepProcesses : public Sweep {
 protected:
  /// Runs a shell command in the test's directory. Result: its exit code.
  int shell(const std::string& command) const {
    const std::string whole = fmt::format("cd '{}' && ({}) >.out 2>.err", path("").string(), command);
    const int state = std::system(whole.c_str());
    return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
  }

  /// Starts the study, kills it after `delay`. Result: whether it ended by itself.
  bool ended_before(std::chrono::milliseconds delay) const {
    const pid_t child = fork();
    if (child == 0) {
      ::setpgid(0, 0);
      const std::string command = fmt::format(
          "cd '{}' && exec '{}' sweep spring.json {} --jobs 2 --out sweep.csv "
          ">/dev/null 2>&1",
          path("").string(), MBGEN_BINARY, kStudy);
      ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
      ::_exit(3);
    }
    int state = 0;
    const auto end = std::chrono::steady_clock::now() + delay;
    while (std::chrono::steady_clock::now() < end) {
      if (::waitpid(child, &state, WNOHANG) == child) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, &state, 0);
    return !WIFSIGNALED(state);
  }

  std::vector<long> all_cases() const {
    std::vector<long> cases;
    for (long i = 0; i < kCases; ++i) cases.push_back(i);
    return cases;
  }
};

TEST_F(SweepProcesses, AnyNumberOfJobsGivesTheSameBytes) {
  const std::string expected = table_of(kStudy);
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), kCases + 1);
  for (const int jobs : {2, 7}) {
    const Outcome run = mbgen(fmt::format("sweep spring.json {} --jobs {} --out {}.csv", kStudy, jobs, jobs));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(read(fmt::format("{}.csv", jobs)), expected);
  }
  std::string compiled = kStudy;
  compiled.replace(compiled.find("generic"), 7, "generated");
  const std::string of_compiled = table_of(compiled + "--restart");
  mbgen("sweep spring.json " + compiled + " --jobs 3 --out compiled.csv");
  EXPECT_EQ(read("compiled.csv"), of_compiled);
}

TEST_F(SweepProcesses, KilledAtAnyMomentItGoesOn) {
  const std::string expected = table_of(kStudy);
  std::mt19937 random(7);
  int killed = 0;
  for (bool ended = false; !ended && killed < 200; killed += ended ? 0 : 1) {
    const int longest = 60 + 20 * killed;  // on a machine so busy that nothing would be done at first
    ended = ended_before(std::chrono::milliseconds(random() % static_cast<unsigned>(longest)));
  }
  EXPECT_GE(killed, 2);
  EXPECT_EQ(read("sweep.csv"), expected);
  EXPECT_EQ(journalled("sweep.csv"), all_cases());  // each once: nothing was done twice
}

TEST_F(SweepProcesses, WhatIsTornOrDamagedIsDoneAgain) {
  const std::string expected = table_of(kStudy);
  mbgen("sweep spring.json " + kStudy + " --out sweep.csv");
  std::string journal = read("sweep.csv.journal");
  journal.resize(journal.size() - 3);     // in the last line
  journal[journal.find('\n') + 40] ^= 1;  // in the first case
  std::filesystem::remove(path("sweep.csv"));
  write("sweep.csv.journal", journal);
  const Outcome run = mbgen("sweep spring.json " + kStudy + " --out sweep.csv");
  EXPECT_EQ(run.err, "sweep: 13 of 15 cases were done before\n");
  EXPECT_EQ(read("sweep.csv"), expected);
  const Outcome again = mbgen("sweep spring.json " + kStudy + " --out sweep.csv");
  EXPECT_EQ(again.err, "sweep: 15 of 15 cases were done before\n");
  EXPECT_EQ(again.out, run.out);
}

TEST_F(SweepProcesses, OtherWordsAreNotMixed) {
  mbgen("sweep spring.json --vary mass=1,2 --metric 'max(x)' --engine generic --out sweep.csv");
  const std::string other = "sweep spring.json --vary mass=1,3 --metric 'max(v)' --engine generic --out sweep.csv";
  const std::string hint =
      "\n  hint: run the command as before to go on with it, with --restart to begin anew, or with another --out\n";
  const Outcome run = mbgen(other);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "sweep.csv.journal: holds cases of another study, they differ in: vary, metric" + hint);
  EXPECT_EQ(mbgen(other + " --restart").exit_code, 0);
  write("spring.json", std::string(kSpring) + "\n");
  EXPECT_EQ(mbgen(other).err, "sweep.csv.journal: holds cases of another study, they differ in: model" + hint);
  write("sweep.csv.journal", "what is this\n");
  EXPECT_EQ(mbgen(other).err, "sweep.csv.journal: is not a journal of mbgen sweep; choose another --out\n");
}

TEST_F(SweepProcesses, RanksOfAParallelJobShareTheCases) {
  if (std::system("command -v mpirun >/dev/null 2>&1") != 0) GTEST_SKIP() << "mpirun is not installed";
  const std::string expected = table_of(kStudy);
  const std::string launcher = "mpirun --allow-run-as-root --oversubscribe -n ";
  const std::string study = fmt::format(" '{}' sweep spring.json {} --out sweep.csv", MBGEN_BINARY, kStudy);
  const std::string alone = mbgen("sweep spring.json " + kStudy + " --out alone.csv").out;
  ASSERT_EQ(shell(launcher + "4" + study), 0) << read(".err");
  std::string printed = read(".out");
  EXPECT_EQ(read("sweep.csv"), expected);
  EXPECT_EQ(printed.replace(printed.rfind("sweep.csv"), 9, "alone.csv"), alone);
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
  // Another number of ranks goes on with what is there.
  std::filesystem::remove(path("sweep.csv.journal.2-of-4"));
  ASSERT_EQ(shell(launcher + "3" + study), 0) << read(".err");
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
  EXPECT_EQ(read("sweep.csv"), expected);
  ASSERT_EQ(shell(launcher + "2" + study + " --restart"), 0) << read(".err");
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
  EXPECT_EQ(read("sweep.csv"), expected);
}

TEST_F(SweepProcesses, RanksOfOtherLaunchersAreSeen) {
  const std::string study = fmt::format("'{}' sweep spring.json {} --out sweep.csv", MBGEN_BINARY, kStudy);
  const std::string expected = table_of(kStudy);
  EXPECT_EQ(shell("PMI_RANK=1 PMI_SIZE=2 " + study + " & PMI_RANK=0 PMI_SIZE=2 " + study + " && wait"), 0);
  EXPECT_EQ(read("sweep.csv"), expected);
  // Names of tables may look like names of journals.
  const std::string named = fmt::format("'{}' sweep spring.json {} --out 1-of-2.csv", MBGEN_BINARY, kStudy);
  EXPECT_EQ(shell("PMI_RANK=0 PMI_SIZE=2 " + named + " && PMI_RANK=0 PMI_SIZE=2 " + named), 0) << read(".err");
  EXPECT_EQ(read("1-of-2.csv"), expected);
  // The script of a batch job has a rank, but is no step.
  const std::string alone = fmt::format("'{}' sweep spring.json {} --out alone.csv", MBGEN_BINARY, kStudy);
  EXPECT_EQ(shell("SLURM_PROCID=0 SLURM_NTASKS=4 " + alone), 0);
  EXPECT_EQ(read("alone.csv"), expected);
}

TEST_F(SweepProcesses, ASlurmScriptRunsThePartsAndGathers) {
  const std::string expected = table_of(kStudy);
  const Outcome written = mbgen("sweep spring.json " + kStudy + " --slurm job.sh --parts 4 --out sweep.csv");
  EXPECT_EQ(written.out, "job.sh: 15 cases in 4 parts; submit with: sh job.sh\n");
  EXPECT_EQ(shell("sh -n job.sh"), 0) << read(".err");
  write("sbatch", "#!/bin/sh\necho \"$@\" >>submitted\necho '77;cluster'\n");
  ASSERT_EQ(shell("chmod +x sbatch && PATH=$PWD:$PATH sh job.sh"), 0) << read(".err");
  const std::string script = path("job.sh").string();
  EXPECT_EQ(read("submitted"),
            fmt::format("--parsable --array=1-4 {0} part\n--dependency=afterany:77 {0} gather\n", script));
  // Tasks at the same time share the cases; one that comes later finds none left.
  const auto task = [&](int k) {
    return fmt::format("(cd / && SLURM_ARRAY_TASK_ID={0} sh {1} part) >{2}", k, script,
                       path(fmt::format("{}.out", k)).string());
  };
  ASSERT_EQ(shell(task(3) + " & " + task(1) + " & wait && " + task(4)), 0) << read(".err");
  long sum = 0;
  for (const int k : {1, 3, 4}) {
    const std::string printed = read(fmt::format("{}.out", k)), begin = fmt::format("part {}/4: ", k);
    ASSERT_TRUE(printed.starts_with(begin)) << printed;
    sum += std::stol(printed.substr(begin.size()));
  }
  EXPECT_EQ(sum, kCases);
  EXPECT_EQ(read("4.out"), "part 4/4: 0 cases\n");
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
  EXPECT_FALSE(std::filesystem::exists(path("sweep.csv")));
  // A part that is gone is computed by the job that gathers.
  std::filesystem::remove(path("sweep.csv.journal.3-of-4"));
  ASSERT_EQ(shell(fmt::format("sh {} gather", script)), 0) << read(".err");
  EXPECT_EQ(read("sweep.csv"), expected);
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
}

TEST_F(SweepProcesses, PartsDivideTheCasesWhereTheyShareNoFiles) {
  const std::string expected = table_of(kStudy);
  for (const int part : {3, 1, 4}) {
    const Outcome run = mbgen(fmt::format("sweep spring.json {} --part {}/4 --out sweep.csv", kStudy, part));
    EXPECT_EQ(run.out, fmt::format("part {}/4: {} cases\n", part, part == 4 ? 3 : 4));
  }
  const Outcome gathered = mbgen("sweep spring.json " + kStudy + " --out sweep.csv");  // also what part 2 left undone
  EXPECT_EQ(gathered.err, "sweep: 11 of 15 cases were done before\n");
  EXPECT_EQ(read("sweep.csv"), expected);
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
}

/// The lock of a case, as a process has it that computes the case.
class HeldCase {
 public:
  HeldCase(const std::filesystem::path& claims, long index)
      : file_(::open(claims.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    struct flock wanted {};
    wanted.l_type = F_WRLCK;
    wanted.l_whence = SEEK_SET;
    wanted.l_start = index;
    wanted.l_len = 1;
    EXPECT_EQ(::fcntl(file_, F_OFD_SETLK, &wanted), 0);
  }
  ~HeldCase() { ::close(file_); }

 private:
  int file_;
};

TEST_F(SweepProcesses, ARankTakesTheNextCaseThatNobodyHas) {
  const std::string expected = table_of(kStudy);
  const std::string study = fmt::format("'{}' sweep spring.json {} --out sweep.csv", MBGEN_BINARY, kStudy);
  {
    const HeldCase slow(path("sweep.csv.journal.claims"), 3);  // another rank takes its time with this one
    ASSERT_EQ(shell("PMI_RANK=2 PMI_SIZE=3 " + study), 0) << read(".err");
    std::vector<long> others = all_cases();
    others.erase(others.begin() + 3);
    EXPECT_EQ(journalled("sweep.csv"), others);
  }
  // The other one died: the first rank of a rerun takes up its case, and no other.
  ASSERT_EQ(shell("PMI_RANK=0 PMI_SIZE=2 " + study), 0) << read(".err");
  EXPECT_EQ(read(".err"), "sweep: 14 of 15 cases were done before\n");
  EXPECT_EQ(read("sweep.csv"), expected);
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
  const std::string of_rerun = read("sweep.csv.journal.1-of-2");
  EXPECT_EQ(std::count(of_rerun.begin(), of_rerun.end(), '\n'), 2);
}

TEST_F(SweepProcesses, TheFirstRankTakesUpTheCaseOfOneThatDies) {
  const std::string expected = table_of(kStudy);
  const std::string study = fmt::format("'{}' sweep spring.json {} --out sweep.csv", MBGEN_BINARY, kStudy);
  std::optional<HeldCase> dying(std::in_place, path("sweep.csv.journal.claims"), 14);
  std::thread first([&] { EXPECT_EQ(shell("PMI_RANK=0 PMI_SIZE=2 " + study), 0) << read(".err"); });
  while (journalled("sweep.csv").size() < kCases - 1) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(std::filesystem::exists(path("sweep.csv")));  // it waits for the case that the other one has
  dying.reset();
  first.join();
  EXPECT_EQ(read("sweep.csv"), expected);
  EXPECT_EQ(journalled("sweep.csv"), all_cases());
}

TEST_F(SweepProcesses, TwoAtOnceDoNotShareAJournal) {
  mbgen("sweep spring.json " + kStudy + " --out sweep.csv");
  const Outcome run = mbgen("sweep spring.json " + kStudy + " --out sweep.csv", ".out");
  EXPECT_EQ(run.exit_code, 0);
  const std::string study = fmt::format("'{}' sweep spring.json {} --out sweep.csv", MBGEN_BINARY, kStudy);
  EXPECT_EQ(shell("flock sweep.csv.journal " + study), 1);
  EXPECT_EQ(read(".err"), "sweep.csv.journal: another mbgen sweep is at work on it\n");
}

}  // namespace
}  // namespace mbgen::cli_test
