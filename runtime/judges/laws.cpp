#include "runtime/judges/laws.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen::cartesian {

double value_of(const Table& table, double argument) {
  const std::vector<double>&x = table.x, &y = table.y;
  const double periods = table.periodic ? std::floor((argument - x.front()) / (x.back() - x.front())) : 0;
  const double at = argument - periods * (x.back() - x.front()), risen = periods * (y.back() - y.front());
  const auto next = std::clamp(std::upper_bound(x.begin(), x.end(), at), x.begin() + 1, x.end() - 1);
  const auto i = static_cast<std::size_t>(next - x.begin()) - 1;
  const double width = x[i + 1] - x[i], part = (at - x[i]) / width, rest = 1 - part;
  if (table.slopes.empty()) return risen + rest * y[i] + part * y[i + 1];
  const double left = table.slopes[i], right = table.slopes[i + 1];
  if (part < 0) return risen + y[i] + left * (at - x[i]);
  if (part > 1) return risen + y[i + 1] + right * (at - x[i + 1]);
  // Hermite's polynomials.
  return risen + rest * rest * ((1 + 2 * part) * y[i] + part * width * left) +
         part * part * ((1 + 2 * rest) * y[i + 1] - rest * width * right);
}

double law(const std::optional<Law>& law, const Values& value, double argument) {
  if (!law) return 0;
  if (const Quantity* factor = std::get_if<Quantity>(&*law)) return value(*factor) * argument;
  return value_of(std::get<Table>(*law), argument);
}

double with_locals(const std::optional<int>& expression, Values value, double first, double second) {
  if (!expression) return 0;
  value.locals = {first, second};
  return evaluate<double>(value.model.expressions[*expression], value);
}

}  // namespace mbgen::cartesian
