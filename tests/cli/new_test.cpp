// mbgen new: every starter is checked, generated and driven; nothing is overwritten by mistake.
#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class New : public CommandLine {};

TEST_F(New, EveryStarterIsAModelThatMoves) {
  const Json list = json_of("new --list --json")["starters"];
  ASSERT_EQ(list.size(), 5u);
  for (const Json& starter : list) {
    const std::string kind = starter["kind"];
    EXPECT_GT(starter["purpose"].get<std::string>().size(), 10u) << kind;
    const Outcome written = mbgen("new " + kind);
    EXPECT_EQ(written.exit_code, 0) << written.err;
    EXPECT_EQ(written.out, kind + ".json\n");
    EXPECT_EQ(mbgen("check " + kind + ".json").out.find(kind + ".json: ok\n"), 0u);
    EXPECT_EQ(mbgen("generate " + kind + ".json --out " + kind).exit_code, 0);
    const Outcome run = mbgen("simulate " + kind + ".json --engine generic --duration 0.5 --out " + kind + ".csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(table(kind + ".csv").rows.size(), 501u) << kind;
  }
}

TEST_F(New, NeverOverwritesWithoutForce) {
  write("mine.json", "precious");
  const Outcome refused = mbgen("new pendulum --out mine.json");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.err, "mine.json: file exists\n  hint: name another one with --out, or overwrite it with --force\n");
  EXPECT_EQ(read("mine.json"), "precious");
  EXPECT_EQ(mbgen("new pendulum --out mine.json --force").exit_code, 0);
  EXPECT_NE(read("mine.json").find("\"hinge\""), std::string::npos);
}

TEST_F(New, SaysWhichKindsThereAre) {
  EXPECT_EQ(mbgen("new").err, "mbgen new: KIND is missing\n  hint: mbgen new --list names the kinds\n");
  const Outcome unknown = mbgen("new pendulums");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_EQ(unknown.err,
            "mbgen new: unknown kind \"pendulums\"\n  hint: known: double_wishbone, four_bar, pendulum, quarter_car, "
            "tyre_rig\n");
  EXPECT_EQ(leftovers(), std::vector<std::string>{});
}

}  // namespace
}  // namespace mbgen::cli_test
