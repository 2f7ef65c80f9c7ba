// Characteristics of many points in every force element, by every engine: the motion is that of the same laws written
// as numbers and expressions.

#include <functional>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

using Function = std::function<double(double)>;

class LargeTables : public CommandLine {
 protected:
  /// A file of points of a function and the table over them. ragged: at places that wander by so much of their
  /// distance.
  std::string table_of(const Function& f, double from, double to, const std::string& more, double ragged,
                       int count = 1001) {
    const std::string name = fmt::format("law{}.csv", files_++);
    std::string text = "x,y\n";
    for (int i = 0; i < count; ++i) {
      const double wander = i == 0 || i == count - 1 ? 0 : ragged * std::sin(7.0 * i);
      const double x = from + (to - from) * (i + wander) / (count - 1);
      text += fmt::format("{},{}\n", x, f(x));
    }
    write(name, text);
    return fmt::format(R"({{ "csv": "{}"{} }})", name, more);
  }

 private:
  int files_ = 0;
};

constexpr const char* kSplined = R"(, "interpolation": "spline")";

/// The laws of a mechanism, as they stand in its text.
struct Laws {
  std::string coil, damper, detent, rubber, rubbing, stop, area, volume, gear;
};

/// Two sliders and a wheel, a block in rubber, geared by a cubic; every element has a law.
std::string mechanism(const Laws& laws) {
  return R"({ "mbgen": 1, "name": "tabled", "gravity": [0, 0, -9.81],
  "bodies": {
    "ground": { "points": { "O": [0, 0, 0], "top": [0, 0, 0.8], "low": [0.1, 0, -0.7], "axle": [0, 1, 0] } },
    "slider": { "mass": 3, "inertia": [0.1, 0.1, 0.1], "points": { "O": [0, 0, 0] } },
    "wheel": { "pose": { "origin": [0, 1, 0] }, "mass": 1, "com": [0.05, 0, 0], "inertia": [0.02, 0.03, 0.02],
               "points": { "O": [0, 0, 0] } },
    "block": { "mass": 1, "inertia": [0.02, 0.03, 0.04], "points": { "O": [0, 0, 0] } } },
  "joints": {
    "slide": { "type": "prismatic", "from": "ground.O", "to": "slider.O", "axis": "z" },
    "turn": { "type": "revolute", "from": "ground.axle", "to": "wheel.O", "axis": "y" },
    "loose": { "type": "free", "from": "slider.O", "to": "block.O" } },
  "couplings": { "gear": )" +
         laws.gear + R"( },
  "springs": { "coil": { "from": "ground.top", "to": "slider.O", )" +
         laws.coil + ", " + laws.damper + R"( } },
  "joint_springs": { "detent": { "joint": "turn", "free": 0.05, )" +
         laws.detent + R"( } },
  "bushings": { "rubber": { "from": "slider.O", "to": "block.O",
    "radial": { "stiffness": )" +
         laws.rubber + R"(, "damping": )" + laws.rubbing + R"( }, "tz": { "stiffness": 2e3, "damping": 9 },
    "conical": { "stiffness": 20, "damping": 0.1 }, "rz": { "stiffness": 20, "damping": 0.1 } } },
  "bump_stops": { "stop": { "joint": "slide", "side": "above", "clearance": 0.01, "stiffness": )" +
         laws.stop + R"( } },
  "air_springs": { "bellows": { "from": "ground.low", "to": "slider.O", "pressure": 3e5, "length": 0.7,
    "area": )" +
         laws.area + ", \"volume\": " + laws.volume + R"( } },
  "outputs": {
    "kinetic": { "bodies": "all", "quantity": "kinetic_energy" },
    "rubber": { "bushing": "rubber", "quantity": "potential_energy" },
    "stop": { "bump_stop": "stop", "quantity": "potential_energy" } },
  "initial": { "positions": { "slide": 0.02 }, "velocities": { "slide": 0.3 } } })";
}

// Straight lines are drawn by any interpolation, cubics by splines: to rounding of the points.
TEST_F(LargeTables, MoveAsTheLawsOfTheirPointsInEveryEngine) {
  Laws closed, tabled;
  closed.coil = R"("force": "800 * (length - 0.8) + 9e4 * (length - 0.8)^3")";
  closed.damper = R"("damping": 30)";
  closed.detent = R"("force": "40 * (position - 0.05) + 200 * (position - 0.05)^3")";
  closed.rubber = "1500", closed.rubbing = "12", closed.stop = "4e4", closed.area = "2e-4", closed.volume = "3e-4";
  closed.gear = R"({ "relation": "z.turn - z.slide - 2 * z.slide^3" })";
  const auto cubic = [](double a, double c) { return [a, c](double x) { return a * x + c * x * x * x; }; };
  const auto line = [](double a) { return [a](double x) { return a * x; }; };
  tabled.coil = "\"stiffness\": " + table_of(cubic(800, 9e4), -0.5, 0.5, kSplined, 0.4);
  tabled.damper = "\"damping\": " + table_of(line(30), -2, 2, "", 0.4);
  tabled.detent = "\"stiffness\": " + table_of(cubic(40, 200), -0.6, 0.6, kSplined, 0);
  tabled.rubber = table_of(line(1500), -0.01, 0.01, R"(, "interpolation": "monotone_cubic")", 0.4);
  tabled.rubbing = table_of(line(12), -1, 1, kSplined, 0.2);
  tabled.stop = table_of(line(4e4), 0, 0.1, "", 0);
  tabled.area = table_of([](double) { return 2e-4; }, 0.4, 1, R"(, "interpolation": "monotone_cubic")", 0.4);
  tabled.volume = table_of([](double l) { return 3e-4 + 2e-4 * (l - 0.7); }, 0.4, 1, "", 0.45);
  tabled.gear = fmt::format(R"({{ "joint": "turn", "follows": "slide", "curve": {} }})",
                            table_of(cubic(1, 2), -0.3, 0.3, kSplined, 0.4));
  write("closed.json", mechanism(closed));
  write("tabled.json", mechanism(tabled));
  const auto motion = [&](const std::string& words) {
    const Outcome run = mbgen("simulate " + words + " --duration 0.3 --every 10 --out o.csv");
    EXPECT_EQ(run.exit_code, 0) << words << run.err;
    return table("o.csv");
  };
  const Table expected = motion("closed.json --step 1e-3 --engine generic");
  for (const char* engine : {"generated", "generic", "augmented", "maggi"})
    expect_same_motion(motion(fmt::format("tabled.json --step 1e-3 --engine {}", engine)), expected, 2e-8);
  // The matrix of an implicit step takes the slopes of the laws.
  for (const char* engine : kEngines) {
    const auto of = [&](const char* model) {
      return motion(fmt::format("{} --step 1e-3 --integrator rosenbrock --engine {}", model, engine));
    };
    expect_same_motion(of("tabled.json"), of("closed.json"), 2e-8);
  }
  const Json of_laws = json_of("linearize closed.json --json")["A"],
             of_tables = json_of("linearize tabled.json --json")["A"];
  ASSERT_EQ(of_laws.size(), of_tables.size());
  for (std::size_t i = 0; i < of_laws.size(); ++i)
    for (std::size_t j = 0; j < of_laws.size(); ++j) {
      const double right = of_laws[i][j];
      EXPECT_NEAR(of_tables[i][j].get<double>(), right, 1e-8 * (1 + std::abs(right))) << i << " " << j;
    }
}

constexpr const char* kOnARail = R"({{ "mbgen": 1, "name": "rail", "gravity": [0, 0, 0],
  "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
    "cart": {{ "mass": 2, "inertia": [1, 1, 1], "points": {{ "O": [0, 0, 0] }} }} }},
  "joints": {{ "way": {{ "type": "prismatic", "from": "ground.O", "to": "cart.O", "axis": "x" }} }},
  "joint_springs": {{ "pull": {{ "joint": "way", "stiffness": {} }} }},
  "outputs": {{ "stored": {{ "joint_spring": "pull", "quantity": "potential_energy" }},
               "kinetic": {{ "bodies": "all", "quantity": "kinetic_energy" }} }},
  "initial": {{ "positions": {{ "way": 0.4 }} }} }})";

// A cart rolls over waves of a force, past the end of the table and from period to period.
TEST_F(LargeTables, KeepTheEnergyThatTheyStore) {
  const auto waves = [](double x) { return 40 * std::sin(20 * x) + 60 * x; };
  const double period = 0.31415926535897931;  // of the sine
  for (const bool is_periodic : {false, true}) {
    const std::string more = is_periodic ? R"(, "interpolation": "spline", "periodic": true)" : kSplined;
    write("rail.json", fmt::format(kOnARail, table_of(waves, -0.35 * is_periodic, is_periodic ? period - 0.35 : 0.35,
                                                      more, 0.3, 2001)));
    const Outcome run = mbgen("simulate rail.json --duration 1 --step 1e-3 --every 10 --engine generic --out o.csv");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Table motion = table("o.csv");
    const double whole = motion.at(0, "stored [J]");
    for (std::size_t row = 0; row < motion.rows.size(); ++row)
      EXPECT_NEAR(motion.at(row, "stored [J]") + motion.at(row, "kinetic [J]"), whole, 1e-5 * whole) << row;
    if (is_periodic) {
      EXPECT_NEAR(whole, 2 * (1 - std::cos(8.0)) + 30 * 0.16, 1e-7);
    }
  }
}

/// Bytes of a solver, without its numbers and of its numbers.
struct Size {
  std::uintmax_t code = 0, numbers = 0;
};

// The code of a table does not grow with it: by nothing where the points are equally spaced, by steps of the search
// else.
TEST_F(LargeTables, MakeNoLargerCodeThanSmallerOnes) {
  const auto size_of = [&](int count, double ragged) {
    write("rail.json", fmt::format(kOnARail, table_of([](double x) { return std::sin(x); }, -1, 1, "", ragged, count)));
    const Json report = json_of("generate rail.json --out made --json --no-runtime");
    Size size;
    for (const Json& file : report["files"]) {
      const std::string name = file;
      (name.ends_with("_samples.hpp") ? size.numbers : size.code) += std::filesystem::file_size(path(name));
    }
    return size;
  };
  const Size small = size_of(150, 0), large = size_of(64'000, 0);
  EXPECT_NEAR(static_cast<double>(large.code), static_cast<double>(small.code), 200);
  EXPECT_LT(large.numbers, 100u * 64'000);
  const Size small_ragged = size_of(150, 0.4), large_ragged = size_of(64'000, 0.4);
  EXPECT_LT(large_ragged.code, small_ragged.code + 20'000);
}

}  // namespace
}  // namespace mbgen::cli_test
