// Five seconds of motion of closed linkages and of the coach without tyres against Simbody's integrator.

#include <cstdio>

#include "tests/support/dynamics.hpp"
#include "tests/system/oracle/oracle_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// One motion: the largest difference of a coordinate at any of ten instants, rad or m.
struct Course {
  std::string model;
  int steps_per_second;  ///< of mbgen's Runge-Kutta method
  double accuracy;       ///< asked of Simbody's
  double tolerance;      ///< rad or m
};

class MotionInSimbody : public InSimbody<Course> {};

TEST_P(MotionInSimbody, IsTheSameForFiveSeconds) {
  const Course& course = GetParam();
  const Mechanism m = load_without_tyres(course.model);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const Dynamics dynamics{solver};
  GenericState state = random_states(m, 1).at(0);
  state.t = 0;
  ASSERT_TRUE(solver.project(state).ok());
  std::vector<double> times;
  for (int k = 1; k <= 10; ++k) times.push_back(0.5 * k);
  const std::vector<foreign::ForeignState> theirs = in_simbody(m).motion(foreign_state(state), times, course.accuracy);
  double error = 0, way = 0;
  for (const foreign::ForeignState& their : theirs) {
    for (int s = 0; s < course.steps_per_second / 2; ++s)
      ASSERT_TRUE(step_rk4(dynamics, state, 1.0 / course.steps_per_second).ok()) << "at " << state.t << " s";
    for (std::size_t i = 0; i < state.z.size(); ++i) error = std::max(error, std::abs(state.z[i] - their.z[i]));
    way = std::max(way, largest_absolute(state.z));
  }
  std::printf("%s: 5 s as in Simbody, %.1e rad or m of up to %.3g\n", m.model.name.c_str(), error, way);
  EXPECT_LT(error, course.tolerance);
}

void PrintTo(const Course& course, std::ostream* stream) { *stream << course.model; }

// Tolerances are three to ten times what was measured, which is both methods' errors and shrinks with both steps. The
// coach hangs in the air, driven wheels spinning, and passes the corners of its bump stops.
INSTANTIATE_TEST_SUITE_P(Closed, MotionInSimbody,
                         ::testing::Values(Course{"models/four_bar.json", 2000, 1e-9, 1e-6},
                                           Course{"models/slider_crank.json", 4000, 1e-9, 3e-6},
                                           Course{"models/iftomm/a04_bricard.json", 1000, 1e-9, 1e-6},
                                           Course{"tests/data/models/spatial_four_bar.json", 4000, 1e-10, 1e-6},
                                           Course{"models/coach.json", 1000, 1e-8, 1e-6}),
                         [](const auto& info) {
                           const std::string& path = info.param.model;
                           const std::size_t first = path.rfind('/') + 1;
                           return path.substr(first, path.rfind('.') - first);
                         });

}  // namespace
}  // namespace mbgen
