#pragma once
// Cubic splines over equal distances as sums of B-splines.

#include <vector>

namespace mbgen::reading {

/// Coefficients c[0] to c[n + 3] of the spline through n values at 0, 1, ..., n - 1, without curvature at its ends; its
/// value at i is (c[i] + 4 c[i + 1] + c[i + 2]) / 6, and what lies behind is level.
/// Requires: n >= 2. Source: C. de Boor, A Practical Guide to Splines, 1978, chapter IX.
std::vector<double> spline_coefficients(const std::vector<double>& values);

}  // namespace mbgen::reading
