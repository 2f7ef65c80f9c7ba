#include "compiler/pairs/pair_choice.hpp"

#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "compiler/pairs/least_cut.hpp"
#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

using Kind = MirrorImage::Kind;
using Question = Decisions::Question;

// Costs, about in bytes of code.
constexpr long kOperation = 6, kDivision = 9, kFusedProduct = 1;
constexpr long kPack = 9, kBroadcast = 6, kBroadcastBothSigns = 11, kTakeApart = 6;

constexpr Question kNone = 0;

class Choice {
 public:
  Choice(const Program& program, const PairedValues& values, const SumsOfSides& sums)
      : program_(program), values_(values), images_(values.images), sums_(sums) {
    const std::size_t count = program.nodes.size();
    question_.assign(count, kNone);
    packed_.assign(count, kNone);
    apart_.assign(count, {kNone, kNone});
    is_apart_.assign(count, {false, false});
    find_uses();
    find_possible();
    find_leading();
  }

  std::vector<bool> made() {
    add_questions();
    for (ValueId v = 0; v < program_.nodes.size(); ++v)
      if (!sums_.is_inside[v]) add_operands(v);
    const std::vector<bool> answers = decisions_.decided();
    std::vector<bool> result(program_.nodes.size(), false);
    for (ValueId v = 0; v < result.size(); ++v) result[v] = asked(v) != kNone && answers[asked(v)];
    return result;
  }

 private:
  /// The value that stands for a pair, whose operations both sides follow.
  ValueId leader(ValueId v) const { return images_[v].kind == Kind::paired ? images_[v].first : v; }
  Question asked(ValueId v) const { return question_[leader(v)]; }
  std::size_t side(ValueId v) const { return images_[v].is_crossed ? 1 : 0; }

  void find_uses() {
    only_user_.assign(program_.nodes.size(), kNoValue);
    std::vector<int> uses(program_.nodes.size(), 0);
    for (ValueId v = 0; v < program_.nodes.size(); ++v)
      for (int k = 0; k < arity(program_.nodes[v].op); ++k) {
        const ValueId operand = program_.nodes[v].operands[k];
        only_user_[operand] = ++uses[operand] == 1 ? v : kNoValue;
      }
  }

  /// Whether operations in lanes can give a value at the image, from packed values where need be.
  void find_possible() {
    is_possible_.assign(program_.nodes.size(), false);
    for (ValueId v = 0; v < program_.nodes.size(); ++v) {
      const Node& node = program_.nodes[v];
      bool all = is_done_in_lanes(node.op);
      for (int k = 0; k < arity(node.op) && !values_.are_twins(); ++k) {
        const ValueId operand = node.operands[k];
        const Kind kind = images_[operand].kind;
        all = all && kind != Kind::unknown && (kind != Kind::lone || is_possible_[operand]);
      }
      is_possible_[v] = all && images_[v].kind != Kind::shared;
    }
  }

  /// Values that are computed even where all pairs are in lanes: lone ones of the other sides of pairs are not.
  void find_leading() {
    is_leading_.assign(program_.nodes.size(), false);
    for (const OutputValue& output : program_.outputs) is_leading_[output.value] = true;
    for (std::size_t v = program_.nodes.size(); v-- > 0;) {
      const Kind kind = images_[v].kind;
      is_leading_[v] =
          kind == Kind::paired ? leader(static_cast<ValueId>(v)) == v : kind != Kind::lone || is_leading_[v];
      const Node& node = program_.nodes[v];
      for (int k = 0; is_leading_[v] && k < arity(node.op); ++k)
        if (images_[node.operands[k]].kind == Kind::lone) is_leading_[node.operands[k]] = true;
    }
  }

  long cost_of(ValueId v) const {
    const Node& node = program_.nodes[v];
    if (!is_operation(node) || node.op == Op::negate || node.op == Op::sin || node.op == Op::cos) return 0;
    if (node.op == Op::divide || node.op == Op::sqrt) return kDivision;
    const bool is_fused = node.op == Op::multiply && only_user_[v] != kNoValue && is_sum(program_.nodes[only_user_[v]]);
    return is_fused ? kFusedProduct : kOperation;
  }

  void add_questions() {
    for (ValueId v = 0; v < program_.nodes.size(); ++v) {
      const Kind kind = images_[v].kind;
      if (sums_.is_inside[v] || (kind != Kind::paired && kind != Kind::lone)) continue;
      Question& question = question_[leader(v)];
      if (leader(v) == v)
        question = decisions_.add(!is_possible_[v] ? Decisions::kNever : is_leading_[v] ? cost_of(v) : 0, 0);
      decisions_.add_cost_of_no(question, cost_of(v));
    }
  }

  void add_operands(ValueId v) {
    if (sums_.is_sum(v)) return add_sum(v);
    const Question question = asked(v);
    if (values_.are_twins() && question != kNone) return add_operands_of_twins(v);
    const Node& node = program_.nodes[v];
    for (int k = 0; k < arity(node.op); ++k) {
      const ValueId operand = node.operands[k];
      if (images_[operand].kind != Kind::shared) need_number(operand, question);
      if (question != kNone && leader(v) == v && is_leading_[v]) need_pair(operand, question);
    }
  }

  /// Both of them: the operands that meet in a pair may be twins or not.
  void add_operands_of_twins(ValueId v) {
    if (leader(v) != v) return;
    for (int k = 0; k < arity(program_.nodes[v].op); ++k) {
      const ValueId one = program_.nodes[v].operands[k];
      const SignedTerm& other = values_.beside[v][static_cast<std::size_t>(k)];
      const bool are_one_pair = values_.are_one_pair(one, other);
      need_number(one, are_one_pair ? asked(v) : kNone);
      need_number(other.value, are_one_pair ? asked(v) : kNone);
      are_one_pair ? need_pair(one, asked(v)) : need_both(one, other, asked(v));
    }
  }

  void add_sum(ValueId v) {
    for (const auto& [term, sign] : sums_.of[v].alone)
      if (images_[term].kind != Kind::shared) need_number(term, kNone);
    std::map<int, Question> reductions;  // by parity
    for (const auto& [first, sign, parity] : sums_.of[v].pairs) {
      Question& reduction = reductions[parity];
      if (reduction == kNone) reduction = decisions_.add(kOperation + kTakeApart, 0);
      decisions_.add_cost_of_yes(question_[first], kOperation);
      decisions_.add_cost_of_no(question_[first], 2 * kOperation);
      decisions_.add_cost(question_[first], reduction, Decisions::kNever);
    }
  }

  /// A value is needed as a number unless `user` is answered yes; kNone: always.
  void need_number(ValueId v, Question user) {
    const Question question = asked(v);
    if (question == kNone) return;
    const bool is_there = images_[v].kind == Kind::paired || is_leading_[v];
    const long cost = is_there ? kTakeApart : Decisions::kNever;
    if (user == kNone) {
      if (!std::exchange(is_apart_[leader(v)][side(v)], true)) decisions_.add_cost_of_yes(question, cost);
      return;
    }
    Question& apart = apart_[leader(v)][side(v)];
    if (apart == kNone) decisions_.add_cost(question, apart = decisions_.add(0, 0), cost);
    decisions_.add_cost(apart, user, Decisions::kNever);
  }

  /// A pair of a value and its image is needed where `user` is answered yes.
  void need_pair(ValueId v, Question user) {
    if (program_.nodes[v].op == Op::constant) return;
    if (images_[v].kind == Kind::lone) return decisions_.add_cost(user, asked(v), Decisions::kNever);
    Question& packed = packed_[leader(v)];
    if (packed == kNone) {
      const bool is_shared = images_[v].kind == Kind::shared;
      const long broadcast = images_[v].sign < 0 ? kBroadcastBothSigns : kBroadcast;
      packed = decisions_.add(is_shared ? broadcast : 0, 0);
      if (!is_shared) decisions_.add_cost(packed, asked(v), kPack);
    }
    decisions_.add_cost(user, packed, Decisions::kNever);
  }

  /// A pair of two numbers that are no twins is needed where `user` is answered yes.
  void need_both(ValueId one, const SignedTerm& other, Question user) {
    if (program_.nodes[one].op == Op::constant && program_.nodes[other.value].op == Op::constant) return;
    Question& question = both_[{one, other.value, other.sign}];
    const long broadcast = other.sign < 0 ? kBroadcastBothSigns : kBroadcast;
    if (question == kNone) question = decisions_.add(one == other.value ? broadcast : kPack, 0);
    decisions_.add_cost(user, question, Decisions::kNever);
  }

  const Program& program_;
  const PairedValues& values_;
  std::span<const MirrorImage> images_;
  const SumsOfSides& sums_;
  Decisions decisions_;
  std::vector<ValueId> only_user_;
  std::vector<bool> is_possible_, is_leading_;
  std::vector<Question> question_;                              ///< by leader: is it computed in lanes?
  std::vector<Question> packed_;                                ///< by leader: is its pair needed?
  std::vector<std::array<Question, 2>> apart_;                  ///< by leader and side: is it needed in lanes alone?
  std::map<std::tuple<ValueId, ValueId, int>, Question> both_;  ///< of numbers that are no twins: is their pair needed?
  std::vector<std::array<bool, 2>> is_apart_;  ///< likewise: is it needed as a number whatever is decided?
};

}  // namespace

bool is_done_in_lanes(Op op) {
  return op == Op::add || op == Op::subtract || op == Op::multiply || op == Op::divide || op == Op::negate ||
         op == Op::sqrt || op == Op::sin || op == Op::cos;
}

std::vector<bool> chosen_pairs(const Program& program, const PairedValues& values, const SumsOfSides& sums) {
  return Choice(program, values, sums).made();
}

}  // namespace mbgen
