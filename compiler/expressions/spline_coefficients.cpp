#include "compiler/expressions/spline_coefficients.hpp"

#include <cstddef>

namespace mbgen::reading {

std::vector<double> spline_coefficients(const std::vector<double>& values) {
  const std::size_t n = values.size();
  // c[i - 1] + 4 c[i] + c[i + 1] = 6 z[i] between the ends, c = z at them: elimination from the front.
  std::vector<double> inner = values, above(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 4 - above[i - 1];
    above[i] = 1 / pivot;
    inner[i] = (6 * values[i] - inner[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) inner[i] -= above[i] * inner[i + 1];
  std::vector<double> c = {2 * inner[0] - inner[1]};
  c.insert(c.end(), inner.begin(), inner.end());
  const double behind = 2 * inner[n - 1] - inner[n - 2];
  c.insert(c.end(), {behind, behind, behind});
  return c;
}

}  // namespace mbgen::reading
