#include "bench/compare/contestants.hpp"

#include <fmt/format.h>

#include <exception>
#include <memory>

#include "bench/foreign/straightforward_maggi.hpp"
#include "compiler/text/user_error.hpp"
#include "tests/system/oracle/mujoco_mechanism.hpp"
#include "tests/system/oracle/simbody_mechanism.hpp"

namespace mbgen::compare {
namespace {

using namespace foreign;

ForeignState foreign_state(const LoadedState& at) { return {at.state.z, at.state.zd, at.tau}; }

/// An engine around a mechanism with accelerations, load and run.
template <class Mechanism>
Engine engine_of(std::shared_ptr<Mechanism> mechanism) {
  Engine engine;
  engine.accelerations = [mechanism](const LoadedState& at, GenericDerivative& derivative) {
    derivative.zdd = mechanism->accelerations(foreign_state(at));
    return Status{};
  };
  engine.time_accelerations = [mechanism](const std::vector<LoadedState>& at, int repetitions) {
    if (repetitions == 0) {
      std::vector<ForeignState> states;
      for (const LoadedState& one : at) states.push_back(foreign_state(one));
      mechanism->load(states);
    }
    mechanism->run(repetitions);
    return 0LL;
  };
  return engine;
}

/// Gives a contestant its engine, or says why there is none.
template <class Mechanism, class... Arguments>
void take_part(Contestant& contestant, const Arguments&... arguments) {
  try {
    contestant.engine = engine_of(std::make_shared<Mechanism>(arguments...));
  } catch (const std::exception& problem) {
    contestant.absent = problem.what();
  }
}

/// All loops as one block over all coordinates: Phi_z as the paper factors it.
Topology in_one_block(Topology topology) {
  LoopBlock all;
  for (const LoopBlock& block : topology.blocks) {
    all.loops.insert(all.loops.end(), block.loops.begin(), block.loops.end());
    all.equations += block.equations;
  }
  for (int i = 0; i < topology.size(); ++i) all.joints.push_back(i);
  topology.blocks.clear();
  if (all.equations > 0) topology.blocks.push_back(all);
  return topology;
}

Contestant mbgen_engine(const Compilation& compilation, const std::string& engine, const std::string& name,
                        const std::string& remark, int lanes = 0) {
  EngineChoice choice;
  choice.name = engine;
  choice.lanes = lanes;
  return {engine, name, remark, "", true, make_engine(compilation, choice)};
}

/// The generated solver, and that of the other form of the equations where there is one.
void add_generated(const Compilation& compilation, std::vector<Contestant>& all) {
  const Form form = compilation.form();
  all.push_back(mbgen_engine(compilation, "generated", fmt::format("mbgen, generated, {}", name_of(form)), ""));
  all.push_back(mbgen_engine(compilation, "generated", "mbgen, generated, eight in lanes", "per instance", kLanes));
  all.back().key = "batch8";
  const Form rest = other_form(form);
  const Compilation other = expect(compile(compilation.model, {rest}));
  if (other.form() == form) return;
  all.push_back(mbgen_engine(other, "generated", fmt::format("mbgen, generated, {}", name_of(rest)),
                             "the form with more operations"));
  all.back().key = "other_form";
}

}  // namespace

std::vector<Contestant> contestants(const Compilation& compilation) {
  const ReferenceMechanism mechanism = reference_mechanism(compilation.model, compilation.topology);
  std::vector<Contestant> all;
  add_generated(compilation, all);
  all.push_back(mbgen_engine(compilation, "generic", "mbgen, generic", "flags of mbgen itself"));
  all.push_back(
      {"straightforward", "straightforward Maggi on Eigen", "full pivoting of the whole Phi_z", "", true, {}});
  take_part<StraightforwardMaggi>(all.back(), mechanism, in_one_block(compilation.topology));
  all.push_back({"straightforward_blocks", "the same, block by block", "full pivoting per loop block", "", true, {}});
  take_part<StraightforwardMaggi>(all.back(), mechanism, compilation.topology);
  all.push_back({"simbody",
                 fmt::format("Simbody {}", SimbodyMechanism::version()),
                 "Debian's package, built with assertions",
                 "",
                 true,
                 {}});
  take_part<SimbodyMechanism>(all.back(), mechanism);
  all.push_back({"mujoco",
                 fmt::format("MuJoCo {}", MujocoMechanism::version()),
                 "Debian's package, no AVX; constraints are soft",
                 "",
                 compilation.topology.loops.empty(),
                 {}});
  take_part<MujocoMechanism>(all.back(), mechanism);
  return all;
}

}  // namespace mbgen::compare
