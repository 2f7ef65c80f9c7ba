#pragma once
// A value over time as piecewise polynomials.

#include <vector>

namespace mbgen {

/// Piece k holds from times[k] to times[k + 1], the last one without end or until `end`; its coefficients belong to
/// powers of the time since its start, the constant first. Outside, the value is constant.
struct Course {
  std::vector<double> times;                ///< s, strictly increasing, one per piece
  std::vector<std::vector<double>> pieces;  ///< coefficients
  double end = 0;                           ///< s
  double before = 0, after = 0;             ///< values outside

  double at(double t) const;
};

/// The polynomial with these coefficients of powers of t, for all times.
Course polynomial(std::vector<double> coefficients);

/// Straight lines from point to point, with constant values outside. Requires: as many t as y, at least one; t strictly
/// increasing; likewise for all functions below.
Course straight_lines(const std::vector<double>& t, const std::vector<double>& y);

/// The cubic spline through the points: continuous to the second derivative, the third one continuous next to the ends
/// (not-a-knot); a parabola through three points, a line through two. Constant outside. Source: C. de Boor, A Practical
/// Guide to Splines, 1978, chapter IV.
Course cubic_spline(const std::vector<double>& t, const std::vector<double>& y);

/// The shape-preserving cubic (PCHIP) through the points: continuous with its first derivative, always between the
/// values of the two adjacent points; a line through two. Constant outside. Source: F. N. Fritsch, J. Butland, "A
/// Method for Constructing Local Monotone Piecewise Cubic Interpolants", SIAM J. Sci. Stat. Comput. 5(2), 1984, their
/// harmonic mean of the secants; slopes at the ends: C. Moler, Numerical Computing with MATLAB, 2004, section 3.6, as
/// in scipy.interpolate.PchipInterpolator.
Course pchip(const std::vector<double>& t, const std::vector<double>& y);

/// The value of the last point passed; before the first point, its value.
Course zero_order_hold(const std::vector<double>& t, const std::vector<double>& y);

/// The polynomials between the points with the given derivatives at both ends: derivatives[k][i] of order k at t[i],
/// order 0 is the value; m derivatives give the degree 2 m - 1. Constant outside.
Course hermite(const std::vector<double>& t, const std::vector<std::vector<double>>& derivatives);

/// The derivative inside the pieces, zero outside.
Course derivative(const Course& course);

/// Smallest and largest value from the first point to `end`, or to the last point for a course without end.
struct CourseRange {
  double smallest = 0, largest = 0;
};

/// By kSamples samples per piece: the error of an extremum is about 1e-3 of the rise of the piece.
CourseRange range_of(const Course& course);

}  // namespace mbgen
