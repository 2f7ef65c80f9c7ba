// Lines of progress in a log: how far a motion is, and a way around a compilation that is waited for.

#include <regex>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class ProgressLines : public CommandLine {
 protected:
  std::string told(const std::string& seconds, const std::string& arguments) {
    set("MBGEN_PROGRESS", seconds);
    const Outcome run = mbgen("simulate " + kSource + "/models/four_bar.json --duration 0.1 --out a.csv " + arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.err;
  }
};

TEST_F(ProgressLines, TellHowFarAMotionIs) {
  const std::string lines = told("1e-9", "--engine generic");
  EXPECT_TRUE(std::regex_search(lines, std::regex("(^|\n)simulate: 50 %, about \\d+ s left\n"))) << lines;
}

TEST_F(ProgressLines, AreLeftOutOnDemand) { EXPECT_EQ(told("0", "--engine generic"), ""); }

TEST_F(ProgressLines, OfACompilationNameTheWayAroundIt) {
  const std::string lines = told("1e-9", "--no-cache");
  EXPECT_TRUE(std::regex_search(lines, std::regex("(^|\n)compiling the solver of four_bar: \\d of \\d parts, \\d+ s; "
                                                  "simulate --engine auto does not wait for it\n")))
      << lines;
}

TEST_F(ProgressLines, TellHowFarATranslationIs) {
  set("MBGEN_PROGRESS", "1e-9");
  const Outcome run = mbgen("generate " + kSource + "/models/four_bar.json --out four_bar");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("translating four_bar: 4 of 16 stages\n"), std::string::npos) << run.err;
}

TEST_F(ProgressLines, TellHowFarARigIs) {
  set("MBGEN_PROGRESS", "1e-9");
  const Outcome run = mbgen("kc " + kSource + "/models/axles/double_wishbone.json --points 3");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::regex_search(run.err, std::regex("(^|\n)kc: \\d+ %"))) << run.err;
}

}  // namespace
}  // namespace mbgen::cli_test
