#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "compiler/program/kinds.hpp"
#include "compiler/schedule/fewest_alive.hpp"
#include "compiler/schedule/scheduled_program.hpp"

namespace mbgen {
namespace {

/// Cost of a cut inside a section, in crossing values: a section kept whole is worth a few more stores.
constexpr long kSectionCost = 10;

/// Section after section, when no value needs one of a later section.
void sort_by_section(const Program& program, std::vector<ValueId>& order) {
  const std::map<Section, std::size_t> places = places_of_sections(program);
  std::vector<std::size_t> place(program.nodes.size(), 0);
  for (const ValueId v : order) {
    const Node& node = program.nodes[v];
    place[v] = places.at(node.section);
    for (int k = 0; k < arity(node.op); ++k)
      if (place[node.operands[k]] > place[v]) return;
  }
  std::ranges::stable_sort(order, {}, [&](ValueId v) { return place[v]; });
}

/// The other of sine and cosine of the same angle in the same section, kNoValue when there is none.
std::vector<ValueId> angle_partners(const Program& program, const std::vector<ValueId>& order) {
  std::map<std::pair<ValueId, Section>, ValueId> first_of;
  std::vector<ValueId> partner(program.nodes.size(), kNoValue);
  for (const ValueId v : order) {
    const Node& node = program.nodes[v];
    if (node.op != Op::sin && node.op != Op::cos) continue;
    const auto [entry, is_first] = first_of.try_emplace({node.operands[0], node.section}, v);
    if (is_first || program.nodes[entry->second].op == node.op) continue;
    partner[v] = entry->second;
    partner[entry->second] = v;
  }
  return partner;
}

std::vector<ValueId> pair_angles(const std::vector<ValueId>& order, const std::vector<ValueId>& partner) {
  std::vector<ValueId> result;
  std::vector<bool> placed(partner.size(), false);
  for (const ValueId v : order) {
    if (placed[v]) continue;
    result.push_back(v);
    if (partner[v] != kNoValue) {
      result.push_back(partner[v]);
      placed[partner[v]] = true;
    }
  }
  return result;
}

/// cost[i]: values defined before place i and used at or after it, with the costs of cutting there.
std::vector<long> cut_costs(const Program& program, const std::vector<ValueId>& order,
                            const std::vector<ValueId>& partner, const std::vector<ArrayPlace>& place_in_call) {
  std::vector<std::size_t> place(program.nodes.size(), 0), last_use(program.nodes.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Node& node = program.nodes[order[i]];
    place[order[i]] = last_use[order[i]] = i;
    for (int k = 0; k < arity(node.op); ++k) last_use[node.operands[k]] = i;
  }
  std::vector<long> change(order.size() + 1, 0);
  for (const ValueId v : order) {
    if (place_in_call[v].call >= 0) continue;
    ++change[place[v] + 1];
    if (last_use[v] + 1 <= order.size()) --change[last_use[v] + 1];
  }
  std::vector<long> cost(order.size() + 1, 0);
  long live = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    live += change[i];
    const bool inside_section = program.nodes[order[i - 1]].section == program.nodes[order[i]].section;
    const int call = place_in_call[order[i]].call;
    const bool inside_angle = partner[order[i]] == order[i - 1];
    const bool inside_call = call >= 0 && call == place_in_call[order[i - 1]].call;
    cost[i] =
        inside_angle || inside_call ? std::numeric_limits<int>::max() : live + (inside_section ? kSectionCost : 0);
  }
  return cost;
}

/// Cheapest division of a range by dynamic programming over the cuts; of equally cheap last parts the longest.
std::vector<PlaceRange> divide(PlaceRange range, const std::vector<long>& cost, std::size_t largest) {
  const std::size_t size = range.last - range.first, smallest = std::max<std::size_t>(largest / 2, 1);
  if (size <= largest) return {range};
  constexpr long kUnreachable = std::numeric_limits<long>::max();
  std::vector<long> best(size + 1, kUnreachable);
  std::vector<std::size_t> from(size + 1, 0);
  best[0] = 0;
  const auto total = [&](std::size_t start) { return best[start] + cost[range.first + start]; };
  std::deque<std::size_t> starts;  // that may be the cheapest of an end, in ascending order of place and total
  for (std::size_t end = smallest; end <= size; ++end) {
    const std::size_t start = end - smallest;
    if (best[start] != kUnreachable) {
      while (!starts.empty() && total(starts.back()) > total(start)) starts.pop_back();
      starts.push_back(start);
    }
    while (!starts.empty() && starts.front() + largest < end) starts.pop_front();
    if (starts.empty()) continue;
    best[end] = total(starts.front());
    from[end] = starts.front();
  }
  std::vector<PlaceRange> parts;
  for (std::size_t end = size; end > 0; end = from[end]) parts.push_back({range.first + from[end], range.first + end});
  std::reverse(parts.begin(), parts.end());
  return parts;
}

/// The values of one call, the two functions of one angle, and every other value by itself.
std::vector<std::vector<ValueId>> bundles_of(const Schedule& schedule, const std::vector<ValueId>& partner) {
  std::vector<std::vector<ValueId>> bundles;
  ValueId last = kNoValue;
  for (const ValueId v : schedule.order) {
    const int call = schedule.calls.place[v].call;
    const bool goes_on =
        last != kNoValue && (partner[v] == last || (call >= 0 && schedule.calls.place[last].call == call));
    if (!goes_on) bundles.emplace_back();
    bundles.back().push_back(v);
    last = v;
  }
  return bundles;
}

/// Brings what the arguments of shared laws follow from before everything else. Result: how many operations they are.
std::size_t put_law_arguments_first(const Program& program, std::vector<std::vector<ValueId>>& bundles) {
  std::vector<bool> is_needed(program.nodes.size(), false);
  for (const OutputValue& output : program.outputs)
    if (output.slot.group.array == Array::law_argument) is_needed[output.value] = true;
  std::size_t operations = 0;
  for (auto bundle = bundles.rbegin(); bundle != bundles.rend(); ++bundle) {
    if (std::ranges::none_of(*bundle, [&](ValueId v) { return is_needed[v]; })) continue;
    operations += bundle->size();
    for (const ValueId v : *bundle) {
      is_needed[v] = true;
      for (int k = 0; k < arity(program.nodes[v].op); ++k) is_needed[program.nodes[v].operands[k]] = true;
    }
  }
  std::stable_partition(bundles.begin(), bundles.end(), [&](const auto& bundle) { return is_needed[bundle.front()]; });
  return operations;
}

/// The values of all bundles, those of the first `start` operations and the others each in an order of few live values.
std::vector<ValueId> few_alive(const Program& program, std::span<const std::vector<ValueId>> bundles,
                               std::size_t start) {
  std::size_t first = 0;
  for (std::size_t operations = 0; operations < start; ++first) operations += bundles[first].size();
  std::vector<ValueId> order = fewest_alive(program, bundles.first(first));
  const std::vector<ValueId> rest = fewest_alive(program, bundles.subspan(first));
  order.insert(order.end(), rest.begin(), rest.end());
  return order;
}

std::vector<ValueId> joined(const std::vector<std::vector<ValueId>>& bundles) {
  std::vector<ValueId> order;
  for (const auto& bundle : bundles) order.insert(order.end(), bundle.begin(), bundle.end());
  return order;
}

/// Cuts the range that a place is inside of.
void cut_at(std::size_t place, std::vector<PlaceRange>& ranges) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (place <= ranges[i].first || place >= ranges[i].last) continue;
    ranges.insert(ranges.begin() + static_cast<std::ptrdiff_t>(i) + 1, {place, ranges[i].last});
    ranges[i].last = place;
  }
}

/// Runs of values of one section.
std::vector<PlaceRange> section_ranges(const Program& program, const std::vector<ValueId>& order) {
  std::vector<PlaceRange> ranges;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool goes_on = i > 0 && program.nodes[order[i - 1]].section == program.nodes[order[i]].section;
    if (!goes_on) ranges.push_back({i, i});
    ranges.back().last = i + 1;
  }
  return ranges;
}

}  // namespace

Schedule straight_schedule(const Program& program, Division division, ValueOrder wanted, Gathering gathering) {
  std::vector<ValueId> order = live_operations(program);
  std::erase_if(order, [&](ValueId v) { return is_constant_pair(program, program.nodes[v]); });
  sort_by_section(program, order);
  const std::vector<ValueId> partner = angle_partners(program, order);
  Schedule result;
  result.ordered = wanted;
  result.order = pair_angles(order, partner);
  if (wanted == ValueOrder::reading)
    result.calls.place.resize(program.nodes.size());
  else
    result.calls = gather_calls(program, result.order, gathering);
  std::vector<std::vector<ValueId>> bundles = bundles_of(result, partner);
  const std::size_t before_laws = put_law_arguments_first(program, bundles);
  result.order = wanted == ValueOrder::fewest_alive ? few_alive(program, bundles, before_laws) : joined(bundles);
  const std::vector<long> cost = cut_costs(program, result.order, partner, result.calls.place);
  const std::size_t largest = wanted == ValueOrder::reading        ? std::max<std::size_t>(result.order.size(), 1)
                              : wanted == ValueOrder::fewest_alive ? kLargestHotPart
                                                                   : kLargestPart;
  std::vector<PlaceRange> ranges;
  if (division == Division::by_section) ranges = section_ranges(program, result.order);
  if (ranges.empty()) ranges = {{0, result.order.size()}};
  cut_at(before_laws, ranges);
  for (const PlaceRange& range : ranges)
    for (const PlaceRange& part : divide(range, cost, largest)) {
      if (before_laws > 0 && part.first == before_laws) result.law_part = result.parts.size();
      result.units.push_back({.first = part.first, .period = part.last - part.first, .part = result.parts.size()});
      result.parts.push_back(part);
    }
  return result;
}

}  // namespace mbgen
