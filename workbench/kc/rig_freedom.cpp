#include "workbench/kc/rig_freedom.hpp"

#include <fmt/format.h>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/choice_at.hpp"
#include "compiler/analysis/configuration.hpp"
#include "runtime/generic/maggi.hpp"

namespace mbgen::kc {
namespace {

/// Motion of the pads of a rig without drives along its free directions at the start: pads x directions.
Eigen::MatrixXd pads_along_freedoms(const Rig& rig) {
  const Compilation& c = rig.compilation;
  const std::optional<Analysis> here = chosen_at(c.model, c.topology, c.analysis, rig.start.z);
  const Analysis& analysis = here ? *here : c.analysis;
  NumericSystem numbers(c.model, c.topology);
  System<double>& system = numbers.at(rig.start.z);
  const Eigen::MatrixXd all =
      dense_rz(c.topology, frozen_directions(system, kinematics(system), analysis.blocks, analysis.driven));
  std::vector<Eigen::Index> pads;
  for (std::size_t i = 0; i < c.topology.bodies.size(); ++i) {
    const std::string& name = c.topology.bodies[i].coordinate;
    if (name == "rig left" || name == "rig right") pads.push_back(static_cast<Eigen::Index>(i));
  }
  return all(pads, Eigen::all);
}

}  // namespace

std::optional<Diagnostic> ride_fault(const Compilation& user, const Axle& axle, const OperatingPoint& at) {
  constexpr double kMoves = 1e-9;  // of the strongest, or m for 1 m or 1 rad of a free direction
  Pads pads_of_axle{.hanging = {}, .are_driven = false};
  for (std::size_t i = 0; i < user.model.tyres.size(); ++i) pads_of_axle.hanging.insert(static_cast<int>(i));
  const Result<Rig> rig = make_rig(user, axle, at, pads_of_axle);
  if (!rig) return {};
  const Eigen::MatrixXd pads = pads_along_freedoms(*rig);
  const std::string& body = user.model.bodies[static_cast<std::size_t>(axle.body)].name;
  const bool is_still = pads.size() == 0 || pads.cwiseAbs().maxCoeff() < kMoves;
  if (is_still) {
    return problem_of(user.model, axle,
                      fmt::format("its wheels cannot travel: nothing lets them go up and down on \"{}\"", body),
                      "a rig needs joints or rubber that let them; rods and joints that hold one motion twice lock it");
  }
  const Eigen::VectorXd strength = singular_values(pads);
  if (pads.rows() < 2 || (strength.size() == 2 && strength[1] > kMoves * strength[0])) return {};
  return problem_of(user.model, axle, "its wheels go up and down only together, and the rig lifts them one by one",
                    "describe the axle by one of its wheels: the other one is its mirror then");
}

}  // namespace mbgen::kc
