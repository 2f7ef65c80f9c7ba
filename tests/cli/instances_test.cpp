// Instances: a corner of a car placed, turned and mirrored moves as physics says, and as its image written by hand.
#include <random>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Instances : public CommandLine {
 protected:
  static std::string model(const std::string& name) {
    return kSource + "/tests/data/models/instances/" + name + ".json";
  }

  /// Accelerations and driving forces at the states, projected to the closures, by the generic engine.
  Json evaluated(const std::string& name, const Json& states) {
    write("states.json", Json{{"states", states}}.dump());
    const Outcome outcome = mbgen("evaluate " + model(name) + " --states states.json --engine generic --project");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }

  Table motion(const std::string& name) {
    const Outcome outcome =
        mbgen("simulate " + model(name) + " --engine generic --duration 0.2 --step 1e-3 --out " + name + ".csv");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return table(name + ".csv");
  }
};

/// The column of an output, which has its unit behind.
std::string column_of(const Table& table, const std::string& output) {
  for (const std::string& name : table.names) {
    if (name.starts_with(output + " [")) return name;
  }
  ADD_FAILURE() << "no output " << output;
  return table.names[0];
}

constexpr std::size_t kCoordinates = 7;  // lower_arm, knuckle rz rx ry, wheel, upper_arm, rack

/// The same every time. sign: what the coordinates are multiplied by.
Json states_of(const std::vector<double>& sign, std::size_t corners) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> position(-0.1, 0.1), rate(-2, 2), force(-50, 50);
  Json states = Json::array();
  for (int i = 0; i < 8; ++i) {
    std::vector<double> z, zd, tau;
    for (std::size_t k = 0; k < kCoordinates; ++k) {
      z.push_back(sign[k] * position(random));
      zd.push_back(sign[k] * rate(random));
      tau.push_back(sign[k] * force(random));
    }
    Json state = {{"z", Json::array()}, {"zd", Json::array()}, {"tau", Json::array()}};
    for (std::size_t corner = 0; corner < corners; ++corner) {
      for (std::size_t k = 0; k < kCoordinates; ++k) {
        state["z"].push_back(z[k]);
        state["zd"].push_back(zd[k]);
        state["tau"].push_back(tau[k]);
      }
    }
    states.push_back(state);
  }
  return states;
}

const std::vector<double> kEqual(kCoordinates, 1.0);

/// Largest difference of the accelerations over the largest of each state. sign: of `other`.
double difference(const Json& one, const Json& other, const std::vector<double>& sign = kEqual) {
  double worst = 0;
  EXPECT_EQ(one["states"].size(), other["states"].size());
  for (std::size_t i = 0; i < one["states"].size(); ++i) {
    const Json &a = one["states"][i]["zdd"], &b = other["states"][i]["zdd"];
    double largest = 0, error = 0;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const double value = a[k % a.size()].get<double>();
      largest = std::max(largest, std::abs(value));
      error = std::max(error, std::abs(value - sign[k % kCoordinates] * b[k].get<double>()));
    }
    worst = std::max(worst, error / largest);
  }
  return worst;
}

TEST_F(Instances, MirroredIsTheImageWrittenByHandToTheLastDigit) {
  // knuckle_rz and knuckle_rx turn about the axes of the model in the hand-written image, about mirrored ones in ours.
  const std::vector<double> sign = {1, -1, -1, 1, 1, 1, 1};
  const Json ours = evaluated("right", states_of(kEqual, 1)), by_hand = evaluated("right_by_hand", states_of(sign, 1));
  EXPECT_EQ(difference(ours, by_hand, sign), 0);
  const Table one = motion("right"), other = motion("right_by_hand");
  for (const char* output :
       {"hub_x", "hub_y", "hub_z", "load", "side_force", "steering_force", "spring", "air", "carrier_y", "both"}) {
    for (std::size_t row = 0; row < one.rows.size(); row += 20) {
      const std::string name = column_of(one, output);
      EXPECT_EQ(one.at(row, name), other.at(row, name)) << output << " in row " << row;
    }
  }
}

TEST_F(Instances, EqualCoordinatesAreMirroredMotions) {
  const Json states = states_of(kEqual, 1);
  const Json left = evaluated("left", states);
  // Rounding of closed loops; a wrong sign anywhere gives a relative difference of 1e-3 and more.
  EXPECT_LT(difference(left, evaluated("right", states)), 1e-12);
  EXPECT_LT(difference(left, evaluated("right_by_turning", states)), 1e-12);
  const Table one = motion("left"), other = motion("right");
  for (const char* output : {"hub_x", "hub_z", "load", "steering_force", "spring", "air", "both"}) {
    const std::string name = column_of(one, output);
    EXPECT_NEAR(one.last(name), other.last(name), 1e-9 * std::max(1.0, std::abs(one.last(name)))) << output;
  }
  for (const char* output : {"hub_y", "side_force", "carrier_y"}) {
    const std::string name = column_of(one, output);
    EXPECT_NEAR(one.last(name), -other.last(name), 1e-9 * std::max(1.0, std::abs(one.last(name)))) << output;
  }
}

TEST_F(Instances, TurningAndMovingChangesNothing) {
  const Json states = states_of(kEqual, 1);
  const Json left = evaluated("left", states);
  EXPECT_LT(difference(left, evaluated("turned", states)), 1e-12);
  EXPECT_LT(difference(left, evaluated("turned_skew", states)), 1e-12);
}

TEST_F(Instances, AMirroredPairOfMirroredInstancesMovesAsEachOfThem) {
  const Json left = evaluated("left", states_of(kEqual, 1)), states = states_of(kEqual, 2);
  EXPECT_LT(difference(left, evaluated("pair", states)), 1e-12);
  EXPECT_LT(difference(left, evaluated("pair_mirrored", states)), 1e-12);
}

}  // namespace
}  // namespace mbgen::cli_test
