// mbgen fit on a coach: eight values from three runs, and from curves of kinematics and compliance alone. Data are made
// by the model itself with other values, and noise.

#include <random>

#include "tests/fit/fit_support.hpp"

namespace mbgen::cli_test {
namespace {

/// Standard normal numbers, the same on every machine (Box and Muller's).
class Noise {
 public:
  double next() {
    const double radius = std::sqrt(-2 * std::log(share())), angle = 2 * std::acos(-1.0) * share();
    return radius * std::cos(angle);
  }

 private:
  double share() { return (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 bits_{1};
};

/// A column of data: its heading, and the standard deviation of its noise.
struct NoisyColumn {
  std::string heading;
  double sigma = 0;
};

/// True values by name.
using Truth = std::vector<std::pair<std::string, double>>;

class CoachFit : public Fit {
 protected:
  static std::string settings_of(const Truth& truth) {
    std::string text;
    for (const auto& [name, value] : truth) text += fmt::format(" --set {}={}", name, value);
    return text;
  }

  static std::string free_of(const Truth& truth) {
    std::string text = " --free ";
    for (const auto& [name, value] : truth) text += (text.ends_with(' ') ? "" : ",") + name;
    return text;
  }

  /// Writes columns of a table with noise.
  void write_noisy(const std::string& from, const std::string& to, const std::vector<NoisyColumn>& columns,
                   Noise& noise) const {
    const Table exact = table(from);
    std::string text;
    for (const NoisyColumn& column : columns) text += (text.empty() ? "" : ",") + column.heading;
    for (std::size_t row = 0; row < exact.rows.size(); ++row) {
      text += "\n";
      for (const NoisyColumn& column : columns) {
        const double value = exact.at(row, column.heading) + (column.sigma > 0 ? column.sigma * noise.next() : 0);
        text += fmt::format("{}{}", &column == &columns.front() ? "" : ",", value);
      }
    }
    write(to, text + "\n");
  }

  /// Fits, kills it in the middle and lets it go on: the same bytes. Every value lies within two standard errors of the
  /// true one, and the sum of squares within five deviations of its expectation.
  void expect_recovered(const std::string& words, const Truth& truth) {
    const Outcome whole = mbgen(words + " --json -o whole.json");
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    const Json result = Json::parse(whole.out);
    EXPECT_TRUE(result["converged"]);
    for (const auto& [name, value] : truth) {
      const auto found = std::ranges::find_if(result["unknowns"], [&](const Json& one) { return one["name"] == name; });
      ASSERT_NE(found, result["unknowns"].end()) << name;
      const double error = (*found)["standard_error"];
      EXPECT_LT(std::abs((*found)["value"].get<double>() - value), 2 * error) << name;
      EXPECT_LT(error, 0.05 * std::abs(value)) << name;
    }
    const double freedoms = result["values"].get<double>() - static_cast<double>(truth.size());
    EXPECT_NEAR(result["sum_of_squares"].get<double>(), freedoms, 5 * std::sqrt(2 * freedoms));
    const std::string journal = read("whole.json.journal");
    write("half.json.journal", journal.substr(0, journal.size() / 2));
    const Outcome rest = mbgen(words + " --json -o half.json");
    EXPECT_EQ(rest.out, whole.out) << rest.err;
    EXPECT_NE(rest.err.find("evaluations were done before"), std::string::npos) << rest.err;
  }
};

/// The coach with its axles and helper springs, its sprung mass and where that lies as parameters.
std::string measured_coach() {
  return fmt::format(R"({{ "mbgen": 1, "name": "measured_coach",
  "include": [{{ "file": "{}/models/axles/coach.json",
    "replace": {{ "/bodies/chassis/mass": "sprung_mass", "/bodies/chassis/com/0": "mass_x" }} }}],
  "parameters": {{ "sprung_mass": {{ "value": 13500, "unit": "kg" }}, "mass_x": {{ "value": -3.6, "unit": "m" }},
    "helper_front": {{ "value": 30e3, "unit": "N/m" }}, "helper_rear": {{ "value": 40e3, "unit": "N/m" }} }},
  "springs": {{
    "helper_front_left": {{ "from": "chassis.air_front_2_left", "to": "lower_arm_left.air_2", "stiffness": "helper_front" }},
    "helper_front_right": {{ "from": "chassis.air_front_2_right", "to": "lower_arm_right.air_2", "stiffness": "helper_front" }},
    "helper_rear_left": {{ "from": "chassis.air_rear_2_left", "to": "rear_axle.air_2_left", "stiffness": "helper_rear" }},
    "helper_rear_right": {{ "from": "chassis.air_rear_2_right", "to": "rear_axle.air_2_right", "stiffness": "helper_rear" }} }} }})",
                     kSource);
}

TEST_F(CoachFit, FindsEightValuesFromCurvesOfItsAxles) {
  write("coach.json", measured_coach());
  const Truth truth = {{"air_pressure_front", 700e3}, {"air_pressure_rear", 690e3}, {"bar_front", 9000},
                       {"bar_rear", 12500},           {"sprung_mass", 13900},       {"mass_x", -3.55},
                       {"helper_front", 26e3},        {"helper_rear", 47e3}};
  Noise noise;
  std::string files;
  for (const std::string axle : {"front", "rear"}) {
    ASSERT_EQ(mbgen("kc coach.json " + axle + " -o rig" + settings_of(truth)).exit_code, 0);
    for (const std::string curve : {"parallel_travel", "opposite_travel"}) {
      std::vector<NoisyColumn> columns = {{"travel [m]"}};
      for (const std::string side : {"left", "right"}) {
        columns.push_back({"load_" + side + " [N]", 30});
        columns.push_back({"camber_" + side + " [rad]", 5e-5});
        if (axle == "front") columns.push_back({"toe_" + side + " [rad]", 5e-5});
      }
      const std::string file = axle + "_" + curve + ".csv";
      write_noisy("rig/" + file, file, columns, noise);
      files += (files.empty() ? "" : ",") + file;
    }
  }
  std::string match;
  for (const std::string side : {"left", "right"})
    match += fmt::format(
        "{0}kc:front:load_{1}:30,kc:front:camber_{1}:5e-5,kc:front:toe_{1}:5e-5,kc:rear:load_{1}:30,"
        "kc:rear:camber_{1}:5e-5",
        match.empty() ? "" : ",", side);
  // The bounds of a position that is negative have to be given.
  std::string free = free_of(truth);
  free.replace(free.find("mass_x"), 6, "mass_x=-5:-2");
  expect_recovered("fit coach.json --data " + files + " --match " + match + free, truth);
}

TEST_F(CoachFit, FindsEightValuesFromThreeRuns) {
  const Truth truth = {{"air_pressure_front", 700e3}, {"air_pressure_rear", 690e3}, {"bar_front", 9000},
                       {"bar_rear", 12500},           {"drag_area", 5.5},           {"drive_gain", 4600},
                       {"steer_amplitude", 0.13},     {"steer_frequency", 0.41}};
  const std::string coach = kSource + "/models/coach.json";
  ASSERT_EQ(mbgen("simulate " + coach + " --duration 10 --every 10 --out exact.csv" + settings_of(truth)).exit_code, 0);
  const std::vector<NoisyColumn> columns = {{"t [s]"},
                                            {"lateral_acceleration [m/s^2]", 0.05},
                                            {"roll [rad]", 1e-3},
                                            {"yaw_rate [rad/s]", 5e-3},
                                            {"forward_speed [m/s]", 0.05},
                                            {"load_front_left [N]", 300}};
  Noise noise;
  std::string files;
  for (const std::string file : {"one.csv", "two.csv", "three.csv"}) {
    write_noisy("exact.csv", file, columns, noise);
    files += (files.empty() ? "" : ",") + file;
  }
  expect_recovered("fit " + coach + " --data " + files +
                       " --match lateral_acceleration:0.05,roll:1e-3,yaw_rate:5e-3,forward_speed:0.05,"
                       "load_front_left:300" +
                       free_of(truth),
                   truth);
}

}  // namespace
}  // namespace mbgen::cli_test
