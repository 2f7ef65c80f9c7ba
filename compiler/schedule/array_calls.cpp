#include "compiler/schedule/array_calls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace mbgen {
namespace {

using Range = std::span<const ValueId>;
using Arguments = std::array<ValueId, 2>;  ///< second: kNoValue for functions of one argument

/// Function for arrays that replaces an operation.
std::optional<ArrayFunction> called_function(Op op) {
  switch (op) {
    case Op::sin:
    case Op::cos:
      return ArrayFunction::sine_and_cosine;
    case Op::atan:
      return ArrayFunction::arc_tangent;
    case Op::exp:
      return ArrayFunction::exponential;
    case Op::tanh:
      return ArrayFunction::hyperbolic_tangent;
    case Op::pow:
      return ArrayFunction::power;
    default:
      return std::nullopt;
  }
}

/// Upper bound of the absolute value, infinity if unknown; known for inverse functions and their multiples.
double bound_of(const Program& program, ValueId v) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto& [first, second, third] = program.nodes[v].operands;
  switch (program.nodes[v].op) {
    case Op::atan:
    case Op::asin:
      return std::numbers::pi / 2;
    case Op::acos:
    case Op::atan2:
      return std::numbers::pi;
    case Op::negate:
      return bound_of(program, first);
    case Op::multiply:  // constants stand first
      if (program.nodes[first].op != Op::constant) return kUnknown;
      return std::abs(program.nodes[first].constant) * bound_of(program, second);
    default:
      return kUnknown;
  }
}

/// Sines, or cosines, of angles without the other function in the program, see Gathering::of_vectors.
std::vector<bool> found_alone(const Program& program) {
  std::set<std::pair<Op, ValueId>> found;
  for (const Node& node : program.nodes)
    if (node.op == Op::sin || node.op == Op::cos) found.insert({node.op, node.operands[0]});
  std::vector<bool> is_alone;
  for (const Node& node : program.nodes)
    is_alone.push_back((node.op == Op::sin && !found.contains({Op::cos, node.operands[0]})) ||
                       (node.op == Op::cos && !found.contains({Op::sin, node.operands[0]})));
  return is_alone;
}

/// Facts about the values of the present range. Members by value id; values outside the range are not used.
struct Levels {
  std::vector<bool> is_here;    ///< in this range
  std::vector<bool> is_called;  ///< computed by an array call
  std::vector<int> level;       ///< number of successive calls before the value, its own included
  std::vector<int> least;       ///< lower bound of the level, for a delayed call
  Gathering gathering;
  std::vector<int> widths;     ///< numbers in each value
  std::vector<bool> is_alone;  ///< a sine or cosine with a call of its own
};

/// Arguments of one call before it is split, with the results for each.
struct Group {
  std::vector<Arguments> arguments;
  std::vector<std::vector<ValueId>> values;  ///< per argument
};

using Groups = std::map<std::pair<int, ArrayFunction>, Group>;  ///< by level and function

ArrayFunction function_of(const Program& program, const Levels& levels, ValueId v) {
  const Node& node = program.nodes[v];
  if (!levels.is_alone[v]) return *called_function(node.op);
  const bool is_bounded = bound_of(program, node.operands[0]) <= std::numbers::pi;
  if (node.op == Op::sin) return is_bounded ? ArrayFunction::bounded_sine : ArrayFunction::sine;
  return is_bounded ? ArrayFunction::bounded_cosine : ArrayFunction::cosine;
}

void find_levels(const Program& program, Range range, Levels& levels) {
  for (const ValueId v : range) {
    const Node& node = program.nodes[v];
    int level = levels.is_called[v] ? std::max(1, levels.least[v]) : 0;
    for (int k = 0; k < arity(node.op); ++k) {
      if (!levels.is_here[node.operands[k]]) continue;
      level = std::max(level, levels.level[node.operands[k]] + (levels.is_called[v] ? 1 : 0));
    }
    levels.level[v] = level;
  }
}

Groups groups_of(const Program& program, Range range, const Levels& levels) {
  Groups groups;
  std::map<std::pair<int, ArrayFunction>, std::map<Arguments, std::size_t>> place_of;
  for (const ValueId v : range) {
    if (!levels.is_called[v]) continue;
    const Node& node = program.nodes[v];
    const std::pair key{levels.level[v], function_of(program, levels, v)};
    Group& group = groups[key];
    const Arguments arguments = {node.operands[0], node.operands[1]};
    const auto [place, is_new] = place_of[key].try_emplace(arguments, group.arguments.size());
    if (is_new) {
      group.arguments.push_back(arguments);
      group.values.emplace_back();
    }
    group.values[place->second].push_back(v);
  }
  return groups;
}

/// Per value of the range: highest level that delays no other value.
std::vector<int> latest_levels(const Program& program, Range range, const Levels& levels) {
  int last = 0;
  for (const ValueId v : range) last = std::max(last, levels.level[v]);
  std::vector<int> latest(program.nodes.size(), last);
  for (std::size_t i = range.size(); i-- > 0;) {
    const ValueId v = range[i];
    const int before = latest[v] - (levels.is_called[v] ? 1 : 0);
    const Node& node = program.nodes[v];
    for (int k = 0; k < arity(node.op); ++k) latest[node.operands[k]] = std::min(latest[node.operands[k]], before);
  }
  return latest;
}

/// Delays the first group that can join a later one of its function. Result: false if there is none.
bool wait_for_later(const Program& program, Range range, const Groups& groups, Levels& levels) {
  const std::vector<int> latest = latest_levels(program, range, levels);
  for (auto group = groups.begin(); group != groups.end(); ++group) {
    int until = std::numeric_limits<int>::max();
    for (const auto& values : group->second.values)
      for (const ValueId v : values) until = std::min(until, latest[v]);
    const auto later = std::find_if(std::next(group), groups.end(), [&](const auto& entry) {
      const auto& [level, function] = entry.first;
      return function == group->first.second && level > group->first.first && level <= until;
    });
    if (later == groups.end()) continue;
    for (const auto& values : group->second.values)
      for (const ValueId v : values) levels.least[v] = later->first.first;
    return true;
  }
  return false;
}

/// Groups of sufficient size. Values of smaller groups are computed individually, which may let later groups join.
Groups find_groups(const Program& program, Range range, Levels& levels) {
  const bool of_vectors = levels.gathering == Gathering::of_vectors;
  const auto fewest_of = [&](ValueId v) -> std::size_t {
    if (levels.is_alone[v]) return 1;
    return of_vectors ? 2 : kFewestInLanes;
  };
  while (true) {
    find_levels(program, range, levels);
    Groups groups = groups_of(program, range, levels);
    if (of_vectors && wait_for_later(program, range, groups, levels)) continue;
    const auto small = std::ranges::find_if(groups, [&](const auto& entry) {
      std::size_t entries = 0;
      for (const auto& values : entry.second.values) entries += static_cast<std::size_t>(levels.widths[values[0]]);
      return entries < fewest_of(entry.second.values[0][0]);
    });
    if (small == groups.end()) return groups;
    for (const auto& values : small->second.values) {
      for (const ValueId v : values) levels.is_called[v] = false;
    }
  }
}

/// New order of a range; the first part, which already contains calls, stays.
class NewOrder {
 public:
  NewOrder(const Program& program, const std::vector<int>& widths, Range range, ArrayCalls& result)
      : program_(program), widths_(widths), range_(range), result_(result), is_placed_(program.nodes.size(), false) {
    std::size_t kept = range.size();
    while (kept > 0 && result.place[range[kept - 1]].call < 0) --kept;
    for (std::size_t i = 0; i < kept; ++i) add(range[i]);
  }

  /// Adds the missing values needed by the arguments, in the old order.
  void add_needed(const Group& group) {
    std::vector<bool> is_needed(program_.nodes.size(), false);
    for (const Arguments& arguments : group.arguments) {
      for (const ValueId v : arguments) {
        if (v != kNoValue) is_needed[v] = true;
      }
    }
    std::vector<ValueId> found;
    for (std::size_t i = range_.size(); i-- > 0;) {
      const ValueId v = range_[i];
      if (!is_needed[v] || is_placed_[v]) continue;
      found.push_back(v);
      for (int k = 0; k < arity(program_.nodes[v].op); ++k) is_needed[program_.nodes[v].operands[k]] = true;
    }
    for (std::size_t i = found.size(); i-- > 0;) add(found[i]);
  }

  void add_calls(ArrayFunction function, const Group& group) {
    for (std::size_t a = 0; a < group.arguments.size(); ++a) {
      if (a == 0 || result_.calls.back().entries + widths_[group.values[a][0]] > kMostInLanes)
        result_.calls.push_back({function, {}, {}});
      ArrayCall& call = result_.calls.back();
      for (const ValueId v : group.values[a]) {
        result_.place[v] = {static_cast<int>(result_.calls.size()) - 1, call.entries};
        add(v);
      }
      call.arguments.push_back(group.arguments[a][0]);
      call.entries += widths_[group.values[a][0]];
      if (function == ArrayFunction::power) call.exponents.push_back(group.arguments[a][1]);
    }
  }

  std::vector<ValueId> finished() {
    for (const ValueId v : range_) {
      if (!is_placed_[v]) order_.push_back(v);
    }
    return std::move(order_);
  }

 private:
  void add(ValueId v) {
    order_.push_back(v);
    is_placed_[v] = true;
  }

  const Program& program_;
  const std::vector<int>& widths_;
  Range range_;
  ArrayCalls& result_;
  std::vector<bool> is_placed_;
  std::vector<ValueId> order_;
};

/// An input, a constant or one operation on them; packed for a pair.
bool is_given(const Program& program, ValueId v) {
  const auto is_leaf = [&](ValueId value) {
    const Node& node = program.nodes[value];
    const Op op = program.nodes[node.op == Op::negate ? node.operands[0] : value].op;
    return op == Op::input || op == Op::constant;
  };
  const Node& node = program.nodes[v];
  for (int k = 0; k < arity(node.op); ++k) {
    if (!is_leaf(node.operands[k])) return false;
  }
  return true;
}

/// Moves values of array calls before the rest of the range. is_candidate: values that may be called.
template <class IsCandidate>
void gather(const Program& program, std::span<ValueId> range, Levels& levels, ArrayCalls& result,
            IsCandidate is_candidate) {
  for (const ValueId v : range) {
    const bool is_free = called_function(program.nodes[v].op).has_value() && result.place[v].call < 0;
    levels.is_here[v] = true;
    levels.is_called[v] = is_free && is_candidate(v);
  }
  const Groups groups = find_groups(program, range, levels);
  if (!groups.empty()) {
    NewOrder new_order(program, levels.widths, range, result);
    for (const auto& [key, group] : groups) {
      new_order.add_needed(group);
      new_order.add_calls(key.second, group);
    }
    std::ranges::copy(new_order.finished(), range.begin());
  }
  for (const ValueId v : range) levels.is_here[v] = levels.is_called[v] = false;
}

/// Gathers functions of inputs over a whole section, even if other sections interrupt it.
void gather_given(const Program& program, std::vector<ValueId>& order, Levels& levels, ArrayCalls& result) {
  for (const Section& section : program.sections) {
    const auto is_in_section = [&](ValueId v) { return program.nodes[v].section == section; };
    const auto first = std::ranges::find_if(order, is_in_section);
    if (first == order.end()) continue;
    const auto last = std::find_if(order.rbegin(), order.rend(), is_in_section).base();
    if (std::all_of(first, last, is_in_section)) continue;
    gather(program, std::span<ValueId>(first, last), levels, result, [&](ValueId v) {
      const Node& node = program.nodes[v];
      return is_in_section(v) && node.op != Op::pow && is_given(program, node.operands[0]);
    });
  }
}

}  // namespace

ArrayCalls gather_calls(const Program& program, std::vector<ValueId>& order, Gathering gathering) {
  ArrayCalls result;
  const std::size_t count = program.nodes.size();
  result.place.resize(count);
  Levels levels{std::vector<bool>(count, false),
                std::vector<bool>(count, false),
                std::vector<int>(count, 0),
                std::vector<int>(count, 0),
                gathering,
                widths_of(program),
                gathering == Gathering::of_vectors ? found_alone(program) : std::vector<bool>(count, false)};
  for (int& width : levels.widths) width = std::max(width, 1);
  gather_given(program, order, levels, result);
  const auto section_of = [&](std::size_t i) { return program.nodes[order[i]].section; };
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && section_of(last) == section_of(first)) ++last;
    gather(program, std::span<ValueId>(order.data() + first, last - first), levels, result,
           [](ValueId) { return true; });
  }
  return result;
}

}  // namespace mbgen
