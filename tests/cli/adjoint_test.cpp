// Motions backwards: derivatives of one number by everything, against mechanisms that were computed in complex
// arithmetic with multipliers (reference), and against the solver with derivatives, number by number.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// Weighted states and outputs of a motion backwards, against directions forward: by every parameter and input, and by
/// numbers of the start. Arguments: steps, size of a step, least number of steps that choose coordinates again.
constexpr const char* kAgainstDirections = R"(#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "MODEL_adjoint.hpp"
#include "MODEL_tangents.hpp"
namespace plain = MODEL;
namespace forward = MODEL_tangents;
namespace backward = MODEL_adjoint;
using Real = forward::Real;

constexpr int kLanes = forward::kDirections;
static const plain::Tuned tuned;
static const plain::Inputs inputs;

static double weight(int i) { return 1 + 0.37 * (i % 5); }
static double weight_of_output(int instant, int i) { return instant % 7 == 0 ? 0.3 + 0.1 * (i % 4) : 0; }

#define REQUIRE(what)                         \
  if (!(what)) {                              \
    std::printf("%d: %s\n", __LINE__, #what); \
    return 1;                                 \
  }

/// Place p of parameters, inputs, z, zd and x, in this order.
template <class P, class I, class S>
static auto* number(P& parameters, I& in, S& state, int p) {
  using Number = std::remove_reference_t<decltype(state.z[0])>;
  if (p < plain::kParameters) return reinterpret_cast<Number*>(&parameters) + p;
  p -= plain::kParameters;
  if (p < plain::kInputs) return reinterpret_cast<Number*>(&in) + p;
  p -= plain::kInputs;
  if (p < plain::kCoordinates) return state.z + p;
  p -= plain::kCoordinates;
  return p < plain::kCoordinates ? state.zd + p : state.x + (p - plain::kCoordinates);
}
constexpr int kNumbers =
    plain::kParameters + plain::kInputs + 2 * plain::kCoordinates + plain::kAuxiliaryStates;

/// The motion. Result: the number of steps that chose coordinates again, -1 where one fails.
static int go_forward(int steps, double h, std::vector<plain::State>& states) {
  int chosen = 0;
  for (int k = 0; k < steps; ++k) {
    plain::State state = states.back();
    const mbgen::Status status = plain::step_rk4(tuned, inputs, state, h);
    if (!status.ok()) return -1;
    chosen += status.code == mbgen::Code::chosen_again;
    states.push_back(state);
  }
  return chosen;
}

static bool go_back(const std::vector<plain::State>& states, double h, backward::Adjoints& cost) {
  const int steps = static_cast<int>(states.size()) - 1;
  for (int i = 0; i < plain::kCoordinates; ++i) cost.z[i] = weight(i), cost.zd[i] = weight(i + 2);
  for (int i = 0; i < plain::kAuxiliaryStates; ++i) cost.x[i] = weight(i + 1);
  constexpr int kOutputSize = plain::kOutputs > 0 ? plain::kOutputs : 1;
  for (int k = steps + 1; k-- > 0;) {
    if (k < steps && !backward::step_rk4_back(tuned, inputs, states[k], h, cost).ok()) return false;
    double weights[kOutputSize];
    for (int i = 0; i < kOutputSize; ++i) weights[i] = weight_of_output(k, i);
    if (weights[0] != 0 && !backward::outputs_back(tuned, inputs, states[k], weights, cost).ok()) return false;
  }
  backward::constants_back(tuned, cost);
  return true;
}

/// Derivatives in the directions of some numbers, and the sums of their terms' sizes.
struct Sums {
  Real::Vector values{}, sizes{};
  void add(double by, const Real& number) {
    values += by * number.tangent;
    for (int lane = 0; lane < kLanes; ++lane) sizes[lane] += std::abs(by * number.tangent[lane]);
  }
};

static bool add_outputs(int k, const forward::Tuned& seeded, const forward::Inputs& in, const forward::State& state,
                        Sums& sums) {
  if (weight_of_output(k, 0) == 0) return true;
  const Real tau[plain::kCoordinates] = {};
  forward::Derivative rates;
  forward::Outputs values;
  if (!forward::accelerations(seeded, in, state, tau, rates).ok()) return false;
  if (!forward::outputs(seeded, in, state, tau, rates, values).ok()) return false;
  for (int i = 0; i < plain::kOutputs; ++i)
    sums.add(weight_of_output(k, i), reinterpret_cast<const Real*>(&values)[i]);
  return true;
}

static bool go_along(int first, int steps, double h, Sums& sums) {
  forward::Parameters parameters;
  forward::Inputs in;
  forward::State state = forward::initial_state();
  for (int lane = 0; lane < kLanes && first + lane < kNumbers; ++lane)
    number(parameters, in, state, first + lane)->tangent[lane] = 1;
  const forward::Tuned seeded(parameters);
  for (int k = 0; k <= steps; ++k) {
    if (!add_outputs(k, seeded, in, state, sums)) return false;
    if (k < steps && !forward::step_rk4(seeded, in, state, h).ok()) return false;
  }
  for (int i = 0; i < plain::kCoordinates; ++i) {
    sums.add(weight(i), state.z[i]);
    sums.add(weight(i + 2), state.zd[i]);
  }
  for (int i = 0; i < plain::kAuxiliaryStates; ++i) sums.add(weight(i + 1), state.x[i]);
  return true;
}

static double by_number(const backward::Adjoints& cost, int p) {
  if (p < plain::kParameters) return cost.parameters[p];
  p -= plain::kParameters;
  if (p < plain::kInputs) return cost.inputs[p];
  p -= plain::kInputs;
  if (p < plain::kCoordinates) return cost.z[p];
  p -= plain::kCoordinates;
  return p < plain::kCoordinates ? cost.zd[p] : cost.x[p - plain::kCoordinates];
}

int main(int, char** argument) {
  const int steps = std::atoi(argument[1]), least_chosen = std::atoi(argument[3]);
  const double h = std::atof(argument[2]);
  std::vector<plain::State> states = {plain::initial_state()};
  const int chosen = go_forward(steps, h, states);
  REQUIRE(chosen >= least_chosen);
  backward::Adjoints cost{};
  REQUIRE(go_back(states, h, cost));
  double worst = 0;
  int moved = 0;
  for (int first = 0; first < kNumbers; first += kLanes) {
    Sums sums;
    REQUIRE(go_along(first, steps, h, sums));
    for (int lane = 0; lane < kLanes && first + lane < kNumbers; ++lane) {
      // Rounding of stiff motions is of the size of the terms, which cancel.
      const double size = std::abs(sums.values[lane]) + 1e-2 * sums.sizes[lane];
      const double off = std::abs(by_number(cost, first + lane) - sums.values[lane]);
      moved += size > 0;
      if (!(off / (size > 0 ? size : 1) <= worst)) worst = off / (size > 0 ? size : 1);
    }
  }
  std::printf("%.3g, %d of %d numbers, %d chosen again\n", worst, moved, kNumbers, chosen);
  return worst < 1e-8 && moved > kNumbers / 3 ? 0 : 1;
}
)";

/// Gradients of every output at the end by every parameter, from the start of the model. Arguments: steps, size of a
/// step.
constexpr const char* kGradients = R"(#include <cstdio>
#include <cstdlib>
#include <vector>

#include "MODEL_adjoint.hpp"
namespace plain = MODEL;
namespace backward = MODEL_adjoint;

int main(int, char** argument) {
  const int steps = std::atoi(argument[1]);
  const double h = std::atof(argument[2]);
  const plain::Tuned tuned;
  const plain::Inputs inputs;
  plain::State state;
  if (!backward::start(tuned, inputs, state).ok()) return 1;
  std::vector<plain::State> states;
  for (int k = 0; k < steps; ++k) {
    states.push_back(state);
    if (!plain::step_rk4(tuned, inputs, state, h).ok()) return 1;
  }
  for (int output = 0; output < plain::kOutputs; ++output) {
    double weights[plain::kOutputs] = {};
    weights[output] = 1;
    backward::Adjoints cost{};
    if (!backward::outputs_back(tuned, inputs, state, weights, cost).ok()) return 1;
    for (int k = steps; k-- > 0;)
      if (!backward::step_rk4_back(tuned, inputs, states[k], h, cost).ok()) return 1;
    if (!backward::start_back(tuned, inputs, cost).ok()) return 1;
    for (int p = 0; p < plain::kParameters; ++p)
      std::printf("%s %s %.17g\n", plain::kOutputNames[output], plain::kParameterNames[p], cost.parameters[p]);
  }
}
)";

class Adjoint : public CommandLine {
 protected:
  /// Writes the solver of a model, its steps backwards and a program over them. Result: the program's output.
  std::string output_of(const std::string& model, const std::string& options, std::string program,
                        const std::string& arguments) {
    const Outcome made = mbgen("generate '" + kSource + "/" + model + "' --adjoint --name made --out made " + options);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    for (std::size_t at = program.find("MODEL"); at != std::string::npos; at = program.find("MODEL"))
      program.replace(at, 5, "made");
    write("main.cpp", program);
    const Outcome compiled = shell(
        "c++ -std=c++17 -O1 -ffp-contract=off -fno-math-errno -Wno-psabi -Imade main.cpp made/made.cpp "
        "made/made_tangents.cpp "
        "made/made_adjoint.cpp -o main");
    EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
    const Outcome run = shell("./main " + arguments);
    EXPECT_EQ(run.exit_code, 0) << run.out;
    return run.out;
  }

  /// Largest error of the gradients at 2 s of the outputs, over the largest derivative on the way, against the
  /// reference.
  double worst_of(const std::string& mechanism, const std::vector<std::string>& columns) {
    const Json data = Json::parse(std::ifstream(kSource + "/tests/data/reference/sensitivities.json"))[mechanism];
    const std::vector<std::string> free = data["free"];
    std::string names;
    for (const std::string& name : free) names += (names.empty() ? "" : ",") + name;
    std::istringstream lines(
        output_of("models/sensitivities/" + mechanism + ".json", "--sensitivities " + names, kGradients, "2000 1e-3"));
    double worst = 0;
    std::size_t found = 0;
    std::string output, parameter;
    double value = 0;
    while (lines >> output >> parameter >> value) {
      const auto column = static_cast<std::size_t>(std::ranges::find(columns, output) - columns.begin());
      const auto place = static_cast<std::size_t>(std::ranges::find(free, parameter) - free.begin());
      if (column == columns.size() || place == free.size()) continue;
      const Json& rows = data["derivatives"][place];
      double largest = 0;
      for (const Json& row : rows) largest = std::max(largest, std::abs(row[column].get<double>()));
      worst = std::max(worst, std::abs(value - rows[20][column].get<double>()) / largest);
      ++found;
    }
    EXPECT_EQ(found, columns.size() * free.size());
    return worst;
  }
};

TEST_F(Adjoint, OfAFourBarAgainstComplexArithmetic) {
  EXPECT_LT(worst_of("four_bar", {"crank", "crank_rate", "crank_acceleration", "coupler", "rocker", "cost"}), 1e-7);
}

/// Its coordinates are chosen again on the way.
TEST_F(Adjoint, OfAFiveBarAgainstComplexArithmetic) {
  EXPECT_LT(worst_of("five_bar", {"angle_1", "angle_4", "rate_1", "rate_4", "x_2", "y_2", "cost"}), 1e-6);
}

/// A position where coordinates are chosen again: 32 of the steps.
TEST_F(Adjoint, OfAFiveBarAgainstDirections) {
  output_of("models/sensitivities/five_bar.json", "--sensitivities l2", kAgainstDirections, "2000 1e-3 10");
}

/// A spatial loop with balls.
TEST_F(Adjoint, OfASpatialFourBarAgainstDirections) {
  output_of("tests/data/models/spatial_four_bar.json", "", kAgainstDirections, "200 1e-3 0");
}

/// Spatial loops of rods with balls.
TEST_F(Adjoint, OfADeltaRobotAgainstDirections) {
  output_of("models/delta.json", "", kAgainstDirections, "200 1e-3 0");
}

/// Sampled values go back by directions.
TEST_F(Adjoint, OfAHydraulicArmAgainstDirections) {
  output_of("models/hydraulic_arm.json", "", kAgainstDirections, "40 1e-3 0");
}

/// Inputs with rates and accelerations drive a loop.
TEST_F(Adjoint, OfADrivenFiveBarAgainstDirections) {
  output_of("tests/data/models/driven_five_bar.json", "", kAgainstDirections, "200 1e-3 0");
}

TEST_F(Adjoint, OfAllElementsAgainstDirections) {
  output_of("tests/data/models/all_elements.json", "", kAgainstDirections, "200 1e-4 0");
}

TEST_F(Adjoint, OfACoachAgainstDirections) { output_of("models/coach.json", "", kAgainstDirections, "100 1e-3 0"); }

TEST_F(Adjoint, IsRefusedWhereItSaysNothing) {
  const std::string model = "generate '" + kSource + "/models/pendulum.json' --adjoint --out made ";
  EXPECT_NE(mbgen(model + "--scalar float").err.find("--adjoint has derivatives of doubles"), std::string::npos);
  EXPECT_NE(mbgen(model + "--reading").err.find("leave out --adjoint or --reading"), std::string::npos);
  const Outcome hosted =
      mbgen("generate '" + kSource + "/examples/c_interface/hosted_wheel.json' --adjoint --c-api --out made");
  EXPECT_NE(hosted.err.find("knows no ground of a host"), std::string::npos) << hosted.err;
}

}  // namespace
}  // namespace mbgen::cli_test
