#include "compiler/passes/passes.hpp"
#include "compiler/program/kinds.hpp"

namespace mbgen {

// As g++ encodes them for AVX2, with their moves and addresses.
static constexpr long kOperationBytes = 11, kPackBytes = 16, kBroadcastBytes = 10, kFirstLaneBytes = 3,
                      kSecondLaneBytes = 12, kNegationBytes = 4;

long size_of_code(const Program& program) {
  const Program contracted = contract(program);
  long size = 0;
  for (const ValueId v : live_operations(contracted)) {
    const Node& node = contracted.nodes[v];
    if (is_constant_pair(contracted, node)) continue;
    switch (node.op) {
      case Op::pack:
        size += node.operands[0] == node.operands[1] ? kBroadcastBytes : kPackBytes;
        break;
      case Op::first_lane:
        size += kFirstLaneBytes;
        break;
      case Op::second_lane:
        size += kSecondLaneBytes;
        break;
      case Op::negate:
        size += kNegationBytes;
        break;
      default:
        size += kOperationBytes;
    }
  }
  return size;
}

}  // namespace mbgen
