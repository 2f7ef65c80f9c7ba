#include "compiler/passes/passes.hpp"
#include "compiler/program/rewrite.hpp"

namespace mbgen {

/// From this many divisions by one value on, a reciprocal and products are cheaper.
static constexpr int kWorthwhile = 3;

Program merge_divisions(const Program& program) {
  std::vector<int> divisions_by(program.nodes.size(), 0);
  for (const Node& node : program.nodes)
    if (node.op == Op::divide) ++divisions_by[node.operands[1]];
  // a / d -> a * (1 / d); the reciprocal of a constant is one
  return rewritten(program, [&](ProgramBuilder& builder, ValueId v, std::span<const ValueId> renamed) {
    const auto& [a, d, none] = program.nodes[v].operands;
    if (program.nodes[v].op != Op::divide) return kNoValue;
    if (divisions_by[d] < kWorthwhile && program.nodes[d].op != Op::constant) return kNoValue;
    return builder.append(Op::multiply, renamed[a], builder.append(Op::divide, builder.constant(1), renamed[d]));
  });
}

}  // namespace mbgen
