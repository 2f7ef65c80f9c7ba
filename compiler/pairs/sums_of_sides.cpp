#include "compiler/pairs/sums_of_sides.hpp"

#include <array>
#include <deque>
#include <map>
#include <utility>

#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

using Kind = MirrorImage::Kind;

class SumFinder {
 public:
  SumFinder(const Program& program, std::span<const MirrorImage> images)
      : program_(program), images_(images), uses_(program.nodes.size(), 0) {
    for (const Node& node : program.nodes)
      for (int k = 0; k < arity(node.op); ++k) ++uses_[node.operands[k]];
    for (const OutputValue& output : program.outputs) uses_[output.value] += 2;
    sums_.of.resize(program.nodes.size());
    sums_.is_inside.assign(program.nodes.size(), false);
  }

  SumsOfSides found() {
    for (std::size_t v = program_.nodes.size(); v-- > 0;) find(static_cast<ValueId>(v));
    return std::move(sums_);
  }

 private:
  /// Whether an operand of a sum is no more than a part of it.
  bool goes_on(ValueId v) const {
    const Node& node = program_.nodes[v];
    return (is_sum(node) || node.op == Op::negate) && uses_[v] == 1 && node.label < 0 &&
           images_[v].kind != Kind::paired;
  }

  void find(ValueId root) {
    const bool may_be_in_lanes = images_[root].kind == Kind::paired || images_[root].kind == Kind::lone;
    if (may_be_in_lanes || !is_sum(program_.nodes[root]) || sums_.is_inside[root]) return;
    std::vector<ValueId> inside;
    const std::vector<SignedTerm> terms = terms_of(root, inside);
    SumOfSides sum = by_sides(terms);
    if (sum.pairs.empty()) return;
    for (const ValueId v : inside) sums_.is_inside[v] = true;
    sums_.of[root] = std::move(sum);
  }

  std::vector<SignedTerm> terms_of(ValueId root, std::vector<ValueId>& inside) const {
    std::vector<SignedTerm> terms, pending{{root, 1}};  // the next one last
    while (!pending.empty()) {
      const auto [v, sign] = pending.back();
      pending.pop_back();
      if (v != root && !goes_on(v)) {
        terms.push_back({v, sign});
        continue;
      }
      if (v != root) inside.push_back(v);
      const Node& node = program_.nodes[v];
      for (int k = arity(node.op) - 1; k >= 0; --k) {
        const bool is_minus = node.op == Op::negate || (node.op == Op::subtract && k == 1);
        pending.push_back({node.operands[k], is_minus ? -sign : sign});
      }
    }
    return terms;
  }

  /// Terms beside their images.
  SumOfSides by_sides(const std::vector<SignedTerm>& terms) const {
    SumOfSides sum;
    std::map<ValueId, std::array<std::deque<std::size_t>, 2>> waiting;  // by what they are, by side
    const auto times = [&](std::size_t i) { return terms[i].sign * images_[terms[i].value].sign; };
    std::vector<bool> is_paired(terms.size(), false);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const MirrorImage& image = images_[terms[i].value];
      if (image.kind != Kind::paired) continue;
      const std::size_t side = image.is_crossed ? 1 : 0;
      auto& of_sides = waiting[image.first];
      if (of_sides[1 - side].empty()) {
        of_sides[side].push_back(i);
        continue;
      }
      const std::size_t other = of_sides[1 - side].front();
      of_sides[1 - side].pop_front();
      is_paired[i] = is_paired[other] = true;
      sum.pairs.push_back({image.first, times(side == 0 ? i : other), times(i) * times(other)});
    }
    for (std::size_t i = 0; i < terms.size(); ++i)
      if (!is_paired[i]) sum.alone.push_back(terms[i]);
    return sum;
  }

  const Program& program_;
  std::span<const MirrorImage> images_;
  std::vector<int> uses_;
  SumsOfSides sums_;
};

}  // namespace

SumsOfSides sums_of_sides(const Program& program, std::span<const MirrorImage> images) {
  return SumFinder(program, images).found();
}

}  // namespace mbgen
