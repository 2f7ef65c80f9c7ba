#include "compiler/passes/passes.hpp"
#include "compiler/program/identities.hpp"
#include "compiler/program/kinds.hpp"
#include "compiler/program/rewrite.hpp"

namespace mbgen {

Program merge_equal_values(const Program& program) {
  const std::vector<Identity> all = identities(program);
  return rewritten(program, [&](ProgramBuilder& builder, ValueId v, std::span<const ValueId> renamed) {
    const Identity& identity = all[v];
    if (!is_operation(program.nodes[v])) return kNoValue;
    if (identity.sign == 0) return builder.constant(0);
    if (identity.first == v) return kNoValue;
    return identity.sign > 0 ? renamed[identity.first] : builder.append(Op::negate, renamed[identity.first]);
  });
}

}  // namespace mbgen
