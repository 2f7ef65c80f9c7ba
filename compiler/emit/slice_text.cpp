#include "compiler/emit/slice_text.hpp"

#include <algorithm>
#include <cstdlib>

#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {

std::string common_label(const std::string& a, const std::string& b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t front = 0, back = 0;
  while (front < shorter && a[front] == b[front]) ++front;
  while (back + front < shorter && a[a.size() - 1 - back] == b[b.size() - 1 - back]) ++back;
  return a.substr(0, front) + a.substr(a.size() - back);
}

std::string label_of_both(const std::string& first, const std::string& second) {
  const auto ends_word = [](const std::string& text, std::size_t at) { return at == text.size() || text[at] == '_'; };
  const std::size_t shorter = std::min(first.size(), second.size());
  std::size_t front = 0, back = 0;
  for (std::size_t i = 0; i < shorter && first[i] == second[i]; ++i)
    if (first[i] == '_') front = i + 1;
  for (std::size_t i = 1; i + front < shorter && first[first.size() - i] == second[second.size() - i]; ++i)
    if (first[first.size() - i] == '_') back = i;
  if (first == second || !ends_word(first, first.size() - back)) return first;
  return first.substr(0, first.size() - back) + "_and_" + second.substr(front);
}

std::string SliceTables::index(const std::vector<int>& indices) {
  const int first = indices[0], step = indices.size() > 1 ? indices[1] - first : 0;
  for (std::size_t slice = 0; slice < indices.size(); ++slice) {
    if (indices[slice] == first + step * static_cast<int>(slice)) continue;
    return item("int", "kPlaces", mapped(indices, [](int index) { return std::to_string(index); }));
  }
  if (step == 0) return std::to_string(first);
  const std::string slope = (std::abs(step) == 1 ? "" : std::to_string(std::abs(step)) + "*") + "k";
  if (first == 0 && step > 0) return slope;
  return std::to_string(first) + (step > 0 ? " + " : " - ") + slope;
}

std::string SliceTables::item(const std::string& type, const std::string& base, const std::vector<std::string>& items) {
  std::string& name = tables_[{type, items}];
  if (name.empty()) {
    name = names_.unique(base);
    declarations_ += array_text("  static constexpr " + type + " " + name, items, "0") + "\n";
  }
  return name + "[k]";
}

}  // namespace mbgen
