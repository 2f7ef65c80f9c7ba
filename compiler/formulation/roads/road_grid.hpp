#pragma once
// Roads of OpenCRG files: from a place to the reference line and from there to the height, by tables alone.
// Source: ASAM OpenCRG 1.2.0, chapter "evaluation".

#include "compiler/formats/crg_file.hpp"
#include "compiler/formulation/elements/force_work.hpp"
#include "compiler/formulation/elements/slope.hpp"

namespace mbgen {
namespace detail {

/// A height and its derivatives by x and y, m and 1.
template <class T>
struct RoadHeight {
  T z{0.0}, by_x{0.0}, by_y{0.0};
};

template <class T>
RoadHeight<T> operator+(const RoadHeight<T>& a, const RoadHeight<T>& b) {
  return {a.z + b.z, a.by_x + b.by_x, a.by_y + b.by_y};
}

template <class T>
T within(const T& x, const T& least, const T& most) {
  return min(max(x, least), most);
}

/// The tables of a grid at symbols or numbers.
template <class T>
struct GridTables {
  const std::vector<double>& samples;
  const RoadGrid& grid;
  T at(int table, const T& index) const { return sample(samples, T(index + T(table))); }
  /// number: 0 x, 1 y, 2 height, 3 banking.
  T line(const T& section, int number) const { return at(grid.line + 4 + number, T(4.0) * section); }
  double last() const { return static_cast<double>(grid.road->sections() - 1); }
};

/// The reference line around an interval: the sections before it, at both of its ends and behind it.
template <class T>
struct LinePieces {
  T x[4], y[4];
  LinePieces(const GridTables<T>& tables, const T& end) {
    for (int k = 0; k < 4; ++k) {
      x[k] = tables.line(end + T(k - 2.0), 0);
      y[k] = tables.line(end + T(k - 2.0), 1);
    }
  }
};

/// Whether the section `end` is an end of the line beyond which a place lies, and where it goes on there: over the seam
/// of a line whose ends are apart.
template <class T>
T over_seam(const GridTables<T>& tables, const T& end, const T& x, const T& y) {
  using mbgen::select;
  const CrgRoad& road = *tables.grid.road;
  const std::size_t last = road.sections() - 1;
  const auto ahead_of = [&](std::size_t at, std::size_t from) {
    return T(road.x[from + 1] - road.x[from]) * (x - T(road.x[at])) +
           T(road.y[from + 1] - road.y[from]) * (y - T(road.y[at]));
  };
  const T start = ahead_of(0, 0), finish = ahead_of(last, last - 1);
  const T forward = select(end - T(tables.last() - 0.5), select(finish, select(start, T(1.0), end), end), end);
  const T back = select(-start, select(-finish, T(tables.last()), end), end);
  return select(T(1.5) - end, back, forward);
}

/// The section at which the interval below a place ends. From the cell's own section the way along the line is gone
/// three times, which is enough where the road does not turn by more than about a radian within a cell; then two
/// comparisons with the lines across the sections give the interval itself.
template <class T>
T interval_end(const GridTables<T>& tables, const T& x, const T& y) {
  using mbgen::select;
  using std::floor;
  const RoadGrid& grid = tables.grid;
  const auto cell_of = [&](const T& place, double corner, int count) {
    return within(T(floor(T(T(1 / grid.cell) * (place - T(corner))))), T(0.0), T(count - 1.0));
  };
  const T cell = T(grid.cells_x) * cell_of(y, grid.cell_y, grid.cells_y) + cell_of(x, grid.cell_x, grid.cells_x);
  T end = tables.at(grid.cells, cell);
  const CrgClosure::Kind closure = grid.road->closure.kind;
  const auto inside = [&](const T& section) {
    if (closure != CrgClosure::Kind::meeting) return within(section, T(1.0), T(tables.last()));
    return T(section - T(tables.last()) * T(floor(T(T(1 / tables.last()) * (section - T(0.5))))));
  };
  const double per_interval = 1 / (grid.road->increment * grid.road->increment);
  for (int k = 0; k < 3; ++k) {
    const T x1 = tables.line(end - T(1.0), 0), y1 = tables.line(end - T(1.0), 1);
    const T along = (x - x1) * (tables.line(end, 0) - x1) + (y - y1) * (tables.line(end, 1) - y1);
    end = inside(T(end + floor(T(T(per_interval) * along))));
    if (closure == CrgClosure::Kind::apart && k == 0) end = over_seam(tables, end, x, y);
  }
  for (int k = 0; k < 2; ++k) {
    const LinePieces<T> p(tables, end);
    const T behind = (x - p.x[1]) * (p.x[2] - p.x[0]) + (y - p.y[1]) * (p.y[2] - p.y[0]);
    const T beyond = (x - p.x[2]) * (p.x[3] - p.x[1]) + (y - p.y[2]) * (p.y[3] - p.y[1]);
    end = inside(T(end + T(select(-beyond, T(0.0), T(1.0))) - T(select(behind, T(0.0), T(1.0)))));
  }
  return end;
}

/// u and v of a place, over A: Slope<T>.
template <class A>
struct GridPlace {
  A u, v;
};

/// Straight on from an end of the line.
template <class A>
GridPlace<A> beyond_end(double u, double end_x, double end_y, double heading, const A& x, const A& y) {
  const A c(std::cos(heading)), s(std::sin(heading)), dx = x - A(end_x), dy = y - A(end_y);
  return {A(u) + c * dx + s * dy, c * dy - s * dx};
}

template <class T, class A>
GridPlace<A> grid_place(const GridTables<T>& tables, const A& x, const A& y) {
  using std::sqrt;
  const CrgRoad& road = *tables.grid.road;
  const GridPlace<A> start = beyond_end(road.start, road.x[0], road.y[0], road.heading[0], x, y);
  if (tables.grid.is_straight) return start;
  const T end = interval_end(tables, x.value, y.value);
  const LinePieces<T> p(tables, end);
  const T ex = p.x[2] - p.x[1], ey = p.y[2] - p.y[1];
  const T first_x = p.x[2] - p.x[0], first_y = p.y[2] - p.y[0], second_x = p.x[3] - p.x[1], second_y = p.y[3] - p.y[1];
  const A dx = x - A(p.x[1]), dy = y - A(p.y[1]);
  const A behind = (A(first_x) * dx + A(first_y) * dy) / A(first_x * ex + first_y * ey);
  const A ahead = (A(second_x) * (A(p.x[2]) - x) + A(second_y) * (A(p.y[2]) - y)) / A(second_x * ex + second_y * ey);
  const A u = A(road.start) + A(road.increment) * (A(end - T(1.0)) + behind / (behind + ahead));
  const A v = (A(ex) * dy - A(ey) * dx) / A(T(sqrt(ex * ex + ey * ey)));
  const CrgClosure& closure = road.closure;
  if (closure.kind == CrgClosure::Kind::meeting) return {u, v};
  const GridPlace<A> finish = beyond_end(road.end(), road.end_x, road.end_y, road.end_heading, x, y);
  const bool closes = closure.kind == CrgClosure::Kind::apart;
  const auto chosen = [&](A GridPlace<A>::*part, const A& on_line) {
    A before = start.*part, behind = finish.*part;
    if (closes) {
      before = select(start.u - A(road.start - closure.before), start.*part, finish.*part);
      behind = select(A(road.end() + closure.behind) - finish.u, finish.*part, start.*part);
    }
    return select(u - A(road.start), select(A(road.end()) - u, on_line, behind), before);
  };
  return {chosen(&GridPlace<A>::u, u), chosen(&GridPlace<A>::v, v)};
}

/// A place between 0 and `size` of a grid, for a place beyond its borders too.
template <class T, class A>
A inside_borders(RoadBorder border, const A& place, double size) {
  using mbgen::select;
  using std::floor;
  const auto from_last = [&](double length) { return place - A(T(length) * T(floor(T(T(1 / length) * place.value)))); };
  A back = place;
  if (border == RoadBorder::repeat) back = from_last(size);
  if (border == RoadBorder::reflect) {
    const A there_and_back = from_last(2 * size);
    back = select(A(size) - there_and_back, there_and_back, A(2 * size) - there_and_back);
  }
  return within(back, A(0.0), A(size));
}

/// The height of a place that may lie beyond a border. inside: height at the border; flat: height 0.
template <class T, class A>
A height_at_border(RoadBorder border, double offset, const A& place, double size, const A& inside, const A& flat) {
  using mbgen::select;
  const bool is_flat = border == RoadBorder::zero;
  if (!is_flat && (border != RoadBorder::keep || offset == 0)) return inside;
  const A outside = (is_flat ? flat : inside) + A(offset);
  return select(place, select(A(size) - place, inside, outside), outside);
}

/// Not a number, with its slopes, where a place is beyond a border that refuses it. room: m, to the nearer border.
template <class A>
A unless_refused(RoadBorder border, const A& room, const A& height) {
  using mbgen::select;
  using std::sqrt;
  constexpr double kRounding = 1e-8;  // m, of places on a border
  if (border != RoadBorder::refuse) return height;
  const A inside = room + A(kRounding);
  return select(inside, height, sqrt(inside));  // the root of a negative number is none
}

/// Height above the plane of the road's origin where x or y moves.
template <class T, class A>
A height_on_grid(const GridTables<T>& tables, const A& x, const A& y) {
  using mbgen::select;
  using std::floor;
  const RoadGrid& grid = tables.grid;
  const CrgRoad& road = *grid.road;
  const GridPlace<A> at = grid_place(tables, x, y);
  const A way = A(1 / road.increment) * (at.u - A(road.start));
  const A along = inside_borders<T>(grid.ends, way, tables.last());
  const T section = min(T(floor(along.value)), T(tables.last() - 1));
  const A share = along - A(section);
  const bool comes_back = grid.sides == RoadBorder::repeat || grid.sides == RoadBorder::reflect;
  const double width = road.v.back() - road.v.front();
  const A side_way = at.v - A(road.v.front());
  const A v = comes_back ? A(road.v.front()) + inside_borders<T>(grid.sides, side_way, width)
                         : within(at.v, A(road.v.front()), A(road.v.back()));
  const T cell =
      min(T(floor(T(T(1 / grid.column_cell) * (v.value - T(road.v.front()))))), T(grid.column_cell_count - 1.0));
  const T guess = tables.at(grid.column_cells, cell);
  const T column = min(T(guess + T(select(v.value - tables.at(grid.columns, T(guess + T(1.0))), T(1.0), T(0.0)))),
                       T(static_cast<double>(road.v.size()) - 2));
  const T right = tables.at(grid.columns, column), left = tables.at(grid.columns, T(column + T(1.0)));
  const A side = (v - A(right)) / A(left - right);
  const T first = T(static_cast<double>(road.v.size())) * section + column;
  const auto in_section = [&](double further) {
    const T a = tables.at(grid.heights, T(first + T(further))), b = tables.at(grid.heights, T(first + T(further + 1)));
    return A(a) + side * A(b - a);
  };
  const auto of_line = [&](int number) {
    const T a = tables.line(section, number), b = tables.line(T(section + T(1.0)), number);
    return A(a) + share * A(b - a);
  };
  const A here = in_section(0), there = in_section(static_cast<double>(road.v.size()));
  A z = here + share * (there - here) + of_line(2);
  if (!road.banking.empty()) z = z + of_line(3) * v;
  const auto at_sides = [&](const A& height) {
    return height_at_border<T>(grid.sides, grid.side_offset, side_way, width, height, A(0.0));
  };
  z = height_at_border<T>(grid.ends, grid.end_offset, way, tables.last(), at_sides(z), at_sides(A(0.0)));
  const auto smooth = [&](double zone, const A& inside, double base) {
    if (zone > 0) z = A(base) + within(A(1 / zone) * inside, A(0.0), A(1.0)) * (z - A(base));
  };
  const bool begins_again = grid.ends == RoadBorder::repeat || grid.ends == RoadBorder::reflect;
  const A u = begins_again ? A(road.start) + A(road.increment) * along : at.u;
  smooth(grid.smooth_begin, u - A(road.start), road.line_height.front());
  smooth(grid.smooth_end, A(road.end()) - u, road.line_height.back());
  z = unless_refused(grid.ends, min(at.u - A(road.start), A(road.end()) - at.u), z);
  return unless_refused(grid.sides, min(at.v - A(road.v.front()), A(road.v.back()) - at.v), z);
}

template <class T>
RoadHeight<T> grid_height(const std::vector<double>& samples, const RoadGrid& grid, const T& x, const T& y) {
  using S = Slope<T>;
  const GridTables<T> tables{samples, grid};
  const S along = height_on_grid(tables, S(x, T(1.0)), S(y));
  return {along.value, along.slope, height_on_grid(tables, S(x), S(y, T(1.0))).slope};
}

}  // namespace detail
}  // namespace mbgen
