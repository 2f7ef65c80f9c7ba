// Modes of vehicles by the parts that move in them.

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class ModeNames : public CommandLine {
 protected:
  Json modes(const std::string& model, const std::string& more) const {
    return json_of("linearize " + kSource + "/" + model + " " + more + " --json")["modes"];
  }
};

std::string largest(const Json& mode) {
  std::string name;
  double most = 0;
  for (const auto& [part, share] : mode["participation"].items()) {
    if (share.get<double>() > most) name = part;
    most = std::max(most, share.get<double>());
  }
  return name;
}

// At speed a coach has three modes of its body and two of each axle; wheels spin against their carcasses above 20 Hz.
TEST_F(ModeNames, TheCoachHasEachOfItsModesOnce) {
  const Json list = modes("models/coach_driver.json", "--speed 20 --slowest-first --band 0.5:15");
  std::map<std::string, double> frequency;
  double last = 0;
  for (const Json& mode : list) {
    double sum = 0;
    for (const auto& [part, share] : mode["participation"].items()) sum += share.get<double>();
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_GE(mode["frequency"].get<double>(), last) << "slowest first";
    last = mode["frequency"];
    EXPECT_TRUE(frequency.emplace(largest(mode), last).second) << largest(mode) << " twice";
  }
  for (const char* name : {"heave", "pitch", "roll"}) EXPECT_LT(frequency.at(name), 1.2) << name;
  for (const char* name : {"front hop", "front tramp", "rear hop", "rear tramp"}) {
    EXPECT_GT(frequency.at(name), 8) << name;
    EXPECT_LT(frequency.at(name), 15) << name;
  }
}

// One rigid body on four tyres, its mass nearer to the front: equal springs couple heave and pitch by their distance.
TEST_F(ModeNames, SharesOfABodyOnSpringsAreThoseOfTwoFreedoms) {
  const Json list = modes("tests/data/models/four_wheeler.json", "--at equilibrium");
  const double k = 2 * 2e5, mass = 1204.02, ahead = (2 * 0.01 * 1.1 + 2 * 1.1 - 2 * 1.5) / mass;
  const double a = 1.1 - ahead, b = 1.5 + ahead;
  // Of the body at (0, 0, 0.02), knuckles and wheels about the common centre of mass, 0.0214 m high.
  double inertia = 1600 + 1200 * ahead * ahead + 4 * 0.9;
  for (const double x : {1.1, 1.1, -1.5, -1.5}) inertia += (x - ahead) * (x - ahead) + 0.28 * 0.28;
  const double zz = 2 * k / mass, zp = k * (b - a) / mass, pz = k * (b - a) / inertia,
               pp = k * (a * a + b * b) / inertia;
  const double mean = (zz + pp) / 2, root = std::sqrt((zz - pp) * (zz - pp) / 4 + zp * pz);
  for (const double square : {mean - root, mean + root}) {
    const double slope = (square - zz) / zp;  // pitch over heave
    const double heave = mass / (mass + inertia * slope * slope);
    const auto nearest = std::ranges::min_element(list, {}, [&](const Json& mode) {
      return std::abs(mode["undamped_frequency"].get<double>() - std::sqrt(square) / (2 * M_PI));
    });
    EXPECT_NEAR((*nearest)["participation"]["heave"].get<double>(), heave, 0.02);
    EXPECT_NEAR((*nearest)["participation"]["pitch"].get<double>(), 1 - heave, 0.02);
  }
}

TEST_F(ModeNames, TextsNameThePartsAndBandsAreChecked) {
  const std::string car = kSource + "/tests/data/models/four_wheeler.json";
  const Outcome listed = mbgen("linearize " + car + " --at equilibrium --band 3:6");
  EXPECT_NE(listed.out.find("   roll "), std::string::npos) << listed.out;
  EXPECT_NE(mbgen("linearize " + car + " --band 3").err.find("--band: \"3\" is no range of frequencies\n"),
            std::string::npos);
  write("pendulum.json", kPendulum);
  EXPECT_FALSE(json_of("linearize pendulum.json --json")["modes"][0].contains("participation"));
}

}  // namespace
}  // namespace mbgen::cli_test
