#include "compiler/emit/local_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/emit/names.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// The number that a section's title begins with, as in "3 Rz", else its index.
std::string section_tag(const Program& program, int section) {
  constexpr const char* kDigits = "0123456789";
  const std::string& title = program.sections[section];
  const std::size_t first = std::min(title.find_first_of(kDigits), title.size());
  const std::string number = title.substr(first, title.find_first_not_of(kDigits, first) - first);
  return number.empty() ? std::to_string(section) : number;
}

}  // namespace

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
  std::string candidate;
  do {
    candidate =
        fmt::format("s{}_{}", section_tag(program_, node.section), ++leftovers_[section_tag(program_, node.section)]);
  } while (!reserve(candidate));
  return candidate;
}

}  // namespace mbgen
