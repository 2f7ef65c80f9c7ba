// Modes as the page animates them: shapes by hand and by the equations of motion, loops that stay closed.
#include "workbench/report/modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/compile.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "tests/report/report_support.hpp"
#include "tests/support/model_support.hpp"
#include "workbench/report/places.hpp"
#include "workbench/report/scene.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// A model with its modes about a state.
struct Vibration {
  Compilation compilation;
  OperatingPoint point;
  std::vector<Mode> modes;
  ModesSource source() const {
    return {compilation.model, compilation.topology, compilation.analysis, point, modes, "reference", 0};
  }
  GenericSolver solver() const {
    GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
    solver.set_inputs(point.inputs);
    return solver;
  }
};

/// About the reference, the first coordinate elsewhere, or about the equilibrium near it.
Vibration vibration_of(Model model, double first = 0, bool at_equilibrium = false) {
  Vibration v{*compile(std::move(model)), {}, {}};
  const Compilation& c = v.compilation;
  for (const Input& input : c.model.inputs) v.point.inputs.push_back(input.default_value);
  GenericState state;
  state.z.assign(static_cast<std::size_t>(c.topology.size()), 0.0);
  state.z[0] = first;
  state.zd.assign(state.z.size(), 0.0);
  state.x.assign(static_cast<std::size_t>(auxiliary_state_count(c.model)), 0.0);
  const GenericSolver solver = v.solver();
  EXPECT_TRUE((at_equilibrium ? solver.equilibrium(state) : solver.project(state)).ok());
  v.point = {state.z, state.zd, state.x, 0, v.point.inputs};
  v.modes = modes(*linearise(c, v.point));
  return v;
}

/// Two masses of 2 kg between two walls, three springs of 8 N/m; dampers (N s/m) at the first wall and between them.
Model chain(double damping) {
  const std::string at_wall = damping > 0 ? R"(, "damping": )" + std::to_string(damping) : "";
  return read(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "A": [0, 0, 0], "B": [3, 0, 0] } },
      "left": { "mass": 2, "com": [1, 0, 0], "inertia": [1, 1, 1], "points": { "A": [0, 0, 0], "C": [1, 0, 0] } },
      "right": { "mass": 2, "com": [2, 0, 0], "inertia": [1, 1, 1], "points": { "C": [1, 0, 0], "E": [2, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "left.A", "axis": "x" },
                "gap": { "type": "prismatic", "from": "left.C", "to": "right.C", "axis": "x" } },
    "joint_springs": { "wall": { "joint": "slide", "stiffness": 8)" +
              at_wall + R"( }, "middle": { "joint": "gap", "stiffness": 8 } },
    "springs": { "far": { "from": "right.E", "to": "ground.B", "stiffness": 8, "free_length": 1 } } })");
}

/// How far along x a body is from its place at the point, in a frame of a mode of the page: those of half the swing
/// stand first, then those of all of it.
double shift(const Vibration& v, const Json& page, std::size_t mode, std::size_t frame, std::size_t body) {
  const std::size_t bodies = v.compilation.model.bodies.size();
  const std::vector<float> poses = decoded(page["animations"][mode]["poses"]), rest = decoded(page["rest"]);
  return poses[(frame * bodies + body) * 7] - rest[body * 7];
}

// Together at sqrt(k / m), against each other at sqrt(3 k / m), the faster one first.
TEST(Modes, OfAChainOfTwoMassesByHand) {
  const Vibration v = vibration_of(chain(0));
  const Json page = modes_json(v.source());
  ASSERT_EQ(page["animations"].size(), 2u);
  const double largest = 0.1 * model_size(v.compilation.model);
  for (const std::size_t m : {0, 1}) {
    const Json& mode = page["animations"][m];
    EXPECT_NEAR(mode["eigenvalue"][1].get<double>(), m == 0 ? std::sqrt(12.0) : 2.0, 1e-12);
    EXPECT_NEAR(mode["frequency"].get<double>(), (m == 0 ? std::sqrt(12.0) : 2.0) / (2 * std::numbers::pi), 1e-12);
    EXPECT_TRUE(mode["oscillates"]);
    EXPECT_FALSE(mode["unstable"]) << "rounding does not grow";
    EXPECT_NEAR(mode["motion"].get<double>(), largest, 1e-9);
    const std::size_t count = mode["count"];
    ASSERT_EQ(count, 32u);
    const double first = shift(v, page, m, count, 1);
    EXPECT_NEAR(std::abs(first), largest, 1e-6);
    for (std::size_t k = 0; k < 2 * count; ++k) {
      const double left = shift(v, page, m, k, 1), right = shift(v, page, m, k, 2);
      EXPECT_NEAR(right, m == 0 ? -left : left, 1e-6);
      EXPECT_NEAR(left, (k < count ? 0.5 : 1.0) * first * std::cos(2 * std::numbers::pi * k / count), 1e-6);
    }
  }
}

// A damper at one mass only makes the shapes complex: the masses pass the middle one after the other.
TEST(Modes, ComplexShapesFulfilTheEquationsOfMotion) {
  const Vibration v = vibration_of(chain(1.5));
  const Json page = modes_json(v.source());
  ASSERT_EQ(page["animations"].size(), 2u);
  for (const std::size_t m : {0, 1}) {
    const Json& mode = page["animations"][m];
    const std::complex<double> s(mode["eigenvalue"][0], mode["eigenvalue"][1]);
    const std::size_t count = mode["count"];
    // Re(a exp(i phase)) is Re a at the beginning and Im a at three quarters.
    const auto amplitude = [&](std::size_t body) {
      return std::complex<double>(shift(v, page, m, count, body), shift(v, page, m, count + 3 * count / 4, body));
    };
    const std::complex<double> left = amplitude(1), right = amplitude(2);
    EXPECT_GT(std::abs(std::imag(right / left)), 0.05) << "not in phase";
    EXPECT_LT(std::abs((2.0 * s * s + 1.5 * s + 16.0) * left - 8.0 * right), 1e-4);
    EXPECT_LT(std::abs((2.0 * s * s + 16.0) * right - 8.0 * left), 1e-4);
  }
}

/// Largest distance between the two places of a joint that joins them, over the frames of a mode.
double largest_gap(const Vibration& v, const Json& mode) {
  const Model& model = v.compilation.model;
  const std::vector<float> poses = decoded(mode["poses"]);
  double gap = 0;
  for (std::size_t k = 0; k < 2 * mode["count"].get<std::size_t>(); ++k) {
    const auto global = [&](const Attachment& at) {
      return placed(&poses[(k * model.bodies.size() + static_cast<std::size_t>(at.body)) * 7], place_of(model, at));
    };
    for (const Joint& joint : model.joints) {
      if (joint.type != JointType::revolute && joint.type != JointType::spherical) continue;
      gap = std::max(gap, distance(global(joint.from), global(joint.to)));
    }
  }
  return gap;
}

TEST(Modes, LoopsStayClosed) {
  for (const char* file : {"four_bar.json", "andrews_squeezer.json", "coach.json"}) {
    const Vibration v = vibration_of(model_of(file), 0, std::string(file) == "coach.json");
    const GenericSolver solver = v.solver();
    const Json page = modes_json(v.source());
    ASSERT_FALSE(v.modes.empty());
    for (std::size_t m = 0; m < v.modes.size(); ++m) {
      const Swing swing = swing_of(v.source(), solver, v.modes[m], 8);
      EXPECT_GT(swing.motion, 0.01 * model_size(v.compilation.model)) << file << ", mode " << m + 1;
      for (const GenericState& frame : swing.frames) {
        EXPECT_LT(largest_absolute(solver.position_residuals(frame)), 1e-9) << file << ", mode " << m + 1;
      }
      EXPECT_LT(largest_gap(v, page["animations"][m]), 1e-5) << file << ", mode " << m + 1;
    }
  }
}

// A crank of 1 m whose end a bar and a rocker of 1.1 m together hold to 1.1 m around a pin that is 2 m away: it cannot
// turn further than 0.3254 rad, and stands at 0.25. The largest swing would go beyond.
TEST(Modes, SwingLessWhereLoopsCannotClose) {
  const Vibration v = vibration_of(read(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "parameters": { "bx": { "value": 0.968912421710645, "unit": "m" }, "bz": { "value": 0.247403959254523, "unit": "m" },
                    "cx": { "value": 1.568883876857426, "unit": "m" }, "cz": { "value": 0.253256566285095, "unit": "m" } },
    "bodies": { "ground": { "points": { "A": [0, 0, 0], "D": [2, 0, 0] } },
      "crank": { "mass": 1, "com": [0.5, 0, 0], "inertia": [0.1, 0.1, 0.1], "points": { "A": [0, 0, 0], "B": ["bx", 0, "bz"] } },
      "bar": { "mass": 1, "com": [1.2, 0, 0], "inertia": [0.1, 0.1, 0.1], "points": { "B": ["bx", 0, "bz"], "C": ["cx", 0, "cz"] } },
      "rocker": { "mass": 1, "com": [1.7, 0, 0], "inertia": [0.1, 0.1, 0.1], "points": { "C": ["cx", 0, "cz"], "D": [2, 0, 0] } } },
    "joints": { "crank": { "type": "revolute", "from": "ground.A", "to": "crank.A", "axis": "y" },
                "knee": { "type": "revolute", "from": "crank.B", "to": "bar.B", "axis": "y" },
                "end": { "type": "revolute", "from": "bar.C", "to": "rocker.C", "axis": "y" },
                "rocker": { "type": "revolute", "from": "ground.D", "to": "rocker.D", "axis": "y" } },
    "joint_springs": { "spring": { "joint": "crank", "stiffness": 100 } } })"));
  ASSERT_EQ(v.modes.size(), 1u);
  const GenericSolver solver = v.solver();
  const Swing swing = swing_of(v.source(), solver, v.modes[0], 16);
  const auto crank = static_cast<std::size_t>(tree_coordinate(v.compilation.topology, {0, 0}));
  const double ahead = swing.frames[16].z[crank] - v.point.z[crank];
  EXPECT_GT(std::abs(ahead), 0.01);
  EXPECT_LT(std::abs(ahead), 0.3254 - 0.25);
  for (const GenericState& frame : swing.frames) {
    EXPECT_LT(largest_absolute(solver.position_residuals(frame)), 1e-9);
  }
}

}  // namespace
}  // namespace mbgen
