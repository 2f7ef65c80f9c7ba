// mbgen fit --free NAME=physical: an inertia stays one of a body where the data ask for another.

#include <Eigen/Dense>

#include "tests/fit/fit_support.hpp"

namespace mbgen::cli_test {
namespace {

constexpr const char* kEntries[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
constexpr int kRow[] = {0, 1, 2, 0, 0, 1}, kColumn[] = {0, 1, 2, 1, 2, 2};

/// Three bodies of one inertia, on three hinges each, driven from rest with 1 rad/s^2 about x, y and z in turn: the
/// torques at the start are the columns of the inertia. with_products: all entries are parameters.
std::string driven_bodies(bool with_products) {
  std::string bodies = R"("ground": { "points": { "O": [0, 0, 0] } })", joints, motions, outputs;
  for (int b = 0; b < 3; ++b) {
    std::string parent = "ground";
    for (int axis = 0; axis < 3; ++axis) {
      const char letter = "xyz"[axis];
      const std::string name = fmt::format("b{}{}", b, letter);
      bodies += fmt::format(R"(, "{}": {{ "mass": {}, "inertia": [{}], "points": {{ "O": [0, 0, 0] }} }})", name,
                            axis == 2 ? 1 : 0,
                            axis < 2        ? "0, 0, 0"
                            : with_products ? R"("xx", "yy", "zz", "xy", "xz", "yz")"
                                            : R"("xx", "yy", "zz")");
      joints += fmt::format(R"({}"j{}{}": {{ "type": "revolute", "from": "{}.O", "to": "{}.O", "axis": "{}" }})",
                            joints.empty() ? "" : ", ", b, letter, parent, name, letter);
      motions += fmt::format(R"({}"m{}{}": {{ "joint": "j{}{}", "angle": "{}*t*t" }})", motions.empty() ? "" : ", ", b,
                             letter, b, letter, axis == b ? 0.5 : 0.0);
      outputs += fmt::format(R"({}"T{}{}": {{ "unit": "N m", "motion": "m{}{}" }})", outputs.empty() ? "" : ", ", b,
                             letter, b, letter);
      parent = name;
    }
  }
  return fmt::format(R"({{ "mbgen": 1, "name": "driven", "gravity": [0, 0, 0],
    "parameters": {{ "xx": {{ "value": 2 }}, "yy": {{ "value": 2.5 }}, "zz": {{ "value": 3 }}, "xy": {{ "value": 0 }},
      "xz": {{ "value": 0 }}, "yz": {{ "value": 0 }} }},
    "bodies": {{ {} }}, "joints": {{ {} }}, "motions": {{ {} }}, "outputs": {{ {} }} }})",
                     bodies, joints, motions, outputs);
}

std::string targets_of(const Eigen::Matrix3d& inertia) {
  std::string text = " --target ";
  for (int b = 0; b < 3; ++b)
    for (int axis = 0; axis < 3; ++axis)
      text += fmt::format("{}start:T{}{}={}:0.01", b + axis == 0 ? "" : ",", b, "xyz"[axis], inertia(axis, b));
  return text;
}

class PhysicalInertia : public Fit {
 protected:
  void expect_found(const Json& result, const Eigen::Matrix3d& inertia, int entries, double tolerance) {
    EXPECT_TRUE(result["converged"]);
    for (int i = 0; i < entries; ++i) {
      const Json& unknown = result["unknowns"][static_cast<std::size_t>(i)];
      EXPECT_EQ(unknown["name"], kEntries[i]);
      EXPECT_NEAR(unknown["value"].get<double>(), inertia(kRow[i], kColumn[i]), tolerance) << kEntries[i];
    }
  }
};

const std::string kThree = "fit driven.json --json --free xx=physical,yy=physical,zz=physical";

TEST_F(PhysicalInertia, WithinItsLimitsIsTheOneOfTheData) {
  write("driven.json", driven_bodies(true));
  Eigen::Matrix3d inertia;
  inertia << 2.2, -0.3, 0.2, -0.3, 1.9, 0.4, 0.2, 0.4, 2.6;
  const Json result = json_of(kThree + ",xy=physical,xz=physical,yz=physical" + targets_of(inertia));
  expect_found(result, inertia, 6, 1e-7);
  EXPECT_TRUE(result["warnings"].empty()) << result["warnings"];
  // Each product stands in two torques.
  EXPECT_NEAR(result["unknowns"][0]["standard_error"].get<double>(), 0.01, 1e-6);
  EXPECT_NEAR(result["unknowns"][3]["standard_error"].get<double>(), 0.01 / std::sqrt(2.0), 1e-6);
}

// The nearest inertia of a body to diag(1, 1, 3), by the sum of squares of all entries: with s the second moments,
// minimise (d1 + d2 + d3)^2 + d1^2 + d2^2 + d3^2 from s = (1.5, 1.5, -0.5) to s >= 0: d = (-1/6, -1/6, 1/2), inertia
// diag(4/3, 4/3, 8/3), squares 1/3. Both the sum and the limit are the same in turned axes.
TEST_F(PhysicalInertia, BeyondThemIsTheNearestAndSaysSo) {
  const Eigen::Vector3d asked(1, 1, 3), nearest(4.0 / 3, 4.0 / 3, 8.0 / 3);
  write("driven.json", driven_bodies(false));
  const Json three = json_of(kThree + targets_of(asked.asDiagonal()));
  expect_found(three, nearest.asDiagonal(), 3, 1e-6);
  EXPECT_NEAR(three["sum_of_squares"].get<double>(), 1e4 / 3, 1e-2);
  ASSERT_EQ(three["warnings"].size(), 1u);
  EXPECT_TRUE(three["warnings"][0].get<std::string>().starts_with(
      "the inertia of b0z is at the limit of bodies, where a principal moment is the sum of the two "
      "others: the data pull it beyond"))
      << three["warnings"];

  write("driven.json", driven_bodies(true));
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  const Json six = json_of(kThree + ",xy=physical,xz=physical,yz=physical" +
                           targets_of(turn * asked.asDiagonal() * turn.transpose()));
  expect_found(six, turn * nearest.asDiagonal() * turn.transpose(), 6, 1e-6);
  EXPECT_EQ(six["warnings"].size(), 1u);
}

// Between bounds the search stops before values that no body has, at no end.
TEST_F(PhysicalInertia, BoundsAloneDoNotComeToAnEndThere) {
  write("driven.json", driven_bodies(false));
  const Json result =
      json_of("fit driven.json --json --free xx,yy,zz" + targets_of(Eigen::Vector3d(1, 1, 3).asDiagonal()));
  EXPECT_FALSE(result["converged"]);
  ASSERT_FALSE(result["warnings"].empty());
  EXPECT_NE(result["warnings"].back().get<std::string>().find("inertia breaks the triangle inequality"),
            std::string::npos)
      << result["warnings"];
}

TEST_F(PhysicalInertia, NeedsAllEntriesOfABody) {
  write("driven.json", driven_bodies(true));
  const Outcome run =
      mbgen("fit driven.json --free xx=physical,yy=physical,zz" + targets_of(Eigen::Matrix3d::Identity()));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(
      run.err.rfind("--free xx=physical: belongs to no inertia whose entries are all found\n  hint: make each", 0), 0u)
      << run.err;
}

}  // namespace
}  // namespace mbgen::cli_test
