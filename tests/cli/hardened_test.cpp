// mbgen as it was linked: what its headers promise to whoever gives it files of others.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Hardened : public CommandLine {
 protected:
  std::string readelf(const std::string& options) const {
    const Outcome run = shell(fmt::format("LC_ALL=C readelf -W {} '{}'", options, MBGEN_BINARY));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  }
};

TEST_F(Hardened, LiesAnywhereAndItsTablesCannotBeWritten) {
  EXPECT_NE(readelf("-h").find("DYN ("), std::string::npos);
  const std::string segments = readelf("-l"), dynamic = readelf("-d");
  EXPECT_NE(segments.find("GNU_RELRO"), std::string::npos);
  EXPECT_NE(dynamic.find("BIND_NOW"), std::string::npos) << dynamic;
  EXPECT_NE(dynamic.find("PIE"), std::string::npos) << dynamic;
  EXPECT_EQ(dynamic.find("TEXTREL"), std::string::npos) << dynamic;
  std::istringstream lines(segments);
  for (std::string line; std::getline(lines, line);) {
    const bool is_loaded = line.find("LOAD") != std::string::npos || line.find("GNU_STACK") != std::string::npos;
    EXPECT_FALSE(is_loaded && line.find("RWE") != std::string::npos) << line;
  }
}

TEST_F(Hardened, WatchesItsStackAndItsCopies) {
  const std::string symbols = readelf("--dyn-syms");
  EXPECT_NE(symbols.find("__stack_chk_fail"), std::string::npos);
#ifdef NDEBUG  // builds that are optimised
  EXPECT_NE(symbols.find("_chk@GLIBC"), std::string::npos) << symbols;
#endif
}

}  // namespace
}  // namespace mbgen::cli_test
