// Bytes as a model file, through the whole compiler when the model is small: code, or diagnostics.
#include <algorithm>

#include "compiler/compile.hpp"
#include "compiler/reader/read_model.hpp"
#include "fuzz_support.hpp"

namespace {

constexpr std::size_t kLongestText = 6000;
constexpr int kMostCoordinates = 8;
constexpr std::size_t kMostLoops = 3, kMostElements = 12, kMostNodes = 200;

/// Whether all stages together take milliseconds.
bool is_small(const mbgen::Model& model, const mbgen::Topology& topology) {
  const std::size_t elements = model.bodies.size() + model.springs.size() + model.air_springs.size() +
                               model.bushings.size() + model.bump_stops.size() + model.joint_springs.size() +
                               model.frictions.size() + model.forces.size() + model.joint_forces.size() +
                               model.motions.size() + model.outputs.size();
  return topology.size() <= kMostCoordinates && topology.loops.size() <= kMostLoops && elements <= kMostElements &&
         model.tyres.size() <= 1 &&
         std::all_of(model.expressions.begin(), model.expressions.end(),
                     [](const mbgen::Expression& expression) { return expression.nodes.size() <= kMostNodes; });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mbgen;
  if (size > kLongestText) return 0;
  const std::string text = fuzz::text_of(data, size);
  const Result<Model> model = read_model(text, "fuzz.json");
  if (!model) return 0;
  const Result<Topology> topology = build_topology(*model);
  if (!topology || !is_small(*model, *topology)) return 0;
  const Result<Compilation> compilation = compile(*model);
  if (!compilation) {
    fuzz::require_places(compilation.problems(), text);
  } else {
    fuzz::require(emit(*compilation).size() > 4, "a compilation has files");
  }
  return 0;
}
