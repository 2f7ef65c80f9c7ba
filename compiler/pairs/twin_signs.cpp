#include "compiler/pairs/twin_signs.hpp"

#include <algorithm>
#include <utility>

#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

/// Signs of which some are known and some hang together.
class Signs {
 public:
  using Sign = std::pair<ValueId, int>;  ///< a value whose sign is open, or kKnown, and the sign relative to that
  static constexpr ValueId kKnown = kNoValue;

  explicit Signs(std::size_t count) : before_(count, {kKnown, 1}) {}

  void set(ValueId v, Sign sign) { before_[v] = sign; }
  Sign open(ValueId v) { return before_[v] = {v, 1}; }

  Sign of(ValueId v) const { return end_of({v, 1}); }
  Sign end_of(Sign sign) const {
    while (sign.first != kKnown && before_[sign.first].first != sign.first)
      sign = {before_[sign.first].first, sign.second * before_[sign.first].second};
    return sign;
  }

  /// Makes both equal where one is open still.
  void agree(Sign a, Sign b) {
    a = end_of(a);
    b = end_of(b);
    if (a.first == b.first) return;
    if (a.first == kKnown) std::swap(a, b);
    before_[a.first] = {b.first, a.second * b.second};
  }
  int sign_of(ValueId v) const { return of(v).second; }

 private:
  std::vector<Sign> before_;
};

class TwinSigns {
 public:
  TwinSigns(const Program& program, const std::vector<ValueId>& twin, const std::vector<std::array<ValueId, 3>>& beside)
      : program_(program), twin_(twin), beside_(beside), signs_(twin.size()) {
    // Operands of both stand before the later one.
    for (ValueId later = 0; later < twin.size(); ++later)
      if (twin[later] < later && is_operation(program.nodes[later])) find(twin[later]);
  }

  PairedValues found() const {
    PairedValues values{std::vector<MirrorImage>(twin_.size()), std::vector<std::array<SignedTerm, 3>>(twin_.size())};
    for (ValueId v = 0; v < twin_.size(); ++v) {
      const ValueId other = twin_[v];
      if (other == kNoValue || other < v) continue;
      const int sign = signs_.sign_of(v);
      values.images[v] = {MirrorImage::Kind::paired, 1, false, v};
      values.images[other] = {MirrorImage::Kind::paired, sign, true, v};
      for (int k = 0; k < arity(program_.nodes[v].op); ++k)
        values.beside[v][static_cast<std::size_t>(k)] = {other_operand(v, k), sign_beside(v, k)};
    }
    return values;
  }

 private:
  using Sign = Signs::Sign;
  static constexpr Sign kPlus = {Signs::kKnown, 1};

  ValueId own(ValueId v, int k) const { return program_.nodes[v].operands[k]; }
  ValueId other_operand(ValueId v, int k) const { return beside_[v][static_cast<std::size_t>(k)]; }
  bool are_constants(ValueId v, int k) const {
    return program_.nodes[own(v, k)].op == Op::constant && program_.nodes[other_operand(v, k)].op == Op::constant;
  }
  bool are_twins(ValueId v, int k) const { return twin_[own(v, k)] == other_operand(v, k); }

  /// Sign of the twin of operand k relative to what shares its pair; of one value twice +1.
  Sign of_operand(ValueId v, int k) const {
    return are_twins(v, k) ? signs_.of(std::min(own(v, k), other_operand(v, k))) : kPlus;
  }

  /// -1 where operand k is subtracted in one of both only.
  int subtracted(ValueId v, int k) const {
    const Node &node = program_.nodes[v], &other = program_.nodes[twin_[v]];
    const bool here = node.op == Op::subtract && k == 1;
    const bool there = other.op == Op::subtract && other.operands[1] == other_operand(v, k);
    return here == there ? 1 : -1;
  }

  void find(ValueId v) {
    const Op op = program_.nodes[v].op;
    if (is_sum(program_.nodes[v])) return find_of_sum(v);
    if (op == Op::multiply || op == Op::divide) return find_of_product(v);
    if (op == Op::negate || op == Op::sin) return signs_.set(v, of_operand(v, 0));
    if (op == Op::sqrt) signs_.agree(of_operand(v, 0), kPlus);
  }

  /// s p_k = whether operand k is subtracted in one only: known operands determine s, and s the open ones.
  void find_of_sum(ValueId v) {
    Sign sign = signs_.open(v);
    for (const bool is_known : {true, false})
      for (int k = 0; k < 2; ++k) {
        const bool takes_any = are_constants(v, k) || (!are_twins(v, k) && own(v, k) != other_operand(v, k));
        const auto [root, relative] = of_operand(v, k);
        if (takes_any || (root == Signs::kKnown) != is_known) continue;
        signs_.agree(sign, {root, relative * subtracted(v, k)});
      }
  }

  void find_of_product(ValueId v) {
    if (are_constants(v, 0) || are_constants(v, 1)) {
      signs_.open(v);
      return;
    }
    Sign first = of_operand(v, 0), second = of_operand(v, 1);
    if (first.first == second.first) return signs_.set(v, {Signs::kKnown, first.second * second.second});
    if (first.first != Signs::kKnown && second.first != Signs::kKnown) {
      signs_.agree({first.first, 1}, kPlus);
      first.first = Signs::kKnown;
    }
    signs_.set(v, {first.first == Signs::kKnown ? second.first : first.first, first.second * second.second});
  }

  /// Factor of operand k of the other value in the pair that holds both.
  int sign_beside(ValueId v, int k) const {
    const Op op = program_.nodes[v].op;
    const int sign = signs_.sign_of(v);
    if (is_sum(program_.nodes[v])) return sign * subtracted(v, k);
    if ((op == Op::multiply || op == Op::divide) && are_constants(v, k)) return sign * of_operand(v, 1 - k).second;
    if (op == Op::sqrt) return 1;
    return of_operand(v, k).second;
  }

  const Program& program_;
  const std::vector<ValueId>& twin_;
  const std::vector<std::array<ValueId, 3>>& beside_;
  Signs signs_;  ///< by the earlier twin
};

}  // namespace

PairedValues with_signs(const Program& program, const std::vector<ValueId>& twin,
                        const std::vector<std::array<ValueId, 3>>& beside) {
  return TwinSigns(program, twin, beside).found();
}

}  // namespace mbgen
