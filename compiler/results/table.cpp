#include "compiler/results/table.hpp"

#include <fmt/format.h>

namespace mbgen {

std::string heading_text(const Heading& heading) {
  return heading.unit.empty() ? heading.name : fmt::format("{} [{}]", heading.name, heading.unit);
}

int find_column(const Results& results, const std::string& name) {
  for (std::size_t c = 0; c < results.columns.size(); ++c) {
    const Heading& heading = results.columns[c].heading;
    if (heading.name == name || heading_text(heading) == name) return static_cast<int>(c);
  }
  return -1;
}

}  // namespace mbgen
