#include <fmt/format.h>

#include <iterator>

#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// A comment line with a title, "; section dynamics"; the untitled one is "; section".
void append_title(std::string& text, const char* kind, const std::string& title) {
  fmt::format_to(std::back_inserter(text), "; {}{}{}\n", kind, title.empty() ? "" : " ", title);
}

void append_value(std::string& text, const Program& program, std::size_t value) {
  const Node& node = program.nodes[value];
  auto end = std::back_inserter(text);
  fmt::format_to(end, "%{} = {}", value, op_name(node.op));
  if (node.op == Op::constant) fmt::format_to(end, " {}", node.constant);
  if (node.op == Op::input) {
    fmt::format_to(end, " {}", text_of(program.inputs[static_cast<std::size_t>(node.input)]));
  }
  for (int i = 0; i < arity(node.op); ++i) fmt::format_to(end, " %{}", node.operands[i]);
  const auto label = static_cast<std::size_t>(node.label);
  if (node.label >= 0)
    fmt::format_to(end, "  ; {}", node.op == Op::constant ? program.constants[label].name : program.labels[label]);
  text += '\n';
}

}  // namespace

std::string text_of(const Section& section) {
  if (section.step == Step::none) return "";
  const std::string step = fmt::format("step {}", static_cast<int>(section.step));
  return section.block < 0 ? step : fmt::format("{}, block {}", step, section.block);
}

std::string text_of(const Owner& owner) {
  constexpr const char* kKinds[] = {"",      "tree_body", "loop",   "loop_block", "body",
                                    "joint", "motion",    "output", "state",      "sampled"};
  static_assert(std::size(kKinds) == static_cast<std::size_t>(OwnerKind::element));
  if (owner.kind == OwnerKind::none) return "";
  if (const int kind = place_of_kind(owner.kind); kind >= 0)
    return fmt::format("element {} of kind {}", owner.index, kind);
  return fmt::format("{} {}", kKinds[static_cast<int>(owner.kind)], owner.index);
}

std::string dump(const Program& program, const Titles& titles) {
  std::string text = fmt::format("program {}\n", program.name);
  Section section;
  Owner owner;
  for (std::size_t value = 0; value < program.nodes.size(); ++value) {
    const Node& node = program.nodes[value];
    if (arity(node.op) > 0 && node.section != section) {
      section = node.section;
      append_title(text, "section", titles.section(section));
    }
    if (arity(node.op) > 0 && node.owner != owner) {
      owner = node.owner;
      append_title(text, "owner", titles.owner(owner));
    }
    append_value(text, program, value);
  }
  for (const auto& [slot, value] : program.outputs) text += fmt::format("out {} = %{}\n", text_of(slot), value);
  return text;
}

}  // namespace mbgen
