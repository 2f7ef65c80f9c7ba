// Kernels of the runtime and stages of the compiler. Whole solvers are timed by `mbgen bench` and bench/compare.sh.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/passes/passes.hpp"
#include "mbgen/math/sincos.hpp"
#include "mbgen/solver/loop.hpp"
#include "mbgen/tyres/tyre.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/start/initial_state.hpp"

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

/// Entries of a block of four equations: four dependent coordinates, then three independent ones.
constexpr int kRows = 4, kColumns = 7;

std::vector<double> dominant_block() {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> block(kRows * kColumns);
  for (double& value : block) value = unit(random);
  for (int i = 0; i < kRows; ++i) block[i * kColumns + i] += 4;  // so that every order of pivots is a good one
  return block;
}

/// Rz of a block by the order that was chosen offline, as emitted code does it: no search, no branch.
void block_frozen(benchmark::State& state) {
  const std::vector<double> source = dominant_block();
  double m[kRows][kColumns];
  for (auto _ : state) {
    std::copy(source.begin(), source.end(), &m[0][0]);
#pragma GCC unroll 8
    for (int k = 0; k < kRows; ++k) {
      const double reciprocal = 1 / m[k][k];
#pragma GCC unroll 8
      for (int j = k + 1; j < kColumns; ++j) m[k][j] *= reciprocal;
#pragma GCC unroll 8
      for (int i = 0; i < kRows; ++i)
#pragma GCC unroll 8
        for (int j = k + 1; j < kColumns && i != k; ++j) m[i][j] -= m[i][k] * m[k][j];
    }
    benchmark::DoNotOptimize(m);
  }
}
BENCHMARK(block_frozen);

/// The same by the factorisation with full pivoting that takes over where the frozen order goes bad.
void block_pivoted(benchmark::State& state) {
  const std::vector<double> source = dominant_block();
  std::vector<double> matrix(source), rz(kColumns * (kColumns - kRows)), work(kColumns);
  std::vector<int> rows(kRows), columns(kColumns);
  const std::vector<unsigned char> driven(kColumns, 0);
  for (auto _ : state) {
    matrix = source;
    LoopFactors loop;
    loop.equations = kRows;
    loop.coordinates = kColumns;
    loop.matrix = matrix.data();
    loop.rows = rows.data();
    loop.columns = columns.data();
    factorise(loop, kRows, nullptr, 1e-10);
    free_directions(loop, driven.data(), rz.data(), work.data());
    benchmark::DoNotOptimize(rz.data());
  }
}
BENCHMARK(block_pivoted);

constexpr int kAngles = 32;

template <class Function>
void angles(benchmark::State& state, const Function& sines_and_cosines) {
  double angle[kAngles], sines[kAngles], cosines[kAngles];
  for (int i = 0; i < kAngles; ++i) angle[i] = 0.1 * i - 1.5;
  for (auto _ : state) {
    benchmark::DoNotOptimize(angle);
    sines_and_cosines(angle, sines, cosines);
    benchmark::DoNotOptimize(sines);
    benchmark::DoNotOptimize(cosines);
  }
  state.SetItemsProcessed(state.iterations() * kAngles);
}

/// Sine and cosine of 32 angles: ours, all in one call, and the C library's.
void angles_own(benchmark::State& state) {
  angles(state, [](const double(&a)[kAngles], double(&s)[kAngles], double(&c)[kAngles]) { mbgen::sincos(a, s, c); });
}
BENCHMARK(angles_own);

void angles_libm(benchmark::State& state) {
  angles(state, [](const double(&a)[kAngles], double(&s)[kAngles], double(&c)[kAngles]) {
    for (int i = 0; i < kAngles; ++i) {
      s[i] = std::sin(a[i]);
      c[i] = std::cos(a[i]);
    }
  });
}
BENCHMARK(angles_libm);

/// One step of an integrator with projection, by the generated solver.
void generated_step(benchmark::State& state, const std::string& model, SolverSettings::Integrator integrator) {
  const Result<Compilation> compiled = compile(model_path(model));
  if (!compiled) {
    state.SkipWithError(to_text(compiled.problems()).c_str());
    return;
  }
  EngineChoice choice;
  choice.integrator = integrator;
  const Engine engine = make_engine(*compiled, choice);
  const GenericState start = initial_state(*compiled, input_values(compiled->model, {}));
  GenericState s = start;
  for (auto _ : state) {
    if (s.t > start.t + 1 || !engine.step(s, 1e-3).ok()) s = start;
  }
}
BENCHMARK_CAPTURE(generated_step, coach_rk4, "coach", SolverSettings::Integrator::rk4)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(generated_step, coach_abm4, "coach", SolverSettings::Integrator::abm4)->Unit(benchmark::kMicrosecond);

/// One evaluation of the generic runtime: the paper's algorithm, un-specialised.
void generic_accelerations(benchmark::State& state, const std::string& model) {
  const Result<Compilation> compiled = compile(model_path(model));
  if (!compiled) {
    state.SkipWithError(to_text(compiled.problems()).c_str());
    return;
  }
  const GenericSolver solver(compiled->model, compiled->topology, compiled->analysis);
  const std::size_t n = compiled->topology.bodies.size();
  GenericState s{std::vector<double>(n), std::vector<double>(n),
                 std::vector<double>(auxiliary_state_count(compiled->model)), 0};
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
