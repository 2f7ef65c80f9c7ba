#include "compiler/emit/local_names.hpp"

#include <fmt/format.h>

#include "compiler/emit/names.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {

std::string UniqueNames::unique(const std::string& base) {
  std::string candidate = base;
  for (int& number = next_number_.try_emplace(base, 2).first->second; !taken_.insert(candidate).second; ++number) {
    candidate = numbered(base, number);
  }
  return candidate;
}

std::string LocalNames::of_value(ValueId value) {
  const Node& node = program_.nodes[value];
  if (node.label >= 0) return unique(identifier_base(program_.labels[node.label]));
  const int step = number_of(node.section.step);
  std::string candidate;
  do {
    candidate = fmt::format("s{}_{}", step, ++leftovers_[step]);
  } while (!reserve(candidate));
  return candidate;
}

}  // namespace mbgen
