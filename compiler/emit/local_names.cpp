#include "compiler/emit/local_names.hpp"

#include <fmt/format.h>

#include "compiler/emit/text.hpp"

namespace mbgen {

std::string LocalNames::of_value(ValueId value) {
  const Node& node = program_.nodes[value];
  if (node.label >= 0) return identifier(program_.labels[node.label]);
  const int step = number_of(node.section.step);
  std::string candidate;
  do {
    candidate = fmt::format("s{}_{}", step, ++leftovers_[step]);
  } while (!reserve(candidate));
  return candidate;
}

ConstantNames::Entry& ConstantNames::entry_of(const NamedConstant& constant) {
  const auto [found, is_new] = index_.try_emplace({constant.name, constant.value}, entries_.size());
  if (is_new) entries_.push_back({names_.identifier(constant.name), constant});
  return entries_[found->second];
}

ConstantNames::ConstantNames(const WrittenPrograms& programs) {
  for (const Program* program : all_programs(programs)) identifiers(*program);
}

std::vector<std::string> ConstantNames::identifiers(const Program& program) {
  std::vector<std::string> result;
  for (const NamedConstant& constant : program.constants) result.push_back(entry_of(constant).identifier);
  return result;
}

std::string ConstantNames::text(const Program& program, const Node& node) {
  Entry& entry = entry_of(program.constants[static_cast<std::size_t>(node.label)]);
  entry.is_used = true;
  return node.constant == entry.constant.value ? entry.identifier : "-" + entry.identifier;
}

std::string ConstantNames::declarations(Scalar scalar) const {
  std::string text;
  for (const Entry& entry : entries_) {
    if (!entry.is_used) continue;
    text += std::string("constexpr ") + name_of(scalar) + " " + entry.identifier + " = " +
            number_text(entry.constant.value, scalar) + ";\n";
  }
  return text;
}

}  // namespace mbgen
