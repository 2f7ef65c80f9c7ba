// A linearisation that is too large is refused with its size, before anything is traced.

#include "compiler/compile.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

// A link without mass keeps the ring from being opened.
TEST(Sizes, ARingOfThreeHundredJointsIsTooLargeForASolver) {
  EXPECT_TRUE(too_large(*decide(*grown("spatial-ring", 300))).empty());
  const Result<Compilation> decided =
      decide(*grown("spatial-ring", 300, R"(sed '/"link9"/s/"mass": 1, .*/"mass": 0,/')"));
  ASSERT_TRUE(decided) << to_text(decided.problems());
  const Diagnostics problems = too_large(*decided);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message,
            "the solver of this model is too large to be written: 299 coordinates with 294 free directions take at "
            "least 8.5e+06 operations, at most 2.1e+06 are written");
}

TEST(Sizes, AFormThatIsTooLargeNamesTheOther) {
  const Result<Compilation> decided = decide(*grown("chain", 200));
  ASSERT_TRUE(decided) << to_text(decided.problems());
  EXPECT_TRUE(too_large(*decided).empty());
  EXPECT_TRUE(too_large(*decided, Form::recursive).empty());
  const Diagnostics problems = too_large(*decided, Form::matrix);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("the matrix form of this model is too large"), std::string::npos);
  EXPECT_EQ(problems[0].hint, "--form recursive is smaller");
}

}  // namespace
}  // namespace mbgen
