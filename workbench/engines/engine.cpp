#include "workbench/engines/engine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/holds.hpp"
#include "compiler/text/user_error.hpp"
#include "compiler/topology/poles.hpp"
#include "workbench/describe/names.hpp"

namespace mbgen {
namespace {

template <CartesianMethod method>
Engine make_judge(const Compilation& compilation, const EngineChoice& choice) {
  return make_cartesian_engine(compilation, choice, method);
}

enum class Coordinates { relative, cartesian };

struct Maker {
  const char* name;
  Coordinates coordinates;
  Engine (*make)(const Compilation&, const EngineChoice&);
};

constexpr Maker kMakers[] = {{"generated", Coordinates::relative, make_generated_engine},
                             {"generic", Coordinates::relative, make_generic_engine},
                             {"augmented", Coordinates::cartesian, make_judge<CartesianMethod::augmented>},
                             {"range-space", Coordinates::cartesian, make_judge<CartesianMethod::range_space>},
                             {"null-space", Coordinates::cartesian, make_judge<CartesianMethod::null_space>},
                             {"maggi", Coordinates::cartesian, make_judge<CartesianMethod::maggi>}};

/// Names of everything that a status may be about.
std::vector<std::string> names_of(const Compilation& compilation, Subject subject) {
  const Model& model = compilation.model;
  const Topology& topology = compilation.topology;
  std::vector<std::string> names;
  switch (subject) {
    case Subject::coordinate:
      return coordinate_names(topology);
    case Subject::loop_block:
      for (const LoopBlock& block : topology.blocks)
        names.push_back(fmt::format("{}", fmt::join(loop_names(topology, block), ", ")));
      return names;
    case Subject::input:
      for (const Input& input : model.inputs) names.push_back(input.name);
      return names;
    case Subject::parameter:
      for (const Parameter& parameter : model.parameters)
        if (parameter.tunable) names.push_back(parameter.name);
      return names;
    case Subject::auxiliary_state:
      return auxiliary_state_names(model);
    case Subject::hold:
      return hold_names(model);
    case Subject::free_direction:
      return actuated_directions(model, topology, compilation.analysis);
  }
  return names;
}

/// A ball without inertia in a direction may have its angles at their pole: names the joint, and why it has no other
/// angles. "" for other directions.
std::string pole_text(const Compilation& compilation, Status status) {
  if (status.code != Code::no_inertia) return "";
  const TreeBody& body = compilation.topology.bodies[status.index];
  const Joint& joint = compilation.model.joints[body.joint];
  if (!is_ball(joint.type)) return "";
  const std::string pole = fmt::format(", the angles of joint {} may be at their pole", joint.name);
  for (const RealPole& real : real_poles(compilation.model, compilation.topology))
    if (real.joint == body.joint)
      return pole + fmt::format(": {} is on {}, so that no others can be taken", real.user, real.coordinate);
  return pole + ", where they have no accelerations";
}

/// A universal joint that is bent by a right angle turns nothing: the one singular position that a joint itself has.
/// Names those of a block that is singular; "" for other statuses and blocks.
std::string universal_text(const Compilation& compilation, Status status) {
  if (status.code != Code::loop_singular && status.code != Code::singular_met) return "";
  const Topology& topology = compilation.topology;
  const LoopBlock& block = topology.blocks[static_cast<std::size_t>(status.index)];
  std::vector<int> joints;
  for (const int j : block.joints) joints.push_back(topology.bodies[static_cast<std::size_t>(j)].joint);
  for (const int l : block.loops) joints.push_back(topology.loops[static_cast<std::size_t>(l)].joint);
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  std::vector<std::string> names;
  for (const int j : joints)
    if (j >= 0 && compilation.model.joints[static_cast<std::size_t>(j)].type == JointType::universal)
      names.push_back(compilation.model.joints[static_cast<std::size_t>(j)].name);
  if (names.empty()) return "";
  return fmt::format(", universal joint{} {} may be bent by a right angle, where {} turn{} nothing",
                     names.size() == 1 ? "" : "s", fmt::join(names, ", "), names.size() == 1 ? "it" : "they",
                     names.size() == 1 ? "s" : "");
}

}  // namespace

const std::vector<std::string>& engine_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Maker& maker : kMakers) all.push_back(maker.name);
    return all;
  }();
  return names;
}

bool is_cartesian(const std::string& name) {
  const auto named = [&](const Maker& maker) { return maker.name == name; };
  const auto maker = std::find_if(std::begin(kMakers), std::end(kMakers), named);
  return maker != std::end(kMakers) && maker->coordinates == Coordinates::cartesian;
}

void require_engine(const std::string& name) {
  if (std::ranges::find(engine_names(), name) == engine_names().end())
    throw UserError(fmt::format("--engine: no engine \"{}\"; there are: {}\n", name, fmt::join(engine_names(), ", ")));
}

Engine make_engine(const Compilation& compilation, const EngineChoice& choice) {
  require_engine(choice.name);
  return std::ranges::find(kMakers, choice.name, &Maker::name)->make(compilation, choice);
}

std::string describe(const Compilation& compilation, Status status) {
  const std::vector<std::string> names = names_of(compilation, subject_of(status.code));
  const bool is_named = status.index >= 0 && status.index < static_cast<int>(names.size());
  if (!is_named) return text(status.code);
  return fmt::format("{}: {}{}{}", text(status.code), names[status.index], pole_text(compilation, status),
                     universal_text(compilation, status));
}

}  // namespace mbgen
