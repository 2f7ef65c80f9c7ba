#include "compiler/compile.hpp"

#include <utility>

namespace mbgen {

Result<Compilation> compile(const std::string& path) {
  Result<Model> model = read_model_file(path);
  if (!model) return model.problems();

  Result<Topology> topology = build_topology(*model);
  if (!topology) return topology.problems();

  Result<Analysis> analysis = analyse(*model, *topology);
  if (!analysis) return analysis.problems();

  Programs programs = trace(*model, *topology, *analysis);
  return Compilation{std::move(*model), std::move(*topology), std::move(*analysis), std::move(programs)};
}

std::vector<EmittedFile> emit(const Compilation& compilation, const EmitOptions& options) {
  return emit(compilation.programs, compilation.model, compilation.topology, compilation.analysis, options);
}

}  // namespace mbgen
