// Single precision: what it goes with, what it is refused with, and what of the emitted text follows it. That the
// solvers compile and compute is seen by tests/system/single_precision, tests/system/c_interface and
// tests/system/calibration.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A number of the text that is written as a double's: digits with a point and no f behind them. Sizes and thresholds
/// in tables of the runtime, before a brace, are doubles.
bool has_double_literal(const std::string& text) {
  for (std::size_t at = text.find('.'); at != std::string::npos; at = text.find('.', at + 1)) {
    std::size_t first = at;
    while (first > 0 && (std::isalnum(static_cast<unsigned char>(text[first - 1])) || text[first - 1] == '_')) --first;
    if (first == at || !std::isdigit(static_cast<unsigned char>(text[first]))) continue;  // a member of a struct
    std::size_t end = text.find_first_not_of("0123456789e", at + 1);
    if (text[end] == '-' || text[end] == '+') end = text.find_first_not_of("0123456789", end + 1);
    if (text[end - 1] != 'e' && text[end] != 'f' && text[end] != ';' && text[end] != '}') return true;
  }
  return false;
}

TEST_F(CommandLine, SinglePrecisionGoesWithBothFormsTunablesAndTheInterfaces) {
  const std::string model = kSource + "/tests/data/models/all_elements.json";
  for (const char* form : {"recursive", "matrix"}) {
    const Outcome run =
        mbgen(fmt::format("generate {} --scalar float --form {} --a2l --no-runtime --out made", model, form));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json manifest = Json::parse(read("made/all_elements.json"));
    EXPECT_EQ(manifest["scalar"], "float");
    EXPECT_EQ(manifest["form"], form);
    const std::string header = read("made/all_elements.hpp"), source = read("made/all_elements.cpp");
    EXPECT_NE(header.find("struct Tuned : Parameters {\n  float derived["), std::string::npos);
    EXPECT_NE(header.find("  float load = 310.0f;  ///< kg\n"), std::string::npos) << header;
    const std::size_t first = source.find("compute_accelerations"), last = source.find("mbgen::Status assemble");
    EXPECT_FALSE(has_double_literal(source.substr(first, last - first)));
    EXPECT_NE(read("made/all_elements_c.h").find("  float load; /* kg */\n"), std::string::npos);
    EXPECT_NE(read("made/all_elements.py").find("(\"load\", ctypes.c_float),"), std::string::npos);
    EXPECT_NE(read("made/all_elements.a2l").find("FNC_VALUES 1 FLOAT32_IEEE"), std::string::npos);
  }
}

// A radius must be positive: the least double above zero is zero in single precision.
TEST_F(CommandLine, SinglePrecisionHasLimitsOfItsOwn) {
  write("tyre.json", R"({ "mbgen": 1, "name": "tyre",
      "parameters": { "speed": { "value": 0.1, "tunable": true, "max": 0.3 } },
      "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                  "p": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
      "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "p.O", "axis": "x" } },
      "frictions": { "f": { "joint": "slide", "coulomb": 1, "velocity": "speed" } } })");
  for (const bool is_float : {true, false}) {
    const Outcome run = mbgen("generate tyre.json --c-api --a2l --no-runtime --out made" +
                              std::string(is_float ? " --scalar float" : ""));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string range = is_float ? "if (values.speed < 1.1754944e-38f || values.speed > 0.3f)"
                                       : "if (values.speed < 2.2250738585072014e-308 || values.speed > 0.3)";
    const std::string limits = is_float ? "1.1754943508222875e-38 0.30000001192092896" : "2.2250738585072014e-308 0.3";
    EXPECT_NE(read("made/tyre_c.cpp").find(range), std::string::npos) << read("made/tyre_c.cpp");
    EXPECT_NE(read("made/tyre.a2l").find(limits), std::string::npos) << read("made/tyre.a2l");
  }
}

TEST_F(CommandLine, SinglePrecisionHasTheCostSheetOfDoublePrecision) {
  write("four_bar.json", kFourBar);
  ASSERT_EQ(mbgen("generate four_bar.json --out double --no-runtime").exit_code, 0);
  ASSERT_EQ(mbgen("generate four_bar.json --out float --scalar float --no-runtime").exit_code, 0);
  EXPECT_EQ(read("float/four_bar_cost.txt"), read("double/four_bar_cost.txt"));
  EXPECT_FALSE(Json::parse(read("double/four_bar.json")).contains("scalar"));
}

TEST_F(CommandLine, SinglePrecisionIsRefusedWhereThereAreDoublesOnly) {
  write("four_bar.json", kFourBar);
  const std::pair<const char*, const char*> refused[] = {
      {"--batch 4", "generate: --batch has lanes of doubles: leave out --batch or --scalar float\n"},
      {"--measure", "generate: --measure times a solver in double precision: leave out --measure or --scalar float\n"}};
  for (const auto& [options, message] : refused) {
    const Outcome run = mbgen(fmt::format("generate four_bar.json --out made --scalar float {}", options));
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, message);
  }
  EXPECT_EQ(leftovers(), (std::vector<std::string>{"four_bar.json"}));
}

TEST_F(CommandLine, SinglePrecisionHasNoPlaceForALargeNumber) {
  write("heavy.json", R"({ "mbgen": 1, "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "arm": { "mass": 1, "com": [0, 0, -1], "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.A", "to": "arm.A", "axis": "y" } },
    "joint_forces": { "push": { "joint": "pin", "force": "1e12*1e12*1e12*1e12*t" } } })");
  EXPECT_EQ(mbgen("generate heavy.json --out made --no-runtime").exit_code, 0);
  const Outcome run = mbgen("generate heavy.json --out single --scalar float");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "heavy.json: 1e+48 is beyond single precision; use other units, or leave out --scalar float\n");
}

}  // namespace
}  // namespace mbgen::cli_test
