// Loop blocks that a solver chooses again fine block by fine block: a walking machine's legs under its crank.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// Exit status 0 where all holds: the first state that does not is 10 + its number, the first bad comparison is
/// printed.
constexpr const char* kDriver = R"(#include "walker_4.cpp"
#include <cstdio>
using namespace walker_4;
using namespace mbgen::solver_detail;
static double difference(const double* a, const double* b, int count) {
  double largest = 0, size = 1;
  for (int i = 0; i < count; ++i) {
    if (!(std::abs(a[i] - b[i]) <= largest)) largest = std::abs(a[i] - b[i]);
    if (std::abs(a[i]) > size) size = std::abs(a[i]);
  }
  return largest / size;
}
static int bad(const char* name, double by) { return std::printf("%s: %g\n", name, by), 1; }
// Closing and consistent velocities from a state that is open.
static int close(const System::Parameters& parameters, const Inputs& inputs, const State& state, int k) {
  for (const bool is_shortest : {false, true}) {
    State open = state;
    for (int c = 0; c < System::kCoordinates; ++c) {
      open.z[c] += 1e-5 * ((7 * c + k) % 5 - 2);
      open.zd[c] += 1e-3 * ((3 * c + k) % 7 - 3);
    }
    for (int n = 0; n < 3; ++n) {
      System::Closure closure;
      System::closure(parameters, inputs, open, closure);
      closure.pivot[0] = 0;
      const mbgen::Status status =
          is_shortest ? correct_closure<System, Correction::shortest>(parameters, inputs, open, closure)
                      : correct_closure<System, Correction::of_dependents>(parameters, inputs, open, closure);
      if (status.code != mbgen::Code::chosen_again) return 5;
      for (int c = 0; c < System::kCoordinates; ++c) open.z[c] += closure.dz[c];
      if (n < 2) continue;
      for (int c = 0; c < System::kCoordinates; ++c) open.zd[c] = closure.zd[c];
    }
    ClosureResidual left;
    if (!closure_residual({}, inputs, open, left).ok()) return 6;
    if (!(left.largest_position <= 1e-13)) return bad("position", left.largest_position);
    if (!(left.largest_velocity <= 1e-12)) return bad("velocity", left.largest_velocity);
  }
  return 0;
}
int main() {
  static const Inputs inputs{};
  static const double none[System::kCoordinates] = {};
  State state = initial_state();
  if (!assemble({}, inputs, state).ok()) return 2;
  System::Parameters parameters{};
  for (int k = 0; k < 110; ++k) {
    for (int i = 0; i < 10; ++i)
      if (!step_rk4({}, inputs, state, 1e-3).ok()) return 3;
    // Accelerations: by the frozen order, by fine blocks, and by the factors of the whole block.
    System::Accelerations frozen;
    System::accelerations(parameters, inputs, state, none, frozen);
    System::ClosureTerms terms;
    System::closure_terms(parameters, inputs, state, terms);
    ByFineBlocks<System> fine;
    if (!fine.solves(0, terms)) return bad("fine blocks do not serve", fine.solution.smallest_pivot);
    const double zero[] = {0};
    Derivative derivative;
    if (pivoted_accelerations<System>(parameters, inputs, state, none, zero, derivative).code != mbgen::Code::chosen_again)
      return 4;
    const double off = difference(frozen.zdd, derivative.zdd, System::kCoordinates);
    if (!(off <= 1e-9)) return bad("accelerations", off);
    System::Projection by_fine, by_all;
    project_by<System>(0, fine, terms, by_fine);
    BlockFactors<System> factors;
    System::ClosureTerms factored = terms;
    const auto loop = factors.factors_of(0, factored);
    project_by<System>(0, ByFactors<System>{0, loop, terms, factors.work, nullptr}, terms, by_all);
    // Directions of one freedom are parallel, whichever coordinate is free.
    int free = 0;
    while (by_all.Rz[free] != 1) ++free;
    double scaled[System::kCoordinates];
    for (int c = 0; c < System::kCoordinates; ++c) scaled[c] = by_fine.Rz[c] / by_fine.Rz[free];
    const double apart = difference(by_all.Rz, scaled, System::kCoordinates);
    if (!(apart <= 1e-9)) return bad("directions", apart);
    const int closing = close(parameters, inputs, state, k);
    if (closing != 0) return closing;
  }
  return 0;
}
)";

TEST_F(CommandLine, FineBlocksOfASolverGiveWhatItsFrozenOrderAndItsWholeBlocksGive) {
  ASSERT_EQ(shell(fmt::format("sh {}/bench/growth_model.sh walker 4", kSource), "walker_4.json").exit_code, 0);
  ASSERT_EQ(mbgen("generate walker_4.json --out made").exit_code, 0);
  const Json manifest = Json::parse(read("made/walker_4.json"));
  const Json& loop = manifest["worst_case"]["factorisation"][0];
  EXPECT_EQ(loop["pivots"], 24);
  EXPECT_EQ(loop["fine_blocks"], 12);  // three loops a leg
  EXPECT_EQ(loop["largest_fine_block"], 2);
  EXPECT_NE(
      read("made/walker_4_cost.txt").find("24 pivots, clear of singular positions in 12 fine blocks of at most 2"),
      std::string::npos);
  write("main.cpp", kDriver);
  const Outcome compiled = shell("c++ -std=c++17 -O1 -Imade main.cpp -o main");
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const Outcome run = shell("./main");
  EXPECT_EQ(run.exit_code, 0) << run.out;
}

}  // namespace
}  // namespace mbgen::cli_test
