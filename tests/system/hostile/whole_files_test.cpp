// Files are written whole or not at all: full disks, places without permission, processes that are killed.
#include <fcntl.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOld = "what was there before\n";
constexpr const char* kSimulate = "simulate pendulum.json --engine generic --step 1e-3 --every 1 ";

class WholeFiles : public CommandLine {
 protected:
  WholeFiles() { write("pendulum.json", kPendulum); }

  /// Runs a shell command in the test's directory; "MBGEN" stands for the binary.
  Outcome shell(std::string command) const {
    for (std::size_t at = command.find("MBGEN"); at != std::string::npos; at = command.find("MBGEN", at)) {
      command.replace(at, 5, MBGEN_BINARY);
    }
    const std::string whole = fmt::format("cd '{}' && ({}) >.out 2>.err", path("").string(), command);
    const int state = std::system(whole.c_str());
    return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, read(".out"), read(".err")};
  }

  /// Every file below the directory but those of the test itself, with its text.
  std::map<std::string, std::string> tree(const std::string& directory = "") const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(path(directory))) {
      const std::string name = fs::relative(entry.path(), path(directory)).string();
      if (!entry.is_regular_file() || name == ".out" || name == ".err") continue;
      files[name] = read((fs::path(directory) / name).string());
    }
    return files;
  }

  /// Starts mbgen, kills it after `delay`. Result: whether it was still running.
  bool killed_after(const std::vector<std::string>& words, std::chrono::microseconds delay) const {
    const pid_t child = fork();
    if (child == 0) {
      const int nothing = ::open("/dev/null", O_RDWR);
      for (const int stream : {0, 1, 2}) ::dup2(nothing, stream);
      if (::chdir(path("").c_str()) != 0) ::_exit(3);
      std::vector<char*> arguments;
      for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
      arguments.push_back(nullptr);
      ::execv(MBGEN_BINARY, arguments.data());
      ::_exit(3);
    }
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGKILL);
    int state = 0;
    ::waitpid(child, &state, 0);
    return WIFSIGNALED(state);
  }
};

TEST_F(WholeFiles, ATooLargeTableLeavesTheOldOne) {
  // 64 blocks of 512 bytes; the table has megabytes. With and without the shell's own handling of the signal.
  for (const char* before : {"", "trap '' XFSZ; "}) {
    write("table.csv", kOld);
    const Outcome run = shell(fmt::format("{}ulimit -f 64; MBGEN {} --duration 20 --out table.csv", before, kSimulate));
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_NE(run.err.find("table.csv: cannot write: File too large"), std::string::npos) << run.err;
    EXPECT_EQ(read("table.csv"), kOld);
    EXPECT_EQ(leftovers(), (std::vector<std::string>{"pendulum.json", "table.csv"}));
  }
}

TEST_F(WholeFiles, AFullDiskLeavesTheOldFiles) {
  // A file system of 64 kB in a name space of its own; where that is not allowed there is only the test above.
  if (shell("unshare -m true").exit_code != 0) GTEST_SKIP() << "no right to mount a small file system";
  fs::create_directory(path("disk"));
  const auto on_small_disk = [&](const std::string& command) {
    return shell(
        fmt::format("unshare -m sh -c 'mount -t tmpfs -o size=64k none disk && echo old >disk/table.csv && "
                    "mkdir disk/solver && echo old >disk/solver/pendulum.cpp && {}; echo code $?; "
                    "find disk -type f | sort; cat disk/table.csv disk/solver/pendulum.cpp'",
                    command));
  };
  const std::string as_before = "code 1\ndisk/solver/pendulum.cpp\ndisk/table.csv\nold\nold\n";
  const Outcome table = on_small_disk(fmt::format("MBGEN {} --duration 20 --out disk/table.csv", kSimulate));
  EXPECT_EQ(table.out, as_before);
  EXPECT_NE(table.err.find("cannot write: No space left on device"), std::string::npos) << table.err;
  const Outcome solver = on_small_disk("MBGEN generate pendulum.json --out disk/solver");
  EXPECT_EQ(solver.out, as_before) << "the solver takes more than 64 kB";
  EXPECT_NE(solver.err.find("cannot write: No space left on device"), std::string::npos) << solver.err;
}

TEST_F(WholeFiles, WithoutPermissionNothingIsWritten) {
  fs::create_directories(path("closed/solver"));
  write("closed/table.csv", kOld);
  std::string as_nobody;
  if (::geteuid() == 0) {  // root needs no permission
    as_nobody = "setpriv --reuid 65534 --regid 65534 --clear-groups ";
    for (const auto& [name, mode] : {std::pair{"", 0755}, {"pendulum.json", 0644}}) ::chmod(path(name).c_str(), mode);
    if (shell(as_nobody + "MBGEN check pendulum.json").exit_code != 0) GTEST_SKIP() << "cannot run as nobody";
  }
  for (const char* name : {"closed/table.csv", "closed/solver", "closed"}) {
    fs::permissions(path(name), fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write,
                    fs::perm_options::remove);
  }
  for (const std::string& command : {std::string(kSimulate) + "--duration 1 --out closed/table.csv",
                                     std::string("generate pendulum.json --out closed/solver"),
                                     std::string("generate pendulum.json --out closed/other")}) {
    const Outcome run = shell(as_nobody + "MBGEN " + command);
    EXPECT_EQ(run.exit_code, 1) << command;
    EXPECT_NE(run.err.find("Permission denied"), std::string::npos) << run.err;
  }
  EXPECT_EQ(tree("closed"), (std::map<std::string, std::string>{{"table.csv", kOld}}));
  fs::permissions(path("closed"), fs::perms::owner_write, fs::perm_options::add);
  fs::permissions(path("closed/solver"), fs::perms::owner_write, fs::perm_options::add);
}

TEST_F(WholeFiles, DevicesAreWrittenAndStayDevices) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const Outcome piped =
      shell(fmt::format("timeout 30 cat pipe >piped.csv & MBGEN {} --duration 0.01 --out pipe; wait", kSimulate));
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  ASSERT_TRUE(fs::is_fifo(path("pipe"))) << "and the machine's own device would be lost next";
  EXPECT_EQ(table("piped.csv").rows.size(), 11u);
  const Outcome full = shell(fmt::format("MBGEN {} --duration 1 --out /dev/full", kSimulate));
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("/dev/full: cannot write: No space left on device"), std::string::npos) << full.err;
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(WholeFiles, SymbolicLinksStayLinks) {
  fs::create_directory(path("far"));
  write("far/table.csv", kOld);
  fs::create_symlink("far/table.csv", path("near.csv"));
  EXPECT_EQ(shell(fmt::format("MBGEN {} --duration 0.01 --out near.csv", kSimulate)).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(path("near.csv")));
  EXPECT_EQ(table("far/table.csv").rows.size(), 11u);
}

TEST_F(WholeFiles, WhatIsReadIsNotWritten) {
  // The manifest is named like the model; of the second one the file is read by an include.
  const std::string including = R"({ "mbgen": 1, "name": "pendulum", "include": ["pendulum.json"] })";
  write("all.json", including);
  for (const char* command : {"generate pendulum.json --out .", "generate ./pendulum.json --out ../$(basename $PWD)",
                              "simulate pendulum.json --engine generic --out pendulum.json",
                              "generate all.json --out .", "generate all.json --out solver --depfile ./pendulum.json",
                              "simulate all.json --engine generic --out pendulum.json"}) {
    const Outcome run = shell(std::string("MBGEN ") + command);
    EXPECT_EQ(run.exit_code, 1) << command;
    EXPECT_NE(run.err.find("it is read by this command"), std::string::npos) << run.err;
    EXPECT_EQ(tree(), (std::map<std::string, std::string>{{"all.json", including}, {"pendulum.json", kPendulum}}))
        << command;
  }
  write("torque.csv", "t,torque\n0,1\n");
  EXPECT_EQ(shell(fmt::format("MBGEN {} --input-table torque.csv --out torque.csv", kSimulate)).exit_code, 1);
  EXPECT_EQ(read("torque.csv"), "t,torque\n0,1\n");
}

TEST_F(WholeFiles, KilledSimulationsLeaveTheOldTableOrTheNew) {
  const std::string command = fmt::format("MBGEN {} --duration 4 --out ", kSimulate);
  ASSERT_EQ(shell(command + "new.csv").exit_code, 0);
  const std::string whole = read("new.csv"), whole_run = read("new.csv.run.json");
  std::vector<std::string> words = {"mbgen"};
  std::istringstream split(std::string(kSimulate) + "--duration 4 --out table.csv");
  for (std::string word; split >> word;) words.push_back(word);
  // Delays from none to about twice the time that it takes.
  const auto start = std::chrono::steady_clock::now();
  killed_after(words, std::chrono::seconds(0));
  shell(command + "new.csv");
  const auto taken = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start);
  std::mt19937 random(3);
  int killed = 0, finished = 0, temporaries = 0;
  for (int i = 0; i < 20; ++i) {
    write("table.csv", kOld);
    const auto delay = std::chrono::microseconds(i * (random() % std::max<long>(1000, taken.count() / 10)));
    (killed_after(words, delay) ? killed : finished) += 1;
    const std::string found = read("table.csv");
    EXPECT_TRUE(found == kOld || found == whole) << found.size() << " bytes of " << whole.size();
    for (const std::string& name : leftovers()) {
      if (name == "pendulum.json" || name == "table.csv" || name == "new.csv" || name == "new.csv.run.json") continue;
      if (name == "table.csv.run.json") {
        EXPECT_EQ(read(name), whole_run);
        fs::remove(path(name));
        continue;
      }
      const std::string ending = name.starts_with(".table.csv.run.json.") ? ".run.json.XXXXXX" : ".XXXXXX";
      EXPECT_TRUE(name.starts_with(".table.csv.") && name.size() == std::string(".table.csv").size() + ending.size())
          << name;
      fs::remove(path(name));
      ++temporaries;
    }
  }
  fmt::print("{} killed, {} finished before; {} temporary files found\n", killed, finished, temporaries);
  EXPECT_GT(killed, 0);
}

TEST_F(WholeFiles, KilledGenerationsLeaveFilesWhole) {
  ASSERT_EQ(shell("MBGEN generate pendulum.json --out new").exit_code, 0);
  const std::map<std::string, std::string> whole = tree("new");
  std::mt19937 random(4);
  int killed = 0;
  for (int i = 0; i < 25; ++i) {
    fs::create_directory(path("solver"));
    for (const auto& [name, text] : whole) {
      fs::create_directories(path("solver/" + name).parent_path());
      write("solver/" + name, kOld);
    }
    killed += killed_after({"mbgen", "generate", "pendulum.json", "--out", "solver"},
                           std::chrono::microseconds(i * (random() % 4000)));
    for (const auto& [name, text] : tree("solver")) {
      const bool is_temporary = fs::path(name).filename().string().starts_with(".");
      if (is_temporary) continue;
      ASSERT_TRUE(whole.count(name)) << name;
      EXPECT_TRUE(text == kOld || text == whole.at(name)) << name;
    }
    fs::remove_all(path("solver"));
  }
  EXPECT_GT(killed, 0);
}

TEST_F(WholeFiles, TheManifestIsNewOnlyWhereAllIs) {
  ASSERT_EQ(shell("MBGEN generate pendulum.json --out new").exit_code, 0);
  const std::map<std::string, std::string> whole = tree("new");
  std::size_t moments = 1;
  for (bool ended = false; !ended; ++moments) {
    SCOPED_TRACE(moments);
    write("rule.d", kOld);
    for (const auto& [name, text] : whole) {
      fs::create_directories(path("solver/" + name).parent_path());
      write("solver/" + name, kOld);
    }
    ended = shell(fmt::format("export LD_PRELOAD='{}' ASAN_OPTIONS=verify_asan_link_order=0 KILLED_AT_RENAME={}; "
                              "MBGEN generate pendulum.json --out solver --depfile rule.d",
                              KILLED_AT_RENAME, moments))
                .exit_code == 0;
    EXPECT_EQ(read("rule.d") == kOld, moments == 1);
    EXPECT_EQ(read("solver/pendulum.json") != kOld, ended);
    std::size_t renewed = 0;
    for (const auto& [name, text] : whole) renewed += read("solver/" + name) == text;
    EXPECT_EQ(renewed, std::min(std::max<std::size_t>(moments, 2) - 2, whole.size()));
    fs::remove_all(path("solver"));
  }
  EXPECT_EQ(moments, whole.size() + 3) << "one moment before each rename, of the rule first, and one after all";
}

TEST_F(WholeFiles, HostilePathsGetWhatIsAnnouncedAndNothingElse) {
  const std::vector<std::string> names = {"a b",    "quote\"'", "$(touch pwned)", "`touch pwned`", "new\nline",
                                          "back\\", "-v",       "\u00e9\u202e",   "\xff\xfe",      "*/",
                                          "%s{}"};
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const bool has_slash = name.find('/') != std::string::npos;
    const std::string directory = "out " + (has_slash ? std::string("x") : name);
    const std::string model = (has_slash ? std::string("y") : name) + ".json";
    std::string text = kPendulum;
    text.replace(text.find("\"name\": \"pendulum\", "), 20, "");  // the file's name is the model's
    write(model, text);
    const std::map<std::string, std::string> before = tree();
    ::setenv("MODEL", ("./" + model).c_str(), 1);
    ::setenv("DIRECTORY", directory.c_str(), 1);
    const Outcome run = shell("MBGEN generate \"$MODEL\" --out \"$DIRECTORY\" --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json report = Json::parse(run.out);
    std::map<std::string, std::string> after = tree();
    std::size_t made = 0;
    for (const auto& [file, content] : after) {
      if (before.count(file)) {
        EXPECT_EQ(content, before.at(file)) << file;
      } else {
        EXPECT_TRUE(file.starts_with(directory + "/")) << file;
        ++made;
      }
    }
    EXPECT_EQ(made, report["files"].size());
    fs::remove_all(path(directory));
    fs::remove(path(model));
  }
  EXPECT_FALSE(fs::exists(path("pwned")));
}

}  // namespace
}  // namespace mbgen::cli_test
