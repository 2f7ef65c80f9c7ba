#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/analysis/symmetry.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

/// The global axis that a mirror turns round, 0 to 2; none where it is no axis.
std::optional<std::size_t> turned_axis(const Mirror& mirror) {
  constexpr double kParallel = 1e-9;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (1 - std::abs(mirror.normal[axis]) < kParallel) return axis;
  return {};
}

/// Sign of a result of a law at the image: forces are mirrored, moments are mirrored and turned round.
int sign_of_result(const std::string& name, std::size_t turned) {
  const auto component = static_cast<std::size_t>(name.back() - 'x');
  if (name.starts_with("force_")) return component == turned ? -1 : 1;
  if (name.starts_with("moment_")) return component == turned ? 1 : -1;
  return 1;
}

/// Results of the laws of tyres whose bodies are images, in the axes of their carriers. Where these are not the global
/// ones, the values find no pairs.
void add_law_results(const Model& model, const Topology& topology, const Mirror& mirror,
                     const std::vector<SharedLaw>& laws, std::vector<MirroredInput>& inputs) {
  const std::optional<std::size_t> turned = turned_axis(mirror);
  if (!turned) return;
  const auto wheel = [&](int tyre) { return topology.tree_body[model.tyres[tyre].centre.body]; };
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const std::vector<int>& tyres = laws[k].tyres;
    const int elements = static_cast<int>(tyres.size());
    for (int e = 0; e < elements; ++e) {
      const int image = wheel(tyres[e]) == kGround ? -1 : mirror.image[wheel(tyres[e])];
      const auto other = std::ranges::find_if(tyres, [&](int tyre) { return image >= 0 && wheel(tyre) == image; });
      if (other == tyres.end()) continue;
      for (int r = 0; r < static_cast<int>(laws[k].results.size()); ++r) {
        const SlotGroup group = of_block(Array::law_result, k);
        inputs.push_back({{group, r * elements + e},
                          {group, r * elements + static_cast<int>(other - tyres.begin())},
                          sign_of_result(laws[k].results[r], *turned)});
      }
    }
  }
}

}  // namespace

std::vector<MirroredInput> mirrored_inputs(const Model& model, const Topology& topology,
                                           const std::vector<SharedLaw>& laws) {
  const Mirror mirror = find_mirror(model, topology);
  if (!mirror.found()) return {};
  std::vector<MirroredInput> inputs = {{{Array::t, 0}, {Array::t, 0}, 1}};
  for (int i = 0; i < topology.size(); ++i)
    for (const Array array : {Array::z, Array::zd, Array::tau})
      if (mirror.image[i] >= 0) inputs.push_back({{array, i}, {array, mirror.image[i]}, mirror.sign[i]});
  for (const auto& [array, count] :
       {std::pair(Array::in, model.inputs.size()), std::pair(Array::par, model.parameters.size())})
    for (int i = 0; i < static_cast<int>(count); ++i) inputs.push_back({{array, i}, {array, i}, 1});
  add_law_results(model, topology, mirror, laws, inputs);
  return inputs;
}

}  // namespace mbgen
