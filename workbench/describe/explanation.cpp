#include "workbench/describe/explanation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "compiler/analysis/symmetry.hpp"
#include "compiler/choose/counted_treatments.hpp"
#include "compiler/model/vectors.hpp"
#include "compiler/solver/titles.hpp"
#include "compiler/topology/poles.hpp"
#include "compiler/topology/twins.hpp"
#include "workbench/describe/explained_elements.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/describe/paragraphs.hpp"
#include "workbench/describe/vehicle_text.hpp"

namespace mbgen {
namespace {

constexpr int kBarWidth = 30;
/// Tolerance for parallel and perpendicular axes, rad.
constexpr double kParallel = 1e-9;

std::string overview_text(const Compilation& c) {
  const auto bodies = static_cast<long>(c.model.bodies.size()) - (c.model.ground >= 0 ? 1 : 0);
  std::string words = fmt::format(
      "{} is made of {}, {} and {}. mbgen describes where they are by {}", c.model.name,
      counted(bodies, "moving body", "moving bodies"), counted(static_cast<long>(c.model.joints.size()), "joint"),
      counted(static_cast<long>(c.model.rods.size()), "rod"), counted(c.topology.size(), "relative coordinate"));
  if (c.topology.loops.empty()) {
    words += ". There are no loops, so that every coordinate is a freedom of its own.";
  } else {
    words += fmt::format(
        " and closes {} by {}, {}: {} {}.", counted(static_cast<long>(c.topology.loops.size()), "loop"),
        counted(equation_count(c.topology), "equation"),
        c.analysis.independent_equations == equation_count(c.topology)
            ? "all independent"
            : fmt::format("of which {} are independent", c.analysis.independent_equations),
        counted(c.analysis.degrees_of_freedom, "freedom"), c.analysis.degrees_of_freedom == 1 ? "remains" : "remain");
    if (c.analysis.position_freedoms != c.analysis.degrees_of_freedom)
      words += fmt::format(
          " That is how many velocities are free; of positions there are {} freedoms, since {} of velocities alone: "
          "rolling and blades hold no position, and a motion may come back elsewhere.",
          c.analysis.position_freedoms,
          counted(c.analysis.position_freedoms - c.analysis.degrees_of_freedom, "equation is one", "equations are"));
  }
  if (!c.model.motions.empty()) {
    std::vector<std::string> names;
    for (const Motion& motion : c.model.motions) names.push_back(motion.name);
    words += fmt::format(" Of these {} driven: {}.", names.size() == 1 ? "one is" : fmt::format("{} are", names.size()),
                         listed(names));
  }
  return paragraph(words);
}

/// A body and its branch of the tree.
std::string branch_text(const Topology& topology, int i, int depth) {
  const TreeBody& body = topology.bodies[static_cast<std::size_t>(i)];
  std::string text = fmt::format("{:>{}}{}: {} by {}{}\n", "", 2 * depth, body.name,
                                 body.kind == FreedomKind::revolute ? "turns" : "slides", body.coordinate,
                                 body.massless ? ", no mass" : "");
  for (const int child : topology.children[static_cast<std::size_t>(i)])
    text += branch_text(topology, child, depth + 1);
  return text;
}

std::string tree_explanation(const Topology& topology) {
  std::string text =
      heading("Tree") +
      paragraph(
          "Each body hangs on the one that it is indented under, and moves on it by one coordinate. Bodies between the "
          "freedoms of one joint have no mass.");
  text += "  ground\n";
  for (const int root : topology.roots) text += branch_text(topology, root, 2);
  return text;
}

std::string cuts_explanation(const Compilation& c) {
  std::string text;
  std::size_t place = 0;
  for (const Loop& loop : c.topology.loops) {
    if (loop.joint < 0) continue;
    const std::string reason = place < c.topology.cut_reasons.size() ? c.topology.cut_reasons[place] : "";
    ++place;
    const std::string why = reason == "marked" ? "the model marks it \"cut\": true"
                            : reason == "no coordinates"
                                ? "a joint of this type is equations only, and closes a loop wherever it stands"
                                : "of the joints of its loop it has " + reason;
    text += paragraph(
        fmt::format("{} ({}, {}): {}.", loop.name, name_of(loop.kind), counted(loop.equations, "equation"), why), "  ");
  }
  if (!text.empty()) {
    text = paragraph("A tree has no loops, so each loop is cut at one joint, which equations hold together instead:") +
           text;
  }
  if (!c.model.rods.empty()) {
    std::vector<std::string> names;
    for (const Rod& rod : c.model.rods) names.push_back(rod.name);
    text += paragraph(fmt::format("Each rod is one equation, the distance of its ends: {}.", listed(names)));
    std::vector<std::string> driven;
    for (const Loop& loop : c.topology.loops)
      if (loop.length >= 0)
        driven.push_back(
            fmt::format("{} by {}", loop.name, c.topology.bodies[static_cast<std::size_t>(loop.length)].coordinate));
    if (!driven.empty()) text += paragraph(fmt::format("Motions change the length of: {}.", listed(driven)));
  }
  for (const Coupling& coupling : c.model.couplings)
    text += paragraph(
        coupling.curve ? fmt::format("{} couples coordinates, one equation: {} is a curve through {} points over {}.",
                                     coupling.name, freedom_of(c.model, *coupling.joint).name, coupling.curve->x.size(),
                                     freedom_of(c.model, *coupling.follows).name)
                       : fmt::format("{} couples coordinates, one equation: {} stays 0.", coupling.name,
                                     c.model.expressions[coupling.relation.expression].text));
  for (const Joint& joint : c.model.joints)
    if (joint.closure >= 0)
      text +=
          paragraph(fmt::format("A motion drives {} where it is cut: it moves the body {}, which has no mass, and {} "
                                "holds that to {}.",
                                joint.name, c.model.bodies[joint.to.body].name, c.model.joints[joint.closure].name,
                                c.model.bodies[c.model.joints[joint.closure].to.body].name));
  return text.empty() ? "" : heading("Cuts") + text;
}

/// Axes of the rotational and of the translational freedoms of a loop, in the reference position.
struct LoopAxes {
  std::vector<Vector3> turns, slides;
};

LoopAxes axes_of(const Model& model, const Topology& topology, const Loop& loop) {
  LoopAxes axes;
  const auto add = [&](FreedomKind kind, const Vector3& axis) {
    (kind == FreedomKind::revolute ? axes.turns : axes.slides).push_back(axis);
  };
  for (const int joint : loop.joints) {
    add(topology.bodies[static_cast<std::size_t>(joint)].kind, topology.bodies[static_cast<std::size_t>(joint)].axis);
  }
  if (loop.joint >= 0) {
    for (const Freedom& freedom : model.joints[static_cast<std::size_t>(loop.joint)].freedoms)
      add(freedom.kind, freedom.axis);
  }
  return axes;
}

/// Whether the loop is planar: all pins along one direction, all slides across it.
bool is_planar(const LoopAxes& axes) {
  if (axes.turns.empty()) return false;
  const Vector3& normal = axes.turns.front();
  const auto is_along = [&](const Vector3& axis) { return 1 - std::abs(dot(axis, normal)) < kParallel; };
  const auto is_across = [&](const Vector3& axis) { return std::abs(dot(axis, normal)) < kParallel; };
  return std::all_of(axes.turns.begin(), axes.turns.end(), is_along) &&
         std::all_of(axes.slides.begin(), axes.slides.end(), is_across);
}

/// Reason for redundant equations of a loop.
std::string cause_of(const Compilation& c, const Loop& loop) {
  const LoopAxes axes = axes_of(c.model, c.topology, loop);
  if (loop.joint >= 0 && is_planar(axes)) {
    return fmt::format("its pins are parallel{}, so it cannot leave its plane, whatever the equations ask",
                       axes.slides.empty() ? "" : " and its slides lie across them");
  }
  if (loop.kind == ClosureKind::coupling) return "other couplings or loops hold this relation already";
  if (is_rolling(loop.kind)) return "other joints or wheels hold this velocity already";
  if (loop.kind == ClosureKind::rod) return "other loops hold the ends of the rod at this distance already";
  return "its joints do not let it move in the directions that these equations forbid, or other loops "
         "forbid it "
         "already; this was found with numbers";
}

std::string redundancy_explanation(const Compilation& c, const BlockAnalysis& decided) {
  const Certificate& certificate = decided.certificate;
  if (certificate.redundant.empty()) return "";
  const auto count = static_cast<long>(certificate.redundant.size());
  std::string text = paragraph(fmt::format(
      "{} of them {} nothing new in any of the {} closed positions that were looked at, and {} left out:", count,
      count == 1 ? "says" : "say", certificate.closed_configurations, count == 1 ? "is" : "are"));
  for (const RedundantEquation& equation : certificate.redundant) {
    text += fmt::format("  {}, {}\n", equation.name, equation.meaning);
  }
  std::vector<int> told;
  for (const RedundantEquation& equation : certificate.redundant) {
    if (std::find(told.begin(), told.end(), equation.loop) != told.end()) continue;
    told.push_back(equation.loop);
    const Loop& loop = c.topology.loops[static_cast<std::size_t>(equation.loop)];
    text += paragraph(fmt::format("Why, for {}: {}.", loop.name, cause_of(c, loop)));
  }
  return text;
}

std::string block_explanation(const Compilation& c, std::size_t b) {
  const LoopBlock& block = c.topology.blocks[b];
  const BlockAnalysis& decided = c.analysis.blocks[b];
  std::vector<std::string> loops;
  for (const int loop : block.loops) loops.push_back(c.topology.loops[static_cast<std::size_t>(loop)].name);
  const std::vector<std::string> independent = local_names(c.topology, block, decided.independent),
                                 dependent = local_names(c.topology, block, decided.dependent),
                                 driven = local_names(c.topology, block, decided.driven);
  std::string text = heading(fmt::format("Loop block {}, on {}", b + 1, body_name(c.topology, block.base)));
  text += paragraph(fmt::format("{} {}: {} and {}.", listed(loops),
                                loops.size() == 1 ? "closes it" : "are closed together, since they share joints",
                                counted(static_cast<long>(block.joints.size()), "coordinate"),
                                counted(block.equations, "equation")));
  text += redundancy_explanation(c, decided);
  if (!driven.empty()) text += paragraph(fmt::format("Driven: {}.", listed(driven)));
  if (!independent.empty())
    text += paragraph(fmt::format(
        "Independent, chosen because the equations stay well conditioned with them over all these positions: {}.",
        listed(independent)));
  if (!dependent.empty()) text += paragraph(fmt::format("These follow: {}.", listed(dependent)));
  if (!decided.certificate.immobile.empty()) {
    text += paragraph(fmt::format("Stands still in every closed configuration that was seen: {}.",
                                  listed(local_names(c.topology, block, decided.certificate.immobile))));
  }
  for (const SingularConfiguration& seen : decided.certificate.singular) {
    text += paragraph(fmt::format(
        "At {} of these positions the rank is {} instead of {}: the loops can go on in more than one way there.",
        seen.times, seen.rank, decided.rank));
  }
  return text;
}

/// "y = 0", or by its normal.
std::string plane_of(const Mirror& mirror) {
  constexpr const char* kLetters[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i)
    if (1 - std::abs(mirror.normal[i]) < kParallel)
      return fmt::format("{} = {:.6g}", kLetters[i], std::copysign(1.0, mirror.normal[i]) * mirror.offset + 0.0);
  return fmt::format("across ({:.6g}, {:.6g}, {:.6g}), {:.6g} m from the origin", mirror.normal[0], mirror.normal[1],
                     mirror.normal[2], mirror.offset);
}

/// Left and right, for a model in which most bodies with mass have a mirror image: a number that differs may be a slip.
std::string sides_explanation(const Compilation& c) {
  const Mirror mirror = find_mirror(c.model, c.topology);
  std::vector<std::string> pairs, unlike, alone;
  std::size_t with_mass = 0;
  for (int i = 0; i < c.topology.size(); ++i) {
    const int image = mirror.image[static_cast<std::size_t>(i)];
    const TreeBody& body = c.topology.bodies[static_cast<std::size_t>(i)];
    if (body.massless) continue;
    ++with_mass;
    if (image < 0) alone.push_back(body.name);
    if (image < i) continue;
    const std::string& other = body_name(c.topology, image);
    if (image > i) pairs.push_back(fmt::format("{} and {}", body.name, other));
    if (!mirror.equal[static_cast<std::size_t>(i)])
      unlike.push_back(image > i ? fmt::format("{} and {}", body.name, other) : body.name);
  }
  if (pairs.empty() || 2 * alone.size() > with_mass) return "";
  std::string text = heading("Left and right") +
                     paragraph(fmt::format("In the plane {}, these are mirror images, with their joints: {}.",
                                           plane_of(mirror), fmt::join(pairs, "; ")));
  if (!unlike.empty())
    text += paragraph(fmt::format("Mass, centre of mass or inertia are not mirrored: {}.", fmt::join(unlike, "; ")));
  if (!alone.empty()) text += paragraph(fmt::format("Joints of {} have no mirror image.", listed(alone)));
  return text;
}

/// Ball joints that keep their angles as coordinates, with the reason.
std::string poles_explanation(const Compilation& c) {
  std::string text;
  for (const RealPole& pole : real_poles(c.model, c.topology))
    text += paragraph(
        fmt::format("Joint {} keeps its angles and their pole, where the second is a quarter turn: {} is on {}.",
                    c.model.joints[static_cast<std::size_t>(pole.joint)].name, pole.user, pole.coordinate));
  return text;
}

std::string freedoms_explanation(const Compilation& c) {
  std::string text = heading("Freedoms");
  const std::vector<int> free = free_coordinates(c.topology, c.analysis);
  text += free.empty() ? paragraph("Nothing is free to move.") : paragraph("The equations of motion are solved for:");
  for (const int i : free) {
    const TreeBody& body = c.topology.bodies[static_cast<std::size_t>(i)];
    text += fmt::format("  {} [{}], {} of joint {}\n", body.coordinate, unit_of(body.kind),
                        body.kind == FreedomKind::revolute ? "rotation" : "translation",
                        c.model.joints[static_cast<std::size_t>(body.joint)].name);
  }
  return text + poles_explanation(c);
}

/// Equal parts that the solver computes in pairs.
std::string twins_explanation(const Compilation& c) {
  if (!c.emitted.in_pairs || !c.emitted.in_pairs->holds_twins) return "";
  const std::vector<int> twin = find_twins(c.topology);
  std::vector<std::string> pairs;
  for (int i = 0; i < c.topology.size(); ++i)
    if (twin[static_cast<std::size_t>(i)] > i && !c.topology.bodies[static_cast<std::size_t>(i)].massless)
      pairs.push_back(
          fmt::format("{} and {}", body_name(c.topology, i), body_name(c.topology, twin[static_cast<std::size_t>(i)])));
  return heading("Twins") +
         paragraph(fmt::format("These are built alike, on one body: {}. Their numbers may differ. Operations that both "
                               "share are computed in pairs, see Operations.",
                               fmt::join(pairs, "; ")));
}

/// Pairs in the solver of one instance, by steps; empty without pairs.
std::string pairs_explanation(const std::optional<PairedAccelerations>& paired, const Titles& titles) {
  if (!paired) return "";
  const Program& program = paired->program;
  const std::vector<int> widths = widths_of(program);
  const std::map<Section, std::size_t> places = places_of_sections(program);
  std::vector<long> counts(program.sections.size(), 0);
  long in_pairs = 0, all = 0;
  for (std::size_t v = 0; v < program.nodes.size(); ++v) {
    const Node& node = program.nodes[v];
    if (arity(node.op) == 0 || node.op >= Op::pack || node.op == Op::negate) continue;
    ++all;
    if (widths[v] < 2) continue;
    ++in_pairs;
    ++counts[places.at(node.section)];
  }
  if (in_pairs == 0) return "";
  std::vector<std::string> steps;
  for (std::size_t s = 0; s < counts.size(); ++s)
    if (counts[s] > 0 && program.sections[s].step != Step::none)
      steps.push_back(fmt::format("{} of {}", counts[s], titles.section(program.sections[s])));
  const char* what = "left and right";
  if (paired->holds_twins) what = paired->holds_sides ? "twins, and left and right of the rest," : "twins";
  return paragraph(fmt::format(
      "The solver of one instance computes {} in pairs, one instruction for both{}: {} of its {} statements, {}.", what,
      paired->holds_twins ? "" : " sides", in_pairs, all, listed(steps)));
}

std::string operations_explanation(const Compilation& compilation) {
  const Programs programs = counted_programs(compilation);
  const Program& accelerations = programs.accelerations;
  const std::vector<OperationCount> counts = count_operations_by_section(accelerations);
  const Titles titles = titles_of(programs.form, compilation.model, compilation.topology);
  const long total = count_operations(accelerations).total();
  const long other =
      count_operations_of(compilation.model, compilation.topology, compilation.analysis, other_form(programs.form));
  std::string text =
      heading("Operations") +
      paragraph(fmt::format("One evaluation of all accelerations takes {} additions, multiplications "
                            "and divisions, in the {} form ({} in the other):",
                            total, name_of(programs.form), other > 0 ? std::to_string(other) : "many more"));
  std::vector<std::size_t> order(counts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return counts[a].total() > counts[b].total(); });
  for (const std::size_t s : order) {
    const long count = counts[s].total();
    if (count == 0) break;
    const auto bar = static_cast<std::size_t>(std::lround(static_cast<double>(kBarWidth) * static_cast<double>(count) /
                                                          static_cast<double>(counts[order.front()].total())));
    text += fmt::format("{:>7}  {:<{}}  {}\n", count, std::string(bar, '#'), kBarWidth,
                        accelerations.sections[s].step == Step::none ? "before the first step"
                                                                     : titles.section(accelerations.sections[s]));
  }
  return text + pairs_explanation(compilation.emitted.in_pairs, titles);
}

std::string notes_explanation(const Diagnostics& notes) {
  if (notes.empty()) return {};
  std::string text = heading("Notes");
  for (const Diagnostic& note : notes) text += paragraph(note_text(note));
  return text;
}

}  // namespace

std::string explanation_text(const Compilation& compilation) {
  std::string text =
      overview_text(compilation) + tree_explanation(compilation.topology) + cuts_explanation(compilation);
  for (std::size_t b = 0; b < compilation.topology.blocks.size(); ++b) text += block_explanation(compilation, b);
  return text + sides_explanation(compilation) + twins_explanation(compilation) + freedoms_explanation(compilation) +
         elements_explanation(compilation.model) + states_explanation(compilation.model) +
         vehicle_explanation(compilation.model) + operations_explanation(compilation) +
         notes_explanation(all_notes(compilation));
}

}  // namespace mbgen
