#include "compiler/analysis/shared_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/violation.hpp"
#include "compiler/formulation/reaction_loads.hpp"
#include "compiler/model/element_access.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRepeatedLoads = 1e-9;  // pivots of equations that repeat others, over the largest
constexpr double kTakesPart = 1e-7;      // of a self-stress whose multipliers have the length 1
constexpr std::size_t kMostOfAKind = 8;

/// Joints that are named, and what the model asks of them.
struct Undetermined {
  std::vector<std::string> joints;  ///< with their kind, quoted
  std::vector<std::string> outputs, frictions, sampled;

  bool is_empty() const { return outputs.empty() && frictions.empty() && sampled.empty(); }
};

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string listed(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kMostOfAKind);
  std::string text = names[0];
  for (std::size_t i = 1; i < shown; ++i) text += (i + 1 == names.size() ? " and " : ", ") + names[i];
  return names.size() > shown ? text + fmt::format(" and {} more", names.size() - shown) : text;
}

/// The mechanism at a closed position near its reference.
class StressScene {
 public:
  StressScene(const Model& model, const Topology& topology, const Analysis& analysis)
      : model_(model), topology_(topology), analysis_(analysis), numbers_(model, topology) {
    std::vector<std::vector<int>> kept;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
      kept.emplace_back();
      const std::vector<int>& redundant = analysis.blocks[b].redundant_equations;
      for (int row = 0; row < equations(b); ++row)
        if (std::find(redundant.begin(), redundant.end(), row) == redundant.end()) kept.back().push_back(row);
    }
    const auto size = static_cast<std::size_t>(topology.size());
    at_ = close_equations(numbers_, std::vector<double>(size, 0.0), kept);
  }

  int equations(std::size_t b) const {
    int count = 0;
    for (const int l : topology_.blocks[b].loops) count += topology_.loops[static_cast<std::size_t>(l)].equations;
    return count;
  }

  /// Self-stresses of a block, as columns: multipliers that no coordinate feels but driven ones. None where the block
  /// is not closed here, or has another rank than everywhere.
  MatrixXd self_stresses(std::size_t b) const {
    const LoopBlock& block = topology_.blocks[b];
    if (is_large(block) || !at_.closed[b]) return {};
    MatrixXd free = at_.blocks[b].jacobian;
    for (std::size_t c = 0; c < block.joints.size(); ++c)
      if (analysis_.driven[static_cast<std::size_t>(block.joints[c])]) free.col(static_cast<Eigen::Index>(c)).setZero();
    MatrixXd stresses = indifferent_directions(free.transpose(), kRepeatedLoads);
    return stresses.cols() == equations(b) - analysis_.blocks[b].rank ? stresses : MatrixXd();
  }

  /// Adds what a self-stress of a block changes.
  void look_at(std::size_t b, const VectorXd& stress, Undetermined& found) {
    System<double>& system = numbers_.at(at_.z);
    const Kinematics<double> k = kinematics(system);
    const auto size = static_cast<std::size_t>(topology_.size());
    const Velocities<double> still{std::vector<Spatial<double>>(size), std::vector<Spatial<double>>(size)};
    Accelerations<double> none;
    none.base.resize(size);
    none.own.resize(size);
    const AppliedForces<double> no_forces;
    const std::vector<double> zdd(size, 0.0);
    std::vector<std::vector<double>> multipliers;
    for (std::size_t other = 0; other < topology_.blocks.size(); ++other)
      multipliers.emplace_back(static_cast<std::size_t>(equations(other)), 0.0);
    multipliers[b].assign(stress.data(), stress.data() + stress.size());
    const VectorXd driving = at_.blocks[b].jacobian.transpose() * stress;
    std::vector<double> drives(model_.motions.size(), 0.0);
    for (std::size_t c = 0; c < topology_.blocks[b].joints.size(); ++c) {
      const auto coordinate = static_cast<std::size_t>(topology_.blocks[b].joints[c]);
      if (analysis_.driven[coordinate])
        drives[static_cast<std::size_t>(analysis_.motion_of[coordinate])] = driving[static_cast<Eigen::Index>(c)];
    }
    const SolvedState<double> s{k, still, none, no_forces, zdd, multipliers, drives};
    const Reactions<double> all = reactions(system, s);
    name_joints(all, found);
    for (const Output& output : model_.outputs)
      if (std::abs(value_of(system, s, all, output)) > kTakesPart) add_once(found.outputs, output.name);
    for (std::size_t i = 0; i < model_.sampled.size(); ++i) {
      const std::optional<ReactionLoad>& load = model_.sampled[i].load;
      if (load && detail::size_of(system, k, all, *load) > kTakesPart) name_load(static_cast<int>(i), found);
    }
  }

 private:
  /// Of an output that shows forces of closures, else 0.
  double value_of(const System<double>& system, const SolvedState<double>& s, const Reactions<double>& all,
                  const Output& output) const {
    if (const auto* reaction = std::get_if<ReactionOutput>(&output.source))
      return detail::reaction_output(system, s.kinematics, all, *reaction);
    if (const auto* multiplier = std::get_if<MultiplierOutput>(&output.source))
      return detail::multiplier_output(topology_, s, *multiplier);
    const auto* drive = std::get_if<DriveOutput>(&output.source);
    return drive == nullptr ? 0 : s.drive_forces[static_cast<std::size_t>(drive->motion)];
  }

  /// The frictions that a sampled reaction presses, or the value where the model sampled it.
  void name_load(int load, Undetermined& found) const {
    bool presses = false;
    each_friction(model_, [&](const auto& friction) {
      if (friction.load != load) return;
      presses = true;
      add_once(found.frictions, friction.name);
    });
    if (!presses) add_once(found.sampled, model_.sampled[static_cast<std::size_t>(load)].name);
  }

  void name_joints(const Reactions<double>& all, Undetermined& found) const {
    const auto takes_part = [](const Reaction<double>& reaction) {
      return std::sqrt(dot(reaction.on_to.linear, reaction.on_to.linear) +
                       dot(reaction.on_to.angular, reaction.on_to.angular)) > kTakesPart;
    };
    for (std::size_t j = 0; j < all.joints.size(); ++j)
      if (takes_part(all.joints[j])) add_once(found.joints, quoted(model_.joints[j].name));
    for (std::size_t r = 0; r < all.rods.size(); ++r)
      if (takes_part(all.rods[r])) add_once(found.joints, quoted(model_.rods[r].name));
  }

  const Model& model_;
  const Topology& topology_;
  const Analysis& analysis_;
  NumericSystem numbers_;
  Configuration at_;
};

constexpr const char* kSharedLoadHint =
    "where their reactions matter, let one of them hold less, or put a bushing in its place: then stiffness decides";

/// Two joints between the same two bodies. Result: whether the block has some.
bool add_hinges(const Model& model, const Topology& topology, std::size_t b, const Certificate& certificate,
                Diagnostics& notes) {
  bool has_some = false;
  for (const int l : topology.blocks[b].loops) {
    const Loop& loop = topology.loops[static_cast<std::size_t>(l)];
    if (loop.joint < 0 || loop.joints.empty() || is_rolling(loop.kind)) continue;
    const auto joint_of = [&](int j) { return topology.bodies[static_cast<std::size_t>(j)].joint; };
    const int beside = joint_of(loop.joints[0]);
    if (!std::all_of(loop.joints.begin(), loop.joints.end(), [&](int j) { return joint_of(j) == beside; })) continue;
    const auto repeated = std::count_if(certificate.redundant.begin(), certificate.redundant.end(),
                                        [&](const RedundantEquation& row) { return row.loop == l; });
    if (repeated == 0) continue;
    has_some = true;
    notes.push_back(
        {where_of(model, loop),
         fmt::format(
             "joints {} and {} connect the same bodies, and {} of {} equations of the latter repeat the former: "
             "how the two share the load follows from the choice of equations",
             quoted(model.joints[static_cast<std::size_t>(beside)].name), quoted(loop.name), repeated, loop.equations),
         kSharedLoadHint,
         {}});
  }
  return has_some;
}

/// Whether the model asks for something that a self-stress can change.
bool asks_for_loads(const Model& model) {
  const bool is_sampled = std::any_of(model.sampled.begin(), model.sampled.end(),
                                      [](const auto& sampled) { return sampled.load.has_value(); });
  const auto is_load = [](const Output& output) {
    return std::holds_alternative<ReactionOutput>(output.source) ||
           std::holds_alternative<MultiplierOutput>(output.source) ||
           std::holds_alternative<DriveOutput>(output.source);
  };
  return is_sampled || std::any_of(model.outputs.begin(), model.outputs.end(), is_load);
}

std::string asked_text(const Undetermined& found) {
  std::vector<std::string> parts;
  const auto add = [&](const char* kind, const std::vector<std::string>& names) {
    if (!names.empty()) parts.push_back(fmt::format("{}{} {}", kind, names.size() == 1 ? "" : "s", listed(names)));
  };
  add("output", found.outputs);
  add("friction", found.frictions);
  add("sampled value", found.sampled);
  return listed(parts);
}

}  // namespace

void add_shared_loads(const Model& model, const Topology& topology, const Analysis& analysis, Diagnostics& notes) {
  std::optional<StressScene> scene;
  const bool is_asked = asks_for_loads(model);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const BlockAnalysis& block = analysis.blocks[b];
    if (block.redundant_equations.empty()) continue;
    // A block of two hinges alone has been told of.
    if (add_hinges(model, topology, b, block.certificate, notes) && topology.blocks[b].loops.size() == 1) continue;
    if (!is_asked) continue;
    if (!scene) scene.emplace(model, topology, analysis);
    const MatrixXd stresses = scene->self_stresses(b);
    Undetermined found;
    for (Eigen::Index i = 0; i < stresses.cols(); ++i) scene->look_at(b, stresses.col(i), found);
    if (found.is_empty()) continue;
    const std::size_t repeated = block.redundant_equations.size();
    const std::string sharing =
        found.joints.empty() ? "how the load is divided" : "how " + listed(found.joints) + " share the load";
    notes.push_back({where_of(model, topology.loops[static_cast<std::size_t>(topology.blocks[b].loops[0])]),
                     fmt::format("{} equation{} of {} repeat{} others: {} follows from the choice of equations, and "
                                 "with it {}",
                                 repeated, repeated == 1 ? "" : "s", loops_text(topology, topology.blocks[b].loops),
                                 repeated == 1 ? "s" : "", sharing, asked_text(found)),
                     kSharedLoadHint,
                     {}});
  }
}

}  // namespace mbgen
