#include "workbench/results/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mbgen {

std::string heading_text(const Heading& heading) {
  // Only the brackets around a unit are brackets: the heading can be taken apart again.
  std::string unit = heading.unit;
  std::replace(unit.begin(), unit.end(), '[', '(');
  std::replace(unit.begin(), unit.end(), ']', ')');
  return unit.empty() ? heading.name : fmt::format("{} [{}]", heading.name, unit);
}

int find_column(const Results& results, const std::string& name) {
  for (std::size_t c = 0; c < results.columns.size(); ++c) {
    const Heading& heading = results.columns[c].heading;
    if (heading.name == name || heading_text(heading) == name) return static_cast<int>(c);
  }
  return -1;
}

}  // namespace mbgen
