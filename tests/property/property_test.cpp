// What must hold for every mechanism, on random ones. A failure shrinks to a small model file, which is printed.
// MBGEN_PROPERTY_CASES: mechanisms of each family, 12 by default; MBGEN_PROPERTY_SEED: the first seed;
// MBGEN_PROPERTY_COMPILED: the solver of every so many is compiled, 12 by default.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "compiler/compile.hpp"
#include "compiler/describe/dump_model.hpp"
#include "compiler/engines/engine.hpp"
#include "compiler/passes/passes.hpp"
#include "tests/mechanism_support.hpp"
#include "tests/property/random_mechanism.hpp"

namespace mbgen::testing {
namespace {

/// Nothing where the property holds.
using Complaint = std::optional<std::string>;
using ByName = std::map<std::string, double>;

/// States and comparisons that the run made, to be seen in its log.
struct Tally {
  long mechanisms = 0, refused = 0, states = 0;
};

Result<Mechanism> understood(const RandomMechanism& random) {
  Result<Model> model = read_model(model_text(random), "random.json");
  if (!model) return model.problems();
  Result<Topology> topology = build_topology(*model);
  if (!topology) return topology.problems();
  Result<Analysis> analysis = analyse(*model, *topology);
  if (!analysis) return analysis.problems();
  return Mechanism{*model, *topology, *analysis};
}

/// Consistent states that are not near a singular position.
std::vector<GenericState> good_states(const Mechanism& m, int wanted) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  std::vector<GenericState> states = random_states(m, wanted);
  std::erase_if(states, [&](const GenericState& state) {
    GenericDerivative derivative;
    return solver.solve_motion(state, derivative).code != Code::ok;
  });
  return states;
}

std::vector<double> interpreted(const Program& program, const GenericState& state, const std::vector<double>& tau) {
  const std::map<std::string, std::vector<double>> given{{"z", state.z}, {"zd", state.zd}, {"tau", tau}, {"t", {0.0}}};
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(given.at(slot.group).at(slot.index));
  const std::vector<double> values = interpret(program, inputs);
  std::vector<double> zdd(state.z.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (program.outputs[i].slot.group == "zdd") zdd[program.outputs[i].slot.index] = values[i];
  return zdd;
}

Complaint differ(const std::string& what, const std::vector<double>& actual, const std::vector<double>& expected,
                 double tolerance) {
  const double error = relative_error(actual, expected);
  if (error < tolerance) return {};
  return what + " differs by " + std::to_string(error / tolerance) + " times the tolerance";
}

constexpr double kTolerance = 1e-8;  ///< of the largest acceleration

// --- the properties ---

/// All passes on a mechanism that is analysed.
Compilation compiled(const Mechanism& m) {
  Compilation compilation{m.model, m.topology, m.analysis};
  add_programs(compilation);
  return compilation;
}

/// Generic, both forms of the symbolic program and the four Cartesian judges say the same.
Complaint engines_disagree(const RandomMechanism&, const Mechanism& m) {
  const GenericSolver generic(m.model, m.topology, m.analysis);
  const Compilation compilation = compiled(m);
  const Programs& programs = compilation.whole;
  const Program matrix = optimise(trace_accelerations(m.model, m.topology, m.analysis, Form::matrix));
  for (const GenericState& state : good_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 3);
    GenericDerivative expected;
    if (!generic.accelerations(state, tau, expected).ok()) return "generic refuses a state";
    if (const Complaint c = differ("the matrix form", interpreted(matrix, state, tau), expected.zdd, kTolerance))
      return c;
    if (const Complaint c =
            differ("the recursive form", interpreted(programs.accelerations, state, tau), expected.zdd, kTolerance))
      return c;
    for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::range_space,
                                         CartesianMethod::null_space, CartesianMethod::maggi}) {
      const CartesianSolver judge(m.model, m.topology, method, Stabilisation::projection);
      GenericDerivative actual;
      if (!judge.accelerations(state, tau, actual).ok()) return "a Cartesian judge refuses a state";
      if (const Complaint c =
              differ("judge " + std::to_string(static_cast<int>(method)), actual.zdd, expected.zdd, kTolerance))
        return c;
    }
  }
  return {};
}

int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

/// The emitted solver, compiled, gives the accelerations of the generic runtime and the same step.
Complaint compiled_solver_disagrees(const RandomMechanism& random, const Mechanism& m) {
  if (random.seed % static_cast<unsigned>(from_environment("MBGEN_PROPERTY_COMPILED", 12)) != 0) return {};
  const Compilation compilation = compiled(m);
  cli::EngineChoice choice;
  choice.use_cache = false;
  const cli::Engine emitted = cli::make_engine(compilation, choice);
  choice.name = "generic";
  const cli::Engine generic = cli::make_engine(compilation, choice);
  for (const GenericState& state : good_states(m, 2)) {
    const cli::LoadedState loaded{state, random_tau(m, 3)};
    GenericDerivative expected, actual;
    if (!generic.accelerations(loaded, expected).ok()) return "generic refuses a state";
    if (!emitted.accelerations(loaded, actual).ok()) return "the compiled solver refuses a state";
    if (const Complaint c = differ("the compiled solver", actual.zdd, expected.zdd, kTolerance)) return c;
    GenericState there = state, here = state;
    if (generic.step(there, 1e-4).code != Code::ok || emitted.step(here, 1e-4).code != Code::ok) continue;
    if (const Complaint c = differ("a step of the compiled solver", here.zd, there.zd, kTolerance)) return c;
  }
  return {};
}

ByName by_name(const Mechanism& m, const std::vector<double>& values) {
  ByName result;
  for (int i = 0; i < m.topology.size(); ++i) result[m.topology.bodies[i].coordinate] = values[i];
  return result;
}

std::vector<double> in_order(const Mechanism& m, const ByName& values) {
  std::vector<double> result;
  for (const TreeBody& body : m.topology.bodies) result.push_back(values.at(body.coordinate));
  return result;
}

/// The same state of another description of the mechanism has the same accelerations.
Complaint accelerations_change(const Mechanism& m, const RandomMechanism& other) {
  const Result<Mechanism> also = understood(other);
  if (!also) return "refused: " + to_text(also.problems());
  const GenericSolver solver(m.model, m.topology, m.analysis), same(also->model, also->topology, also->analysis);
  for (const GenericState& state : good_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 3);
    GenericDerivative expected, actual;
    if (!solver.accelerations(state, tau, expected).ok()) return "a state is refused";
    const GenericState there{in_order(*also, by_name(m, state.z)), in_order(*also, by_name(m, state.zd)), {}, state.t};
    if (!same.accelerations(there, in_order(*also, by_name(m, tau)), actual).ok()) return "the same state is refused";
    if (const Complaint c = differ("it", actual.zdd, in_order(*also, by_name(m, expected.zdd)), kTolerance)) return c;
  }
  return {};
}

Complaint translation_shows(const RandomMechanism& random, const Mechanism& m) {
  const std::array<Point, 3> identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return accelerations_change(m, moved(random, identity, {3, -4, 5}));
}

Complaint rotation_shows(const RandomMechanism& random, const Mechanism& m) {
  if (!has_plain_joints(random)) return {};
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(-1.1), e = std::sin(-1.1);
  const std::array<Point, 3> rotation{{{c, -s, 0}, {d * s, d * c, -e}, {e * s, e * c, d}}};
  return accelerations_change(m, moved(random, rotation, {-1, 2, 0.5}));
}

Complaint mirror_shows(const RandomMechanism& random, const Mechanism& m) {
  return has_plain_joints(random) ? accelerations_change(m, mirrored(random)) : Complaint{};
}

Complaint order_shows(const RandomMechanism& random, const Mechanism& m) {
  return accelerations_change(m, renumbered(random, random.seed));
}

/// A run of `steps` steps of h. Result: outputs before and after; none where the motion meets a singular position.
std::optional<std::array<GenericOutputs, 2>> run(const Compilation& compilation, GenericState state, int steps,
                                                 double h) {
  const cli::Engine engine = cli::make_generic_engine(compilation, cli::EngineChoice{});
  std::array<GenericOutputs, 2> results;
  const auto look = [&](GenericOutputs& outputs) {
    const cli::LoadedState loaded{state, std::vector<double>(state.z.size(), 0.0)};
    GenericDerivative derivative;
    return engine.accelerations(loaded, derivative).ok() && engine.outputs(loaded, derivative, outputs).ok();
  };
  if (!look(results[0])) return {};
  for (int k = 0; k < steps; ++k)
    if (engine.step(state, h).code != Code::ok) return {};
  if (!look(results[1])) return {};
  return results;
}

/// J, with that of the springs, whose lengths are the outputs after the velocities of the bodies.
double energy_of(const RandomMechanism& random, const GenericOutputs& outputs) {
  double energy = outputs.kinetic_energy + outputs.potential_energy;
  std::size_t length = 3 * random.bodies.size();
  for (const RandomLink& link : random.links) {
    if (link.stiffness == 0) continue;
    const double stretch = outputs.y[length++] - kFreeLength;
    energy += 0.5 * link.stiffness * stretch * stretch;
  }
  return energy;
}

/// What changes in 0.02 s, by 20 steps and by 40: no more than the integrator's error, which falls with the fourth
/// power of the step. change: of two ends of a run, 0 for none.
Complaint drifts(const Mechanism& m, const std::string& what,
                 const std::function<double(const GenericOutputs&, const GenericOutputs&)>& change) {
  const Compilation compilation{m.model, m.topology, m.analysis, {}};
  for (const GenericState& state : good_states(m, 1)) {
    const auto after = [&](int steps) {
      const auto ends = run(compilation, state, steps, 0.02 / steps);
      return ends ? change((*ends)[0], (*ends)[1]) : 0.0;
    };
    const double coarse = after(20), fine = after(40);
    if (fine > 1e-10 && fine > coarse / 8)
      return what + " drifts by " + std::to_string(fine * 1e9) + "e-9, by twice the step " +
             std::to_string(coarse * 1e9) + "e-9";
  }
  return {};
}

/// Nothing dissipates.
Complaint energy_drifts(const RandomMechanism& random, const Mechanism& m) {
  return drifts(m, "energy", [&](const GenericOutputs& start, const GenericOutputs& end) {
    return std::abs(energy_of(random, end) - energy_of(random, start)) / (1 + start.kinetic_energy);
  });
}

/// Nothing touches the ground.
Complaint momentum_drifts(const RandomMechanism& random, const Mechanism& m) {
  const bool is_free = std::ranges::all_of(random.joints, [](const RandomJoint& joint) {
    return (joint.from != kOnGround && joint.to != kOnGround) || joint.type == "free";
  });
  if (!is_free || random.gravity != Point{}) return {};
  return drifts(m, "momentum", [&](const GenericOutputs& start, const GenericOutputs& end) {
    double largest_change = 0, size = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double change = 0;
      for (std::size_t b = 0; b < random.bodies.size(); ++b) {
        change += random.bodies[b].mass * (end.y[3 * b + axis] - start.y[3 * b + axis]);
        size += random.bodies[b].mass * std::abs(start.y[3 * b + axis]);
      }
      largest_change = std::max(largest_change, std::abs(change));
    }
    return largest_change / size;
  });
}

/// The file written another way is the same model.
Complaint format_shows(const RandomMechanism& random, const Mechanism& m) {
  const std::string other = nlohmann::ordered_json::parse(model_text(random)).dump();
  const Result<Model> again = read_model(other, "random.json");
  if (!again) return "refused: " + to_text(again.problems());
  const auto content = [](const Model& model) {
    const std::string text = cli::dump_model(model);
    return text.substr(text.find('\n'));  // the first line has the hash of the text
  };
  if (content(*again) != content(m.model)) return "it is another model";
  return {};
}

/// Two compilations write the same bytes.
Complaint bytes_change(const RandomMechanism&, const Mechanism& m) {
  if (m.topology.size() > 12) return {};
  const std::vector<EmittedFile> first = emit(compiled(m)), second = emit(compiled(m));
  for (std::size_t f = 0; f < first.size(); ++f)
    if (first[f].text != second[f].text) return first[f].path + " differs";
  return {};
}

struct Property {
  const char* name;
  Complaint (*violated)(const RandomMechanism&, const Mechanism&);
};

constexpr Property kProperties[] = {
    {"engines agree", engines_disagree},
    {"the compiled solver agrees", compiled_solver_disagrees},
    {"translation changes nothing", translation_shows},
    {"rotation changes nothing", rotation_shows},
    {"a mirror changes nothing", mirror_shows},
    {"order changes nothing", order_shows},
    {"energy is conserved", energy_drifts},
    {"momentum is conserved", momentum_drifts},
    {"the file's format does not matter", format_shows},
    {"the same bytes twice", bytes_change},
};

/// What the property says of a mechanism; nothing of one that is refused.
Complaint complaint(const Property& property, const RandomMechanism& random) {
  const Result<Mechanism> m = understood(random);
  return m ? property.violated(random, *m) : Complaint{};
}

RandomMechanism shrunk(const Property& property, RandomMechanism random) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (RandomMechanism& candidate : simpler(random)) {
      if (!complaint(property, candidate)) continue;
      random = std::move(candidate);
      smaller = true;
      break;
    }
  }
  return random;
}

class EveryFamily : public ::testing::TestWithParam<int> {};

TEST_P(EveryFamily, HasTheProperties) {
  const int cases = from_environment("MBGEN_PROPERTY_CASES", 12), first = from_environment("MBGEN_PROPERTY_SEED", 1);
  Tally tally;
  for (int seed = first; seed < first + cases; ++seed) {
    const RandomMechanism random = random_mechanism(static_cast<Family>(GetParam()), seed);
    const Result<Mechanism> m = understood(random);
    ++tally.mechanisms;
    if (!m) {
      ++tally.refused;
      ASSERT_FALSE(m.problems().empty());
      std::printf("refused: %s", to_text(m.problems()).c_str());
      continue;
    }
    tally.states += static_cast<long>(good_states(*m, 2).size());
    for (const Property& property : kProperties) {
      const Complaint first_complaint = property.violated(random, *m);
      if (!first_complaint) continue;
      const RandomMechanism small = shrunk(property, random);
      ADD_FAILURE() << property.name << ", seed " << seed << ": " << *first_complaint
                    << "\nshrunk: " << *complaint(property, small) << "\n"
                    << model_text(small);
      return;
    }
  }
  std::printf("%ld mechanisms, %ld refused, %ld states, %zu properties\n", tally.mechanisms, tally.refused,
              tally.states, std::size(kProperties));
  EXPECT_GT(tally.states, tally.mechanisms / 2) << "too few states were compared";
}

std::string family_name(const ::testing::TestParamInfo<int>& info) {
  static constexpr const char* kNames[] = {"tree", "deep_chain",     "closed_chain", "planar_loops",
                                           "rods", "massless_links", "floating",     "tiny"};
  return kNames[info.param];
}

/// Well-posed whatever is locked or overconstrained: none is refused, and two Cartesian judges say the same.
TEST(Locked, IsAcceptedAndEqualToTheCartesianJudges) {
  const int cases = from_environment("MBGEN_PROPERTY_CASES", 12), first = from_environment("MBGEN_PROPERTY_SEED", 1);
  int states = 0;
  for (int seed = first; seed < first + cases; ++seed) {
    const RandomMechanism random = random_mechanism(Family::locked, seed);
    const Result<Mechanism> m = understood(random);
    EXPECT_TRUE(m) << "seed " << seed << ": " << to_text(m ? Diagnostics{} : m.problems());
    if (!m) continue;
    const GenericSolver generic(m->model, m->topology, m->analysis);
    for (const GenericState& state : good_states(*m, 2)) {
      ++states;
      const std::vector<double> tau = random_tau(*m, 3);
      GenericDerivative expected, actual;
      ASSERT_TRUE(generic.accelerations(state, tau, expected).ok()) << seed;
      for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::null_space}) {
        const CartesianSolver judge(m->model, m->topology, method, Stabilisation::projection);
        ASSERT_TRUE(judge.accelerations(state, tau, actual).ok()) << seed;
        EXPECT_FALSE(differ("judge", actual.zdd, expected.zdd, kTolerance)) << seed;
      }
    }
  }
  EXPECT_GT(states, cases);
}

/// Linkages at a place where two of their ways meet, and structures with singular values down to 3e-5.
TEST(Locked, OnesOfOtherSeedsThatWereRefusedAreAccepted) {
  for (const int seed : {297, 1057, 1069, 1145, 1269, 1279, 1324, 1354, 1355}) {
    const Result<Mechanism> m = understood(random_mechanism(Family::locked, seed));
    EXPECT_TRUE(m) << "seed " << seed << ": " << to_text(m ? Diagnostics{} : m.problems());
  }
}

/// Joints whose axes share a direction, as many as there are of one.
int most_parallel(const Model& model) {
  int most = 0;
  for (const Joint& a : model.joints) {
    const auto is_parallel = [&](const Joint& b) {
      return std::abs(a.axis[0] * b.axis[0] + a.axis[1] * b.axis[1] + a.axis[2] * b.axis[2]) > 1 - 1e-9;
    };
    most = std::max(most, static_cast<int>(std::count_if(model.joints.begin(), model.joints.end(), is_parallel)));
  }
  return most;
}

/// However its links are made, a line-symmetric chain of six pins moves on the branch of its reference.
TEST(Bricard, EveryLineSymmetricOneHasOneFreedom) {
  for (int seed = 1; seed <= 40; ++seed) {
    const RandomMechanism random = random_bricard(seed);
    const Result<Mechanism> m = understood(random);
    ASSERT_TRUE(m) << "seed " << seed << ": " << to_text(m.problems()) << model_text(random);
    EXPECT_EQ(m->analysis.degrees_of_freedom, 1) << seed;
    EXPECT_EQ(m->analysis.blocks[0].redundant_equations.size(), 1u) << seed;
    // Four parallel pins may be a flat four-bar, which the other two only carry.
    if (most_parallel(m->model) < 4) {
      EXPECT_TRUE(m->analysis.blocks[0].certificate.immobile.empty()) << seed;
    }
    EXPECT_GE(m->analysis.blocks[0].certificate.steps, 10) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Random, EveryFamily, ::testing::Range(0, kFamilies), family_name);

}  // namespace
}  // namespace mbgen::testing
