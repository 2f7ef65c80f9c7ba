// Output and refusals of `--batch`.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

using Names = std::vector<std::string>;

class BatchOption : public CommandLine {
 protected:
  BatchOption() { write("four_bar.json", kFourBar); }

  Names files_of(const Json& report) const {
    Names files;
    for (const Json& file : report["files"]) {
      files.push_back(file);
      EXPECT_TRUE(std::filesystem::exists(path(file))) << file;
    }
    return files;
  }
};

TEST_F(BatchOption, AddsTwoFilesAndTheirHeadersToTheSolver) {
  const Names plain = files_of(json_of("generate four_bar.json --out plain --json --no-runtime"));
  const Names both = files_of(json_of("generate four_bar.json --batch 4 --out both --json --no-runtime"));
  EXPECT_EQ(plain, (Names{"plain/four_bar.hpp", "plain/four_bar.cpp", "plain/four_bar_cost.txt", "plain/CMakeLists.txt",
                          "plain/four_bar.json"}));
  EXPECT_EQ(both, (Names{"both/four_bar.hpp", "both/four_bar.cpp", "both/four_bar_cost.txt", "both/CMakeLists.txt",
                         "both/four_bar_batch.hpp", "both/four_bar_batch.cpp", "both/four_bar.json"}));
  EXPECT_EQ(read("both/four_bar.hpp"), read("plain/four_bar.hpp"));
  EXPECT_NE(read("both/four_bar_batch.hpp").find("constexpr int kLanes = 4;"), std::string::npos);

  const Json whole = json_of("generate four_bar.json --batch 8 --out whole --json");
  const Names files = files_of(whole);
  for (const char* header : {"whole/mbgen/lanes.hpp", "whole/mbgen/solver/rows.hpp", "whole/mbgen/lanes/batch.hpp",
                             "whole/mbgen/batch_steps.hpp"}) {
    EXPECT_NE(std::find(files.begin(), files.end(), header), files.end()) << header;
  }
  EXPECT_NE(read("whole/four_bar_batch.hpp").find("constexpr int kLanes = 8;"), std::string::npos);
}

TEST_F(BatchOption, RefusesOtherWidths) {
  for (const char* width : {"0", "2", "3", "16", "-4", "08", "4.0", "eight"}) {
    for (const char* command : {"generate four_bar.json --out made", "bench four_bar.json", "evaluate four_bar.json"}) {
      const Outcome run = mbgen(fmt::format("{} --batch {}", command, width));
      EXPECT_EQ(run.exit_code, 1) << command << width;
      EXPECT_EQ(run.out, "") << command << width;
      EXPECT_NE(run.err.find("not in {4,8}"), std::string::npos) << command << width << run.err;
    }
  }
  const Outcome empty = mbgen("generate four_bar.json --out made --batch ''");
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_NE(empty.err.find("--batch: must not be empty"), std::string::npos) << empty.err;
  EXPECT_EQ(leftovers(), Names{"four_bar.json"});
}

TEST_F(BatchOption, IsOfTheGeneratedEngineAlone) {
  write("states.json", R"({ "states": [{ "z": [0.6, 0, 0], "zd": [0, 0, 0] }] })");
  const Outcome run = mbgen("evaluate four_bar.json --engine generic --batch 4 --states states.json");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("--batch"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("generic"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace mbgen::cli_test
