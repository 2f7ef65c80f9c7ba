// A case of a study is judged as a motion of `simulate` is: by the same watchers, in the same words.

#include "tests/sweep/sweep_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A motion that ends before its time.
struct Ending {
  const char* name;
  std::vector<std::pair<std::string, std::string>> files;  ///< beside m.json
  std::string model;                                       ///< with a parameter p of 1
  const char* words;                                       ///< duration and step
  const char* hint;                                        ///< begins so
};

void PrintTo(const Ending& ending, std::ostream* out) { *out << ending.name; }

std::string four_bar_with(const char* initial) {
  std::string model = kFourBar;
  const std::size_t at = model.find("\"initial\"");
  return model.replace(at, model.size() - at, std::string("\"parameters\": { \"p\": 1 }, ") + initial + " }");
}

/// A wheel that is pulled over the end of a road which has no height there; a linkage at a step of a third of its turn;
/// a rocker that is driven farther than its crank lets it; a spring whose ends come together.
std::vector<Ending> endings() {
  return {
      {"road",
       {{"short.crg",
         "$ROAD_CRG\nREFERENCE_LINE_INCREMENT = 1\n$\n$ROAD_CRG_OPTS\nBORDER_MODE_U = 0\n$\n$KD_Definition\n#:LRFI\n"
         "D:long section at v = -1,m\nD:long section at v = 1,m\n$$$$\n 0.0000000 0.0000000\n 0.0000000 0.0000000\n"}},
       R"({ "mbgen": 1, "name": "cart", "parameters": { "p": 1 },
         "bodies": { "ground": { "points": { "o": [0.0994, 0, 0.28] } },
           "hub": { "mass": "10 * p", "com": [0.0994, 0, 0.28], "inertia": [1, 1, 1], "points": { "o": [0.0994, 0, 0.28] } } },
         "joints": { "hub": { "type": "prismatic", "from": "ground.o", "to": "hub.o", "axis": "x" } },
         "tyre_data": { "rubber": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000,
           "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 } } },
         "roads": { "short": { "crg": { "file": "short.crg" } } },
         "tyres": { "front": { "centre": "hub.o", "data": "rubber", "stiffness": 1e5, "friction": 0,
           "rolling_resistance": 0 } },
         "initial": { "velocities": { "hub": 3 } } })",
       "--duration 1 --step 1e-3",
       "tyre \"front\" leaves the road \"short\" beyond its end (u = 1.00"},
      {"step",
       {},
       four_bar_with(R"("initial": { "positions": { "crank_pin": 0.6 }, "velocities": { "crank_pin": 60 } })"),
       "--duration 0.6 --step 0.1",
       "step 0.1 s is too long; the fastest mode at the start, "},
      {"reach",
       {},
       four_bar_with(R"("motions": { "drive": { "joint": "rocker_pin", "angle": "-0.5 * t" } })"),
       "--duration 6 --step 1e-2",
       "the lengths in these loops let rocker_pin go no farther: change a length, or its motion"},
      {"ends",
       {},
       R"({ "mbgen": 1, "name": "coin", "parameters": { "p": 1 }, "bodies": { "ground": { "points": { "a": [0, 0, 0] } },
         "m": { "mass": "p", "inertia": [1, 1, 1], "points": { "a": [0, 0, 0], "b": [0, 0, 0] } } },
         "joints": { "slide": { "type": "prismatic", "from": "ground.a", "to": "m.a", "axis": "z" } },
         "springs": { "s": { "from": "ground.a", "to": "m.b", "stiffness": 100, "free_length": 0.1 } } })",
       "--duration 1 --step 1e-2",
       "the ends of spring \"s\" (m.json:4:"}};
}

class Judged : public CommandLine, public ::testing::WithParamInterface<Ending> {};

TEST_P(Judged, ACaseEndsInTheWordsOfSimulate) {
  const Ending& ending = GetParam();
  for (const auto& [file, text] : ending.files) write(file, text);
  write("m.json", ending.model);
  const std::string words = std::string(ending.words) + " --engine generic --out ";
  const Outcome motion = mbgen("simulate m.json " + words + "m.csv");
  ASSERT_EQ(motion.exit_code, 1) << motion.err;
  const std::size_t begin = motion.err.find("stopped after"), hint = motion.err.find("\n  hint: ");
  ASSERT_NE(begin, std::string::npos) << motion.err;
  ASSERT_NE(hint, std::string::npos) << motion.err;
  const std::string status = motion.err.substr(begin, motion.err.find("; m.csv", begin) - begin) + "; " +
                             motion.err.substr(hint + 9, motion.err.find('\n', hint + 1) - hint - 9);
  EXPECT_NE(status.find(std::string("; ") + ending.hint), std::string::npos) << status;

  const Json study = json_of("sweep m.json --vary p=1 --metric 'final(t)' --json " + words + "s.csv");
  EXPECT_EQ(study["cases"][0]["status"], status);
}

INSTANTIATE_TEST_SUITE_P(Endings, Judged, ::testing::ValuesIn(endings()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace mbgen::cli_test
