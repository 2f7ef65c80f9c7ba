#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "compiler/pairs/pair_choice.hpp"
#include "compiler/pairs/pairs.hpp"
#include "compiler/pairs/twin_values.hpp"
#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

using Kind = MirrorImage::Kind;

/// In which lane of each pair the value that stands for it is, so that few pairs meet others turned round.
class LaneChoice {
 public:
  explicit LaneChoice(std::size_t count) : before_(count), is_turned_(count, false) {
    for (ValueId v = 0; v < count; ++v) before_[v] = v;
  }

  /// Asks for both in one lane, or in different ones, unless that is decided already.
  void ask(ValueId a, ValueId b, bool turned) {
    const auto [root_a, turn_a] = root_of(a);
    const auto [root_b, turn_b] = root_of(b);
    if (root_a == root_b) return;
    const ValueId later = std::max(root_a, root_b);
    before_[later] = std::min(root_a, root_b);
    is_turned_[later] = (turn_a != turn_b) != turned;
  }
  std::size_t lane_of(ValueId v) const { return root_of(v).second ? 1 : 0; }

 private:
  std::pair<ValueId, bool> root_of(ValueId v) const {
    bool turned = false;
    for (; before_[v] != v; v = before_[v]) turned = turned != is_turned_[v];
    return {v, turned};
  }
  std::vector<ValueId> before_;
  std::vector<bool> is_turned_;  ///< relative to the one before
};

class Folding {
 public:
  Folding(const Program& program, PairedValues values)
      : program_(program),
        values_(std::move(values)),
        images_(values_.images),
        sums_(sums_of_sides(program, images_)),
        is_pair_(chosen_pairs(program, values_, sums_)),
        lanes_(program.nodes.size()),
        builder_(ProgramBuilder::like(program)),
        numbers_(program.nodes.size(), kNoValue),
        pairs_(program.nodes.size(), kNoValue),
        sides_(program.nodes.size()) {
    for (ValueId v = 0; v < program.nodes.size(); ++v)
      if (images_[v].kind != Kind::unknown) sides_[leader(v)][side(v)].push_back(v);
    choose_lanes();
  }

  /// The program with pairs, empty where there is none.
  Program folded() {
    if (std::ranges::find(is_pair_, true) == is_pair_.end()) return {};
    // Pairs come where they are needed: of lone values of the other side, nobody needs them.
    for (ValueId v = 0; v < program_.nodes.size(); ++v)
      if (!sums_.is_inside[v] && !is_pair_[v]) number(v);
    for (const auto& [slot, value] : program_.outputs) builder_.output(slot.group, slot.index, number(value));
    if (is_void_) return {};
    return builder_.finish();
  }

 private:
  static constexpr ValueId kInTheMaking = kNoValue - 1;

  ValueId leader(ValueId v) const { return images_[v].kind == Kind::paired ? images_[v].first : v; }
  std::size_t side(ValueId v) const { return images_[v].is_crossed ? 1 : 0; }
  /// The lane of its pair that a value is in.
  std::size_t lane(ValueId v) const { return lanes_.lane_of(leader(v)) ^ side(v); }

  void choose_lanes() {
    for (ValueId v = 0; v < program_.nodes.size(); ++v) {
      const Node& node = program_.nodes[v];
      if (!is_pair_[v] || leader(v) != v) continue;
      for (int k = 0; k < arity(node.op); ++k) {
        const ValueId operand = node.operands[k];
        if (values_.are_twins() && !values_.are_one_pair(operand, values_.beside[v][static_cast<std::size_t>(k)]))
          continue;
        if (images_[operand].kind != Kind::shared) lanes_.ask(leader(operand), v, images_[operand].is_crossed);
      }
    }
  }

  ValueId signed_value(ValueId value, int sign) { return sign < 0 ? builder_.append(Op::negate, value) : value; }

  /// Ends what goes round in a circle: sides that take each other's values have no order, and stay numbers.
  bool begins(ValueId& place) {
    if (place == kInTheMaking) is_void_ = true;
    if (place != kNoValue) return false;
    place = kInTheMaking;
    return true;
  }
  ValueId made(ValueId place) { return place == kInTheMaking ? builder_.constant(0) : place; }

  /// A value of the program as a number.
  ValueId number(ValueId v) {
    if (!begins(numbers_[v])) return made(numbers_[v]);
    if (is_pair_[v]) {
      const ValueId pair = pair_of(leader(v));
      builder_.set_origin(program_.nodes[v]);
      return numbers_[v] =
                 signed_value(builder_.append(lane(v) == 0 ? Op::first_lane : Op::second_lane, pair), images_[v].sign);
    }
    if (sums_.is_sum(v)) return numbers_[v] = sum(v);
    const Node& node = program_.nodes[v];
    for (int k = 0; k < arity(node.op); ++k) number(node.operands[k]);
    return numbers_[v] = builder_.copy(program_, node, numbers_);
  }

  /// The pair of a leader: in its lane the value itself, in the other one what it is at the image.
  ValueId pair_of(ValueId v) {
    if (!begins(pairs_[v])) return made(pairs_[v]);
    if (!is_pair_[v]) {
      if (sides_[v][1].empty()) is_void_ = true;  // nothing is its image: the choice knows better
      if (is_void_) return pairs_[v] = builder_.constant(0);
      const ValueId other = sides_[v][1].front();
      std::array<ValueId, 2> ends = {number(v), number(other)};
      builder_.set_origin(program_.nodes[v]);
      ends[1] = signed_value(ends[1], images_[other].sign);
      if (lane(v) == 1) std::swap(ends[0], ends[1]);
      return pairs_[v] = builder_.append(Op::pack, ends[0], ends[1]);
    }
    const Node& node = program_.nodes[v];
    ValueId operands[3] = {kNoValue, kNoValue, kNoValue};
    for (int k = 0; k < arity(node.op); ++k)
      operands[k] = values_.are_twins() ? pair_beside(v, k) : pair_with(node.operands[k], lane(v));
    append_named(v, operands);
    return pairs_[v];
  }

  /// A pair with this value in a lane, and in the other one what it is at the image.
  ValueId pair_with(ValueId v, std::size_t wanted) {
    const MirrorImage& image = images_[v];
    if (image.kind == Kind::shared) {
      const ValueId one = number(v);
      if (program_.nodes[v].op == Op::constant) return one;
      builder_.set_origin(program_.nodes[v]);
      const ValueId other = signed_value(one, image.sign);
      return builder_.append(Op::pack, wanted == 0 ? one : other, wanted == 0 ? other : one);
    }
    ValueId pair = pair_of(leader(v));
    builder_.set_origin(program_.nodes[v]);
    if (lane(v) != wanted) {
      const ValueId second = builder_.append(Op::second_lane, pair);
      pair = builder_.append(Op::pack, second, builder_.append(Op::first_lane, pair));
    }
    return signed_value(pair, image.sign);
  }

  /// An operand of a twin and of the one that shares its pair.
  ValueId pair_beside(ValueId v, int k) {
    const ValueId one = program_.nodes[v].operands[k];
    const SignedTerm& other = values_.beside[v][static_cast<std::size_t>(k)];
    if (values_.are_one_pair(one, other)) return pair_with(one, lane(v));
    std::array<ValueId, 2> ends = {number(one), number(other.value)};
    builder_.set_origin(program_.nodes[v]);
    ends[1] = signed_value(ends[1], other.sign);
    if (lane(v) == 1) std::swap(ends[0], ends[1]);
    return builder_.append(Op::pack, ends[0], ends[1]);
  }

  void add(ValueId& to, ValueId term, int sign) {
    to = to == kNoValue ? signed_value(term, sign) : builder_.append(sign < 0 ? Op::subtract : Op::add, to, term);
  }

  /// Left and right are summed in lanes; single values come first.
  ValueId sum(ValueId v) {
    std::vector<std::pair<ValueId, int>> numbers;
    std::map<int, std::vector<std::pair<ValueId, int>>> pairs;  // by parity
    for (const auto& [term, sign] : sums_.of[v].alone) numbers.emplace_back(number(term), sign);
    for (const auto& [first, sign, parity] : sums_.of[v].pairs) {
      if (is_pair_[first]) {
        pairs[parity].emplace_back(pair_of(first), parity < 0 && lane(first) == 1 ? -sign : sign);
        continue;
      }
      const ValueId other = sides_[first][1].front();
      numbers.emplace_back(number(first), sign);
      numbers.emplace_back(number(other), parity * sign * images_[other].sign);
    }
    builder_.set_origin(program_.nodes[v]);
    ValueId total = kNoValue;
    for (const auto& [term, sign] : numbers) add(total, term, sign);
    for (const auto& [parity, terms] : pairs) {
      ValueId in_lanes = kNoValue;
      for (const auto& [term, sign] : terms) add(in_lanes, term, sign);
      const ValueId first = builder_.append(Op::first_lane, in_lanes);
      const ValueId second = builder_.append(Op::second_lane, in_lanes);
      add(total, builder_.append(parity < 0 ? Op::subtract : Op::add, first, second), 1);
    }
    builder_.label_like(total, program_, program_.nodes[v]);
    return total;
  }

  /// The value in a lane of the pair of a leader that tells most about it: one with a name where there is one.
  /// kNoValue: the program has none.
  ValueId best_known(ValueId v, std::size_t in_lane) const {
    const std::vector<ValueId>& values = sides_[v][lane(v) ^ in_lane];
    const auto named = std::ranges::find_if(values, [&](ValueId u) { return program_.nodes[u].label >= 0; });
    return named != values.end() ? *named : values.empty() ? kNoValue : values.front();
  }

  void append_named(ValueId v, const ValueId (&operands)[3]) {
    std::array<Owner, 2> owners;
    std::array<std::string, 2> names;
    for (std::size_t k = 0; k < 2; ++k) {
      const ValueId known = best_known(v, k);
      if (known == kNoValue) continue;
      owners[k] = program_.nodes[known].owner;
      const std::int32_t label = program_.nodes[known].label;
      if (label >= 0) names[k] = program_.labels[static_cast<std::size_t>(label)];
    }
    builder_.set_section(program_.nodes[v].section);
    builder_.set_owner(owners[0] == Owner{} ? owners[1] : owners[0], owners[1]);
    pairs_[v] = builder_.append(program_.nodes[v].op, operands[0], operands[1], operands[2]);
    if (!names[0].empty()) builder_.label(pairs_[v], names[0], names[1]);
  }

  const Program& program_;
  PairedValues values_;
  const std::vector<MirrorImage>& images_;
  SumsOfSides sums_;
  std::vector<bool> is_pair_;
  LaneChoice lanes_;
  ProgramBuilder builder_;
  std::vector<ValueId> numbers_, pairs_;
  std::vector<std::array<std::vector<ValueId>, 2>> sides_;  ///< by leader: the values of each side, the earliest first
  bool is_void_ = false;
};

}  // namespace

Program fold_pairs(const Program& program, std::span<const MirroredInput> mirror) {
  return mirror.empty() ? Program{} : Folding(program, {mirror_images(program, mirror)}).folded();
}

Program fold_twins(const Program& program, std::span<const TwinInput> twins) {
  return twins.empty() ? Program{} : Folding(program, twin_values(program, twins)).folded();
}

}  // namespace mbgen
