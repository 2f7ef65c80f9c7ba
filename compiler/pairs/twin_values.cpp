#include "compiler/pairs/twin_values.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/pairs/twin_signs.hpp"
#include "compiler/program/arithmetic.hpp"
#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

constexpr int kDepth = 4;              // operands of operands that are compared
constexpr double kAlike = 0.6;         // least likeness of twins
constexpr double kPerOperation = 0.9;  // likeness that an operation between two values and what they share leaves
constexpr double kPerSign = 0.95;      // likeness that is left where one is added and the other subtracted
constexpr int kRounds = 8;             // pairs found late may make others known

/// Whether two are one operation but for signs of their operands.
bool are_one_operation(const Node& a, const Node& b) { return a.op == b.op || (is_sum(a) && is_sum(b)); }

/// Whether operands of two that are one operation may be turned.
bool are_turned(const Node& a) { return is_sum(a) || is_commutative(a.op); }

/// Pairs twins by the similarity of their operands and users.
class TwinFinder {
 public:
  TwinFinder(const Program& program, std::span<const TwinInput> inputs)
      : program_(program), twin_(program.nodes.size(), kNoValue), users_(program.nodes.size()) {
    for (ValueId v = 0; v < program.nodes.size(); ++v)
      for (int k = 0; k < arity(program.nodes[v].op); ++k) {
        std::vector<ValueId>& users = users_[program.nodes[v].operands[k]];
        if (users.empty() || users.back() != v) users.push_back(v);
      }
    std::map<Slot, ValueId> value_of;
    for (ValueId v = 0; v < program.nodes.size(); ++v)
      if (program.nodes[v].op == Op::input)
        value_of.emplace(program.inputs[static_cast<std::size_t>(program.nodes[v].input)], v);
    for (const auto& [slot, twin] : inputs) {
      const auto a = value_of.find(slot), b = value_of.find(twin);
      if (a != value_of.end() && b != value_of.end()) make_twins(a->second, b->second);
    }
    find();
  }

  /// Per value its twin.
  const std::vector<ValueId>& twins() const { return twin_; }

  /// The operands of b in the order in which they are most like those of a.
  std::array<ValueId, 3> beside(ValueId a, ValueId b) const {
    const Node &one = program_.nodes[a], &other = program_.nodes[b];
    std::array<ValueId, 3> order{other.operands[0], other.operands[1], other.operands[2]};
    std::array<ValueId, 3> turned{other.operands[1], other.operands[0], other.operands[2]};
    const bool turns = are_turned(one) && likeness(one, turned, kDepth) > likeness(one, order, kDepth);
    return turns ? turned : order;
  }

 private:
  /// Values with one candidate come first: their twins decide between the candidates of the others.
  void find() {
    bool takes_nearest = false;
    for (int round = 0; round < kRounds; ++round) {
      bool goes_on = false;
      for (ValueId v = 0; v < twin_.size(); ++v) {
        const ValueId twin = twin_[v] == kNoValue ? best_match(v, takes_nearest) : kNoValue;
        if (twin == kNoValue) continue;
        pair_up(v, twin);
        goes_on = true;
      }
      if (!goes_on && takes_nearest) return;
      takes_nearest = !goes_on;
    }
  }

  void make_twins(ValueId a, ValueId b) {
    twin_[a] = b;
    twin_[b] = a;
  }

  double likeness(const Node& node, const std::array<ValueId, 3>& others, int depth) const {
    double sum = 0;
    for (int k = 0; k < arity(node.op); ++k)
      sum += likeness(node.operands[k], others[static_cast<std::size_t>(k)], depth - 1);
    return sum / arity(node.op);
  }

  /// From 0 to 1: how much two operands of twins have in common.
  double likeness(ValueId a, ValueId b, int depth) const {
    if (a == b) return twin_[a] == kNoValue ? 1 : 0;
    if (twin_[a] != kNoValue || twin_[b] != kNoValue) return twin_[a] == b ? 1 : 0;
    const Node &one = program_.nodes[a], &other = program_.nodes[b];
    if (!are_one_operation(one, other)) return 0;
    if (one.op == Op::constant) return 1;
    if (one.op == Op::input) return 0;
    if (depth <= 0) return 0.5;
    double best = likeness(one, {other.operands[0], other.operands[1], other.operands[2]}, depth);
    if (are_turned(one))
      best = std::max(best, likeness(one, {other.operands[1], other.operands[0], other.operands[2]}, depth));
    return (one.op == other.op ? 1 : kPerSign) * kPerOperation * best;
  }

  struct Match {
    ValueId twin = kNoValue;
    double like = 0;
    bool is_alone = true;  ///< nothing else is as much alike
  };

  /// The value most like v among the users of the twins of its operands, the one nearest of several.
  Match most_like(ValueId v) const {
    const Node& node = program_.nodes[v];
    Match best;
    const auto far = [&](ValueId w) { return w > v ? w - v : v - w; };
    for (int k = 0; k < arity(node.op); ++k) {
      if (twin_[node.operands[k]] == kNoValue) continue;
      for (const ValueId w : users_[twin_[node.operands[k]]]) {
        const Node& other = program_.nodes[w];
        if (w == v || twin_[w] != kNoValue || !are_one_operation(node, other)) continue;
        if (other.section.step != node.section.step) continue;
        const double like = (other.op == node.op ? 1 : kPerSign) * likeness(node, beside(v, w), kDepth);
        if (like < kAlike || like < best.like || w == best.twin) continue;
        const bool is_alone = like > best.like;
        if (is_alone || far(w) < far(best.twin)) best = {w, like};
        best.is_alone = is_alone;
      }
    }
    return best;
  }

  /// The twin of v, kNoValue if nothing is similar or the most similar value is more similar to another one; if several
  /// are equally similar, only with `takes_nearest`.
  ValueId best_match(ValueId v, bool takes_nearest) const {
    const Match match = most_like(v);
    if (match.twin == kNoValue || (!match.is_alone && !takes_nearest)) return kNoValue;
    const Match back = most_like(match.twin);
    return back.like <= match.like && (back.is_alone || takes_nearest) ? match.twin : kNoValue;
  }

  /// Twins, and operands of theirs that are the same operation without being twins yet.
  void pair_up(ValueId a, ValueId b) {
    const bool are_free = a != b && twin_[a] == kNoValue && twin_[b] == kNoValue;
    if (!are_free || !are_one_operation(program_.nodes[a], program_.nodes[b]) || !is_operation(program_.nodes[a]))
      return;
    make_twins(a, b);
    const std::array<ValueId, 3> others = beside(a, b);
    for (int k = 0; k < arity(program_.nodes[a].op); ++k)
      pair_up(program_.nodes[a].operands[k], others[static_cast<std::size_t>(k)]);
  }

  const Program& program_;
  std::vector<ValueId> twin_;
  std::vector<std::vector<ValueId>> users_;
};

/// Takes apart twins that cannot be computed at once, one needing what the other gives, directly or through twins.
class Circles {
 public:
  Circles(const Program& program, std::vector<ValueId>& twin)
      : twin_(twin), users_(twin.size()), missing_(twin.size(), 0), is_known_(twin.size(), false) {
    for (ValueId v = 0; v < twin.size(); ++v)
      for (int k = 0; k < arity(program.nodes[v].op); ++k, ++missing_[v])
        users_[program.nodes[v].operands[k]].push_back(v);
  }

  /// Goes through the program as far as all operands of both twins are known; where nothing goes on, the earliest value
  /// waits for its twin alone.
  void part() {
    for (ValueId v = 0; v < twin_.size(); ++v) learn(v);
    for (ValueId v = 0; v < twin_.size(); ++v) {
      go_on();
      if (is_known_[v]) continue;
      const ValueId other = std::exchange(twin_[v], kNoValue);
      twin_[other] = kNoValue;
      learn(v);
      learn(other);
    }
  }

 private:
  void learn(ValueId v) {
    const ValueId other = twin_[v];
    if (is_known_[v] || missing_[v] > 0 || (other != kNoValue && missing_[other] > 0)) return;
    for (const ValueId u : {v, other}) {
      if (u == kNoValue) continue;
      is_known_[u] = true;
      known_.push_back(u);
    }
  }

  void go_on() {
    while (!known_.empty()) {
      const ValueId v = known_.back();
      known_.pop_back();
      for (const ValueId user : users_[v])
        if (--missing_[user] == 0) learn(user);
    }
  }

  std::vector<ValueId>& twin_;
  std::vector<std::vector<ValueId>> users_;
  std::vector<int> missing_;  ///< operands that are not known
  std::vector<bool> is_known_;
  std::vector<ValueId> known_;  ///< whose users do not know it yet
};

}  // namespace

PairedValues twin_values(const Program& program, std::span<const TwinInput> inputs) {
  const TwinFinder finder = TwinFinder(program, inputs);
  std::vector<ValueId> twin = finder.twins();
  Circles(program, twin).part();
  std::vector<std::array<ValueId, 3>> beside(twin.size(), {kNoValue, kNoValue, kNoValue});
  for (ValueId v = 0; v < twin.size(); ++v)
    if (twin[v] != kNoValue && twin[v] > v && is_operation(program.nodes[v])) beside[v] = finder.beside(v, twin[v]);
  return with_signs(program, twin, beside);
}

}  // namespace mbgen
