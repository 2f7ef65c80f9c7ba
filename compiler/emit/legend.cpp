#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/quantity_names.hpp"
#include "compiler/emit/shapes.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/topology/names.hpp"

namespace mbgen {
namespace {

std::string line(const std::string& words, const std::string& indent = "") {
  return wrapped_words(comment_text(words), "// " + indent) + "\n";
}

std::string tree_text(const EmitContext& context) {
  const Topology& topology = context.topology;
  std::string text = line("Tree, each body with its coordinate, on the body before it:");
  for (const TreeBody& body : topology.bodies) {
    text += line(fmt::format("{}: {}, {}, on {}", body.name, body.coordinate, name_of(body.kind),
                             body_name(topology, body.parent)),
                 "  ");
  }
  return text;
}

std::string coordinates_of(const Topology& topology, const LoopBlock& block, const std::vector<int>& columns) {
  return columns.empty() ? "none" : joined(local_names(topology, block, columns), ", ");
}

std::string loops_text(const EmitContext& context) {
  const Topology& topology = context.topology;
  std::string text;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& block = topology.blocks[b];
    text += line(fmt::format("Loop block {}, on {}:", b, body_name(topology, block.base)));
    for (const int l : block.loops) {
      const Loop& loop = topology.loops[static_cast<std::size_t>(l)];
      text += line(fmt::format("{}: {} between {} and {}", loop.name, name_of(loop.kind),
                               body_name(topology, loop.body_from), body_name(topology, loop.body_to)),
                   "  ");
    }
    const BlockAnalysis& found = context.analysis.blocks[b];
    text += line("independent: " + coordinates_of(topology, block, found.independent), "  ");
    if (context.programs.form == Form::recursive && found.quasi.independent != found.independent)
      text += line("in the accelerations: " + coordinates_of(topology, block, found.quasi.independent), "  ");
  }
  return text;
}

/// Whether a value or a number of the programs has a name that begins so.
bool has_name(const EmitContext& context, std::string_view prefix) {
  const auto is_so = [&](const Program& program, const Node& node) {
    if (node.label < 0) return false;
    const auto label = static_cast<std::size_t>(node.label);
    return (node.op == Op::constant ? program.constants[label].name : program.labels[label]).starts_with(prefix);
  };
  return std::ranges::any_of(all_programs(context.written), [&](const Program* program) {
    return std::ranges::any_of(program->nodes, [&](const Node& node) { return is_so(*program, node); });
  });
}

/// The kinds of quantities that the programs have, of a text for people.
std::string quantities_text(const EmitContext& context) {
  if (context.options.spelling != Spelling::reading) return "";
  std::set<std::string_view> met;
  for (const Program* program : all_programs(context.written)) {
    for (const std::string& label : program->labels) met.insert(quantity_of(label).prefix);
    for (const NamedConstant& constant : program->constants) met.insert(quantity_of(constant.name).prefix);
  }
  std::string text;
  for (const QuantityName& kind : quantity_names()) {
    if (!met.contains(kind.prefix)) continue;
    text += line(fmt::format("{}: {}{}{}", kind.prefix, kind.words, kind.unit.empty() ? "" : ", ", kind.unit), "  ");
  }
  return text;
}

}  // namespace

std::string legend_text(const EmitContext& context) {
  return fill_template("legend.in",
                       {{"tree", tree_text(context)},
                        {"reading", context.options.spelling == Spelling::reading},
                        {"quantities", quantities_text(context)},
                        {"loops", loops_text(context)},
                        {"moments", has_name(context, "K_") ? "h first moments, K second moments" : "h first moments"},
                        {"pairs", context.in_pairs}});
}

}  // namespace mbgen
