// generate --reading and explain --equation: the copy of a solver for people, and the line of a quantity in it.

#include <regex>
#include <sstream>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class ReadingCommand : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    ASSERT_EQ(mbgen("new four_bar").exit_code, 0);
  }
  std::string line_of(const std::string& file, int number) const {
    std::istringstream lines(read(file));
    std::string line;
    for (int i = 0; i < number; ++i) std::getline(lines, line);
    return line;
  }
};

TEST_F(ReadingCommand, TheLineOfAQuantityIsWhereExplainSays) {
  ASSERT_EQ(mbgen("generate four_bar.json --reading --no-runtime --out reading").exit_code, 0);
  const Outcome found = mbgen("explain four_bar.json --equation pivot_coupler");
  ASSERT_EQ(found.exit_code, 0) << found.err;
  EXPECT_TRUE(found.out.starts_with("pivot_coupler: of a coordinate: pivot of its column of the closure Jacobian"))
      << found.out;
  static const std::regex kPlace(
      R"(  four_bar\.cpp:(\d+), compute_accelerations, step 2: closure Jacobian Phi_z and its factors \(60\).*)");
  std::istringstream lines(found.out);
  std::smatch match;
  int places = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, match, kPlace)) continue;
    ++places;
    EXPECT_NE(line_of("reading/four_bar.cpp", std::stoi(match[1])).find("double pivot_coupler ="), std::string::npos)
        << line;
  }
  EXPECT_EQ(places, 1) << found.out;
}

TEST_F(ReadingCommand, APartHasTheListOfItsQuantities) {
  const Outcome found = mbgen("explain four_bar.json --equation coupler");
  ASSERT_EQ(found.exit_code, 0) << found.err;
  EXPECT_TRUE(found.out.starts_with("coupler\n")) << found.out;
  for (const char* name :
       {"  m_coupler ", "  R_coupler_x_x ", "  pivot_coupler ", "  w_coupler_y ", "  minus_zdd_star_coupler "})
    EXPECT_NE(found.out.find(name), std::string::npos) << name << "\n" << found.out;
}

TEST_F(ReadingCommand, AnUnknownNameGetsTheNearest) {
  const Outcome unknown = mbgen("explain four_bar.json --equation pivot_copler");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_EQ(unknown.out, "");
  EXPECT_EQ(unknown.err,
            "--equation: the reading copy has no quantity \"pivot_copler\"\n  hint: did you mean \"pivot_coupler\"?\n");
}

TEST_F(ReadingCommand, WordsLeadToTheQuantitiesOfAPart) {
  const Outcome found = mbgen("explain four_bar.json --equation 'composite inertia of the rocker'");
  ASSERT_EQ(found.exit_code, 0) << found.err;
  EXPECT_TRUE(found.out.starts_with("no quantity is named \"composite inertia of the rocker\"; ")) << found.out;
  EXPECT_NE(found.out.find("_rocker"), std::string::npos) << found.out;
  const Outcome unknown = mbgen("explain four_bar.json --equation 'price of gold'");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_TRUE(unknown.err.starts_with("--equation: the reading copy has no quantity \"price of gold\"\n  hint: "))
      << unknown.err;
}

TEST_F(ReadingCommand, TheFastSolverIsTheSameBesideIt) {
  ASSERT_EQ(mbgen("generate four_bar.json --no-runtime --out fast").exit_code, 0);
  ASSERT_EQ(mbgen("generate four_bar.json --reading --no-runtime --out reading").exit_code, 0);
  EXPECT_NE(read("fast/four_bar.cpp"), read("reading/four_bar.cpp"));
  EXPECT_NE(read("reading/four_bar.cpp").find("// Made by `mbgen generate four_bar.json --reading`"),
            std::string::npos);
  const std::string fast = read("fast/four_bar.cpp");
  ASSERT_EQ(mbgen("generate four_bar.json --no-runtime --out fast").exit_code, 0);
  EXPECT_EQ(read("fast/four_bar.cpp"), fast);
}

TEST_F(ReadingCommand, OptionsThatDoNotGoTogetherAreRefused) {
  EXPECT_EQ(mbgen("generate four_bar.json --reading --batch 4 --out a").err,
            "generate: --reading writes no lanes: leave out --batch or --reading\n");
  EXPECT_EQ(mbgen("generate four_bar.json --reading --casadi --out a").err,
            "generate: --reading writes no derivatives: leave out --casadi or --reading\n");
  EXPECT_EQ(mbgen("generate four_bar.json --reading --measure --out a").err,
            "generate: --measure times the fast solver: leave out --measure or --reading\n");
  EXPECT_EQ(mbgen("explain four_bar.json --tyre a --equation b").err,
            "explain: one of --tyre and --equation at a time\n");
}

}  // namespace
}  // namespace mbgen::cli_test
