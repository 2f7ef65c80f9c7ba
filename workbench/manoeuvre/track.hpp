#pragma once
// Tracks of files: a course through points, and the speed that its bends allow.

#include <string>
#include <string_view>
#include <vector>

#include "workbench/manoeuvre/manoeuvre.hpp"
#include "workbench/manoeuvre/path.hpp"

namespace mbgen {

/// Points of a track.
struct TrackPoints {
  std::vector<double> x, y;    ///< m
  std::vector<double> speeds;  ///< m/s, the highest at each point; empty: none are given
};

/// Reads a table (CSV) with the columns x, y and perhaps speed, each with its unit: x [m], speed [m/s]. file: for
/// messages. Fails: UserError with the line for a missing column, another unit, a field that is no finite number, fewer
/// than four points, or two equal ones after each other.
TrackPoints read_track(std::string_view text, const std::string& file);

/// The course of a track: cubic splines of x and y over the length of chords, so that its curvature is continuous;
/// from its first point along x. speeds: per point of the path, m/s.
struct Track {
  Path path;
  std::vector<double> speeds;
  double length = 0;  ///< m, of one lap
};

/// is_closed: the last point is joined to the first one; the path then has `laps` laps.
Track track_through(const TrackPoints& points, bool is_closed, int laps);

/// Lowers the speeds to what bends, drive and brakes allow: at most sqrt(lateral / |curvature|), growing from `first`
/// with at most `acceleration`, and falling with at most `deceleration` ahead of slow places.
void limit_speeds(Track& track, const TrackManoeuvre& manoeuvre, double first);

/// The speed at a place of the course.
double speed_at(const Track& track, double way);

}  // namespace mbgen
