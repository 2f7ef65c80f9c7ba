#include "workbench/start/open_loops.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/analysis/equations.hpp"
#include "compiler/text/user_error.hpp"
#include "mbgen/solver/newton.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kMostLoops = 3;

/// The distance and the angle between the two sides of a loop.
struct LoopGap {
  int loop = 0;
  double distance = 0;  ///< m
  double angle = 0;     ///< sine of it
  double size() const { return std::hypot(distance, angle); }
};

/// residuals: of all loops, in their order. Result: the same for every loop.
std::vector<LoopGap> loop_gaps(const Compilation& compilation, const std::vector<double>& residuals) {
  const Topology& topology = compilation.topology;
  std::vector<LoopGap> result;
  std::vector<std::size_t> row;
  std::size_t next = 0;
  for (std::size_t l = 0; l < topology.loops.size(); ++l) {
    result.push_back({static_cast<int>(l)});
    row.push_back(next);
    next += static_cast<std::size_t>(topology.loops[l].equations);
  }
  for (const LoopBlock& block : topology.blocks) {
    for (const ClosureEquation& equation : closure_equations(compilation.model, topology, block)) {
      const auto l = static_cast<std::size_t>(equation.loop);
      double& size = equation.unit == ResidualUnit::metre ? result[l].distance : result[l].angle;
      size = std::hypot(size, opening(compilation.model, topology, equation, residuals[row[l]++]));
    }
  }
  return result;
}

std::vector<LoopGap> widest_first(std::vector<LoopGap> all) {
  std::erase_if(all, [](const LoopGap& gap) { return !(gap.size() > kClosed); });
  std::stable_sort(all.begin(), all.end(), [](const LoopGap& a, const LoopGap& b) { return a.size() > b.size(); });
  if (all.size() > kMostLoops) all.resize(kMostLoops);
  return all;
}

/// `loop "a" stays open by 2 mm, loop "b" by 1 mm and 3 deg`.
std::string gaps_text(const Compilation& compilation, const std::vector<LoopGap>& all) {
  std::vector<std::string> texts;
  for (const LoopGap& gap : all) {
    std::vector<std::string> sizes;
    if (gap.distance > kClosed) sizes.push_back(opening_text(ResidualUnit::metre, gap.distance));
    if (gap.angle > kClosed) sizes.push_back(opening_text(ResidualUnit::one, gap.angle));
    texts.push_back(fmt::format("loop {} {}by {}", quoted(compilation.topology.loops[gap.loop].name),
                                texts.empty() ? "stays open " : "", fmt::join(sizes, " and ")));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// " (rack -14 m, arm 0.1 rad)": the driven coordinates that are farthest from the reference; none that is there.
std::string driven_text(const Compilation& compilation, const GenericState& state) {
  constexpr std::size_t kMost = 3;
  std::vector<std::pair<double, std::string>> values;
  for (const Motion& motion : compilation.model.motions) {
    const int i = tree_coordinate(compilation.topology, motion.joint);
    if (i < 0 || state.z[static_cast<std::size_t>(i)] == 0) continue;
    const TreeBody& body = compilation.topology.bodies[static_cast<std::size_t>(i)];
    const double z = state.z[static_cast<std::size_t>(i)];
    values.emplace_back(std::abs(z), fmt::format("{} {:.4g} {}", body.coordinate, z, unit_of(body.kind)));
  }
  std::stable_sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  if (values.size() > kMost) values.resize(kMost);
  std::vector<std::string> texts;
  for (const auto& [size, text] : values) texts.push_back(text);
  return texts.empty() ? "" : fmt::format(" ({})", fmt::join(texts, ", "));
}

/// At the first value that is locked, or the first motion.
[[noreturn]] void refuse(const Compilation& compilation, const std::vector<InitialValue>& values, const char* what,
                         const std::string& open, const std::string& driven = "") {
  std::vector<std::string> names;
  Where where{compilation.model.file, 0, 0, ""};
  for (const InitialValue& value : values) {
    if (!value.locked) continue;
    if (names.empty()) where = value.where;
    names.push_back(compilation.topology.bodies[tree_coordinate(compilation.topology, value.coordinate)].coordinate);
  }
  if (!names.empty()) {
    throw UserError(
        Diagnostics{{where, fmt::format("the locked {} do not fit together: {}", what, open),
                     fmt::format("give {} other values, or leave out \"locked\"", fmt::join(names, ", ")), ""}});
  }
  if (!compilation.model.motions.empty()) where = compilation.model.motions.front().where;
  throw UserError(Diagnostics{{where, fmt::format("the driven {}{} do not fit together: {}", what, driven, open),
                               "change the motions at t = 0", ""}});
}

}  // namespace

void refuse_open_positions(const Compilation& compilation, const GenericSolver& solver, const GenericState& state) {
  const std::vector<LoopGap> all = loop_gaps(compilation, solver.position_residuals(state));
  refuse(compilation, compilation.model.initial.positions, "positions", gaps_text(compilation, widest_first(all)),
         driven_text(compilation, state));
}

void refuse_open_velocities(const Compilation& compilation) {
  refuse(compilation, compilation.model.initial.velocities, "velocities", "the loops do not close at them");
}

}  // namespace mbgen
