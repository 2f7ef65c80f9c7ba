#include "compiler/emit/angles.hpp"

#include <algorithm>
#include <span>
#include <unordered_map>

namespace mbgen {
namespace {

bool is_angle_function(const Node& node) { return node.op == Op::sin || node.op == Op::cos; }

/// What is known of the values of one section.
class Section {
 public:
  /// is_earlier: per value, whether it stands in an earlier section or is an input or a constant.
  Section(const Program& program, const std::vector<bool>& is_earlier) : program_(program), is_early_(is_earlier) {}

  /// Sorts a range into what is moved before the calls, the sines and cosines by angle, and the rest.
  void sort(std::span<const ValueId> range) {
    for (const ValueId v : range) {
      if (is_simple(v)) is_early_[v] = true;
      const Node& node = program_.nodes[v];
      if (!is_angle_function(node) || !is_early_[node.operands[0]]) continue;
      const auto [place, is_new] = place_of_.try_emplace(node.operands[0], angles_.size());
      if (is_new) {
        angles_.push_back(node.operands[0]);
        functions_.emplace_back();
      }
      functions_[place->second].push_back(v);
    }
  }

  /// The range in its new order; the calls and their places go to `result`.
  void write(std::span<ValueId> range, AngleCalls& result) const {
    if (angles_.size() < kFewestInLanes) return;
    std::vector<ValueId> order;
    const std::vector<bool> is_moved = moved(range);
    for (const ValueId v : range) {
      if (is_moved[v]) order.push_back(v);
    }
    for (std::size_t a = 0; a < angles_.size(); ++a) {
      if (a % kMostInLanes == 0) result.calls.emplace_back();
      AngleCall& call = result.calls.back();
      for (const ValueId v : functions_[a]) {
        result.place[v] = {static_cast<int>(result.calls.size()) - 1, static_cast<int>(call.angles.size())};
        order.push_back(v);
      }
      call.angles.push_back(angles_[a]);
    }
    for (const ValueId v : range) {
      if (!is_moved[v] && result.place[v].call < 0) order.push_back(v);
    }
    std::copy(order.begin(), order.end(), range.begin());
  }

 private:
  bool is_early(ValueId v) const { return is_early_[v]; }

  /// A sum, difference or multiple of what is known early.
  bool is_simple(ValueId v) const {
    const Node& node = program_.nodes[v];
    const auto& operand = node.operands;
    switch (node.op) {
      case Op::add:
      case Op::subtract:
        return is_early(operand[0]) && is_early(operand[1]);
      case Op::negate:
        return is_early(operand[0]);
      case Op::multiply:
        return is_early(operand[0]) && is_early(operand[1]) &&
               (program_.nodes[operand[0]].op == Op::constant || program_.nodes[operand[1]].op == Op::constant);
      default:
        return false;
    }
  }

  /// The values of the range that the angles need.
  std::vector<bool> moved(std::span<const ValueId> range) const {
    std::vector<bool> needed(program_.nodes.size(), false);
    for (const ValueId angle : angles_) needed[angle] = true;
    std::vector<bool> result(program_.nodes.size(), false);
    for (std::size_t i = range.size(); i-- > 0;) {
      const Node& node = program_.nodes[range[i]];
      if (!needed[range[i]]) continue;
      result[range[i]] = true;
      for (int k = 0; k < arity(node.op); ++k) needed[node.operands[k]] = true;
    }
    return result;
  }

  const Program& program_;
  std::vector<bool> is_early_;
  std::vector<ValueId> angles_;
  std::unordered_map<ValueId, std::size_t> place_of_;  ///< of an angle in angles_
  std::vector<std::vector<ValueId>> functions_;        ///< per angle
};

}  // namespace

AngleCalls gather_angles(const Program& program, std::vector<ValueId>& order) {
  AngleCalls result;
  result.place.resize(program.nodes.size());
  std::vector<bool> is_earlier(program.nodes.size(), false);
  for (ValueId v = 0; v < program.nodes.size(); ++v) {
    is_earlier[v] = program.nodes[v].op == Op::input || program.nodes[v].op == Op::constant;
  }
  const auto section_of = [&](std::size_t i) { return program.nodes[order[i]].section; };
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && section_of(last) == section_of(first)) ++last;
    const std::span<ValueId> range(order.data() + first, last - first);
    Section section(program, is_earlier);
    section.sort(range);
    section.write(range, result);
    for (const ValueId v : range) is_earlier[v] = true;
  }
  return result;
}

}  // namespace mbgen
