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

std::string dump(const Program& program) {
  std::string text = fmt::format("program {}\n", program.name);
  std::uint16_t section = 0, block = 0;
  for (std::size_t value = 0; value < program.nodes.size(); ++value) {
    const Node& node = program.nodes[value];
    if (arity(node.op) > 0 && node.section != section) {
      section = node.section;
      append_title(text, "section", program.sections[section]);
    }
    if (arity(node.op) > 0 && node.block != block) {
      block = node.block;
      append_title(text, "block", program.blocks[block]);
    }
    append_value(text, program, value);
  }
  for (const auto& [slot, value] : program.outputs) text += fmt::format("out {} = %{}\n", text_of(slot), value);
  return text;
}

}  // namespace mbgen
