// Derivatives of accelerations and of motions by masses, stiffnesses, gravity, lengths of force elements and places of
// joints, as the solver with derivatives has them, against a complex step of a judge of its own (complex_judge.hpp).

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "compiler/compile.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/system/property/complex_judge.hpp"
#include "tests/system/property/properties.hpp"
#include "workbench/sensitivity/tangent_engine.hpp"

namespace mbgen::testing::complex_step {
namespace {

/// Whether the judge knows all that the mechanism has.
bool is_plain(const RandomMechanism& random) {
  const auto is_known = [](const RandomJoint& joint) {
    return (joint.type == "revolute" || joint.type == "spherical" || (joint.type == "prismatic" && !joint.cut)) &&
           joint.swing == 0;
  };
  const auto is_massless = [](const RandomLink& link) { return link.mass == 0; };
  return !is_driven(random) && random.bushings.empty() && random.relations.empty() && !random.bodies.empty() &&
         random.bodies[0].mass > 0 && std::ranges::all_of(random.joints, is_known) &&
         std::ranges::all_of(random.links, is_massless);
}

/// The model with tunable gravity, mass of body 0, stiffness of link 0 where this is a spring, its start, and the place
/// of the last joint on both bodies, these two along x.
std::string varied_text(const RandomMechanism& random) {
  nlohmann::ordered_json model = nlohmann::ordered_json::parse(model_text(random));
  const auto tunable = [&](const char* name, double value) {
    model["parameters"][name] = {{"value", value}, {"tunable", true}};
  };
  const auto place = [&](int body, const std::string& point, const char* name) {
    const std::string owner = body == kOnGround ? "ground" : random.bodies[static_cast<std::size_t>(body)].name;
    model["bodies"][owner]["points"][point][0] = name;
  };
  tunable("gravity", 1);
  tunable("mass", random.bodies[0].mass);
  for (int i = 0; i < 3; ++i) model["gravity"][i] = nlohmann::json(random.gravity[i]).dump() + "*gravity";
  model["bodies"][random.bodies[0].name]["mass"] = "mass";
  if (!random.links.empty()) {
    const RandomLink& link = random.links[0];
    tunable("hook", link.start[0]);
    place(link.from, link.name + "_from", "hook");
    if (link.stiffness > 0) {
      tunable("stiffness", link.stiffness);
      model["springs"][link.name]["stiffness"] = "stiffness";
    }
  }
  const RandomJoint& joint = random.joints.back();
  tunable("pin", joint.at[0]);
  place(joint.from, joint.name + "_from", "pin");
  place(joint.to, joint.name + "_to", "pin");
  model.erase("outputs");
  return model.dump();
}

/// The numbers of the mechanism, one of them with a step.
Varied varied_by(const RandomMechanism& random, const std::string& name) {
  Varied varied{1.0, random.bodies[0].mass, random.links.empty() ? 0 : random.links[0].stiffness};
  const std::map<std::string, Number*> places{{"gravity", &varied.gravity},
                                              {"mass", &varied.mass},
                                              {"stiffness", &varied.stiffness},
                                              {"hook", &varied.hook},
                                              {"pin", &varied.pin}};
  *places.at(name) += Number(0, kStep);
  return varied;
}

Numbers complex_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).cast<Number>();
}

double largest_part(const Numbers& numbers, bool imaginary) {
  double largest = 0;
  for (const Number& one : numbers)
    largest = std::max(largest, imaginary ? std::abs(one.imag()) / kStep : std::abs(one.real()));
  return largest;
}

/// Of derivatives: a part of the largest, or the rounding of the values where they are none.
double tolerance_of(const Numbers& numbers, double part) {
  return part * largest_part(numbers, true) + 1e-13 * largest_part(numbers, false);
}

using Values = std::map<Slot, double>;

/// Outputs of a program and their derivatives; inputs and their derivatives are in `given`.
Values apart_at(const Program& program, Values given) {
  const auto all = [](const Slot&) { return true; };
  const DerivativesApart apart = take_derivatives_apart(program, all, all);
  const auto outputs = [&](const Program& one) {
    std::vector<double> inputs;
    for (const Slot& slot : one.inputs) inputs.push_back(given[slot]);
    const std::vector<double> values = interpret(one, inputs);
    for (std::size_t i = 0; i < values.size(); ++i) given[one.outputs[i].slot] = values[i];
  };
  outputs(apart.values);
  outputs(apart.along);
  return given;
}

/// A state with the derivatives by parameter p that it has where its loops remain closed.
Values given_at(const Model& model, std::size_t p, const Numbers& z, const Numbers& zd,
                const std::vector<double>& tau) {
  Values given;
  for (int i = 0; i < z.size(); ++i) {
    for (const auto& [array, numbers] : {std::pair{Array::z, &z}, {Array::zd, &zd}}) {
      given[{array, i}] = (*numbers)[i].real();
      given[{derivative_of(array), i}] = (*numbers)[i].imag() / kStep;
    }
    given[{Array::tau, i}] = tau[static_cast<std::size_t>(i)];
  }
  for (std::size_t q = 0; q < model.parameters.size(); ++q)
    given[{Array::par, static_cast<int>(q)}] = model.parameters[q].value;
  given[{derivative_of(Array::par), static_cast<int>(p)}] = 1;
  return given;
}

void expect_derivatives_of_a_complex_step(const RandomMechanism& random, const Compilation& c,
                                          std::map<std::string, int>& compared) {
  const Mechanism m{c.model, c.topology, c.analysis};
  const Program& accelerations = c.emitted.in_pairs ? c.emitted.in_pairs->program : c.emitted.programs.accelerations;
  for (const GenericState& state : good_states(m, 1)) {
    const std::vector<double> tau = random_tau(m, 3);
    for (std::size_t p = 0; p < c.model.parameters.size(); ++p) {
      const std::string& name = c.model.parameters[p].name;
      ComplexJudge judge(random, c.topology, varied_by(random, name));
      Numbers z = complex_of(state.z), zd = complex_of(state.zd);
      judge.close(z, zd);
      const Numbers zdd = judge.accelerations(z, zd, tau);
      Values given = given_at(c.model, p, z, zd, tau);
      given = apart_at(accelerations, apart_at(c.emitted.programs.derived_constants, given));
      const double largest_value = largest_part(zdd, false);
      for (int i = 0; i < zdd.size(); ++i) {
        EXPECT_NEAR((given[{Array::zdd, i}]), zdd[i].real(), 1e-8 * largest_value) << random.seed << " " << name;
        EXPECT_NEAR((given[{derivative_of(Array::zdd), i}]), zdd[i].imag() / kStep, tolerance_of(zdd, 1e-8))
            << random.seed << " " << name << " " << c.topology.bodies[static_cast<std::size_t>(i)].coordinate;
      }
      compared[name] += largest_part(zdd, true) > 0 ? 1 : 0;
    }
  }
}

/// The mechanism as it is compiled, none where that is refused.
std::optional<Compilation> compiled(const RandomMechanism& random) {
  Result<Model> model = read_model(varied_text(random), "varied.json");
  EXPECT_TRUE(model) << random.seed << "\n" << to_text(model.problems());
  if (!model) return {};
  Result<Compilation> c = compile(std::move(*model));
  if (!c) return {};
  return std::move(*c);
}

/// Calls with the plain mechanisms of each family, up to `seeds`. Result: how many there are.
template <class Use>
int each_mechanism(std::initializer_list<Family> families, int seeds, const Use& use) {
  int count = 0;
  for (const Family family : families)
    for (int seed = 1; seed <= seeds; ++seed) {
      const RandomMechanism random = random_mechanism(family, seed);
      if (!is_plain(random) || !understood(random)) continue;
      ++count;
      if (const std::optional<Compilation> c = compiled(random)) use(random, *c);
    }
  return count;
}

/// MBGEN_PROPERTY_CASES: seeds of each family, 4 by default.
TEST(ComplexStep, EqualsDerivativesOfRandomMechanisms) {
  const int cases = from_environment("MBGEN_PROPERTY_CASES", 4);
  std::map<std::string, int> compared;
  const int mechanisms =
      each_mechanism({Family::tree, Family::closed_chain, Family::planar_loops, Family::rods, Family::massless_links,
                      Family::mirror_halves, Family::equal_legs, Family::equal_cells},
                     3 * cases, [&](const RandomMechanism& random, const Compilation& c) {
                       expect_derivatives_of_a_complex_step(random, c, compared);
                     });
  std::printf("%d mechanisms\n", mechanisms);
  EXPECT_GE(mechanisms, 7 * cases);
  for (const char* name : {"gravity", "mass", "hook", "pin"}) EXPECT_GE(compared[name], 2 * cases) << name;
  EXPECT_GE(compared["stiffness"], cases);
}

/// Steps of the solver with derivatives, compiled, against steps of the judge. Both close their loops after a step,
/// each in its own way: what the steps leave open is of their order.
void expect_motion_of_a_complex_step(const RandomMechanism& random, const Compilation& c, int& compared) {
  constexpr double kLength = 5e-4;  // s
  std::vector<std::string> names;
  for (const Parameter& parameter : c.model.parameters) names.push_back(parameter.name);
  const TangentEngine engine = make_tangent_engine(c, {}, names);
  for (const GenericState& start : good_states({c.model, c.topology, c.analysis}, 1)) {
    std::vector<Numbers> z(names.size(), complex_of(start.z)), zd(names.size(), complex_of(start.zd));
    std::vector<TangentNumber>& numbers = engine.memory->passes[0].after;
    for (std::size_t p = 0; p < names.size(); ++p)
      ComplexJudge(random, c.topology, varied_by(random, names[p])).close(z[p], zd[p]);
    GenericState state = start;
    const std::size_t n = start.z.size();
    const auto number = [&](std::size_t p, std::size_t i) {
      return i < n ? z[p][static_cast<Eigen::Index>(i)] : zd[p][static_cast<Eigen::Index>(i - n)];
    };
    for (std::size_t i = 0; i < 2 * n; ++i) {
      numbers[i] = number(0, i).real();
      (i < n ? state.z[i] : state.zd[i - n]) = numbers[i].value;
      for (std::size_t p = 0; p < names.size(); ++p) numbers[i].tangent[p] = number(p, i).imag() / kStep;
    }
    numbers[2 * n + start.x.size()] = state.t;
    for (int k = 0; k < 20; ++k) ASSERT_TRUE(engine.engine.step(state, kLength).ok());
    for (std::size_t p = 0; p < names.size(); ++p) {
      ComplexJudge judge(random, c.topology, varied_by(random, names[p]));
      for (int k = 0; k < 20; ++k) judge.step(z[p], zd[p], kLength);
      for (std::size_t i = 0; i < 2 * n; ++i)
        EXPECT_NEAR(numbers[i].tangent[p], number(p, i).imag() / kStep, tolerance_of(i < n ? z[p] : zd[p], 1e-7))
            << random.seed << " " << names[p] << " " << c.topology.bodies[i % n].coordinate;
      compared += largest_part(zd[p], true) > 0 ? 1 : 0;
    }
  }
}

/// MBGEN_PROPERTY_CASES: a quarter as many seeds of each family; a solver of each is compiled.
TEST(ComplexStep, EqualsDerivativesOfMotions) {
  const int seeds = from_environment("MBGEN_PROPERTY_CASES", 4) / 4;
  int compared = 0;
  const int mechanisms = each_mechanism({Family::closed_chain, Family::rods, Family::planar_loops}, seeds,
                                        [&](const RandomMechanism& random, const Compilation& c) {
                                          expect_motion_of_a_complex_step(random, c, compared);
                                        });
  EXPECT_GE(mechanisms, 2 * seeds);
  EXPECT_GE(compared, 3 * mechanisms);
}

}  // namespace
}  // namespace mbgen::testing::complex_step
