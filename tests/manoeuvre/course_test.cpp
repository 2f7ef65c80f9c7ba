// Tracks of files against circles and straight lines, speed profiles and standing starts against closed forms.

#include <gtest/gtest.h>

#include "compiler/text/user_error.hpp"
#include "tests/manoeuvre/metrics_support.hpp"
#include "workbench/manoeuvre/track.hpp"

namespace mbgen::metrics_test {
namespace {

TrackPoints circle_points(double radius, int count, double turn) {
  TrackPoints points;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * 2 * kPi * i / count;
    points.x.push_back(7 + radius * std::cos(angle));
    points.y.push_back(-3 + radius * std::sin(angle));
  }
  return points;
}

// The curvature of a cubic spline through n points of a circle is off by (2 pi / n)^2 / 12 at most.
TEST(Tracks, AClosedCircleHasItsLengthAndCurvature) {
  const double radius = 50;
  for (const double turn : {1.0, -1.0}) {
    const Track track = track_through(circle_points(radius, 40, turn), true, 3);
    EXPECT_NEAR(track.length, 2 * kPi * radius, 1e-4 * radius);
    EXPECT_EQ(track.speeds.size(), track.path.points.size());
    double heading = 0, bent = 0, jump = 0, off = 0;
    for (std::size_t i = 0; i < track.path.points.size(); ++i) {
      const PathPoint& point = track.path.points[i];
      bent = std::max(bent, std::abs(point.curvature * radius * turn - 1));
      jump = std::max(jump, std::abs(point.heading - heading));
      // The circle begins at the origin along x: its centre is to the left or the right.
      off = std::max(off, std::abs(std::hypot(point.x, point.y - turn * radius) / radius - 1));
      heading = point.heading;
    }
    EXPECT_LT(bent, std::pow(2 * kPi / 40, 2) / 12 * 1.1);
    EXPECT_LT(jump, 0.01);
    EXPECT_LT(off, 1e-4);
    EXPECT_NEAR(heading, turn * 3 * 2 * kPi, 0.01);
  }
}

TEST(Tracks, AnOpenLineEndsAtItsLastPoint) {
  const Track track = track_through({{3, 10, 40, 103}, {4, 4, 4, 4}, {}}, false, 1);
  EXPECT_NEAR(track.length, 100, 1e-9);
  EXPECT_NEAR(track.path.at(60).x, 60, 1e-9);
  EXPECT_NEAR(track.path.at(60).y, 0, 1e-9);
}

// v^2 = v0^2 + 2 a s towards the bend, sqrt(a R) in it.
TEST(Tracks, SpeedsAreThoseThatBendsDriveAndBrakesAllow) {
  TrackPoints points;
  for (int i = 0; i <= 60; ++i) points.x.push_back(5.0 * i), points.y.push_back(0);
  for (int i = 1; i <= 40; ++i) {
    points.x.push_back(300 + 50 * std::sin(i * kPi / 40));
    points.y.push_back(50 - 50 * std::cos(i * kPi / 40));
  }
  Track track = track_through(points, false, 1);
  TrackManoeuvre limits;
  limits.lateral_acceleration = 4.5, limits.acceleration = 1, limits.deceleration = 2, limits.largest_speed = 22;
  limit_speeds(track, limits, 10);
  const double in_bend = std::sqrt(4.5 * 50);
  EXPECT_NEAR(speed_at(track, 0), 10, 1e-9);
  EXPECT_NEAR(speed_at(track, 100), std::sqrt(100 + 2 * 1 * 100), 1e-2);
  EXPECT_NEAR(speed_at(track, 200), 22, 1e-9);
  EXPECT_NEAR(speed_at(track, 360), in_bend, 2e-2);
  EXPECT_NEAR(speed_at(track, 275), std::sqrt(in_bend * in_bend + 2 * 2 * 25), 0.5) << "braking ahead of the bend";
  for (std::size_t i = 1; i < track.speeds.size(); ++i)
    EXPECT_LE(track.speeds[i - 1] * track.speeds[i - 1] - track.speeds[i] * track.speeds[i],
              2 * 2 * track.path.spacing + 1e-9);
}

std::string error_of(const std::string& text) {
  try {
    read_track(text, "t.csv");
  } catch (const UserError& error) {
    const std::string all = error.what();
    return all.substr(0, all.find('\n'));
  }
  return "none";
}

TEST(Tracks, FaultsOfTheTableHaveTheirLine) {
  EXPECT_EQ(error_of("x [m],y [m]\n0,0\n1,0\n2,0\n3,1\n"), "none");
  EXPECT_EQ(read_track("y,x,speed [m/s]\r\n1,2,3\r\n2,2,3\r\n3,2,3\r\n4,2,3\r\n", "t.csv").speeds.size(), 4u);
  EXPECT_EQ(error_of("x [m],z [m]\n0,0\n"), "t.csv:1: the columns x and y are missing");
  EXPECT_EQ(error_of("x [km],y [m]\n0,0\n"), "t.csv:1: column \"x [km]\" must have the unit m");
  EXPECT_EQ(error_of("x,y\n0,0\n1\n"), "t.csv:3: must have 2 fields like the header, found 1");
  EXPECT_EQ(error_of("x,y\n0,0\n0,0\n"), "t.csv:3: the point is the one before");
  EXPECT_EQ(error_of("x,y,speed\n0,0,0\n"), "t.csv:2: speed must be above 0, got 0");
  EXPECT_EQ(error_of("x,y\n0,0\n1,0\n"), "t.csv:3: a track needs at least 4 points, got 2");
  EXPECT_NE(error_of("x,y\n0,nan\n1,0\n"), "none");
  EXPECT_EQ(error_of(""), "t.csv:1: a track needs at least 4 points, got 0");
}

// At rest for a second, 0.1 m back within the next, then 2 m/s^2.
TEST(StandingStart, TimesAreThoseOfUniformAcceleration) {
  VehicleSeries s = empty_series(2001, 0.01);
  for (std::size_t i = 0; i < s.t.size(); ++i) {
    const double t = s.t[i], back = std::clamp(t - 1, 0.0, 1.0), later = std::max(0.0, t - 2);
    const double way = -0.1 * back + later * later;
    s.heading[i] = 0.5, s.x[i] = way * std::cos(0.5), s.y[i] = way * std::sin(0.5);
    s.speed[i] = t < 1 ? 0 : t < 2 ? -0.1 : 2 * later;
    s.longitudinal_acceleration[i] = t < 2 ? 0 : 2;
  }
  const VehicleMetrics metrics = start_metrics(s, {.at = 1});
  EXPECT_NEAR(value(metrics, "rollback"), 0.1, 1e-12);
  EXPECT_NEAR(value(metrics, "time_to_move"), 1.05, 1e-9);
  EXPECT_NEAR(value(metrics, "time_to_50"), 1 + 50 / 3.6 / 2, 1e-9);
  EXPECT_NEAR(value(metrics, "time_to_100"), 1 + 100 / 3.6 / 2, 1e-9);
  EXPECT_NEAR(value(metrics, "distance"), 18 * 18 - 0.1, 1e-9);
  // At 12 s the speed is 20 m/s, that is 72 km/h: what it has already is not reached.
  const VehicleMetrics later = start_metrics(s, {.at = 12});
  EXPECT_FALSE(has(later, "time_to_move"));
  EXPECT_TRUE(notes(later, "time_to_move: the vehicle moves already"));
  EXPECT_FALSE(has(later, "time_to_50"));
  EXPECT_NEAR(value(later, "time_to_80"), 80 / 3.6 / 2 - 10, 1e-9);
}

}  // namespace
}  // namespace mbgen::metrics_test
