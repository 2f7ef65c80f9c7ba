// Properties of every mechanism, on random ones. A failure shrinks to a small model file, which is printed.
// MBGEN_PROPERTY_CASES: mechanisms of each family, 4 by default; MBGEN_PROPERTY_SEED: the first seed;
// MBGEN_PROPERTY_COMPILED: the solver of every so many is compiled, 4 by default.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/symmetry.hpp"
#include "tests/system/property/properties.hpp"

namespace mbgen::testing {
namespace {

/// States and comparisons that the run made, to be seen in its log.
struct Tally {
  long mechanisms = 0, refused = 0, states = 0;
};

/// Violation of the property by a mechanism; none where the mechanism is refused.
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

struct NamedFamily {
  Family family;
  const char* name;
};

void PrintTo(const NamedFamily& family, std::ostream* out) { *out << family.name; }

/// Of EveryFamily; locked has a test of its own.
constexpr NamedFamily kFamilies[] = {
    {Family::tree, "tree"},
    {Family::deep_chain, "deep_chain"},
    {Family::closed_chain, "closed_chain"},
    {Family::by_equations, "by_equations"},
    {Family::rolling, "rolling"},
    {Family::guided_rolling, "guided_rolling"},
    {Family::planar_loops, "planar_loops"},
    {Family::rods, "rods"},
    {Family::actuators, "actuators"},
    {Family::massless_links, "massless_links"},
    {Family::floating, "floating"},
    {Family::coupled, "coupled"},
    {Family::coupled_joints, "coupled_joints"},
    {Family::driven_cuts, "driven_cuts"},
    {Family::tiny, "tiny"},
    {Family::mirror_halves, "mirror_halves"},
    {Family::nearly_mirror_halves, "nearly_mirror_halves"},
    {Family::equal_legs, "equal_legs"},
    {Family::equal_cells, "equal_cells"},
    {Family::alike_cells, "alike_cells"},
};

class EveryFamily : public ::testing::TestWithParam<NamedFamily> {};

TEST_P(EveryFamily, HasTheProperties) {
  const int cases = from_environment("MBGEN_PROPERTY_CASES", 4), first = from_environment("MBGEN_PROPERTY_SEED", 1);
  Tally tally;
  for (int seed = first; seed < first + cases; ++seed) {
    const RandomMechanism random = random_mechanism(GetParam().family, seed);
    const Result<Mechanism> m = understood(random);
    ++tally.mechanisms;
    if (!m) {
      ++tally.refused;
      ASSERT_FALSE(m.problems().empty());
      std::printf("refused: %s", to_text(m.problems()).c_str());
      continue;
    }
    tally.states += static_cast<long>(good_states(*m, 2).size());
    for (const Property& property : properties()) {
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
              tally.states, properties().size());
  EXPECT_GT(tally.states, tally.mechanisms / 2) << "too few states were compared";
}

/// Well-posed whatever is locked or overconstrained: none is refused, and two Cartesian judges say the same.
TEST(Locked, IsAcceptedAndEqualToTheCartesianJudges) {
  const int cases = from_environment("MBGEN_PROPERTY_CASES", 4), first = from_environment("MBGEN_PROPERTY_SEED", 1);
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

/// Two bodies, one on the other, that rods hold in place on a body that moves: their inertia is carried along.
TEST(Locked, InertiaOfABlockWithoutFreedomIsCarriedAlong) {
  const RandomMechanism random = random_mechanism(Family::actuators, 112);
  const Result<Mechanism> m = understood(random);
  ASSERT_TRUE(m);
  EXPECT_GT(m->analysis.degrees_of_freedom, 0);
  const Complaint engines = properties()[0].violated(random, *m);
  EXPECT_FALSE(engines) << *engines;
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

/// Tree bodies whose numbers are not those of their mirror image; all of them where the plane y = 0 is not seen.
std::vector<std::string> unlike_their_images(const RandomMechanism& random) {
  const Result<Mechanism> m = understood(random);
  EXPECT_TRUE(m) << to_text(m ? Diagnostics{} : m.problems()) << model_text(random);
  std::vector<std::string> result;
  if (!m) return result;
  const Mirror mirror = find_mirror(m->topology, NumericSystem(m->model, m->topology).constants());
  for (int i = 0; i < m->topology.size(); ++i)
    if (std::abs(mirror.normal[1]) < 1 - 1e-9 || mirror.image[i] < 0 || !mirror.equal[i])
      result.push_back(m->topology.bodies[i].name);
  return result;
}

TEST(Symmetry, EveryMirrorImageIsSeenAndSoIsOneOtherNumber) {
  for (int seed = 1; seed <= 40; ++seed) {
    const RandomMechanism halves = random_mechanism(Family::mirror_halves, seed);
    EXPECT_EQ(unlike_their_images(halves), std::vector<std::string>{}) << model_text(halves);
    const RandomMechanism other = random_mechanism(Family::nearly_mirror_halves, seed);
    EXPECT_EQ(unlike_their_images(other).size(), 2u) << model_text(other);
  }
}

INSTANTIATE_TEST_SUITE_P(Random, EveryFamily, ::testing::ValuesIn(kFamilies),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace mbgen::testing
