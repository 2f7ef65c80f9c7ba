// Linked and loaded files come from directories that nobody else can write.

#include "workbench/host/own_directory.hpp"

#include <grp.h>
#include <sys/stat.h>

#include "tests/support/cli_support.hpp"
#include "workbench/host/temporary_directory.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

constexpr uid_t kStranger = 65534;  // nobody, on Debian

class OwnDirectory : public CommandLine {
 protected:
  fs::path directory(const std::string& name, mode_t mode) const {
    fs::create_directories(path(name));
    EXPECT_EQ(::chmod(path(name).c_str(), mode), 0);
    return path(name);
  }

  /// Makes the last run's compiler refuse, so that only a kept solver can run.
  void use_compiler_that_breaks() {
    write("compiler",
          "#!/bin/sh\nif [ -e \"$(dirname \"$0\")/broken\" ] && [ \"$1\" != --version ]; then\n"
          "  echo this compiler is broken; exit 1\nfi\nexec c++ \"$@\" -O0\n");
    fs::permissions(path("compiler"), fs::perms::owner_all);
    set("CXX", path("compiler").string());
  }

  static constexpr const char* kRun = "simulate pendulum.json --duration 0.1 --step 1e-2 --out o.csv";
};

TEST_F(OwnDirectory, FaultsAreSeenInTheDirectoryAndOnTheWay) {
  EXPECT_EQ(foreign_hand(directory("own", 0755), false), "");
  EXPECT_EQ(foreign_hand(directory("own/deeper", 0700), false), "");
  EXPECT_EQ(foreign_hand(path("own") / ".." / "own" / "", false), "");

  const fs::path open = directory("open", 0777);
  EXPECT_EQ(foreign_hand(open, false), "others can write in " + open.string() + " (mode 0777)");
  EXPECT_EQ(foreign_hand(open, true), "others can write in " + open.string() + " (mode 0777)");
  EXPECT_EQ(foreign_hand(directory("open/mine", 0700), false), "others can write in " + open.string() + " (mode 0777)");

  const fs::path sticky = directory("sticky", 01777);
  EXPECT_EQ(foreign_hand(sticky, false), "others can write in " + sticky.string() + " (mode 1777)");
  EXPECT_EQ(foreign_hand(sticky, true), "");
  EXPECT_EQ(foreign_hand(directory("sticky/mine", 0700), false), "");
}

TEST_F(OwnDirectory, LinksAreLookedThrough) {
  directory("own", 0700);
  directory("open/mine", 0700);
  directory("open", 0777);
  fs::create_symlink("own", path("link"));
  EXPECT_EQ(foreign_hand(path("link"), false), "");
  fs::create_symlink(path("open/mine"), path("to_open"));
  EXPECT_NE(foreign_hand(path("to_open"), false).find("others can write in " + path("open").string()),
            std::string::npos);
  fs::create_symlink("round", path("round"));
  EXPECT_NE(foreign_hand(path("round"), false), "");
}

TEST_F(OwnDirectory, WhatBelongsToAnotherUserIsNotTrusted) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give directories to another user";
  const fs::path foreign = directory("foreign", 0755);
  const fs::path mine = directory("foreign/mine", 0700);
  ASSERT_EQ(::chown(foreign.c_str(), kStranger, 0), 0);
  EXPECT_NE(foreign_hand(foreign, false).find(foreign.string() + " belongs to user"), std::string::npos);
  EXPECT_NE(foreign_hand(mine, false).find(foreign.string() + " belongs to user"), std::string::npos);

  directory("own", 0700);
  fs::create_symlink("own", path("link"));
  ASSERT_EQ(::lchown(path("link").c_str(), kStranger, 0), 0);
  EXPECT_NE(foreign_hand(path("link"), false).find("link belongs to user"), std::string::npos);

  const fs::path shared = directory("shared", 0775);
  ASSERT_EQ(::chown(shared.c_str(), 0, kStranger), 0);
  EXPECT_EQ(foreign_hand(shared, false), "others can write in " + shared.string() + " (mode 0775)");
}

TEST_F(OwnDirectory, SolversThatOthersCouldHaveWrittenAreNotLoaded) {
  write("pendulum.json", kPendulum);
  use_compiler_that_breaks();
  set("XDG_CACHE_HOME", path("cache").string());
  ASSERT_EQ(mbgen(kRun).exit_code, 0);
  struct stat status = {};
  ASSERT_EQ(::stat(path("cache/mbgen").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0700u);
  std::vector<fs::path> files(fs::directory_iterator(path("cache/mbgen")), {});
  std::erase_if(files, [](const fs::path& file) { return file.extension() != ".so"; });
  ASSERT_EQ(files.size(), 1u);
  const fs::path kept = files[0];
  write("broken", "");
  ASSERT_EQ(mbgen(kRun).exit_code, 0);  // found again

  ASSERT_EQ(::chmod(kept.c_str(), 0777), 0);
  EXPECT_NE(mbgen(kRun).err.find("this compiler is broken"), std::string::npos) << "a file that others can write";
  fs::rename(kept, path("elsewhere"));
  ASSERT_EQ(::chmod(path("elsewhere").c_str(), 0700), 0);
  fs::create_symlink(path("elsewhere"), kept);
  EXPECT_NE(mbgen(kRun).err.find("this compiler is broken"), std::string::npos) << "a link";
  fs::rename(path("elsewhere"), kept);
  ASSERT_EQ(mbgen(kRun).exit_code, 0);

  ASSERT_EQ(::chmod(path("cache").c_str(), 0777), 0);
  const Outcome run = mbgen(kRun);
  EXPECT_NE(run.err.find(fmt::format("{0}/mbgen: note: nothing is kept or loaded here: others can write in {0} (mode "
                                     "0777)\n  hint: name a directory that only you can write in XDG_CACHE_HOME",
                                     path("cache").string())),
            std::string::npos)
      << run.err;
  EXPECT_EQ(run.err.find("note:"), run.err.rfind("note:")) << "told once: " << run.err;
  EXPECT_NE(run.err.find("this compiler is broken"), std::string::npos) << run.err;
}

TEST_F(OwnDirectory, TemporaryFilesAreNotPutWhereOthersCouldExchangeThem) {
  write("pendulum.json", kPendulum);
  set("TMPDIR", directory("open", 0777).string());
  const std::string fault = fmt::format(
      "{0}: not used for temporary files, others could exchange the files that are compiled there: others can write in "
      "{0}",
      path("open").string());
  for (const char* command : {"simulate pendulum.json --duration 0.1 --step 1e-2 --no-cache --out o.csv",
                              "export pendulum.json --fmi 3 -o p.fmu", "generate pendulum.json --out o --measure"}) {
    const Outcome run = mbgen(command);
    EXPECT_EQ(run.exit_code, 1) << command;
    EXPECT_NE(run.err.find(fault), std::string::npos) << command << "\n" << run.err;
  }
  set("TMPDIR", path("missing").string());
  const Outcome run = mbgen("export pendulum.json --fmi 3 -o p.fmu");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("name one in TMPDIR"), std::string::npos) << run.err;
}

TEST_F(OwnDirectory, TwoUsersShareATemporaryDirectory) {
  const bool is_reachable =
      shell("setpriv --reuid 65534 --regid 65534 --clear-groups env '" MBGEN_BINARY "' --version").exit_code == 0;
  if (!is_reachable) GTEST_SKIP() << "mbgen cannot be run here as a second user";
  write("pendulum.json", kPendulum);
  use_compiler_that_breaks();
  fs::permissions(path("compiler"), fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(directory_, fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  set("TMPDIR", directory("temporary", 01777).string());
  const std::string run = fmt::format("'{}' simulate pendulum.json --duration 0.1 --step 1e-2 --out", MBGEN_BINARY);
  const Outcome first = shell("env -u HOME -u XDG_CACHE_HOME " + run + " one.csv");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const Outcome second =
      shell("setpriv --reuid 65534 --regid 65534 --clear-groups env -u HOME -u XDG_CACHE_HOME " + run + " /dev/null",
            ".second");
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_TRUE(fs::is_empty(path("temporary")));

  // A cache of the first user is none of the second's, and one of the second's none of the administrator's.
  directory("strangers/mbgen", 0755);
  ASSERT_EQ(::chown(path("strangers").c_str(), kStranger, kStranger), 0);
  set("XDG_CACHE_HOME", path("strangers").string());
  const Outcome third = shell(run + " three.csv");
  EXPECT_EQ(third.exit_code, 0) << third.err;
  EXPECT_NE(third.err.find("nothing is kept or loaded here: " + path("strangers").string() + " belongs to user"),
            std::string::npos)
      << third.err;
}

}  // namespace
}  // namespace mbgen::cli_test
