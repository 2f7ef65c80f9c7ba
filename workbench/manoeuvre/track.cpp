#include "workbench/manoeuvre/track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/results/csv.hpp"

namespace mbgen {
namespace {

constexpr double kTrackSpacing = 0.25;  // m, of the path's points
constexpr int kPieces = 64;             // of a chord, for the length of its arc
constexpr std::size_t kAround = 24;     // points over which a spline forgets its ends: 0.268^24 is 2e-14

[[noreturn]] void fail(const CsvLines& line, const std::string& cause) {
  throw UserError(
      fmt::format("{}: {}\n  hint: a track is a table with the columns x [m], y [m] and perhaps speed [m/s], "
                  "one point a line\n",
                  line.place(), cause));
}

/// Place of a column in the header; -1: missing.
int column_of(const CsvLines& header, std::string_view name, std::string_view unit) {
  for (std::size_t i = 0; i < header.fields().size(); ++i) {
    const std::string& heading = header.fields()[i];
    if (heading == name || heading == fmt::format("{} [{}]", name, unit)) return static_cast<int>(i);
    if (heading.starts_with(fmt::format("{} [", name)))
      fail(header, fmt::format("column \"{}\" must have the unit {}", heading, unit));
  }
  return -1;
}

/// A cubic spline through values at rising places, without curvature at its ends.
class Spline {
 public:
  Spline(const std::vector<double>& at, const std::vector<double>& values) : at_(at), values_(values) {
    const std::size_t n = at.size();
    bends_.assign(n, 0.0);
    std::vector<double> factor(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {  // Thomas' algorithm for the second derivatives
      const double before = at[i] - at[i - 1], after = at[i + 1] - at[i];
      const double pivot = 2 * (before + after) - before * factor[i - 1];
      factor[i] = after / pivot;
      const double change = (values[i + 1] - values[i]) / after - (values[i] - values[i - 1]) / before;
      bends_[i] = (6 * change - before * bends_[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) bends_[i] -= factor[i] * bends_[i + 1];
  }

  /// Value, first and second derivative in a chord at a share of it.
  std::array<double, 3> at(std::size_t chord, double share) const {
    const double h = at_[chord + 1] - at_[chord], a = 1 - share, b = share;
    const double low = bends_[chord], high = bends_[chord + 1];
    const double value =
        a * values_[chord] + b * values_[chord + 1] + ((a * a * a - a) * low + (b * b * b - b) * high) * h * h / 6;
    const double slope =
        (values_[chord + 1] - values_[chord]) / h + ((3 * b * b - 1) * high - (3 * a * a - 1) * low) * h / 6;
    return {value, slope, a * low + b * high};
  }

 private:
  std::vector<double> at_, values_, bends_;
};

/// The point of the course at a share of a chord.
PathPoint point_at(const Spline& x, const Spline& y, std::size_t chord, double share) {
  const auto [px, dx, ddx] = x.at(chord, share);
  const auto [py, dy, ddy] = y.at(chord, share);
  return {px, py, std::atan2(dy, dx), (dx * ddy - dy * ddx) / std::pow(dx * dx + dy * dy, 1.5)};
}

/// Points at equal distances along the chords from `first` on to `last`.
std::vector<PathPoint> spaced_points(const Spline& x, const Spline& y, std::size_t first, std::size_t last,
                                     double spacing) {
  std::vector<PathPoint> points;
  double way = 0, next = 0;
  for (std::size_t chord = first; chord < last; ++chord) {
    for (int piece = 0; piece < kPieces; ++piece) {
      const double from = static_cast<double>(piece) / kPieces, to = static_cast<double>(piece + 1) / kPieces;
      const PathPoint a = point_at(x, y, chord, from), b = point_at(x, y, chord, to);
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      for (; next < way + length; next += spacing)
        points.push_back(point_at(x, y, chord, from + (to - from) * (next - way) / length));
      way += length;
    }
  }
  return points;
}

double chords_length(const Spline& x, const Spline& y, std::size_t first, std::size_t last) {
  double way = 0;
  for (std::size_t chord = first; chord < last; ++chord) {
    PathPoint before = point_at(x, y, chord, 0);
    for (int piece = 1; piece <= kPieces; ++piece) {
      const PathPoint point = point_at(x, y, chord, static_cast<double>(piece) / kPieces);
      way += std::hypot(point.x - before.x, point.y - before.y);
      before = point;
    }
  }
  return way;
}

/// The points with others of the same track before and after them, if it is closed.
TrackPoints surrounded(const TrackPoints& points, std::size_t around) {
  TrackPoints more;
  const std::size_t count = points.x.size();
  for (std::size_t i = 0; i < count + 2 * around + 1; ++i) {
    const std::size_t place = (i + count * around - around) % count;
    more.x.push_back(points.x[place]);
    more.y.push_back(points.y[place]);
  }
  return more;
}

std::vector<double> chord_lengths(const TrackPoints& points) {
  std::vector<double> at{0};
  for (std::size_t i = 1; i < points.x.size(); ++i)
    at.push_back(at.back() + std::hypot(points.x[i] - points.x[i - 1], points.y[i] - points.y[i - 1]));
  return at;
}

/// From the first point along x, with headings without jumps.
void lay_along_x(std::vector<PathPoint>& points) {
  const PathPoint origin = points.front();
  const double c = std::cos(origin.heading), s = std::sin(origin.heading);
  double heading = 0;
  for (PathPoint& point : points) {
    const double dx = point.x - origin.x, dy = point.y - origin.y;
    heading += std::remainder(point.heading - origin.heading - heading, 2 * std::numbers::pi);
    point = {c * dx + s * dy, c * dy - s * dx, heading, point.curvature};
  }
}

/// More laps: each begins where the one before ends.
void repeat(std::vector<PathPoint>& points, int laps) {
  const std::vector<PathPoint> lap = points;
  const double turn =
      2 * std::numbers::pi * std::round((lap.back().heading - lap.front().heading) / (2 * std::numbers::pi));
  for (int k = 1; k < laps; ++k)
    for (PathPoint point : lap) {
      point.heading += k * turn;
      points.push_back(point);
    }
}

}  // namespace

TrackPoints read_track(std::string_view text, const std::string& file) {
  TrackPoints points;
  int columns[3] = {-1, -1, -1};
  CsvLines line(text, file);
  while (line.next()) {
    if (line.is_header()) {
      columns[0] = column_of(line, "x", "m");
      columns[1] = column_of(line, "y", "m");
      columns[2] = column_of(line, "speed", "m/s");
      if (columns[0] < 0 || columns[1] < 0) fail(line, "the columns x and y are missing");
      continue;
    }
    double values[3] = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      if (columns[k] >= 0) values[k] = parse_number(line.fields()[static_cast<std::size_t>(columns[k])], line.place());
    if (!points.x.empty() && points.x.back() == values[0] && points.y.back() == values[1])
      fail(line, "the point is the one before");
    points.x.push_back(values[0]);
    points.y.push_back(values[1]);
    if (columns[2] < 0) continue;
    if (!(values[2] > 0)) fail(line, fmt::format("speed must be above 0, got {:g}", values[2]));
    points.speeds.push_back(values[2]);
  }
  if (points.x.size() < 4) fail(line, fmt::format("a track needs at least 4 points, got {}", points.x.size()));
  return points;
}

Track track_through(const TrackPoints& given, bool is_closed, int laps) {
  TrackPoints points = given;
  const bool ends_at_start = is_closed && points.x.front() == points.x.back() && points.y.front() == points.y.back();
  if (ends_at_start) {
    points.x.pop_back();
    points.y.pop_back();
    if (!points.speeds.empty()) points.speeds.pop_back();
  }
  const std::size_t around = is_closed ? kAround : 0, count = points.x.size();
  const TrackPoints all = is_closed ? surrounded(points, around) : points;
  const std::vector<double> at = chord_lengths(all);
  const Spline x(at, all.x), y(at, all.y);
  const std::size_t first = around, last = is_closed ? around + count : count - 1;
  Track track;
  track.length = chords_length(x, y, first, last);
  const double pieces = std::max(4.0, std::round(track.length / kTrackSpacing));
  track.path.spacing = track.length / pieces;
  track.path.points = spaced_points(x, y, first, last, track.path.spacing);
  track.path.points.resize(static_cast<std::size_t>(pieces), track.path.points.back());
  track.speeds.assign(track.path.points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0, chord = first; i < track.speeds.size() && !points.speeds.empty(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / pieces * (at[last] - at[first]) + at[first];
    while (chord + 1 < last && at[chord + 1] < share) ++chord;
    track.speeds[i] = std::lerp(points.speeds[(chord - first) % count], points.speeds[(chord + 1 - first) % count],
                                std::clamp((share - at[chord]) / (at[chord + 1] - at[chord]), 0.0, 1.0));
  }
  lay_along_x(track.path.points);
  if (!is_closed) return track;
  const std::vector<double> lap = track.speeds;
  for (int k = 1; k < laps; ++k) track.speeds.insert(track.speeds.end(), lap.begin(), lap.end());
  repeat(track.path.points, laps);
  return track;
}

void limit_speeds(Track& track, const TrackManoeuvre& manoeuvre, double first) {
  std::vector<double>& speeds = track.speeds;
  const double step = track.path.spacing;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double curvature = std::abs(track.path.points[i].curvature);
    speeds[i] = std::min({speeds[i], manoeuvre.largest_speed, std::sqrt(manoeuvre.lateral_acceleration / curvature)});
  }
  for (std::size_t i = speeds.size() - 1; i-- > 0;)
    speeds[i] = std::min(speeds[i], std::sqrt(speeds[i + 1] * speeds[i + 1] + 2 * manoeuvre.deceleration * step));
  speeds.front() = std::min(speeds.front(), first);
  for (std::size_t i = 1; i < speeds.size(); ++i)
    speeds[i] = std::min(speeds[i], std::sqrt(speeds[i - 1] * speeds[i - 1] + 2 * manoeuvre.acceleration * step));
}

double speed_at(const Track& track, double way) {
  const double place = std::clamp(way / track.path.spacing, 0.0, static_cast<double>(track.speeds.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(place), track.speeds.size() - 2);
  return std::lerp(track.speeds[i], track.speeds[i + 1], place - static_cast<double>(i));
}

}  // namespace mbgen
