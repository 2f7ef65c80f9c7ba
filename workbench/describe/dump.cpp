#include "workbench/describe/dump.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "compiler/compile.hpp"
#include "compiler/program/kinds.hpp"
#include "compiler/solver/titles.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/describe/dump_model.hpp"
#include "workbench/describe/names.hpp"

namespace mbgen {
namespace {

std::string dump_bodies(const Topology& topology) {
  std::string text = "bodies (index name: coordinate, kind, parent)\n";
  for (int i = 0; i < topology.size(); ++i) {
    const TreeBody& body = topology.bodies[i];
    text +=
        fmt::format("  {} {}: {}, {} about or along ({}), on {}{}\n", i, body.name, body.coordinate, name_of(body.kind),
                    fmt::join(body.axis, ", "), body_name(topology, body.parent), body.massless ? ", massless" : "");
  }
  return text;
}

std::string dump_topology(const Topology& topology) {
  std::string text = dump_bodies(topology) + "loops\n";
  for (const Loop& loop : topology.loops) {
    text += fmt::format("  {}: {}, from {} to {}, ancestor {}, {} equations, joints {}\n", loop.name,
                        name_of(loop.kind), body_name(topology, loop.body_from), body_name(topology, loop.body_to),
                        body_name(topology, loop.ancestor), loop.equations,
                        fmt::join(coordinate_names(topology, loop.joints), " "));
  }
  text += "loop blocks\n";
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& block = topology.blocks[b];
    text += fmt::format("  {}: on {}, {} equations, loops {}, joints {}\n", b, body_name(topology, block.base),
                        block.equations, fmt::join(block.loops, " "),
                        fmt::join(coordinate_names(topology, block.joints), " "));
  }
  text += "groups, from the root\n";
  for (std::size_t g = 0; g < topology.groups.size(); ++g) {
    const JointGroup& group = topology.groups[g];
    text += fmt::format(
        "  {}: {}, on {}, parent {}, joints {}\n", g, group.block < 0 ? "joint" : fmt::format("block {}", group.block),
        body_name(topology, group.base), group.parent, fmt::join(coordinate_names(topology, group.joints), " "));
  }
  return text;
}

std::string dump_analysis(const Topology& topology, const Analysis& analysis) {
  std::string text =
      fmt::format("closed configurations {}\nindependent equations {}\ndegrees of freedom {}\n",
                  analysis.closed_configurations, analysis.independent_equations, analysis.degrees_of_freedom);
  for (std::size_t b = 0; b < analysis.blocks.size(); ++b) {
    const BlockAnalysis& decided = analysis.blocks[b];
    const LoopBlock& block = topology.blocks[b];
    text += fmt::format("block {}: rank {} of {} equations, worst pivot ratio {}\n", b, decided.rank, block.equations,
                        decided.worst_pivot_ratio);
    text += fmt::format("  dependent {}\n", fmt::join(local_names(topology, block, decided.dependent), " "));
    text += fmt::format("  independent {}\n", fmt::join(local_names(topology, block, decided.independent), " "));
    text += fmt::format("  driven {}\n", fmt::join(local_names(topology, block, decided.driven), " "));
    text += fmt::format("  redundant {}\n", fmt::join(decided.redundant_names, ", "));
    text += fmt::format("  triangular blocks {}\n", fmt::join(decided.triangular_sizes, " "));
    for (const Pivot& pivot : decided.pivots) {
      text += fmt::format("  pivot equation {} coordinate {} reference {}\n", pivot.equation,
                          topology.bodies[block.joints[pivot.coordinate]].coordinate, pivot.reference);
    }
  }
  return text;
}

/// The programs that a stage left, and the accelerations in pairs.
struct StagePrograms {
  std::vector<const Program*> all;
  const std::optional<PairedAccelerations>& in_pairs;
};

StagePrograms programs_of(const Compilation& so_far) {
  const std::vector<const Program*> emitted = all_programs(so_far.emitted);
  if (!emitted.empty()) return {emitted, so_far.emitted.in_pairs};
  return {all_programs(so_far.whole), so_far.whole.in_pairs};
}

std::string dump_programs(const Compilation& so_far) {
  const Titles titles = titles_of(so_far.form(), so_far.model, so_far.topology);
  const auto [all, in_pairs] = programs_of(so_far);
  std::string text;
  for (const Program* program : all) text += fmt::format("; program {}\n{}\n", program->name, dump(*program, titles));
  if (in_pairs)
    text += fmt::format("; program {} in pairs\n{}\n", in_pairs->program.name, dump(in_pairs->program, titles));
  return text;
}

std::string dump_code(const std::vector<EmittedFile>& files) {
  std::string text;
  for (const EmittedFile& file : files) text += fmt::format("// ===== {} =====\n{}", file.path, file.text);
  return text;
}

std::string dump_of(const Stage& stage) {
  const auto& [name, so_far, milliseconds] = stage;
  if (name == "model") return dump_model(so_far.model);
  if (name == "topology") return dump_topology(so_far.topology);
  if (name == "analysis") return dump_analysis(so_far.topology, so_far.analysis);
  return dump_programs(so_far);
}

/// Share of statements on pairs in the accelerations in pairs.
std::string pairs_text(const Program& program) {
  const std::vector<int> widths = widths_of(program);
  const std::vector<ValueId> statements = live_operations(program);
  const auto is_pair = [&](ValueId v) { return widths[v] == 2 && program.nodes[v].op != Op::pack; };
  return fmt::format("; in pairs {} of {} statements", std::ranges::count_if(statements, is_pair), statements.size());
}

/// Operation counts of the accelerations, and of all programs, after a stage.
std::string stage_line(const Stage& stage) {
  const std::string line = fmt::format("{:<18}{:>10.1f} ms", stage.name, stage.milliseconds);
  const auto [programs, in_pairs] = programs_of(stage.so_far);
  if (programs.empty()) return line + "\n";
  long all = 0;
  for (const Program* program : programs) all += count_operations(*program).total();
  return fmt::format("{}{:>9} operations, {:>8} of them in the accelerations{}\n", line, all,
                     count_operations(*programs.front()).total(), in_pairs ? pairs_text(in_pairs->program) : "");
}

}  // namespace

std::vector<std::string> dump_stages() {
  std::vector<std::string> stages = stage_names();
  stages.insert(stages.end(), {"code", "passes"});
  return stages;
}

std::string dump_stage(Model model, const std::string& stage, const StartOf& start, std::optional<Form> form,
                       EmitOptions options) {
  const std::vector<std::string> stages = dump_stages();
  if (std::find(stages.begin(), stages.end(), stage) == stages.end()) {
    throw UserError(fmt::format("--dump: no stage \"{}\"; there are: {}\n", stage, fmt::join(stages, ", ")));
  }
  std::string text;
  const StageWatch watch = [&](const Stage& ended) {
    if (stage == "passes") text += stage_line(ended);
    if (ended.name == stage) text = dump_of(ended);
    return ended.name != stage;
  };
  const Compilation compilation = expect(compile(std::move(model), {form, watch}));
  if (stage != "code") return text;
  options.runtime_headers = false;
  options.initial = start(compilation);
  return dump_code(emit(compilation, options));
}

}  // namespace mbgen
