// mbgen optimise: ends that are no least, which must not be ok.

#include "tests/optimise/optimise_support.hpp"

namespace mbgen::cli_test {
namespace {

class OptimiseEnds : public Optimise {
 protected:
  void SetUp() override {
    Optimise::SetUp();
    if (IsSkipped()) return;
    write("ends.json", R"({ "mbgen": 1, "name": "ends", "include": ["forms.json"], "solver": { "duration": 0.01 },
      "outputs": {
      "p": { "unit": "m", "expression": "p" }, "saddle": { "unit": "m^2", "expression": "p*q" },
      "hidden": { "unit": "1", "expression": "1e6*p + (q - 1)^2" },
      "edge": { "unit": "m^2", "expression": "max((p - 1)^2 + (q - 2)^2, (p - 3)^2 + q*q + 1) + 0" },
      "wall": { "unit": "1", "expression": "(p - 1)^2 + 1e10*max(0, p - 1.5)^4" } } })");
  }
  Json found(const std::string& words) { return json_of("optimise ends.json --json " + words); }
};

TEST_F(OptimiseEnds, WideBoundsHoldNoValueBetweenThem) {
  const Json stopped = found("--free p=1e-9:0.4:1e9 --set q=1 --goal min:start:bowl --evaluations 1");
  EXPECT_EQ(stopped["variables"][0]["at_bound"], "");
  EXPECT_NE(stopped["status"], "ok");
  const Json result = found("--free p=1e-9:0.4:1e9 --set q=1 --goal min:start:bowl");
  EXPECT_EQ(result["status"], "ok");
  EXPECT_NEAR(value_of(result, "p"), 2, 1e-6);
}

TEST_F(OptimiseEnds, ASteepStartHidesNoSlopeOfTheResult) {
  for (const char* method : {"slsqp", "mma", "cobyla"}) {
    const Json result = found(std::string("--free p=0:2:3 --goal min:start:wall --method ") + method);
    EXPECT_EQ(result["status"], "ok") << method;
    EXPECT_NEAR(value_of(result, "p"), 1, 1e-4) << method;
  }
  const std::string words = "--free p=0:0.5:1,q=-3:0:3 --goal min:start:hidden";
  EXPECT_NE(found(words + " --evaluations 2")["status"], "ok");
  const Json whole = found(words);
  EXPECT_EQ(whole["status"], "ok");
  EXPECT_NEAR(value_of(whole, "q"), 1, 1e-4);
}

TEST_F(OptimiseEnds, AStationaryStartThatIsNoLeastIsLeft) {
  const Json top = found("--free p=1:2:3 --set q=1 --goal max:start:bowl");
  EXPECT_EQ(top["status"], "ok");
  EXPECT_NEAR(top["goals"][0]["value"].get<double>(), 1, 1e-9);
  const Json saddle = found("--free p=-1:0:1,q=-1:0:1 --goal min:start:saddle");
  EXPECT_NEAR(saddle["goals"][0]["value"].get<double>(), -1, 1e-9);
  // On the circle p = 1 is stationary, and the largest.
  const Json circle = found("--free p=-2:0.5:2,q=-2:0:2 --goal min:start:p --constraint start:near==1");
  EXPECT_EQ(circle["status"], "ok");
  EXPECT_NEAR(value_of(circle, "p"), -1, 1e-5);
  // The least itself as start is not told from other stationary ones.
  EXPECT_EQ(found("--free p=0:2:3 --set q=1 --goal min:start:bowl")["status"], "doubted, see the warnings");
}

// Two bowls of equal height on q = p - 1.25, where their sum of gradients falls to (p - 1) = (3.25 - p): the least of
// the higher one is 2 * 1.125^2 at p = 2.125. With p <= 2 it is
// 1 + 1.25^2, and falls by 1/2 per m. Derivatives are differences over 1e-4 of the variables, which tell no more, and
// multipliers from a few thousandths beside.
TEST_F(OptimiseEnds, ACornerWhereGradientsCancelIsAnEnd) {
  const std::string words = "--free p=-5:0.4:5,q=-5:0.6:5 --goal min:start:edge";
  const Json corner = found(words);
  EXPECT_EQ(corner["status"], "ok") << corner;
  EXPECT_NEAR(value_of(corner, "p"), 2.125, 1e-3);
  EXPECT_NEAR(value_of(corner, "q"), 0.875, 1e-3);
  EXPECT_NEAR(corner["goals"][0]["value"].get<double>(), 2.53125, 1e-4);
  const Json bounded = found("--free p=-5:0.4:2,q=-5:0.6:5 --goal min:start:edge:1");
  EXPECT_EQ(bounded["status"], "ok") << bounded;
  EXPECT_NEAR(bounded["goals"][0]["value"].get<double>(), 2.5625, 1e-4);
  EXPECT_NEAR(entry(bounded, "variables", "p")["goal_per_unit"].get<double>(), -0.5, 5e-3);
  // Too few evaluations to come there.
  EXPECT_NE(found(words + " --evaluations 3")["status"], "ok");
}

// The same corner under p <= 2, and on the circle p^2 + q^2 = 4: there p (2 p - 2.5) = 4 - 1.25^2, and the sum of the
// components of both conditions gives the multiplier 3 / (p + q) - 1.
TEST_F(OptimiseEnds, ACornerUnderAConstraintIsAnEndAndHasMultipliers) {
  const double p = (2.5 + std::sqrt(25.75)) / 4, q = p - 1.25, multiplier = 3 / (p + q) - 1;
  const auto expect_end = [&](const std::string& goal, const std::string& limited, const std::string& limit,
                              double value, double falls, double tolerance, double part) {
    const Json end =
        found("--free p=-5:0.4:5,q=-5:0.6:5 --goal 'min:" + goal + ":1' --constraint '" + limited + limit + "'");
    EXPECT_EQ(end["status"], "ok") << end;
    EXPECT_NEAR(end["goals"][0]["value"].get<double>(), value, tolerance) << limited << limit;
    EXPECT_NEAR(end["constraints"][0]["goal_per_unit"].get<double>(), -falls, part * falls) << limited << limit;
  };
  const double on_circle = std::pow(p - 1, 2) + std::pow(q - 2, 2);
  for (const char* limit : {"<=4", "==4"}) {
    expect_end("start:edge", "start:near", limit, on_circle, multiplier, 1e-4, 1e-2);
    // Of motions derivatives are exact.
    expect_end("mean(edge)", "mean(near)", limit, on_circle, multiplier, 1e-6, 1e-4);
  }
  expect_end("start:edge", "start:p", "<=2", 2.5625, 0.5, 1e-4, 1e-2);
  expect_end("mean(edge)", "mean(p)", "<=2", 2.5625, 0.5, 1e-6, 1e-4);
}

TEST_F(OptimiseEnds, EqualitiesMayRepeatEachOther) {
  const Json result =
      found("--free p=-2:0.5:2,q=-2:0.1:2 --goal min:start:bowl:1 --constraint start:sum==1,start:sum==1");
  EXPECT_EQ(result["status"], "ok");
  EXPECT_NEAR(value_of(result, "p"), 1, 1e-6);
  EXPECT_NEAR(value_of(result, "q"), 0, 1e-6);
  const Json more = found(
      "--free p=-2:0.5:2,q=-2:0.1:2 --goal min:start:near --constraint "
      "start:p==1,start:p==1,start:sum==2,start:near==2");
  EXPECT_EQ(more["status"], "ok");
  EXPECT_NEAR(value_of(more, "q"), 1, 1e-6);
}

}  // namespace
}  // namespace mbgen::cli_test
