// Axles at positions where a choice of coordinates made over many stands badly, and axles beside others: neither ends
// a curve. Five links against their spheres, solved here alone.

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compiler/algebra/dense.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/kc/kc_support.hpp"

namespace mbgen::kc_test {
namespace {

using Json = nlohmann::json;
using Eigen::Vector3d;

Json json_of_file(const std::string& name) {
  std::ifstream file(source_path(name));
  return Json::parse(file);
}

std::string message_of(const std::string& name, const std::string& axle) {
  try {
    report_of_file(name, {.points = 3}, axle);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

/// A carrier on five rods of constant length, by its turn and its way: six equations with the height of the wheel.
class FiveLinks {
 public:
  FiveLinks() {
    const Json points = json_of_file("tests/data/kc/five_links.json")["hardpoints"];
    const auto point = [&](const std::string& name) {
      return Vector3d(points[name][0], points[name][1], points[name][2]);
    };
    centre_ = point("C");
    for (const auto& [inner, outer] :
         {std::pair("TI", "TO"), {"L1", "L1o"}, {"L2", "L2o"}, {"L3", "L3o"}, {"L4", "L4o"}}) {
      inner_.push_back(point(inner));
      outer_.push_back(point(outer));
    }
  }

  /// Turn of the carrier with its wheel centre so much higher.
  Eigen::Matrix3d turn_at(double travel) {
    Eigen::Matrix<double, 6, 1> at = Eigen::Matrix<double, 6, 1>::Zero();
    for (int part = 1; part <= 20; ++part) {
      for (int step = 0; step < 20; ++step) {
        Eigen::Matrix<double, 6, 6> slope;
        for (int i = 0; i < 6; ++i) {
          Eigen::Matrix<double, 6, 1> ahead = at, behind = at;
          ahead[i] += 1e-6;
          behind[i] -= 1e-6;
          slope.col(i) = (open(ahead, travel * part / 20) - open(behind, travel * part / 20)) / 2e-6;
        }
        at -= solved(slope, open(at, travel * part / 20));
      }
    }
    EXPECT_LT(open(at, travel).norm(), 1e-13);
    return turn(at);
  }

 private:
  static Eigen::Matrix3d turn(const Eigen::Matrix<double, 6, 1>& at) {
    return (Eigen::AngleAxisd(at[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(at[1], Vector3d::UnitY()) *
            Eigen::AngleAxisd(at[0], Vector3d::UnitX()))
        .toRotationMatrix();
  }

  Eigen::Matrix<double, 6, 1> open(const Eigen::Matrix<double, 6, 1>& at, double travel) const {
    const Eigen::Matrix3d turned = turn(at);
    const Vector3d way = at.tail<3>();
    Eigen::Matrix<double, 6, 1> result;
    for (int i = 0; i < 5; ++i) {
      const Vector3d here = centre_ + way + turned * (outer_[static_cast<std::size_t>(i)] - centre_);
      const Vector3d& inner = inner_[static_cast<std::size_t>(i)];
      result[i] = (here - inner).norm() - (outer_[static_cast<std::size_t>(i)] - inner).norm();
    }
    result[5] = way[2] - travel;
    return result;
  }

  Vector3d centre_;
  std::vector<Vector3d> inner_, outer_;
};

TEST(Choices, FiveLinksGoOnWhereTheFrozenChoiceIsSingular) {
  const KcReport report = report_of_file("tests/data/kc/five_links.json", {.points = 21});
  for (const char* curve : {"parallel_travel", "opposite_travel", "steering"})
    EXPECT_EQ(table(report, curve).columns.front().values.size(), 21u) << curve;
  FiveLinks links;
  const Json axis = json_of_file("tests/data/kc/five_links.json")["joints"]["hub"]["axis"];
  const Vector3d home(axis[0], axis[1], axis[2]);
  for (const double travel : table(report, "parallel_travel").columns.front().values) {
    const Vector3d a = links.turn_at(travel) * home;
    EXPECT_NEAR(value_at(report, "parallel_travel", "toe_left", travel), std::atan2(a[0], a[1]), 1e-9) << travel;
    EXPECT_NEAR(value_at(report, "parallel_travel", "camber_left", travel), std::atan2(-a[2], std::hypot(a[0], a[1])),
                1e-9)
        << travel;
  }
}

/// The car of tests/data/kc/c1.json at its reference, with a front axle or without.
KcReport rear_of(bool with_front) {
  Json car = json_of_file("tests/data/kc/c1.json");
  car["initial"] = Json::object();
  if (!with_front) {
    for (const char* corner : {"fl", "fr"}) {
      car["instances"].erase(corner);
      car["tyres"].erase(corner);
    }
    car["axles"].erase("front");
  }
  return report_of(expect(read_model(car.dump(), source_path("tests/data/kc/c1.json"))), {.travel = 0.03, .points = 5},
                   "rear");
}

TEST(Choices, TheOtherAxleDoesNotMatter) {
  const KcReport at_rest = report_of_file("tests/data/kc/c1.json", {.points = 5}, "rear");
  ASSERT_EQ(at_rest.tables.size(), 6u);
  for (const KcTable& curve : at_rest.tables) EXPECT_EQ(curve.columns.front().values.size(), 5u) << curve.name;
  const KcReport both = rear_of(true), alone = rear_of(false);
  ASSERT_EQ(both.tables.size(), alone.tables.size());
  for (const char* column : {"toe_left", "camber_right", "centre_x_left", "contact_y_right", "load_left"}) {
    const std::vector<double>& one = values(table(both, "parallel_travel"), column);
    const std::vector<double>& other = values(table(alone, "parallel_travel"), column);
    ASSERT_EQ(one.size(), 5u);
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_NEAR(one[i], other[i], 1e-9 * (1 + std::abs(other[i]))) << column;
  }
}

TEST(Choices, AnAxleBesideOneThatCannotTravelHasCurves) {
  for (const char* file : {"tests/data/kc/arm_stuck.json", "tests/data/kc/arm_beam.json"}) {
    const KcReport report = report_of_file(file, {.points = 3}, "front");
    EXPECT_EQ(report.notes.front(), "wheels of axle \"rear\" hang free: on pads they would have no position of rest");
    EXPECT_EQ(table(report, "parallel_travel").columns.front().values.size(), 3u);
  }
}

/// The car of arm_stuck.json with a third axle, of trailing arms and a beam that twists about the line of their pivots.
Json with_twist_beam() {
  Json car = json_of_file("tests/data/kc/arm_stuck.json");
  const Json arm = {-1.9, 0, 0.35}, hub = {-2.3, 0, 0.31};
  for (const auto& [side, y] : {std::pair("l", 0.6), std::pair("r", -0.6)}) {
    const std::string s = side, wheel = "t" + s + "wheel", k = "t" + s + "k";
    const auto at = [y = y](Json place) { return place[1] = y, place; };
    car["bodies"]["body"]["points"]["t" + s] = at(arm);
    car["bodies"]["body"]["points"]["t" + s + "t"] = at({-2.2, 0, 0.8});
    car["bodies"][wheel] = car["bodies"]["flwheel"];
    car["bodies"][wheel]["com"] = at(hub);
    car["bodies"][wheel]["points"]["hub"] = at(hub);
    car["bodies"][k] = {{"mass", 15},
                        {"com", at({-2.1, 0, 0.33})},
                        {"inertia", {0.3, 0.3, 0.2}},
                        {"points", {{"p", at(arm)}, {"s", at({-2.2, 0, 0.33})}, {"hub", at(hub)}, {"b", arm}}}};
    car["joints"]["t" + s + "arm"] = {{"type", "revolute"}, {"from", "body.t" + s}, {"to", k + ".p"}, {"axis", "y"}};
    car["joints"]["t" + s + "hub"] = {
        {"type", "revolute"}, {"from", k + ".hub"}, {"to", wheel + ".hub"}, {"axis", "y"}};
    car["springs"]["t" + s] = {{"from", "body.t" + s + "t"}, {"to", k + ".s"}, {"stiffness", 4e4}, {"preload", -4000}};
    car["tyres"]["t" + s] = {{"centre", wheel + ".hub"}, {"data", "t"}, {"stiffness", 2e5}};
  }
  car["joints"]["beam"] = {{"type", "revolute"}, {"from", "tlk.b"}, {"to", "trk.b"}, {"axis", "y"}, {"cut", true}};
  car["axles"]["tag"] = {{"body", "body"}, {"end", "rear"}, {"left", {{"tyre", "tl"}}}, {"right", {{"tyre", "tr"}}}};
  return car;
}

/// Of three axles one cannot travel: it alone hangs free where another one is measured.
TEST(Choices, OnlyAxlesThatCannotStandHangFree) {
  const Json car = with_twist_beam();
  for (const char* axle : {"front", "tag"}) {
    const KcReport report = report_of(expect(read_model(car.dump(), "three_axles.json")), {.points = 3}, axle);
    EXPECT_EQ(report.notes.front(), "wheels of axle \"rear\" hang free: on pads they would have no position of rest");
    EXPECT_EQ(table(report, "parallel_travel").columns.front().values.size(), 3u);
  }
  Json stuck = car;
  for (const char* tyre : {"tl", "tr"}) stuck["axles"].erase("tag"), stuck["tyres"].erase(tyre);
  stuck["tyres"]["spare"] = {{"centre", "tlwheel.hub"}, {"data", "t"}, {"stiffness", 2e5}};
  stuck["joints"]["tlarm"]["type"] = "fixed";
  stuck["joints"]["tlarm"].erase("axis");
  stuck["joints"].erase("beam");
  const KcReport report = report_of(expect(read_model(stuck.dump(), "spare.json")), {.points = 3}, "front");
  EXPECT_EQ(report.notes.front(),
            "wheels of axle \"rear\" and tyre \"spare\" hang free: on pads they would have no position of rest");
}

TEST(Choices, AnAngleForAnAxleWithoutSteeringIsTold) {
  const Model car = expect(read_model(with_twist_beam().dump(), "three_axles.json"));
  const std::string note = "the axle has no steering: --steer changes nothing";
  EXPECT_EQ(std::ranges::count(report_of(car, {.steer = 0.1, .points = 3}, "tag").notes, note), 1);
  EXPECT_EQ(std::ranges::count(report_of(car, {.points = 3}, "tag").notes, note), 0);
}

TEST(Choices, AnAxleWithoutRideFreedomIsNamed) {
  EXPECT_EQ(message_of("tests/data/kc/arm_stuck.json", "rear"),
            source_path("tests/data/kc/arm_stuck.json") +
                ": axle rear: its wheels cannot travel: nothing lets them go up and down on \"body\"\n"
                "  hint: a rig needs joints or rubber that let them; rods and joints that hold one motion twice lock "
                "it\n");
  EXPECT_EQ(message_of("tests/data/kc/arm_beam.json", "rear"),
            source_path("tests/data/kc/arm_beam.json") +
                ": axle rear: its wheels go up and down only together, and the rig lifts them one by one\n"
                "  hint: describe the axle by one of its wheels: the other one is its mirror then\n");
}

TEST(Choices, CurvesThatAreStoppedKeepTheirPoints) {
  const Compilation compilation = expect(decide(source_path("models/axles/double_wishbone.json")));
  StateArguments at;
  at.at = "initial";
  long asked = 0;
  const auto watch = [&](long done, long of) {
    EXPECT_EQ(done, ++asked);
    EXPECT_GE(of, 2 * 20);
    return done < 13;  // ten below the start, three above
  };
  const KcReport report = kinematics_and_compliance(compilation, find_axle(compilation.model, ""),
                                                    operating_point(compilation, at).point, {.points = 21}, watch);
  EXPECT_EQ(asked, 13);
  ASSERT_EQ(report.tables.size(), 1u);
  EXPECT_EQ(report.tables[0].columns.front().values.size(), 14u);
  EXPECT_EQ(report.notes.back().find("interrupted: parallel_travel is not complete; there is no opposite_travel"), 0u)
      << report.notes.back();
}

}  // namespace
}  // namespace mbgen::kc_test
