#include "compiler/program/identities.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "compiler/program/function_field.hpp"
#include "compiler/program/mixed_words.hpp"

namespace mbgen {
namespace {

/// A width and the functions of both lanes, up to the sign of the first.
struct LanesOfWidth {
  int width = 1;
  std::array<Element, 2> lanes;
  friend bool operator==(const LanesOfWidth&, const LanesOfWidth&) = default;
};

struct HashOfLanes {
  std::size_t operator()(const LanesOfWidth& key) const {
    std::uint64_t hash = static_cast<std::uint64_t>(key.width);
    for (const Element& e : key.lanes) hash = mixed_word(hash, 2 * static_cast<std::uint64_t>(e.number) + e.negative);
    return hash;
  }
};

}  // namespace

std::vector<Identity> identities(const Program& program) {
  using Lanes = std::array<Element, 2>;
  FunctionField field;
  const std::vector<Lanes> all = elements_of(program, field, input_variables(program, field));
  const std::vector<int> widths = widths_of(program);
  std::unordered_map<LanesOfWidth, ValueId, HashOfLanes> first;
  std::vector<ValueId> first_number(field.size(), kNoValue);  // the same for numbers, by their functions
  std::vector<Identity> result(all.size());
  for (ValueId v = 0; v < result.size(); ++v) {
    if (all[v] == Lanes{}) {
      result[v] = {v, 0};
      continue;
    }
    const bool negative = all[v][0].number != 0 ? all[v][0].negative : all[v][1].negative;
    const LanesOfWidth key{std::max(widths[v], 1), {with_sign(all[v][0], negative), with_sign(all[v][1], negative)}};
    const bool is_number = key.width == 1 && key.lanes[0] == key.lanes[1];
    ValueId& earlier = is_number ? first_number[static_cast<std::size_t>(key.lanes[0].number)]
                                 : first.try_emplace(key, v).first->second;
    if (earlier == kNoValue) earlier = v;
    const bool opposite = all[earlier] != all[v];
    result[v] = {earlier, opposite ? -1 : 1};
  }
  return result;
}

}  // namespace mbgen
