// Outputs of motions, energies and wheels through the command line: every engine writes the same table.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

TEST_F(CommandLine, EnginesAgreeOnEveryOutputOfMotions) {
  const auto table_of = [&](const std::string& engine) {
    const Outcome run = mbgen(fmt::format(
        "simulate {}/tests/data/models/wheel_outputs.json --duration 5e-4 --step 1e-4 --out {}.csv --engine {}",
        kSource, engine, engine));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return table(engine + ".csv");
  };
  const Table generic = table_of("generic");
  EXPECT_NEAR(generic.at(0, "spin [rad/s]"), 30, 1e-9);
  for (const char* engine : {"generated", "augmented", "maggi"}) {
    SCOPED_TRACE(engine);
    expect_same_motion(generic, table_of(engine), 1e-9);
  }
}

}  // namespace
}  // namespace mbgen::cli_test
