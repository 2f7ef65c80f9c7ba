#include "compiler/analysis/notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/analysis/misalignment.hpp"
#include "compiler/analysis/shared_loads.hpp"
#include "compiler/analysis/violation.hpp"

namespace mbgen {
namespace {

constexpr double kBarelyHeld = 0.01;  // smallest singular value
constexpr std::size_t kMostNames = 8;

std::string coordinates_text(const Topology& topology, const LoopBlock& block, const std::vector<int>& columns) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < columns.size() && c < kMostNames; ++c)
    names.push_back(topology.bodies[block.joints[columns[c]]].coordinate);
  const std::string more =
      columns.size() > kMostNames ? fmt::format(" and {} more", columns.size() - kMostNames) : std::string();
  return fmt::format("coordinate{} {}{}", columns.size() == 1 ? "" : "s", fmt::join(names, ", "), more);
}

/// Which axis locks these loops, if one does that was hardly meant to.
std::string cause(const Model& model, const Topology& topology, const std::vector<int>& loops) {
  for (int l : loops) {
    const std::optional<Misalignment> off = misaligned_joint(model, topology, {l});
    if (!off || off->angle >= kMeantParallel) continue;
    const std::string name = quoted(model.joints[off->joint].name);
    const double degrees = off->angle / 0.017453292519943295;
    if (off->kind == FreedomKind::revolute)
      return fmt::format(
          "if {} is to move: the axis of joint {} is {:.3g} deg off the direction that the other axes share",
          loops_text(topology, {l}), name, degrees);
    return fmt::format("if {} is to move: joint {} slides {:.3g} deg out of its plane", loops_text(topology, {l}), name,
                       degrees);
  }
  return "a structure is solved like anything else; a mechanism needs joints with more freedoms";
}

std::string hold_text(const Certificate& certificate) {
  if (certificate.smallest_kept >= kBarelyHeld) return {};
  return fmt::format(", barely (smallest singular value {:.1e}): a small change of a length moves them far",
                     certificate.smallest_kept);
}

/// Words on coordinates that stand still while their loops move: no more than the closed configurations show.
std::string still_text(const Topology& topology, const LoopBlock& block, const std::vector<int>& columns,
                       const Certificate& certificate) {
  const std::string names = coordinates_text(topology, block, columns), loops = loops_text(topology, block.loops);
  const bool is_one = columns.size() == 1, is_one_loop = block.loops.size() == 1;
  if (certificate.closed_configurations <= 1)
    return fmt::format("{} {} begin to move at the reference, the only configuration in which {} {} seen to close",
                       names, is_one ? "does not" : "do not", loops, is_one_loop ? "was" : "were");
  return fmt::format("{} move{} by less than 1e-6 of the motion of {} in each of {} closed configurations", names,
                     is_one ? "s" : "", loops, certificate.closed_configurations);
}

/// Whether a contact of the block is there to hold a coordinate: a translation along the normal of its plane.
bool held_by_contact(const Model& model, const Topology& topology, const LoopBlock& block, int column) {
  constexpr double kAlong = 1 - 1e-9;  // cosine
  const TreeBody& body = topology.bodies[block.joints[static_cast<std::size_t>(column)]];
  return body.kind == FreedomKind::prismatic && std::any_of(block.loops.begin(), block.loops.end(), [&](int l) {
           using enum ClosureKind;
           const Loop& loop = topology.loops[static_cast<std::size_t>(l)];
           if (loop.kind != rolling_disc && loop.kind != rolling_ball && loop.kind != point_on_plane) return false;
           const Vector3& normal = model.joints[static_cast<std::size_t>(loop.joint)].axis;
           return std::abs(normal[0] * body.axis[0] + normal[1] * body.axis[1] + normal[2] * body.axis[2]) > kAlong;
         });
}

void add_locked(const Model& model, const Topology& topology, std::size_t b, const Certificate& certificate,
                Diagnostics& notes) {
  const LoopBlock& block = topology.blocks[b];
  std::vector<int> locked, left = certificate.immobile;
  for (int l : block.loops) {
    const std::vector<int> columns = block_part(topology, block, {l}).columns;
    const auto still = [&](int c) { return contains(certificate.immobile, c); };
    if (!columns.empty() && std::all_of(columns.begin(), columns.end(), still)) locked.push_back(l);
  }
  for (const std::vector<int>& loops : connected(topology, locked)) {
    const std::vector<int> columns = block_part(topology, block, loops).columns;
    std::erase_if(left, [&](int c) { return contains(columns, c); });
    notes.push_back({where_of(model, topology.loops[loops[0]]),
                     fmt::format("{} hold{} {} in place{}", loops_text(topology, loops), loops.size() == 1 ? "s" : "",
                                 coordinates_text(topology, block, columns), hold_text(certificate)),
                     cause(model, topology, loops),
                     {}});
  }
  std::erase_if(left, [&](int c) { return held_by_contact(model, topology, block, c); });
  if (left.empty()) return;
  notes.push_back({where_of(model, topology.loops[block.loops[0]]),
                   still_text(topology, block, left, certificate),
                   cause(model, topology, block.loops),
                   {}});
}

void add_other_modes(const Model& model, const Topology& topology, std::size_t b, const BlockAnalysis& decided,
                     Diagnostics& notes) {
  const LoopBlock& block = topology.blocks[b];
  int others = 0, least = 0;
  for (const RankCount& seen : decided.certificate.ranks)
    if (seen.rank > decided.rank) others += seen.configurations, least = std::max(least, seen.rank);
  if (others == 0) return;
  const auto freedoms = [&](int rank) { return static_cast<int>(block.joints.size()) - rank; };
  notes.push_back({where_of(model, topology.loops[block.loops[0]]),
                   fmt::format("{} ha{} other assembly modes: {} of {} configurations closed from elsewhere leave {} "
                               "freedom{} where the mode of the reference leaves {}",
                               loops_text(topology, block.loops), block.loops.size() == 1 ? "s" : "ve", others,
                               decided.certificate.closed_configurations, freedoms(least),
                               freedoms(least) == 1 ? "" : "s", freedoms(decided.rank)),
                   "the model stays in the mode of its reference; a start far from it may end in another",
                   {}});
}

/// A block that is too large for another partition at run time; then no block of the model gets one.
void add_kept_partition(const Model& model, const Topology& topology, Diagnostics& notes) {
  const auto kept = std::find_if(topology.blocks.begin(), topology.blocks.end(),
                                 [](const LoopBlock& block) { return !chooses_again(block); });
  if (kept == topology.blocks.end()) return;
  notes.push_back({where_of(model, topology.loops[kept->loops[0]]),
                   fmt::format("a generated solver keeps the independent coordinates that were chosen near the "
                               "reference: a loop block of {} coordinates and {} equations is too large to choose "
                               "others at run time",
                               kept->joints.size(), kept->equations),
                   "where they do not serve, its motion ends with a singular loop; --engine generic chooses them at "
                   "every state",
                   {}});
}

}  // namespace

Diagnostics analysis_notes(const Model& model, const Topology& topology, const Analysis& analysis) {
  Diagnostics notes;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    add_locked(model, topology, b, analysis.blocks[b].certificate, notes);
    add_other_modes(model, topology, b, analysis.blocks[b], notes);
  }
  add_kept_partition(model, topology, notes);
  add_shared_loads(model, topology, analysis, notes);
  for (Diagnostic& note : unactuated_directions(model, topology, analysis)) notes.push_back(std::move(note));
  return notes;
}

}  // namespace mbgen
