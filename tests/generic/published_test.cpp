// Published problems integrated by the generic runtime.

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Andrews' mechanism: angles and velocities of the reference row at time t, by coordinate name.
std::map<std::string, std::pair<double, double>> andrews_reference(double t) {
  const auto data = nlohmann::json::parse(std::ifstream(source_path("tests/data/reference/andrews.json")));
  const char* const order[] = {"beta", "theta", "gamma", "phi", "delta", "omega", "epsilon"};
  std::map<std::string, std::pair<double, double>> values;
  for (const auto& row : data["rows"])
    if (std::abs(std::stod(row["t"].get<std::string>()) - t) < 1e-12)
      for (int i = 0; i < 7; ++i)
        values[order[i]] = {
            std::stod(row["q"][i].get<std::string>()) - std::stod(data["initial"][order[i]].get<std::string>()),
            std::stod(row["qd"][i].get<std::string>())};
  return values;
}

class Andrews : public ::testing::Test {
 protected:
  Mechanism m = load("models/andrews_squeezer.json");
  GenericSolver solver{m.model, m.topology, m.analysis};
  Dynamics dynamics{solver};

  /// Largest error of an angle at t = 0.03 s after so many steps.
  double error_after(int steps, bool abm) const {
    GenericState state{std::vector<double>(7), std::vector<double>(7), {}, 0};
    AbmHistory<Dynamics> history{};
    for (int s = 0; s < steps; ++s)
      EXPECT_TRUE(
          (abm ? step_abm4(dynamics, state, history, 0.03 / steps) : step_rk4(dynamics, state, 0.03 / steps)).ok());
    double error = 0;
    for (const auto& [name, value] : andrews_reference(0.03))
      error = std::max(error, std::abs(state.z[find_coordinate(m.topology, name)] - value.first));
    return error;
  }
};

TEST_F(Andrews, StartsWithThePublishedAccelerations) {
  GenericState state{std::vector<double>(7), std::vector<double>(7), {}, 0};
  EXPECT_LT(largest_absolute(solver.position_residuals(state)), 1e-14);
  GenericDerivative derivative;
  ASSERT_TRUE(solver.accelerations(state, std::vector<double>(7), derivative).ok());
  EXPECT_NEAR(derivative.zdd[find_coordinate(m.topology, "beta")] / 14222.4439199541138705911625887, 1, 1e-12);
  EXPECT_NEAR(derivative.zdd[find_coordinate(m.topology, "theta")] / -10666.8329399655854029433719415, 1, 1e-12);
}

// The published solution is good to 1.1e-9 in beta, the reference to 1e-17.
TEST_F(Andrews, ReachesThePublishedSolutionWithOrderFour) {
  const double coarse = error_after(3000, false), middle = error_after(6000, false), fine = error_after(12000, false);
  std::printf("Andrews at 0.03 s: errors %.2e, %.2e, %.2e rad at 3000, 6000, 12000 steps; ratios %.2f, %.2f\n", coarse,
              middle, fine, coarse / middle, middle / fine);
  EXPECT_LT(fine, 1e-9);
  EXPECT_NEAR(coarse / middle, 16, 1.5);
  EXPECT_NEAR(middle / fine, 16, 1.0);
}

// The order of the method itself is shown in the runtime's tests; here its error constants nearly cancel.
TEST_F(Andrews, TwoEvaluationAdamsReachesItToo) {
  const double middle = error_after(6000, true), fine = error_after(12000, true);
  std::printf("Andrews at 0.03 s, ABM4: errors %.2e, %.2e rad at 6000, 12000 steps\n", middle, fine);
  EXPECT_LT(fine, 1e-10);
  EXPECT_GT(middle / fine, 10);
}

}  // namespace
}  // namespace mbgen
