// Kernels of the runtime and stages of the compiler. Whole solvers are timed by `mbgen bench`.

#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/passes/passes.hpp"
#include "mbgen/loop.hpp"
#include "mbgen/tyre.hpp"
#include "runtime/generic/generic.hpp"

namespace {

using namespace mbgen;

std::string model_path(const std::string& name) { return std::string(MBGEN_SOURCE_DIR) + "/models/" + name + ".json"; }

/// Full pivoting of one loop block: equations x coordinates.
void loop_factorisation(benchmark::State& state) {
  const int equations = static_cast<int>(state.range(0)), coordinates = equations + 3;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> source(static_cast<std::size_t>(equations) * coordinates), matrix(source.size());
  for (double& value : source) value = unit(random);
  std::vector<int> rows(equations), columns(coordinates);
  for (auto _ : state) {
    matrix = source;
    LoopFactors loop;
    loop.equations = equations;
    loop.coordinates = coordinates;
    loop.matrix = matrix.data();
    loop.rows = rows.data();
    loop.columns = columns.data();
    factorise(loop, equations, nullptr, 1e-10);
    benchmark::DoNotOptimize(loop.smallest_ratio);
  }
}
BENCHMARK(loop_factorisation)->Arg(2)->Arg(4)->Arg(6)->Arg(11);

/// One evaluation of the generic runtime: the paper's algorithm, un-specialised.
void generic_accelerations(benchmark::State& state, const std::string& model) {
  const Result<Compilation> compiled = compile(model_path(model));
  if (!compiled) {
    state.SkipWithError(to_text(compiled.problems()).c_str());
    return;
  }
  const GenericSolver solver(compiled->model, compiled->topology, compiled->analysis);
  const std::size_t n = compiled->topology.bodies.size();
  GenericState s{std::vector<double>(n), std::vector<double>(n), std::vector<double>(2 * compiled->model.tyres.size()),
                 0};
  GenericDerivative derivative;
  const std::vector<double> tau(n);
  for (auto _ : state) benchmark::DoNotOptimize(solver.accelerations(s, tau, derivative).index);
}
BENCHMARK_CAPTURE(generic_accelerations, coach_mechanism, "coach_mechanism")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(generic_accelerations, truck_mechanism, "truck_mechanism")->Unit(benchmark::kMicrosecond);

/// From the file to optimised programs.
void compile_model(benchmark::State& state, const std::string& model) {
  for (auto _ : state) {
    const Result<Compilation> compiled = compile(model_path(model));
    if (!compiled) state.SkipWithError(to_text(compiled.problems()).c_str());
    benchmark::DoNotOptimize(&compiled);
  }
}
BENCHMARK_CAPTURE(compile_model, coach_mechanism, "coach_mechanism")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compile_model, truck_mechanism, "truck_mechanism")->Unit(benchmark::kMillisecond);

}  // namespace
