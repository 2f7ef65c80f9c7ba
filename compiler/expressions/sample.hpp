#pragma once
// Numbers of tables that stand as data.

#include <vector>

namespace mbgen {

/// Number `index` of a table, the first or last one outside, as mbgen/sample.hpp has it.
inline double sample(const std::vector<double>& samples, double index) {
  const double last = static_cast<double>(samples.size() - 1);
  return samples[index >= 0 ? static_cast<std::size_t>(index < last ? index : last) : 0];
}

}  // namespace mbgen
