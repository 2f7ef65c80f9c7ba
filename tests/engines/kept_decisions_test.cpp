// Decisions about a model are kept beside its solver.

#include "workbench/engines/kept_decisions.hpp"

#include "compiler/analysis/analysis_bytes.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/cli_support.hpp"
#include "workbench/engines/kept_object.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

class KeptDecisions : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    set("XDG_CACHE_HOME", path("cache").string());
    write("pendulum.json", kPendulum);
  }

  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    std::error_code problem;
    for (const fs::directory_entry& entry : fs::directory_iterator(path("cache/mbgen"), problem))
      if (entry.path().extension() == ".decisions") found.push_back(entry.path());
    return found;
  }

  int simulate(const std::string& further = "") const {
    return mbgen("simulate pendulum.json --duration 0.02 --step 1e-2 --out o.csv " + further).exit_code;
  }
};

TEST_F(KeptDecisions, AreTakenWhereTheyAreWhole) {
  ASSERT_EQ(simulate(), 0);
  ASSERT_EQ(files().size(), 1u);
  const std::string name = "cache/mbgen/" + files()[0].filename().string(), own = read(name), table = read("o.csv");
  ASSERT_EQ(simulate(), 0);
  EXPECT_EQ(read("o.csv"), table);
  // Without the file, damaged, of another model: decided anew, with the same result and the same file.
  const Analysis other = decide(kSource + "/models/slider_crank.json")->analysis;
  for (const std::string& text :
       {std::string(), own.substr(0, own.size() / 2), own + "x", sealed("some words"), sealed(bytes_of(other))}) {
    write(name, text);
    ASSERT_EQ(simulate(), 0);
    EXPECT_EQ(read("o.csv"), table);
    EXPECT_EQ(read(name), own);
  }
  // Whole ones are taken as they are: a mark in them stays.
  std::optional<Analysis> marked = analysis_of_bytes(*content_of_sealed(path(name)));
  ASSERT_TRUE(marked);
  marked->closed_configurations = 12345;
  write(name, sealed(bytes_of(*marked)));
  ASSERT_EQ(simulate(), 0);
  EXPECT_EQ(read(name), sealed(bytes_of(*marked)));
}

TEST_F(KeptDecisions, AreOfOneModelAndOfSolversThatAreKept) {
  ASSERT_EQ(simulate("--engine generic"), 0);
  ASSERT_EQ(simulate("--no-cache"), 0);
  EXPECT_EQ(files().size(), 0u);
  ASSERT_EQ(simulate(), 0);
  ASSERT_EQ(simulate("--engine auto"), 0);
  EXPECT_EQ(files().size(), 1u);
  std::string longer = kPendulum;
  longer.replace(longer.find("9.81"), 4, "9.82");
  write("pendulum.json", longer);
  ASSERT_EQ(simulate(), 0);
  EXPECT_EQ(files().size(), 2u);
  EXPECT_EQ(mbgen("cache --clean").exit_code, 0);
  EXPECT_EQ(files().size(), 0u);
}

TEST_F(KeptDecisions, AreThoseOfTheModelsThatWereUsedLast) {
  ASSERT_EQ(simulate(), 0);
  for (int i = 0; i < 70; ++i) {
    write(fmt::format("cache/mbgen/{}.decisions", i), "");
    fs::last_write_time(path(fmt::format("cache/mbgen/{}.decisions", i)),
                        fs::file_time_type::clock::now() - std::chrono::seconds(1000 + i));
  }
  std::string longer = kPendulum;
  longer.replace(longer.find("9.81"), 4, "9.82");
  write("pendulum.json", longer);
  ASSERT_EQ(simulate(), 0);
  EXPECT_EQ(files().size(), 64u);
  EXPECT_TRUE(fs::exists(path("cache/mbgen/61.decisions")));
  EXPECT_FALSE(fs::exists(path("cache/mbgen/62.decisions")));
}

}  // namespace
}  // namespace mbgen::cli_test
