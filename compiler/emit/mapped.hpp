#pragma once
// Lists computed from lists.

#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace mbgen {

/// Results of `make`, a function of an item or one of its members, for each item.
template <class Items, class Make>
auto mapped(const Items& items, Make make) {
  std::vector<std::decay_t<std::invoke_result_t<Make&, decltype(*std::begin(items))>>> results;
  for (const auto& item : items) results.push_back(std::invoke(make, item));
  return results;
}

/// The `name` of each item.
template <class Items>
std::vector<std::string> names_of(const Items& items) {
  return mapped(items, [](const auto& item) { return item.name; });
}

}  // namespace mbgen
