#include "runtime/cartesian/laws.hpp"

#include <vector>

#include "mbgen/table.hpp"

namespace mbgen::cartesian {

double along(const Table& table, double argument) {
  const int count = static_cast<int>(table.x.size());
  if (table.interpolation == Table::Interpolation::linear)
    return interpolate_linear(table.x.data(), table.y.data(), count, argument);
  std::vector<double> slopes(table.x.size());
  monotone_slopes(table.x.data(), table.y.data(), count, slopes.data());
  return interpolate_monotone_cubic(table.x.data(), table.y.data(), slopes.data(), count, argument);
}

double law(const std::optional<Law>& law, const Values& value, double argument) {
  if (!law) return 0;
  if (const Quantity* factor = std::get_if<Quantity>(&*law)) return value(*factor) * argument;
  return along(std::get<Table>(*law), argument);
}

double with_locals(const std::optional<int>& expression, Values value, double first, double second) {
  if (!expression) return 0;
  value.locals = {first, second};
  return evaluate<double>(value.model.expressions[*expression], value);
}

}  // namespace mbgen::cartesian
