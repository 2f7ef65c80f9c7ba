#include "compiler/program/identities.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "compiler/program/function_field.hpp"

namespace mbgen {

std::vector<Identity> identities(const Program& program) {
  using Lanes = std::array<Element, 2>;
  FunctionField field;
  const std::vector<Lanes> all = elements_of(program, field, input_variables(program, field));
  const std::vector<int> widths = widths_of(program);
  std::map<std::pair<int, Lanes>, ValueId> first;  // by width, up to the sign of the first lane
  std::vector<Identity> result(all.size());
  for (ValueId v = 0; v < result.size(); ++v) {
    if (all[v] == Lanes{}) {
      result[v] = {v, 0};
      continue;
    }
    const bool negative = all[v][0].number != 0 ? all[v][0].negative : all[v][1].negative;
    const Lanes key = {with_sign(all[v][0], negative), with_sign(all[v][1], negative)};
    const ValueId earlier = first.try_emplace({std::max(widths[v], 1), key}, v).first->second;
    const bool opposite = all[earlier] != all[v];
    result[v] = {earlier, opposite ? -1 : 1};
  }
  return result;
}

}  // namespace mbgen
