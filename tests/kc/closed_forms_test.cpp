// Axles whose curves are closed forms: swing axle, trailing arm, springs in series, a kingpin on rubber; an axle of two
// wheels against the mirror of one; published angles and loads of the Iltis.

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/reader/read_model.hpp"
#include "tests/kc/kc_support.hpp"

namespace mbgen::kc_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// A left wheel on an arm whose pivot along x is at (0, 0.1, 0.4); spring upright over y = 0.4.
constexpr const char* kSwingAxle = R"({ "mbgen": 1, "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "pivot": [0, 0.1, 0.4], "spring": [0, 0.4, 0.9] } },
    "arm": { "mass": 20, "com": [0, 0.5, 0.35], "inertia": [1, 1, 1],
      "points": { "pivot": [0, 0.1, 0.4], "spring": [0, 0.4, 0.4], "hub": [0, 0.7, 0.3] } } },
  "joints": { "arm": { "type": "revolute", "from": "ground.pivot", "to": "arm.pivot", "axis": "x" } },
  "springs": { "spring": { "from": "ground.spring", "to": "arm.spring", "stiffness": 40000 } },
  "axles": { "rear": { "left": { "centre": "arm.hub", "radius": 0.3 }, "end": "rear" } } })";

TEST(SwingAxle, TurnsAboutItsPivot) {
  constexpr double kReach = 0.6, kDrop = -0.1;  // of the hub from the pivot
  const double travel = 0.04, length = std::hypot(kReach, kDrop);
  const KcReport report = report_of_text(kSwingAxle, {.travel = travel, .points = 3});
  for (const double s : {-travel, 0.0, travel}) {
    const auto value = [&](const std::string& column) { return value_at(report, "parallel_travel", column, s); };
    const double turn = std::asin((kDrop + s) / length) - std::asin(kDrop / length);
    const double y = length * std::cos(std::asin((kDrop + s) / length));
    EXPECT_NEAR(value("camber_left"), -turn, 1e-12);
    EXPECT_NEAR(value("toe_left"), 0, 1e-14);
    EXPECT_NEAR(value("centre_y_left"), y - kReach, 1e-12);
    // The contact centre is 0.3 m below in the plane of the wheel; its way is square to the line to the pivot.
    const double patch_y = 0.1 + y + 0.3 * std::sin(turn), patch_z = 0.4 + kDrop + s - 0.3 * std::cos(turn);
    EXPECT_NEAR(value("track_change"), 2 * (patch_y - 0.7), 1e-12);
    EXPECT_NEAR(value("roll_centre_height"), patch_y * (0.4 - patch_z) / (patch_y - 0.1), 1e-10);
    const double at = std::hypot(0.3 - 0.3 * std::cos(turn), 0.5 - 0.3 * std::sin(turn));
    EXPECT_NEAR(value("ratio_spring"), (0.15 * std::cos(turn) - 0.09 * std::sin(turn)) / at / y, 1e-10);
    EXPECT_NEAR(value("load_left"), 40000 * (0.5 - at) * value("ratio_spring"), 1e-6);
  }
  EXPECT_NEAR(figure(report, "camber_gradient"), -1 / kReach, 1e-10);
  EXPECT_NEAR(figure(report, "wheel_rate"), 40000 * 0.25, 1e-5);
  EXPECT_NEAR(figure(report, "roll_rate"), 0.5 * 1.4 * 1.4 * 10000, 1e-5);
  EXPECT_EQ(report.tables.size(), 2u);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_NE(report.notes[0].find("nothing gives way"), std::string::npos);
}

// A trailing arm with its pivot along y at (0.4, 0.6, 0.35); spring upright halfway.
std::string trailing_arm(const std::string& supports) {
  return R"({ "mbgen": 1, "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "pivot": [0.4, 0.6, 0.35], "spring": [0.2, 0.6, 0.8] } },
    "arm": { "mass": 20, "com": [0.1, 0.7, 0.3], "inertia": [1, 1, 1],
      "points": { "pivot": [0.4, 0.6, 0.35], "spring": [0.2, 0.6, 0.35], "hub": [0, 0.7, 0.3],
        "low": [0, 0.6, 0.1], "high": [0, 0.6, 0.5] } },
    "wheel": { "mass": 15, "com": [0, 0.7, 0.3], "inertia": [1, 1, 1], "points": { "hub": [0, 0.7, 0.3] } } },
  "joints": { "arm": { "type": "revolute", "from": "ground.pivot", "to": "arm.pivot", "axis": "y" },
    "wheel": { "type": "revolute", "from": "arm.hub", "to": "wheel.hub", "axis": "y" } },
  "springs": { "spring": { "from": "ground.spring", "to": "arm.spring", "stiffness": 60000 } },
  "axles": { "rear": { "left": { "centre": "wheel.hub", "radius": 0.3, "steering_axis": ["arm.low", "arm.high"] },
    "end": "rear", "wheelbase": 2.5, "centre_of_gravity_height": 0.5, "brake_share": 0.3, "drive_share": 1)" +
         supports + " } } }";
}

// The arm's pivot is parallel to the wheel's axis: a wheel that is one with its arm is not taken to spin there.
TEST(TrailingArm, MayBeOneWithItsWheel) {
  std::string text = trailing_arm("");
  const auto cut = [&](const std::string& from, const std::string& to, const std::string& instead) {
    const std::size_t begin = text.find(from);
    text.replace(begin, text.find(to, begin) - begin, instead);
  };
  cut(",\n    \"wheel\": { \"mass\"", " },\n  \"joints\"", "");
  cut(",\n    \"wheel\": { \"type\"", " },\n  \"springs\"", "");
  cut("\"wheel.hub\"", ", \"radius\"", "\"arm.hub\"");
  const KcReport one = report_of_text(text, {.travel = 0.03, .points = 3});
  const KcReport two = report_of_text(trailing_arm(""), {.travel = 0.03, .points = 3});
  for (const char* name : {"anti_lift", "anti_squat", "roll_centre_height", "scrub_radius", "caster"})
    EXPECT_NEAR(figure(one, name), figure(two, name), 1e-12) << name;
  EXPECT_NEAR(figure(one, "wheel_rate"), 60000 * 0.25, 1e-5);
}

TEST(TrailingArm, CarriesBrakesAndDriveByItsSlopes) {
  const KcReport report = report_of_text(trailing_arm(""), {.travel = 0.03, .points = 3});
  // Arms of the contact centre and the wheel centre from the pivot: (-0.4, -0.35) and (-0.4, -0.05).
  EXPECT_NEAR(figure(report, "anti_lift"), 0.3 * 0.35 / 0.4 * 5, 1e-12);
  EXPECT_NEAR(figure(report, "anti_squat"), 0.05 / 0.4 * 5, 1e-12);
  const KcReport turned =
      report_of_text(trailing_arm(R"(, "brakes_on": "body", "drive_on": "carrier")"), {.travel = 0.03, .points = 3});
  EXPECT_NEAR(figure(turned, "anti_lift"), 0.3 * 0.05 / 0.4 * 5, 1e-12);
  EXPECT_NEAR(figure(turned, "anti_squat"), 0.35 / 0.4 * 5, 1e-12);
  EXPECT_NEAR(figure(report, "wheel_rate"), 60000 * 0.25, 1e-5);
  EXPECT_NEAR(figure(report, "roll_centre_height"), 0, 1e-12);
  EXPECT_NEAR(figure(report, "scrub_radius"), 0.1, 1e-12);
  const double length = std::hypot(0.4, 0.05);
  for (const double s : {-0.03, 0.03}) {
    const auto value = [&](const std::string& column) { return value_at(report, "parallel_travel", column, s); };
    const double turn = std::asin((s - 0.05) / length) - std::asin(-0.05 / length);
    EXPECT_NEAR(value("caster_left"), -turn, 1e-12);
    EXPECT_NEAR(value("camber_left"), 0, 1e-14);
    EXPECT_NEAR(value("track_change"), 0, 1e-14);
    // Rearwards lengthens the wheelbase of a rear axle.
    EXPECT_NEAR(value("wheelbase_change"), length * std::cos(std::asin((s - 0.05) / length)) - 0.4, 1e-12);
    const double reach = length * std::cos(std::asin((s - 0.05) / length));
    EXPECT_NEAR(value("anti_squat"), -(s - 0.05) / reach * 5, 1e-10);
  }
}

// A wheel on an upright slide over a spring whose upper seat slides in rubber; beside it the wheel turns about an
// upright kingpin 0.04 m ahead of it in rubber, and slides sideways in rubber.
constexpr const char* kSeries = R"({ "mbgen": 1, "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "o": [0, 0.6, 0.3], "seat": [0, 0.6, 0.8] } },
    "slider": { "mass": 5, "com": [0, 0.6, 0.3], "inertia": [1, 1, 1], "points": { "o": [0, 0.6, 0.3] } },
    "seat": { "mass": 1, "com": [0, 0.6, 0.8], "inertia": [1, 1, 1], "points": { "o": [0, 0.6, 0.8] } },
    "block": { "mass": 5, "com": [0, 0.6, 0.3], "inertia": [1, 1, 1], "points": { "o": [0, 0.6, 0.3], "pin": [0.04, 0.7, 0.3] } },
    "hub": { "mass": 10, "com": [0, 0.7, 0.3], "inertia": [1, 1, 1], "points": { "pin": [0.04, 0.7, 0.3], "centre": [0, 0.7, 0.3] } } },
  "joints": {
    "slider": { "type": "prismatic", "from": "ground.o", "to": "slider.o", "axis": "z" },
    "seat": { "type": "prismatic", "from": "ground.seat", "to": "seat.o", "axis": "z" },
    "block": { "type": "prismatic", "from": "slider.o", "to": "block.o", "axis": "y" },
    "hub": { "type": "revolute", "from": "block.pin", "to": "hub.pin", "axis": "z" } },
  "springs": { "coil": { "from": "seat.o", "to": "slider.o", "stiffness": 30000, "preload": -2000 } },
  "bushings": {
    "mount": { "from": "ground.seat", "to": "seat.o", "tz": { "stiffness": 90000, "preload": 2000 } },
    "side": { "from": "slider.o", "to": "block.o", "ty": { "stiffness": 2e6 } },
    "kingpin": { "from": "block.pin", "to": "hub.pin", "rz": { "stiffness": 5000 } } },
  "axles": { "front": { "left": { "centre": "hub.centre", "radius": 0.3 } } } })";

TEST(Compliance, SpringsInSeriesAndAKingpinOnRubber) {
  const KcReport report = report_of_text(kSeries, {.travel = 0.02, .force = 2000, .moment = 100, .points = 5});
  const double series = 30000.0 * 90000 / 120000;
  EXPECT_NEAR(figure(report, "wheel_rate"), series, 1e-6 * series);
  EXPECT_NEAR(figure(report, "ratio_coil"), 0.75, 1e-9);
  for (const double s : {-0.02, -0.01, 0.0, 0.01, 0.02})
    EXPECT_NEAR(value_at(report, "parallel_travel", "load_left", s), 2000 + series * s, 1e-5);
  // A force across the wheel keeps its lever of 0.04 m behind the kingpin: to the left it turns the wheel to the right.
  EXPECT_NEAR(figure(report, "steer_by_lateral_force"), -0.04 / 5000, 1e-15);
  EXPECT_NEAR(figure(report, "steer_by_aligning_moment"), 1.0 / 5000, 1e-14);
  EXPECT_NEAR(figure(report, "steer_by_brake_force"), 0, 1e-16);
  EXPECT_NEAR(figure(report, "camber_by_lateral_force"), 0, 1e-16);
  EXPECT_NEAR(figure(report, "centre_y_by_lateral_force"), 1 / 2e6 + 0.04 * 0.04 / 5000, 1e-15);
  for (const double force : {-2000.0, -1000.0, 1000.0, 2000.0}) {
    const double turn = -0.04 * force / 5000;
    EXPECT_NEAR(value_at(report, "lateral_force", "steer_angle_left", force), turn, 1e-11);
    EXPECT_NEAR(value_at(report, "lateral_force", "centre_x_left", force), 0.04 - 0.04 * std::cos(turn), 1e-11);
    EXPECT_NEAR(value_at(report, "lateral_force", "centre_y_left", force),
                force * std::cos(turn) / 2e6 - 0.04 * std::sin(turn), 1e-11);
  }
  EXPECT_NEAR(value_at(report, "aligning_moment", "steer_angle_left", 100), 100.0 / 5000, 1e-11);
}

// Slopes of a corner in rubber are those of its curves.
TEST(Compliance, GradientsAreThoseOfTheCurves) {
  const std::string text = R"({"mbgen": 1, "include": [")" + source_path("models/rubber_wishbone.json") + R"("],
    "axles": { "front": { "left": { "centre": "wheel.hub", "radius": 0.31 }, "without": ["road"] } } })";
  constexpr double kTravel = 1e-3, kForce = 20;
  const KcReport report = report_of_text(text, {.travel = kTravel, .force = kForce, .moment = 2, .points = 3});
  const auto difference = [&](const std::string& curve, const std::string& column, double by) {
    return (value_at(report, curve, column, by) - value_at(report, curve, column, -by)) / (2 * by);
  };
  const auto expect_near = [&](const std::string& name, double slope) {
    EXPECT_NEAR(figure(report, name), slope, 2e-4 * std::abs(slope)) << name;
    EXPECT_GT(std::abs(slope), 1e-12) << name;
  };
  expect_near("toe_gradient", difference("parallel_travel", "toe_left", kTravel));
  expect_near("camber_gradient", difference("parallel_travel", "camber_left", kTravel));
  expect_near("wheel_rate", difference("parallel_travel", "load_left", kTravel));
  for (const std::string load : {"brake_force", "drive_force", "lateral_force"}) {
    expect_near("steer_by_" + load, difference(load, "steer_angle_left", kForce));
    expect_near("camber_by_" + load, difference(load, "camber_left", kForce));
  }
  expect_near("centre_y_by_lateral_force", difference("lateral_force", "centre_y_left", kForce));
  expect_near("steer_by_aligning_moment", difference("aligning_moment", "steer_angle_left", 2));
}

// One wheel and its mirror are an axle of two.
TEST(Axle, OfOneWheelIsThatOfTwo) {
  const std::string corner = source_path("models/rubber_wishbone.json");
  const std::string one = R"({"mbgen": 1, "include": [")" + corner + R"("],
    "axles": { "front": { "left": { "centre": "wheel.hub", "radius": 0.31 }, "without": ["road"] } } })";
  const std::string two = R"({"mbgen": 1, "initial": { "equilibrium": true }, "instances": {
      "l": { "file": ")" + corner +
                          R"(", "suffix": "_l" },
      "r": { "file": ")" + corner +
                          R"(", "suffix": "_r", "mirror": "xz" } },
    "axles": { "front": { "left": { "centre": "wheel_l.hub", "radius": 0.31 }, "right": { "centre": "wheel_r.hub", "radius": 0.31 },
      "without": ["road_l", "road_r"] } } })";
  const KcSettings options{.travel = 0.03, .force = 1500, .moment = 40, .points = 5};
  const KcReport single = report_of_text(one, options), both = report_of_text(two, options);
  for (const KcTable& of : single.tables) {
    const KcTable& other = table(both, of.name);
    for (const Column& column : of.columns) {
      if (column.heading.name.starts_with("ratio_")) continue;
      const std::vector<double>& values_of_both = values(other, column.heading.name);
      for (std::size_t row = 0; row < column.values.size(); ++row) {
        const double size = std::max(1e-3, std::abs(column.values[row]));
        EXPECT_NEAR(values_of_both[row], column.values[row], 1e-6 * size) << of.name << ' ' << column.heading.name;
      }
    }
  }
  const std::vector<double>& left = values(table(both, "opposite_travel"), "camber_left");
  const std::vector<double>& right = values(table(both, "opposite_travel"), "camber_right");
  for (std::size_t row = 0; row < left.size(); ++row) EXPECT_NEAR(left[row], right[left.size() - 1 - row], 1e-9);
  EXPECT_NEAR(figure(both, "roll_rate"), figure(single, "roll_rate"), 1e-6 * figure(single, "roll_rate"));
  EXPECT_NEAR(figure(both, "ratio_strut_l"), figure(single, "ratio_strut"), 1e-8);
}

// A rigid axle on two links along it and a rod across rolls about the rod's height in the middle.
TEST(Axle, RigidRollsAboutItsRodAcross) {
  const KcReport report = report_of_text(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": {
      "ground": { "points": { "o": [0, 0, 0.3], "l": [0.8, 0.4, 0.3], "r": [0.8, -0.4, 0.3], "u": [0.8, 0, 0.5],
        "rod": [0, -0.4, 0.45], "sl": [0, 0.5, 0.8], "sr": [0, -0.5, 0.8] } },
      "axle": { "mass": 80, "com": [0, 0, 0.3], "inertia": [10, 1, 10], "points": { "o": [0, 0, 0.3], "l": [0, 0.4, 0.3],
        "r": [0, -0.4, 0.3], "u": [0, 0, 0.5], "rod": [0, 0.4, 0.45], "sl": [0, 0.5, 0.3], "sr": [0, -0.5, 0.3],
        "left": [0, 0.75, 0.3], "right": [0, -0.75, 0.3] } } },
    "joints": { "axle": { "type": "free", "from": "ground.o", "to": "axle.o" } },
    "rods": { "l": { "from": "ground.l", "to": "axle.l" }, "r": { "from": "ground.r", "to": "axle.r" },
      "u": { "from": "ground.u", "to": "axle.u" }, "across": { "from": "ground.rod", "to": "axle.rod" } },
    "springs": { "left": { "from": "ground.sl", "to": "axle.sl", "stiffness": 50000 },
      "right": { "from": "ground.sr", "to": "axle.sr", "stiffness": 50000 } },
    "axles": { "rear": { "left": { "centre": "axle.left", "radius": 0.3 }, "right": { "centre": "axle.right", "radius": 0.3 },
      "end": "rear" } } })",
                                         {.travel = 0.02, .points = 3});
  EXPECT_NEAR(figure(report, "roll_centre_height"), 0.45, 1e-9);
  EXPECT_NEAR(value_at(report, "opposite_travel", "roll_centre_to_left", 0), 0, 1e-9);
  EXPECT_NEAR(figure(report, "wheel_rate"), 50000, 1e-4);
  EXPECT_NEAR(figure(report, "wheel_rate_roll"), 50000 * (0.5 * 0.5) / (0.75 * 0.75), 1e-4);
  EXPECT_NEAR(figure(report, "roll_rate"), 0.5 * 1 * 1 * 50000, 1e-4);
  EXPECT_NEAR(value_at(report, "opposite_travel", "camber_left", 0.02), -std::asin(0.02 / 0.75), 1e-9);
}

// At the published equilibrium: loads of the wheels, and where pitch, leaf, carrier and knuckle put the wheels (6
// digits).
TEST(Iltis, StandsAsPublished) {
  std::ifstream file(source_path("tests/data/reference/iltis.json"));
  const nlohmann::json data = nlohmann::json::parse(file);
  const auto published = [&](const std::string& name) { return data["equilibrium"][name].get<double>(); };
  double carried = 0;
  for (const std::string axle : {"front", "rear"}) {
    const std::string corner = axle == "front" ? "front_right" : "rear_left";
    const KcReport report = report_of_file("models/axles/iltis.json", {.travel = 0.05, .points = 3}, axle);
    // The left carrier turns about -x by leaf and carrier together, its knuckle about the pins, all of it by the pitch.
    const double nominal = std::atan(0.084 / 0.302);
    const double lean = published("leaf_" + corner) + published("carrier_" + corner) + nominal;
    const double knuckle = (axle == "front" ? -1 : 1) * published("steer_" + corner), pitch = published("pitch");
    const double y = -std::sin(nominal), z = std::cos(nominal), c = std::cos(knuckle), s = std::sin(knuckle);
    const double ax = -s * z, ay = c + (1 - c) * y * y, az = (1 - c) * y * z;
    const double leaned_y = ay * std::cos(lean) + az * std::sin(lean),
                 leaned_z = az * std::cos(lean) - ay * std::sin(lean);
    const double pitched_x = ax * std::cos(pitch) + leaned_z * std::sin(pitch);
    const double pitched_z = leaned_z * std::cos(pitch) - ax * std::sin(pitch);
    EXPECT_NEAR(figure(report, "steer_angle", 0), std::atan2(-pitched_x, leaned_y), 1e-6);
    EXPECT_NEAR(figure(report, "camber", 0), -std::atan2(pitched_z, std::hypot(pitched_x, leaned_y)), 2e-6);
    EXPECT_NEAR(figure(report, "toe", 1), figure(report, "toe", 0), 1e-9);
    EXPECT_NEAR(figure(report, "camber", 1), figure(report, "camber", 0), 1e-9);
    EXPECT_NEAR(figure(report, "kingpin_inclination", 0), nominal - lean, 3e-6);
    // Published by statics at no pitch.
    const double load = data["nominal"]["load_" + corner].get<double>();
    EXPECT_NEAR(figure(report, "load", 0), load, 2) << axle;
    EXPECT_NEAR(figure(report, "load", 1), figure(report, "load", 0), 1e-6);
    carried += 2 * figure(report, "load", 0);
  }
  // The springs of 1 km that are the road lean by 1.5e-6 in the model, so the body it sets down is held by 4 mN.
  EXPECT_NEAR(carried, 9.81 * (1260 + 4 * (57.35 + 6)), 0.01);
}

TEST(Rig, SaysWhatItCannotDo) {
  const auto message = [](const auto& run) {
    try {
      run();
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message([] {
              report_of_file("models/axles/coach.json", {}, "middle");
            }).find("unknown axle \"middle\"; known: front, rear"),
            std::string::npos);
  EXPECT_NE(message([] { report_of_file("models/axles/coach.json", {}); }).find("name one of the axles: front, rear"),
            std::string::npos);
  EXPECT_NE(message([] { report_of_file("models/four_bar.json", {}); }).find("has no axles"), std::string::npos);
  const std::string turned = R"({"mbgen": 1, "include": [")" + source_path("models/axles/coach.json") +
                             R"("], "initial": { "positions": { "chassis_rz": 0.4 } } })";
  EXPECT_NE(message([&] {
              report_of(expect(read_model(turned, "turned.json")), {}, "front");
            }).find("is turned by 0.4 rad about z"),
            std::string::npos);
  const KcReport report = report_of_text(kSwingAxle, {.travel = 0.9, .points = 11});
  ASSERT_EQ(report.notes.size(), 3u);
  EXPECT_NE(report.notes[1].find("parallel_travel ends before"), std::string::npos) << report.notes[1];
  EXPECT_GT(table(report, "parallel_travel").columns.front().values.size(), 4u);
}

TEST(Report, FilesHoldWhatTheTablesHold) {
  const KcReport report = report_of_text(trailing_arm(""), {.travel = 0.03, .points = 3});
  const std::vector<NamedText> files = kc_files(report);
  ASSERT_EQ(files.size(), 9u) << "two curves, four matrices, the page";
  EXPECT_EQ(files[0].path, "rear_parallel_travel.csv");
  EXPECT_EQ(files[0].text.find("travel [m],toe_left [rad],"), 0u) << files[0].text;
  EXPECT_EQ(std::count(files[0].text.begin(), files[0].text.end(), '\n'), 4);
  EXPECT_NE(files[1].text.find("caster_left"), std::string::npos);
  EXPECT_EQ(files.back().path, "rear.html");
  EXPECT_NE(files.back().text.find("<td colspan=\"2\">15</td><td>N/mm</td>"), std::string::npos) << files.back().text;
  EXPECT_NE(kc_text(report).find("  wheel_rate                                  15 N/mm\n"), std::string::npos)
      << kc_text(report);
  EXPECT_NEAR(kc_json(report)["figures"]["wheel_rate"]["values"][0].get<double>(), 15000, 1e-5);
}

TEST(Coach, AxlesHaveTheirCurves) {
  const KcReport front =
      report_of_file("models/axles/coach.json", {.travel = 0.04, .steer = 0.3, .points = 3}, "front");
  EXPECT_EQ(front.tables.size(), 3u);
  // The wheelbase is that between both axles.
  EXPECT_TRUE(std::isfinite(value_at(front, "steering", "ackermann", 0.3)));
  EXPECT_NEAR(figure(front, "camber", 0), figure(front, "camber", 1), 1e-3);
  EXPECT_GT(
      value_at(front, "steering", "steer_angle_left", 0.3) * value_at(front, "steering", "steer_angle_right", 0.3), 0);
  EXPECT_LT(std::abs(figure(front, "camber", 0)), 1 * kDegree);
  const KcReport rear = report_of_file("models/axles/coach.json", {.travel = 0.04, .points = 3}, "rear");
  EXPECT_NEAR(figure(rear, "wheel_rate", 0), figure(rear, "wheel_rate", 1), 1e-3 * figure(rear, "wheel_rate", 0));
  // A bar across acts in roll alone.
  EXPECT_GT(figure(rear, "wheel_rate_roll", 0), 0);
}

}  // namespace
}  // namespace mbgen::kc_test
