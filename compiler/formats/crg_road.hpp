#pragma once
// Positions, heights and curvature of an OpenCRG road, numerically.

#include "compiler/formats/crg_file.hpp"

namespace mbgen {

/// A position: along the reference line and to the left of it, or global; m.
struct CrgPlace {
  double u = 0, v = 0;
};
struct PlanePlace {
  double x = 0, y = 0;
};

/// The road with its line closed on request of REFLINE_CONTINUATION: as a ring if its ends are no farther apart than
/// CHECK_TOL (default 0.1 mm), else by straight lines under the conditions of the C API: headings within 60 degrees,
/// end and start ahead of each other. Otherwise it remains open.
CrgRoad closed_as_asked(CrgRoad road);

/// Global position of u, v. Before the start and after the end the reference line continues according to its closure.
PlanePlace plane_place(const CrgRoad& road, CrgPlace at);

/// The u, v of a position, from the nearest section. Cost: linear in the sections.
CrgPlace road_place(const CrgRoad& road, PlanePlace at);

/// Height, m, without options: bilinear between sections and columns, plus the reference line's own and its banking.
/// Beyond the borders the height of the border.
double height_of(const CrgRoad& road, CrgPlace at);

/// Heading of the reference line, rad, and its curvature over at least 0.5 m, 1/m, at v beside it: 0 if the road is too
/// short.
struct CrgCourse {
  double heading = 0, curvature = 0;
};
CrgCourse course_of(const CrgRoad& road, CrgPlace at);

/// A rotation to the left about a position, its translation to another one, and a rise; rad, m.
struct CrgMove {
  PlanePlace from, to;
  double angle = 0, rise = 0;
};
CrgRoad turned_and_moved(CrgRoad road, const CrgMove& move);

}  // namespace mbgen
