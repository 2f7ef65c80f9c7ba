#pragma once
// A value over time, piece by piece a polynomial.

#include <vector>

namespace mbgen::cli {

/// Piece k holds from times[k] to times[k + 1], the last one without end or until `end`; coefficients are those of
/// powers of the time since its start, the constant first. Outside the value stands still.
struct Course {
  std::vector<double> times;                ///< s, strictly increasing, one per piece
  std::vector<std::vector<double>> pieces;  ///< coefficients
  double end = 0;                           ///< s
  double before = 0, after = 0;             ///< values outside

  double at(double t) const;
};

/// The polynomial through all times with these coefficients of powers of t.
Course polynomial(std::vector<double> coefficients);

/// Straight lines from point to point, the end values held outside. Requires: as many t as y, at least one; t strictly
/// increasing. So do the cubic splines below.
Course straight_lines(const std::vector<double>& t, const std::vector<double>& y);

/// The cubic spline through the points: continuous to the second derivative, the third one continuous next to the ends
/// (not-a-knot); a parabola through three points, a line through two. The end values are held outside.
/// Source: C. de Boor, A Practical Guide to Splines, 1978, chapter IV.
Course cubic_spline(const std::vector<double>& t, const std::vector<double>& y);

/// The derivative inside the pieces, zero outside.
Course derivative(const Course& course);

}  // namespace mbgen::cli
