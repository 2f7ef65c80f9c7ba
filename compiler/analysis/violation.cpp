#include "compiler/analysis/violation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "compiler/analysis/misalignment.hpp"

namespace mbgen {
namespace {

constexpr double kDegree = 0.017453292519943295;  // rad

std::string motion_text(const Topology& topology, const Violation& violation, const ClosureEquation& equation) {
  const TreeBody& body = topology.bodies[violation.coordinate];
  return fmt::format("moving {} by {:.2g} {} opens {} ({}) by {:.3g}{}", body.coordinate, violation.motion,
                     unit_of(body.kind), equation.name, equation.meaning, violation.residual,
                     equation.unit == ResidualUnit::metre ? " m" : "");
}

std::string advice(const Model& model, const std::optional<Misalignment>& off, bool second_order) {
  const std::string rest = "; a rigid connection takes fixed joints";
  if (!off && second_order)
    return "a mechanism in this position bears no load: move a point or change a length, so that the equations hinder "
           "every motion "
           "or "
           "none" +
           rest;
  if (!off) return "make the points and axes of the joints agree, or use joints with fewer equations" + rest;
  const std::string& name = model.joints[off->joint].name;
  if (off->kind == FreedomKind::revolute)
    return fmt::format(
        "the axis of joint \"{}\" is {:.3g} deg off the direction that the other axes share; make it parallel, or use "
        "a "
        "spherical joint{}",
        name, off->angle / kDegree, rest);
  return fmt::format("joint \"{}\" slides {:.3g} deg out of the plane of the loop; turn it into the plane{}", name,
                     off->angle / kDegree, rest);
}

}  // namespace

void move(const LoopBlock& block, const PartView& view, const Eigen::VectorXd& direction, std::vector<double>& z) {
  for (std::size_t c = 0; c < view.part.columns.size(); ++c)
    z[block.joints[view.part.columns[c]]] += direction[c] * view.column_scale[c];
}

double distance(const LoopBlock& block, const PartView& view, const std::vector<double>& from,
                const std::vector<double>& to, int& coordinate) {
  double largest = -1;
  for (std::size_t c = 0; c < view.part.columns.size(); ++c) {
    const int j = block.joints[view.part.columns[c]];
    const double here = std::abs(to[j] - from[j]) / view.column_scale[c];
    if (here > largest) largest = here, coordinate = j;
  }
  return largest;
}

std::string loops_text(const Topology& topology, const std::vector<int>& loops) {
  std::vector<std::string> names;
  for (int l : loops) names.push_back(quoted(topology.loops[l].name));
  return fmt::format("loop{} {}", loops.size() > 1 ? "s" : "", fmt::join(names, ", "));
}

Diagnostic refusal(const Model& model, const Topology& topology, const std::vector<int>& loops,
                   const std::string& fault, const Violation& violation, const ClosureEquation& equation) {
  const std::optional<Misalignment> off = misaligned_joint(model, topology, loops);
  const Loop& opened = topology.loops[equation.loop];
  const Where& where = off ? model.joints[off->joint].where : where_of(model, opened);
  return {where,
          fault + ", and " + motion_text(topology, violation, equation),
          advice(model, off, violation.second_order),
          {}};
}

}  // namespace mbgen
