// A linearisation that is too large is refused with its size, before anything is traced.

#include <fmt/format.h>

#include "compiler/analysis/implicit_operations.hpp"
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

/// A boom of so many segments.
Result<Compilation> boom(int segments, const std::string& integrator) {
  return decide(*read_model(fmt::format(R"({{ "mbgen": 1, "name": "boom", "bodies": {{ "ground": {{}} }},
    "beams": {{ "boom": {{ "segments": {}, "points": {{ "root": [0, 0, 0], "tip": [2, 0, 0] }},
      "section": {{ "shape": "round", "diameter": 0.05 }}, "supports": {{ "root": {{ "body": "ground" }} }} }} }},
    "solver": {{ "integrator": "{}", "step": 1e-3 }} }})",
                                        segments, integrator),
                            "boom.json"));
}

// The equations of an implicit step of a chain are dense; the recursive form of its accelerations is not.
TEST(Sizes, EquationsOfImplicitStepsAreCountedBeforeTheyAreWritten) {
  const Compilation small = *boom(8, "rosenbrock");
  const double counted = implicit_operations(small.model, small.topology, small.analysis, kMostOperations);
  constexpr double kWritten = 48199;  // by the cost sheet
  EXPECT_GT(counted, 0.7 * kWritten);
  EXPECT_LT(counted, 1.2 * kWritten);
  EXPECT_TRUE(too_large(small).empty());
  EXPECT_TRUE(too_large(*boom(40, "rk4")).empty());
  const Diagnostics problems = too_large(*boom(40, "rosenbrock"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("the equations of implicit steps of this model are too large to be written: 240"),
            std::string::npos)
      << problems[0].message;
}

}  // namespace
}  // namespace mbgen
