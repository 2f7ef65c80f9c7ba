// Decisions as bytes are those that they were made of, to the last bit.

#include "compiler/analysis/analysis_bytes.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

TEST(AnalysisBytes, GiveTheSameDecisions) {
  for (const char* model : {"models/truck.json", "models/agile_eye.json", "models/slider_crank.json",
                            "models/pendulum.json", "models/rolling_disc.json"}) {
    const Analysis analysis = load(model).analysis;
    const std::string bytes = bytes_of(analysis);
    const std::optional<Analysis> again = analysis_of_bytes(bytes);
    ASSERT_TRUE(again) << model;
    EXPECT_EQ(bytes_of(*again), bytes) << model;
    EXPECT_EQ(again->driven, analysis.driven) << model;
    ASSERT_EQ(again->blocks.size(), analysis.blocks.size()) << model;
    for (std::size_t b = 0; b < analysis.blocks.size(); ++b) {
      EXPECT_EQ(again->blocks[b].dependent, analysis.blocks[b].dependent) << model;
      EXPECT_EQ(again->blocks[b].quasi.independent, analysis.blocks[b].quasi.independent) << model;
      EXPECT_EQ(again->blocks[b].certificate.smallest_kept, analysis.blocks[b].certificate.smallest_kept) << model;
      EXPECT_EQ(again->blocks[b].redundant_names, analysis.blocks[b].redundant_names) << model;
      EXPECT_EQ(again->blocks[b].candidates.size(), analysis.blocks[b].candidates.size()) << model;
    }
  }
}

TEST(AnalysisBytes, AreNothingWhenTheyAreOfSomethingElse) {
  const std::string bytes = bytes_of(load("models/slider_crank.json").analysis);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(analysis_of_bytes(std::string_view(bytes).substr(0, length))) << length;
  EXPECT_FALSE(analysis_of_bytes(bytes + '\0'));
  EXPECT_FALSE(analysis_of_bytes(std::string(bytes.size(), '\xff')));
}

}  // namespace
}  // namespace mbgen
