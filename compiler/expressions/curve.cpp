#include "compiler/expressions/curve.hpp"

#include <algorithm>

namespace mbgen {
namespace {

using Numbers = std::vector<double>;

/// Widths and secants of the segments of a table.
struct Segments {
  Numbers width, secant;
};

Segments segments_of(const Table& table) {
  Segments segments;
  for (std::size_t i = 0; i + 1 < table.x.size(); ++i) {
    segments.width.push_back(table.x[i + 1] - table.x[i]);
    segments.secant.push_back((table.y[i + 1] - table.y[i]) / segments.width.back());
  }
  return segments;
}

/// Slopes of the parabola through three points.
Numbers parabola(const Segments& s) {
  const double bend = (s.secant[1] - s.secant[0]) / (s.width[0] + s.width[1]);
  return {s.secant[0] - bend * s.width[0], s.secant[0] + bend * s.width[0], s.secant[1] + bend * s.width[1]};
}

/// Elimination along three diagonals; in the equations of a spline no pivot is small.
Numbers solve_tridiagonal(const Numbers& lower, Numbers diagonal, const Numbers& upper, Numbers right) {
  const std::size_t n = right.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) right[i] -= upper[i] * right[i + 1];
    right[i] /= diagonal[i];
  }
  return right;
}

/// The spline whose third derivative is continuous at the points next to the ends. Requires: three segments or more.
Numbers spline_slopes(const Segments& s) {
  const std::size_t last = s.width.size();
  Numbers lower(last + 1), diagonal(last + 1), upper(last + 1), right(last + 1);
  // h: the end's segment, g: its neighbour.
  const auto end = [&](double h, double g, double secant, double next) {
    return ((h + 2 * (h + g)) * g * secant + h * h * next) / (h + g);
  };
  diagonal[0] = s.width[1];
  upper[0] = s.width[0] + s.width[1];
  right[0] = end(s.width[0], s.width[1], s.secant[0], s.secant[1]);
  for (std::size_t i = 1; i < last; ++i) {
    lower[i] = s.width[i];
    diagonal[i] = 2 * (s.width[i - 1] + s.width[i]);
    upper[i] = s.width[i - 1];
    right[i] = 3 * (s.width[i] * s.secant[i - 1] + s.width[i - 1] * s.secant[i]);
  }
  lower[last] = s.width[last - 2] + s.width[last - 1];
  diagonal[last] = s.width[last - 2];
  right[last] = end(s.width[last - 1], s.width[last - 2], s.secant[last - 1], s.secant[last - 2]);
  return solve_tridiagonal(lower, diagonal, upper, right);
}

/// The spline that goes on from period to period. Each equation's diagonal is twice the rest of it, so that a sweep
/// halves the error.
Numbers periodic_spline_slopes(const Segments& s) {
  constexpr int kSweeps = 64;
  const std::size_t n = s.width.size();
  Numbers slopes(n, 0.0);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      const double h = s.width[before], g = s.width[i];
      const double right = 3 * (g * s.secant[before] + h * s.secant[i]);
      slopes[i] = (right - g * slopes[before] - h * slopes[after]) / (2 * (h + g));
    }
  }
  slopes.push_back(slopes.front());
  return slopes;
}

/// Monotone slopes; those of a periodic table with a neighbour of the next period at each end.
Numbers monotone(const Table& table) {
  Numbers x = table.x, y = table.y;
  if (table.periodic) {
    const Segments s = segments_of(table);
    x.insert(x.begin(), x.front() - s.width.back());
    y.insert(y.begin(), y.front() - s.width.back() * s.secant.back());
    x.push_back(x.back() + s.width.front());
    y.push_back(y.back() + s.width.front() * s.secant.front());
  }
  Numbers slopes(x.size());
  monotone_slopes(x.data(), y.data(), static_cast<int>(x.size()), slopes.data());
  return table.periodic ? Numbers(slopes.begin() + 1, slopes.end() - 1) : slopes;
}

}  // namespace

std::vector<double> slopes_of(const Table& table) {
  if (table.interpolation == Table::Interpolation::linear || table.x.size() < 2) return {};
  if (table.interpolation == Table::Interpolation::monotone_cubic) return monotone(table);
  const Segments segments = segments_of(table);
  if (table.periodic) return periodic_spline_slopes(segments);
  if (segments.width.size() == 1) return {segments.secant[0], segments.secant[0]};
  return segments.width.size() == 2 ? parabola(segments) : spline_slopes(segments);
}

}  // namespace mbgen
