#include "compiler/schedule/roll.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kGram = 6;              // operations that must agree before a period is tried
constexpr std::size_t kLongestPeriod = 8192;  // operations of a slice
constexpr int kTriedPeriods = 48;             // candidates per start
constexpr std::size_t kFewestSlices = 4;
constexpr std::size_t kLeastSaved = 128;  // operations: a shorter loop is not worth its frame

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash += word + 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  return hash ^ (hash >> 27);
}

/// Properties that a value must share with the values at its place in the other slices.
std::vector<std::uint64_t> signatures(const Program& program, const std::vector<ValueId>& order,
                                      const std::set<SlotGroup>& indexed) {
  const auto of_slot = [&](const Slot& slot) {
    const SlotGroup& group = slot.group;
    const std::uint64_t array =
        mixed(static_cast<std::uint64_t>(group.array), static_cast<std::uint64_t>(group.block + 1));
    return mixed(mixed(array, static_cast<std::uint64_t>(group.derivative)),
                 indexed.count(group) ? 0 : static_cast<std::uint64_t>(slot.index) + 1);
  };
  std::vector<std::uint64_t> of_outputs(program.nodes.size(), 0);
  for (const OutputValue& output : program.outputs)
    of_outputs[output.value] = mixed(of_outputs[output.value], of_slot(output.slot));
  std::vector<std::uint64_t> result;
  for (const ValueId v : order) {
    const Node& node = program.nodes[v];
    std::uint64_t signature = mixed(static_cast<std::uint64_t>(node.op), static_cast<std::uint64_t>(node.section.step));
    signature = mixed(signature, static_cast<std::uint64_t>(node.section.block + 1));
    signature = mixed(signature, of_outputs[v]);
    for (int k = 0; k < arity(node.op); ++k) {
      const Node& operand = program.nodes[node.operands[k]];
      signature =
          mixed(signature, operand.op == Op::constant ? 1
                           : operand.op == Op::input  ? of_slot(program.inputs[static_cast<std::size_t>(operand.input)])
                                                      : 2);
    }
    result.push_back(signature);
  }
  return result;
}

class LoopFinder {
 public:
  LoopFinder(const Program& program, const std::vector<ValueId>& order, const std::set<SlotGroup>& indexed)
      : signature_(signatures(program, order, indexed)), last_use_(order.size()) {
    std::vector<std::size_t> place(program.nodes.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = last_use_[i] = i;
      const Node& node = program.nodes[order[i]];
      for (int k = 0; k < arity(node.op); ++k)
        if (is_operation(program.nodes[node.operands[k]])) last_use_[place[node.operands[k]]] = i;
    }
    for (std::size_t i = 0; i + kGram <= signature_.size(); ++i) places_[gram(i)].push_back(i);
  }

  std::vector<RolledLoop> loops() {
    std::vector<RolledLoop> found;
    for (std::size_t i = 0; i + kGram <= signature_.size();) {
      const RolledLoop loop = best_from(i);
      if (loop.count == 0) {
        ++i;
        continue;
      }
      found.push_back(loop);
      i = loop.end();
    }
    return found;
  }

 private:
  std::uint64_t gram(std::size_t i) const {
    std::uint64_t hash = 0;
    for (std::size_t k = 0; k < kGram; ++k) hash = mixed(hash, signature_[i + k]);
    return hash;
  }

  /// How many values from `i` on have an equal one `period` later.
  std::size_t repeats(std::size_t i, std::size_t period) const {
    std::size_t length = 0;
    while (i + length + period < signature_.size() && signature_[i + length] == signature_[i + length + period])
      ++length;
    return length;
  }

  RolledLoop best_from(std::size_t i) const {
    const std::vector<std::size_t>& places = places_.at(gram(i));
    RolledLoop best;
    std::size_t saved = kLeastSaved;
    int tried = 0;
    for (auto next = std::upper_bound(places.begin(), places.end(), i);
         next != places.end() && *next - i <= kLongestPeriod && tried < kTriedPeriods; ++next, ++tried) {
      const std::size_t period = *next - i, length = repeats(i, period), first = best_start(i, period, length);
      // The first slice stays straight: what it takes from the slice before comes from elsewhere.
      // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): the next place is beyond i
      const std::size_t count = (i + length - first) / period;
      if (count < kFewestSlices || (count - 1) * period <= saved) continue;
      saved = (count - 1) * period;
      best = {first + period, period, count};
    }
    return best;
  }

  /// The start within the first slice at which the fewest values of a slice are still needed in the next.
  std::size_t best_start(std::size_t i, std::size_t period, std::size_t length) const {
    if (length < 2 * period) return i;
    std::vector<long> crossing(2 * period + 1, 0);
    for (std::size_t k = 0; k < period; ++k) {
      const std::size_t way = last_use_[i + period + k] - (i + period + k);
      if (way == 0 || way >= period) continue;
      ++crossing[k + 1];
      --crossing[k + way + 1];
    }
    std::size_t best = 0;
    long fewest = -1, live = 0;
    std::vector<long> at(period, 0);
    for (std::size_t k = 0; k < 2 * period; ++k) {
      live += crossing[k];
      at[k % period] += live;
    }
    for (std::size_t k = 0; k < period; ++k)
      if (fewest < 0 || at[k] < fewest) fewest = at[k], best = k;
    return i + best;
  }

  std::vector<std::uint64_t> signature_;
  std::vector<std::size_t> last_use_;  // place of the last user, per place
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> places_;
};

}  // namespace

Rolling roll(const Program& program, const std::set<SlotGroup>& indexed) {
  Rolling rolling;
  rolling.order = live_operations(program);
  rolling.loops = LoopFinder(program, rolling.order, indexed).loops();
  return rolling;
}

}  // namespace mbgen
