// `--engine auto`: the engine that has the motion first.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class AutoEngine : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    set("XDG_CACHE_HOME", path("cache").string());
    write("pendulum.json", kPendulum);
  }

  /// The line that names the engine, of a motion of so many steps of 1 ms.
  std::string line(int steps) {
    const Outcome run = mbgen(fmt::format(
        "simulate pendulum.json --engine auto --duration {} --step 1e-3 --every 1000 --out o.csv", steps * 1e-3));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::size_t at = run.err.find("simulate: engine ");
    return at == std::string::npos ? run.err : run.err.substr(at, run.err.find('\n', at) - at);
  }
};

TEST_F(AutoEngine, IsGenericWhereItsMotionIsOverBeforeACompilerWouldBe) {
  EXPECT_TRUE(line(100).starts_with("simulate: engine generic: 100 steps take the generic engine about ")) << line(100);
  EXPECT_TRUE(line(200000).starts_with("simulate: engine generated: 200000 steps take the generic engine about "));
  EXPECT_EQ(line(100), "simulate: engine generated: its solver is kept");
}

TEST_F(AutoEngine, IsGenericWithoutACompiler) {
  set("CXX", "no-such-compiler");
  EXPECT_EQ(line(200), "simulate: engine generic: there is no C++ compiler");
}

}  // namespace
}  // namespace mbgen::cli_test
