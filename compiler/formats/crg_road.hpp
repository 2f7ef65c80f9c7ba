#pragma once
// Places, heights and curvature of a road of an OpenCRG file, at numbers.

#include "compiler/formats/crg_file.hpp"

namespace mbgen {

/// A place: along the reference line and to the left of it, or global; m.
struct CrgPlace {
  double u = 0, v = 0;
};
struct PlanePlace {
  double x = 0, y = 0;
};

/// The road with its line closed where REFLINE_CONTINUATION asks for it: in a ring where its ends are no farther apart
/// than CHECK_TOL (0.1 mm without), else by straight lines as the C API does where it calls a line closed: headings
/// within 60 degrees, and end and start ahead of each other. Otherwise it stays open.
CrgRoad closed_as_asked(CrgRoad road);

/// Where u, v are. Before the start and behind the end the reference line goes as its closure says.
PlanePlace plane_place(const CrgRoad& road, CrgPlace at);

/// The u, v of a place, found from the nearest section. Cost: linear in the sections.
CrgPlace road_place(const CrgRoad& road, PlanePlace at);

/// Height, m, without what options ask for: bilinear between sections and columns, with the reference line's own and
/// its banking. Beyond the borders the height of the border.
double height_of(const CrgRoad& road, CrgPlace at);

/// Heading of the reference line, rad, and its curvature over at least 0.5 m, 1/m, as it is v beside it: 0 where the
/// road does not reach as far.
struct CrgCourse {
  double heading = 0, curvature = 0;
};
CrgCourse course_of(const CrgRoad& road, CrgPlace at);

/// A turn to the left about a place, which then comes to another one, and a rise; rad, m.
struct CrgMove {
  PlanePlace from, to;
  double angle = 0, rise = 0;
};
CrgRoad turned_and_moved(CrgRoad road, const CrgMove& move);

}  // namespace mbgen
