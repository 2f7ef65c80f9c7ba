// Nothing is shared behind the scenes: solvers and compilations in many threads give the bits of one thread. Built with
// the preset `tsan` the thread sanitizer watches, too.

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/reader/read_model.hpp"
#include "mbgen/integrators.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

constexpr int kThreads = 4;

Model model_of(const std::string& name) {
  return *read_model_file(std::string(MBGEN_SOURCE_DIR) + "/models/" + name + ".json");
}

/// Results of `work` in each of several threads that run at once.
template <class Work>
auto in_threads(const Work& work) {
  std::vector<decltype(work())> results(kThreads);
  std::vector<std::thread> threads;
  for (int k = 0; k < kThreads; ++k) threads.emplace_back([&, k] { results[k] = work(); });
  for (std::thread& thread : threads) thread.join();
  return results;
}

/// Everything emitted, in one text.
std::string emitted(const Model& model) {
  std::string text;
  for (const EmittedFile& file : emit(*compile(model))) text += file.path + "\n" + file.text;
  return text;
}

/// Positions and velocities after some projected steps from the closed initial position, moving.
std::vector<double> motion(const Compilation& compilation, LinearAlgebra library) {
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis, {library, Factorisation::lu});
  const std::size_t n = compilation.topology.bodies.size();
  GenericState state;
  state.z.assign(n, 0.0);
  state.zd.assign(n, 0.3);
  std::vector<double> numbers;
  for (int step = 0; step < 20; ++step) {
    if (!solver.project(state).ok()) break;
    GenericDerivative derivative;
    if (!solver.accelerations(state, std::vector<double>(n, 1.0), derivative).ok()) break;
    for (std::size_t i = 0; i < n; ++i) {
      state.z[i] += 1e-3 * state.zd[i];
      state.zd[i] += 1e-3 * derivative.zdd[i];
    }
    numbers.insert(numbers.end(), derivative.zdd.begin(), derivative.zdd.end());
  }
  return numbers;
}

TEST(Threads, CompileToTheSameBytes) {
  const Model model = model_of("four_bar");
  const std::string alone = emitted(model);
  for (const std::string& text : in_threads([&] { return emitted(model); })) EXPECT_EQ(text, alone);
}

TEST(Threads, GenericSolversOfOneModelGiveTheBitsOfOneThread) {
  const Compilation compilation = *compile(model_of("coach_mechanism"));
  // Not LinearAlgebra::blas: Debian's serial OpenBLAS shares buffers between threads without a lock.
  for (const LinearAlgebra library : {LinearAlgebra::eigen, LinearAlgebra::sparse}) {
    const std::vector<double> alone = motion(compilation, library);
    ASSERT_EQ(alone.size(), 20 * compilation.topology.bodies.size());
    for (const std::vector<double>& numbers : in_threads([&] { return motion(compilation, library); })) {
      EXPECT_EQ(numbers, alone);
    }
  }
}

}  // namespace
}  // namespace mbgen
