// Every linear algebra of the generic runtime against Eigen's LU and against states of an independent solver.

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

struct NamedAlgebra {
  const char* name;
  GenericAlgebra algebra;
};

constexpr NamedAlgebra kAlgebras[] = {{"entries", {LinearAlgebra::entries, Factorisation::lu}},
                                      {"eigen", {LinearAlgebra::eigen, Factorisation::lu}},
                                      {"qr", {LinearAlgebra::eigen, Factorisation::qr}},
                                      {"blas", {LinearAlgebra::blas, Factorisation::lu}},
                                      {"sparse", {LinearAlgebra::sparse, Factorisation::lu}}};

class AlgebrasOnAModel : public ::testing::TestWithParam<std::string> {
 protected:
  GenericSolver solver(const GenericAlgebra& algebra = {}) const { return {m.model, m.topology, m.analysis, algebra}; }
  const Mechanism m = load(GetParam());
};

// The states are closed and well conditioned, so pivots in any order leave rounding only: 4e-12 is seen.
TEST_P(AlgebrasOnAModel, AccelerationsAreThoseOfEigen) {
  const GenericSolver reference = solver({LinearAlgebra::eigen, Factorisation::lu});
  const std::vector<GenericState> states = random_states(m, 4);
  ASSERT_FALSE(states.empty());
  for (const NamedAlgebra& named : kAlgebras) {
    const GenericSolver other = solver(named.algebra);
    for (const GenericState& state : states) {
      const std::vector<double> tau = random_tau(m, 5);
      GenericDerivative expected, actual;
      ASSERT_TRUE(reference.accelerations(state, tau, expected).ok());
      ASSERT_TRUE(other.accelerations(state, tau, actual).ok()) << named.name;
      EXPECT_LT(relative_error(actual.zdd, expected.zdd), 1e-10) << named.name;
      EXPECT_EQ(actual.xd, expected.xd) << named.name;
    }
  }
}

// Which coordinates give way differs; that the loops close, and that motions are kept, does not.
TEST_P(AlgebrasOnAModel, ProjectionClosesTheLoops) {
  for (const NamedAlgebra& named : kAlgebras) {
    const GenericSolver other = solver(named.algebra);
    for (GenericState state : random_states(m, 2)) {
      const GenericState before = state;
      for (std::size_t i = 0; i < state.z.size(); ++i) {
        state.z[i] += 1e-3 * std::sin(static_cast<double>(i));
        state.zd[i] += 1e-2 * std::cos(static_cast<double>(i));
      }
      ASSERT_TRUE(other.project(state).ok()) << named.name;
      EXPECT_LE(largest_absolute(other.position_residuals(state)), m.model.solver.closure_tolerance) << named.name;
      EXPECT_LT(largest_absolute(other.velocity_residuals(state)), 1e-10) << named.name;
      for (std::size_t i = 0; i < state.z.size(); ++i) {
        if (m.analysis.driven[i]) {
          EXPECT_EQ(state.z[i], before.z[i]) << named.name;
        }
      }
    }
  }
}

// A clock changes nothing, and every step of a mechanism with loops takes time.
TEST_P(AlgebrasOnAModel, ClockSeesTheNineSteps) {
  const std::vector<GenericState> states = random_states(m, 1);
  ASSERT_FALSE(states.empty());
  const std::vector<double> tau = random_tau(m, 3);
  for (const NamedAlgebra& named : kAlgebras) {
    const GenericSolver timed = solver(named.algebra);
    GenericDerivative with, without;
    StepClock clock;
    ASSERT_TRUE(timed.accelerations(states[0], tau, without).ok());
    ASSERT_TRUE(timed.accelerations(states[0], tau, with, &clock).ok());
    EXPECT_EQ(with.zdd, without.zdd) << named.name;
    for (const long long ticks : clock.ticks) EXPECT_GT(ticks, 0) << named.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, AlgebrasOnAModel, ::testing::ValuesIn(all_models()), test_name);

struct AlgebraCase {
  const char *name, *model, *states;
};

void PrintTo(const AlgebraCase& which, std::ostream* out) { *out << which.name; }

class AlgebrasAtReferenceStates : public ::testing::TestWithParam<AlgebraCase> {};

// The truck has eleven redundant equations; the reference is good to 1e-11 (tests/data/reference/README.md).
TEST_P(AlgebrasAtReferenceStates, EveryAlgebraGivesTheirAccelerations) {
  const Mechanism m = load(GetParam().model);
  const auto file = nlohmann::json::parse(std::ifstream(source_path(GetParam().states)));
  std::vector<int> place;
  for (const std::string name : file["joint_order"]) place.push_back(find_coordinate(m.topology, name));
  const auto in_place = [&](const nlohmann::json& values) {
    std::vector<double> result(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) result[place[i]] = values[i];
    return result;
  };
  for (const NamedAlgebra& named : kAlgebras) {
    const GenericSolver solver(m.model, m.topology, m.analysis, named.algebra);
    for (const auto& s : file["states"]) {
      GenericDerivative derivative;
      ASSERT_TRUE(
          solver.accelerations({in_place(s["z"]), in_place(s["zd"]), {}, 0}, in_place(s["tau"]), derivative).ok());
      EXPECT_LT(relative_error(derivative.zdd, in_place(s["zdd"])), 1e-11) << named.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Vehicles, AlgebrasAtReferenceStates,
    ::testing::Values(AlgebraCase{"coach", "models/coach_mechanism.json", "tests/data/reference/coach_states.json"},
                      AlgebraCase{"truck", "models/truck_mechanism.json", "tests/data/reference/truck_states.json"}),
    [](const auto& info) { return info.param.name; });

std::string four_bar_text() {
  std::ifstream file(source_path("models/four_bar.json"));
  return {std::istreambuf_iterator<char>(file), {}};
}

// Crank and coupler of the four-bar in line: the point that closes the loop moves along one line for both, so the
// rocker must be dependent. Offline, here, it was made the independent one.
TEST(EveryAlgebra, ChoosesAgainWhereTheFrozenChoiceHasNoSolution) {
  const Mechanism m = mechanism_of(four_bar_text());
  const auto coordinate = [&](const char* name) { return find_coordinate(m.topology, name); };
  const int crank = coordinate("crank_pin"), coupler = coordinate("coupler_pin"), rocker = coordinate("rocker_pin");
  const double ab = std::hypot(0.1, 0.05), bc = std::hypot(0.32, 0.2), dc = std::hypot(0.02, 0.25), ad = 0.4;
  const double ac = ab + bc, angle = std::acos((ac * ac + ad * ad - dc * dc) / (2 * ac * ad));
  GenericState state{std::vector<double>(3), std::vector<double>(3), {}, 0};
  state.z[crank] = std::atan2(0.05, 0.1) - angle;  // a turn about y takes z towards x
  state.z[coupler] = std::atan2(0.2, 0.32) - angle - state.z[crank];
  state.z[rocker] = std::atan2(0.25, 0.02) - std::atan2(ac * std::sin(angle), ac * std::cos(angle) - ad);
  state.zd[crank] = 5;
  state.zd[coupler] = -6;
  const GenericSolver reference(m.model, m.topology, m.analysis);
  ASSERT_LT(largest_absolute(reference.position_residuals(state)), 1e-15);
  ASSERT_TRUE(reference.project(state).ok());
  EXPECT_NEAR(state.zd[rocker], 0, 1e-14);
  EXPECT_GT(std::abs(state.zd[crank]), 1);

  Analysis bad = m.analysis;
  const std::vector<int>& joints = m.topology.blocks[0].joints;
  const auto column = [&](int joint) {
    return static_cast<int>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
  };
  bad.blocks[0].independent = {column(rocker)};
  bad.blocks[0].dependent = {column(crank), column(coupler)};
  bad.blocks[0].pivots[0].coordinate = column(crank);
  bad.blocks[0].pivots[1].coordinate = column(coupler);
  const std::vector<double> tau = random_tau(m, 3);
  GenericDerivative expected, actual;
  ASSERT_TRUE(reference.accelerations(state, tau, expected).ok());
  for (const NamedAlgebra& named : kAlgebras) {
    const GenericSolver solver(m.model, m.topology, bad, named.algebra);
    for (const double away : {0.3, 1e-5, 0.0, -1e-5, -0.3}) {
      GenericState near = state;
      near.z[crank] += away;
      ASSERT_TRUE(reference.project(near).ok());
      ASSERT_TRUE(reference.accelerations(near, tau, expected).ok());
      ASSERT_TRUE(solver.accelerations(near, tau, actual).ok()) << named.name << " " << away;
      EXPECT_LT(relative_error(actual.zdd, expected.zdd), 1e-10) << named.name << " " << away;
    }
  }
}

// All bars in one line: the loops lose an equation, whatever is chosen. Beside it all is well again.
TEST(EveryAlgebra, SaysWhereTheLoopsLoseRank) {
  const Mechanism m = load("models/iftomm/a02_n_four_bar_2.json");
  GenericState down{std::vector<double>(m.topology.size()), std::vector<double>(m.topology.size()), {}, 0};
  const std::vector<double> tau(m.topology.size(), 0.0);
  for (const char* name : {"A0", "A1", "A2"}) down.z[find_coordinate(m.topology, name)] = -std::acos(-1.0) / 2;
  for (const char* name : {"B0", "B1"}) down.z[find_coordinate(m.topology, name)] = std::acos(-1.0) / 2;
  GenericState beside = down;
  for (double& z : beside.z) z *= 0.9;
  for (const NamedAlgebra& named : kAlgebras) {
    const GenericSolver solver(m.model, m.topology, m.analysis, named.algebra);
    GenericDerivative derivative;
    for (int again = 0; again < 2; ++again) {
      const Status status = solver.accelerations(down, tau, derivative);
      EXPECT_EQ(status.code, Code::loop_singular) << named.name;
      EXPECT_EQ(status.index, 0) << named.name;
      EXPECT_TRUE(solver.accelerations(beside, tau, derivative).ok()) << named.name;
    }
    GenericState state = down;
    EXPECT_EQ(solver.project(state).code, Code::loop_singular) << named.name;
    EXPECT_EQ(state.z, down.z) << named.name;
  }
}

// A driven crank keeps its acceleration, and the other two follow it without any freedom left.
TEST(EveryAlgebra, NeverLetsADrivenCoordinateDepend) {
  std::string text = four_bar_text();
  const std::string initial = "\"initial\": { \"velocities\": { \"crank_pin\": 12 } },";
  ASSERT_NE(text.find(initial), std::string::npos);
  text.replace(text.find(initial), initial.size(),
               "\"motions\": { \"turn\": { \"joint\": \"crank_pin\", \"angle\": \"0.3*sin(2*t)\" } },");
  const Mechanism m = mechanism_of(text);
  const int crank = find_coordinate(m.topology, "crank_pin");
  for (const NamedAlgebra& named : kAlgebras) {
    const GenericSolver solver(m.model, m.topology, m.analysis, named.algebra);
    GenericState state{std::vector<double>(3), std::vector<double>(3), {}, 0.4};
    ASSERT_TRUE(solver.project(state).ok()) << named.name;
    EXPECT_NEAR(state.z[crank], 0.3 * std::sin(0.8), 1e-15) << named.name;
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, {0, 0, 0}, derivative).ok()) << named.name;
    EXPECT_NEAR(derivative.zdd[crank], -1.2 * std::sin(0.8), 1e-14) << named.name;
    const auto velocities_at = [&](double t) {
      GenericState moved = state;
      moved.t = t;
      EXPECT_TRUE(solver.project(moved).ok());
      return moved.zd;
    };
    const double h = 1e-5;
    const std::vector<double> before = velocities_at(0.4 - h), after = velocities_at(0.4 + h);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(derivative.zdd[i], (after[i] - before[i]) / (2 * h), 1e-8) << named.name;
  }
}

}  // namespace
}  // namespace mbgen
