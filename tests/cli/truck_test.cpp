// The truck on the road: counts, static equilibrium, slalom, engines side by side, wheels that leave the road.

#include <cmath>
#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const std::string kModels = std::string(MBGEN_SOURCE_DIR) + "/models/";
const std::string kTruck = kModels + "truck.json";
constexpr double kTruckMass = 39250;  // kg, all bodies and rods of ../shared/reference/truck.json

using Names = std::vector<std::string>;

const Names kLeftWheels = {"load1_left [N]", "load2_left [N]", "load3_left [N]", "load4_left [N]", "load5_left [N]"};
const Names kRightWheels = {"load1_right [N]", "load2_right [N]", "load3_right [N]", "load4_right [N]",
                            "load5_right [N]"};

double sum(const Table& run, std::size_t row, const Names& columns) {
  double total = 0;
  for (const std::string& name : columns) total += run.at(row, name);
  return total;
}

double smallest(const Table& run, const Names& columns) {
  double least = run.at(0, columns[0]);
  for (std::size_t row = 0; row < run.rows.size(); ++row)
    for (const std::string& name : columns) least = std::min(least, run.at(row, name));
  return least;
}

double largest_absolute(const Table& run, const std::string& column) {
  double most = 0;
  for (std::size_t row = 0; row < run.rows.size(); ++row) most = std::max(most, std::abs(run.at(row, column)));
  return most;
}

/// Time of the largest value.
double time_of_peak(const Table& run, const std::string& column) {
  std::size_t peak = 0;
  for (std::size_t row = 0; row < run.rows.size(); ++row)
    if (run.at(row, column) > run.at(peak, column)) peak = row;
  return run.rows[peak][0];
}

/// Sum of all "mass" values of a model file and of the subsystems that it places, read without mbgen.
double mass_of(const std::string& file) {
  const Json model = Json::parse(std::ifstream(file), nullptr, true, true);
  double total = 0;
  for (const char* group : {"bodies", "rods"})
    for (const Json& one : model.value(group, Json::object())) total += one.value("mass", 0.0);
  for (const Json& one : model.value("instances", Json::object()))
    total += mass_of((std::filesystem::path(file).parent_path() / one["file"].get<std::string>()).string());
  return total;
}

/// The truck at the speed of the slalom, thrown over to its right: all of it turns about x at this rate, rad/s.
std::string kicked_truck(double roll_rate) {
  std::stringstream text;
  text << std::ifstream(kTruck).rdbuf();
  std::string model = text.str();
  const auto replace = [&model](const std::string& from, const std::string& to) {
    const std::size_t at = model.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    model.replace(at, from.size(), to);
  };
  replace("\"frame_tx\": \"speed\"", fmt::format("\"frame_tx\": \"speed\", \"frame_rx\": {}", roll_rate));
  for (const char* file : {"\"truck_mechanism.json", "\"tyres/", "\"parts/"}) {
    for (std::size_t at = 0; (at = model.find(file, at)) != std::string::npos; at += kModels.size())
      model.insert(at + 1, kModels);
  }
  return model;
}

// The numbers of the paper's truck.
TEST_F(CommandLine, TruckHasThePapersCounts) {
  for (const auto& [file, driven] : {std::pair{"truck_mechanism.json", 0}, std::pair{"truck.json", 1}}) {
    const Json found = json_of("inspect " + kModels + file + " --json");
    EXPECT_EQ(found["bodies"], 81) << file;
    EXPECT_EQ(found["massless_bodies"], 34) << file;
    EXPECT_EQ(found["joints"], 89) << file;
    EXPECT_EQ(found["cut_joints"], 9) << file;
    EXPECT_EQ(found["relative_coordinates"], 80) << file;
    EXPECT_EQ(found["constraint_equations"], 51) << file;
    EXPECT_EQ(found["independent_equations"], 40) << file;
    EXPECT_EQ(found["degrees_of_freedom"], 40) << file;
    EXPECT_EQ(found["driven_coordinates"], driven) << file;
  }
}

TEST_F(CommandLine, TruckStandsOnItsWheelsCloseToTheReference) {
  EXPECT_DOUBLE_EQ(mass_of(kModels + "truck_mechanism.json"), kTruckMass);
  ASSERT_EQ(mbgen("simulate " + kTruck + " --duration 1e-3 --step 1e-3 --engine generic --out rest.csv").exit_code, 0);
  const Table start = table("rest.csv");
  const double weight = sum(start, 0, kLeftWheels) + sum(start, 0, kRightWheels);
  EXPECT_NEAR(weight, kTruckMass * 9.81, 1e-9 * kTruckMass * 9.81);
  EXPECT_LT(start.at(0, "residual [m]"), 1e-10);
  for (int axle = 1; axle <= 5; ++axle)
    EXPECT_LT(std::abs(start.at(0, fmt::format("z.axle{}_tz [m]", axle))), 0.003) << "axle " << axle;
  for (const char* held :
       {"cab_lower_arm", "seat_arm_left", "seat_arm_right", "lift_arm", "knuckle_left", "trailer_rx"})
    EXPECT_LT(std::abs(start.at(0, fmt::format("z.{} [rad]", held))), 0.001) << held;
}

TEST_F(CommandLine, TruckDrivesItsSlalomAndEnginesAgreeOnItsStart) {
  ASSERT_EQ(mbgen("simulate " + kTruck + " --duration 5 --step 1e-3 --every 5 --out slalom.csv").exit_code, 0);
  const Table run = table("slalom.csv");
  EXPECT_EQ(run.rows.size(), 1001u);
  for (const char* body : {"tractor", "trailer"}) {
    const double lateral = largest_absolute(run, fmt::format("lateral_acceleration_{} [m/s^2]", body));
    EXPECT_GT(lateral, 2) << body;
    EXPECT_LT(lateral, 2.6) << body;
  }
  EXPECT_LT(largest_absolute(run, "roll_trailer [rad]"), 3 * std::numbers::pi / 180);
  EXPECT_LT(largest_absolute(run, "residual [m]"), 1e-10);
  EXPECT_GT(std::min(smallest(run, kLeftWheels), smallest(run, kRightWheels)), 15000);
  const double lag = time_of_peak(run, "yaw_rate_trailer [rad/s]") - time_of_peak(run, "yaw_rate_tractor [rad/s]");
  EXPECT_GT(lag, 0.3);
  EXPECT_LT(lag, 0.7);

  for (const char* engine : {"generated", "generic"})
    ASSERT_EQ(
        mbgen(fmt::format("simulate {} --duration 0.5 --step 1e-3 --engine {} --out {}.csv", kTruck, engine, engine))
            .exit_code,
        0);
  expect_same_motion(table("generic.csv"), table("generated.csv"), 1e-9);
}

// The semitrailer's left wheels leave the road and come down again: no force while they are up, no energy out of
// nothing.
TEST_F(CommandLine, WheelsOfTheTruckLeaveTheRoadAndComeBack) {
  const std::string model = write("kicked.json", kicked_truck(0.8));
  const Json found =
      json_of("simulate " + model + " --duration 0.35 --step 1e-3 --engine generic --out kicked.csv --json");
  const Table run = table("kicked.csv");
  const double speed = run.at(0, "zd.frame_tx [m/s]");
  EXPECT_LT(std::abs(found["energy_error"].get<double>()), 1e-8 * 0.5 * kTruckMass * speed * speed);
  for (const char* wheel : {"load4_left [N]", "load5_left [N]"}) {
    EXPECT_EQ(smallest(run, {wheel}), 0) << wheel;
    EXPECT_GT(run.at(0, wheel), 30000) << wheel;
    EXPECT_GT(run.last(wheel), 10000) << wheel;
  }
  EXPECT_GT(smallest(run, kRightWheels), 15000);
  EXPECT_LT(largest_absolute(run, "residual [m]"), 1e-10);
}

}  // namespace
}  // namespace mbgen::cli_test
