// Bytes as a model file: a model with its tree, or diagnostics that stand inside the text.
#include <cmath>

#include "compiler/reader/read_model.hpp"
#include "compiler/topology/topology.hpp"
#include "fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mbgen;
  const std::string text = fuzz::text_of(data, size);
  const Result<Model> model = read_model(text, "fuzz.json");
  if (!model) {
    fuzz::require_places(model.problems(), text);
    return 0;
  }
  for (const Body& body : model->bodies) fuzz::require(std::isfinite(body.mass.value), "a model has finite masses");
  for (const Expression& expression : model->expressions) {
    for (std::size_t i = 0; i < expression.nodes.size(); ++i) {
      const ExpressionNode& node = expression.nodes[i];
      for (const int operand : {node.first, node.second, node.third})
        fuzz::require(operand < static_cast<int>(i), "operands stand before their users");
    }
  }
  const Result<Topology> topology = build_topology(*model);
  if (!topology) fuzz::require_places(topology.problems(), text);
  return 0;
}
