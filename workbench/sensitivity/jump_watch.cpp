#include "workbench/sensitivity/jump_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mbgen {
namespace {

constexpr int kBisections = 20;       // of a step: within its millionth only a jump changes a law
constexpr double kSmallShare = 1e-2;  // of the largest acceleration: others do not count below it
constexpr double kJumpShare = 1e-3;   // of the acceleration

/// The state at this part of the way between two.
GenericState between(const GenericState& from, const GenericState& to, double part) {
  GenericState state = to;
  const auto mix = [&](std::vector<double>& values, const std::vector<double>& before) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = before[i] + part * (values[i] - before[i]);
  };
  mix(state.z, from.z);
  mix(state.zd, from.zd);
  mix(state.x, from.x);
  state.t = from.t + part * (to.t - from.t);
  return state;
}

}  // namespace

JumpWatch::JumpWatch(const Compilation& compilation, const std::vector<std::string>& parameters)
    : compilation_(compilation), corners_(compilation) {
  std::vector<int> tunable;
  for (int index = 0; const Parameter& parameter : compilation.model.parameters) {
    if (!parameter.tunable) continue;
    if (std::ranges::find(parameters, parameter.name) != parameters.end()) tunable.push_back(index);
    ++index;
  }
  const std::vector<bool> follow = corners_.follow(tunable);
  for (std::size_t i = 0; i < follow.size(); ++i)
    if (follow[i]) watched_.push_back(i);
}

bool JumpWatch::jumps(std::size_t corner, const Sample& sample) {
  const auto at = [&](double part) { return between(*last_, sample.state, part); };
  const bool side = conditions_[corner] >= 0;
  double before = 0, after = 1;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = (before + after) / 2;
    ((corners_.conditions(at(middle), sample.inputs)[corner] >= 0) == side ? before : after) = middle;
  }
  const auto accelerations = [&](double part) { return corners_.rates(at(part), sample.inputs).zdd; };
  const std::vector<double> first = accelerations(0), last = accelerations(1), left = accelerations(before),
                            right = accelerations(after);
  double largest = 0;
  for (const std::vector<double>* all : {&first, &last})
    for (const double acceleration : *all) largest = std::max(largest, std::abs(acceleration));
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double scale = std::max({std::abs(first[i]), std::abs(last[i]), kSmallShare * largest});
    if (!(std::abs(right[i] - left[i]) > kJumpShare * scale)) continue;
    coordinate_ = compilation_.topology.bodies[i].coordinate;
    return true;
  }
  return false;
}

void JumpWatch::add(const Sample& sample) {
  if (first_ || watched_.empty()) return;
  const std::vector<double> conditions = corners_.conditions(sample.state, sample.inputs);
  if (last_) {
    for (const std::size_t corner : watched_) {
      if ((conditions[corner] >= 0) == (conditions_[corner] >= 0) || !jumps(corner, sample)) continue;
      first_ = sample.state.t;
      break;
    }
  }
  last_ = sample.state;
  conditions_ = conditions;
}

std::string JumpWatch::warning() const {
  if (!first_) return "";
  return fmt::format(
      "derivatives after t = {:.6g} s are not exact: a law jumps there, the acceleration of {} with it, at an instant "
      "that moves with the parameters; a law without a jump has derivatives, as tanh in place of a step",
      *first_, coordinate_);
}

}  // namespace mbgen
