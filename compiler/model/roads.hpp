#pragma once
// Roads under tyres: height and friction over the position, in the axes of the road.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/expressions/sample.hpp"
#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A part of a road in its axes: x along it from `from` on, y to the left from `right` to `left`.
struct RoadStretch {
  Quantity from;                        ///< m
  std::optional<Quantity> length;       ///< m, > 0; none: infinite in both directions
  std::optional<Quantity> right, left;  ///< m; none: as wide as the road
};

/// Obstacle on a road, or a gap in it. u: m from the beginning, L its length, h its height.
///   bump     h sin^2(pi u / L)
///   plank    h, with ramps of length r at both ends: h (3 q^2 - 2 q^3), q = u / r; steps where r is 0
///   pothole  a plank that goes down
///   sine     h sin(2 pi u / wave_length + phase), within a plank of height 1 where it has a length
///   sweep    h sin(2 pi phi + phase), phi = u / l0 + (1 / l1 - 1 / l0) u^2 / (2 L), within a plank of height 1
struct RoadFeature : RoadStretch {
  enum class Kind { bump, plank, pothole, sine, sweep };
  std::string name;
  Where where;
  Kind kind = Kind::bump;
  Quantity height;                                        ///< m
  double ramp = 0;                                        ///< m
  std::optional<Quantity> wave_length, last_wave_length;  ///< m, > 0; l0 and l1 of a sweep
  Quantity phase;                                         ///< rad

  /// Short with edges: sampled individually by an enveloping contact.
  bool is_obstacle() const { return kind == Kind::plank || kind == Kind::pothole; }
};

/// A part of a road with its own friction; where several overlap, the last one counts.
struct RoadPatch : RoadStretch {
  std::string name;
  Where where;
  Quantity friction;  ///< factor of the tyre's friction
};

/// Heights of a left and a right track by samples along the road, straight across between them and level outside: a
/// cubic spline, two times continuous. Its coefficients stand in Model::samples, right before left for each place:
///   z(u) = sum over k = 0..3 of b_k(u - i) c[i + k],  i = floor(u),  u = (x - from) / spacing
/// with the uniform B-splines b of degree 3. Source: C. de Boor, A Practical Guide to Splines, 1978, chapter IX.
struct RoadTracks {
  double from = 0, spacing = 1;  ///< m: x of the first place, and the distance of two
  int count = 0;                 ///< points; for periodic tracks the points of a period
  bool is_periodic = false;      ///< else level before the first and after the last point
  double right = -1, left = 1;   ///< m: y of the tracks
  int first = 0;                 ///< index into Model::samples of the first coefficient, of 2 (count + 4)
};

struct CrgRoad;

/// Heights beyond a border of a grid: the border's own, 0, the grid repeated, its mirror image, or none (not a number).
enum class RoadBorder { keep, zero, repeat, reflect, refuse };
const char* name_of(RoadBorder border);

/// A grid of heights along a reference line, of an OpenCRG file, as tables in Model::samples, where whole numbers are
/// exact. u along the line, v to the left of it; beyond its ends the line is straight.
struct RoadGrid {
  std::shared_ptr<const CrgRoad> road;  ///< the same, not as tables
  double smooth_begin = 0,
         smooth_end = 0;  ///< m: over them heights grow from, and fade to, the reference line's; 0: not
  RoadBorder ends = RoadBorder::keep, sides = RoadBorder::keep;
  double end_offset = 0, side_offset = 0;  ///< m: added beyond ends and sides that keep their height or have height 0
  bool is_straight = false;                ///< then nothing is searched
  /// x, y (m), height (m) and banking of the line at each section, the first and the last one twice
  int line = 0;
  int heights = 0;  ///< m, section by section, right to left
  int columns = 0;  ///< v of each column, m
  /// column to the right of the start of each cell, from the first column's v on; no cell is wider than a column
  int column_cells = 0, column_cell_count = 0;
  double column_cell = 1;  ///< m
  /// section near the middle of each cell of the plane, row by row along x
  int cells = 0, cells_x = 1, cells_y = 1;
  double cell = 1, cell_x = 0, cell_y = 0;  ///< m: size, and the corner of the first
};

/// Inputs of a host for the ground under a wheel, each NAME_x and so on after its road: a position (m, global), and
/// there the height of the ground (m), its slopes (1, global axes) and the factor of the tyre's friction.
constexpr std::array<std::string_view, 6> kHostInputs = {"x", "y", "height", "slope_x", "slope_y", "friction"};

/// A road: height(x, y) plus the heights of its tracks, grids and features, above the plane z = origin.z of the global
/// frame.
struct Road {
  std::string name;
  Where where;
  Vector3 origin{};           ///< m, global: x = y = 0 of the road, and zero of its heights
  double heading = 0;         ///< rad, of its axis x from the global one, to the left
  std::optional<int> height;  ///< expression; local 0 x, local 1 y, both m in the axes of the road; m
  /// 1, in its axes: added to the slopes of its heights, for ground under one wheel given by a host
  Quantity slope_x, slope_y;
  std::optional<int> friction;  ///< likewise; factor of the tyre's friction; 1 without
  /// index of the first of kHostInputs, in a row: `height` and `friction` are then the host's plane under one wheel; -1
  /// for none
  int host_input = -1;
  std::vector<RoadTracks> tracks;
  std::vector<RoadGrid> grids;
  std::vector<RoadFeature> features;
  std::vector<RoadPatch> patches;

  /// Constant height, apart from features.
  bool is_level() const { return !height && tracks.empty() && grids.empty() && !is_of_one_point(); }
  bool has_friction() const { return friction || !patches.empty(); }
  /// Valid below one point only: a host gives a plane, or slopes are given.
  bool is_of_one_point() const {
    const auto is_given = [](const Quantity& q) { return q.expression >= 0 || q.value != 0; };
    return host_input >= 0 || is_given(slope_x) || is_given(slope_y);
  }
};

}  // namespace mbgen
