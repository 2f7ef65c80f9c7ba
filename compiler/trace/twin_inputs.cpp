#include <algorithm>

#include "compiler/topology/twins.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

/// Results of the laws of tyres whose wheels are twins.
void add_law_results(const Model& model, const Topology& topology, const std::vector<int>& twin,
                     const std::vector<SharedLaw>& laws, std::vector<TwinInput>& inputs) {
  const auto wheel = [&](int tyre) { return topology.tree_body[model.tyres[tyre].centre.body]; };
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const std::vector<int>& tyres = laws[k].tyres;
    const int elements = static_cast<int>(tyres.size());
    const SlotGroup group = of_block(Array::law_result, k);
    for (int e = 0; e < elements; ++e) {
      const int other = wheel(tyres[e]) == kGround ? -1 : twin[wheel(tyres[e])];
      for (int f = e + 1; f < elements && other >= 0; ++f) {
        if (wheel(tyres[f]) != other) continue;
        for (int r = 0; r < static_cast<int>(laws[k].results.size()); ++r)
          inputs.push_back({{group, r * elements + e}, {group, r * elements + f}});
        break;
      }
    }
  }
}

}  // namespace

std::vector<TwinInput> twin_inputs(const Model& model, const Topology& topology, const std::vector<SharedLaw>& laws) {
  const std::vector<int> twin = find_twins(topology);
  std::vector<TwinInput> inputs;
  for (int i = 0; i < topology.size(); ++i)
    for (const Array array : {Array::z, Array::zd, Array::tau})
      if (twin[i] > i) inputs.push_back({{array, i}, {array, twin[i]}});
  add_law_results(model, topology, twin, laws, inputs);
  return inputs;
}

}  // namespace mbgen
