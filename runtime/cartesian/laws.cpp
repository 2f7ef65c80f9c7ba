#include "runtime/cartesian/laws.hpp"

#include "compiler/model/curve.hpp"

namespace mbgen::cartesian {

double law(const std::optional<Law>& law, const Values& value, double argument) {
  if (!law) return 0;
  if (const Quantity* factor = std::get_if<Quantity>(&*law)) return value(*factor) * argument;
  return value_along(std::get<Table>(*law), argument);
}

double with_locals(const std::optional<int>& expression, Values value, double first, double second) {
  if (!expression) return 0;
  value.locals = {first, second};
  return evaluate<double>(value.model.expressions[*expression], value);
}

}  // namespace mbgen::cartesian
