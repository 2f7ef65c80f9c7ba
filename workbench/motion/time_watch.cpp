#include "workbench/motion/time_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/model/model.hpp"
#include "workbench/describe/names.hpp"

namespace mbgen {
namespace {

constexpr long kLooksPerMotion = 100;
/// Points in a step, in parts of it: three that a method uses, two between them. Derivatives of a table jump at its
/// rows, often at the start of a step: this is no change within a step.
constexpr double kInside = 1e-6, kSeen[] = {kInside, 0.5, 1 - kInside}, kBetween[] = {0.25, 0.75};
/// For a sine that turns by `a` rad in a step: mean of the largest deviation from the parabola, over its range.
constexpr double kMeanDeviation = 0.00249;  // a^3
/// Largest part of the range that a step may contribute: jumps of single steps are not fast changes.
constexpr double kMostOfAStep = 0.01;
/// Ranges of accelerations below these parts of their size, and of the largest of all, are rounding.
constexpr double kRoundingInTime = 1e-6, kRoundingOfAll = 1e-8;

bool looks_at_time(const Model& model) {
  return std::any_of(model.expressions.begin(), model.expressions.end(), [](const Expression& expression) {
    return std::any_of(expression.nodes.begin(), expression.nodes.end(),
                       [](const ExpressionNode& node) { return node.kind == ExpressionNode::Kind::time; });
  });
}

}  // namespace

TimeWatch::TimeWatch(const Compilation& compilation, Engine engine, SolverSettings::Integrator integrator,
                     const SimulationSettings& settings, const InputsOverTime* inputs)
    : compilation_(compilation),
      integrator_(integrator),
      settings_(settings),
      inputs_(inputs),
      every_(std::max(1L, settings.steps / kLooksPerMotion)),
      engine_(std::move(engine)),
      smallest_(compilation.topology.bodies.size(), INFINITY),
      largest_(compilation.topology.bodies.size(), -INFINITY) {
  if (looks_at_time(compilation.model)) sources_.push_back({});
  const bool move = inputs_ != nullptr && !inputs_->is_constant;
  for (int i = 0; move && i < static_cast<int>(compilation.model.inputs.size()); ++i) sources_.push_back({i, {}});
}

void TimeWatch::add(const Sample& sample) {
  if (sample.step % every_ != 0 || sample.step >= settings_.steps) return;
  for (Source& source : sources_) look(sample, source);
}

void TimeWatch::look(const Sample& sample, Source& source) {
  LoadedState at{sample.moving, std::vector<double>(sample.moving.z.size(), 0.0)};
  const auto accelerations = [&](double part, std::vector<double>& zdd) {
    const double t = sample.state.t + part * settings_.step;
    if (source.input < 0) {
      at.state.t = t;
    } else {  // inputs that move are set anew for every step: no history of a method is lost
      std::vector<double> values = sample.inputs;
      const auto i = static_cast<std::size_t>(source.input);
      values[i] = inputs_->courses[i].at(t);
      engine_.set_inputs(values);
    }
    GenericDerivative rates;
    const bool is_ok = engine_.accelerations(at, rates).ok();
    zdd = std::move(rates.zdd);
    return is_ok;
  };
  std::vector<double> seen[3], between[2];
  bool are_known = true;
  for (int k = 0; k < 3; ++k) are_known = are_known && accelerations(kSeen[k], seen[k]);
  for (int k = 0; k < 2; ++k) are_known = are_known && accelerations(kBetween[k], between[k]);
  if (source.input >= 0) engine_.set_inputs(sample.inputs);
  if (!are_known) return;
  std::vector<double> deviations;
  for (std::size_t i = 0; i < smallest_.size(); ++i) {
    for (const std::vector<double>* zdd : {&seen[0], &seen[1], &seen[2], &between[0], &between[1]}) {
      smallest_[i] = std::min(smallest_[i], (*zdd)[i]);
      largest_[i] = std::max(largest_[i], (*zdd)[i]);
    }
    const double early = 0.375 * seen[0][i] + 0.75 * seen[1][i] - 0.125 * seen[2][i];
    const double late = 0.375 * seen[2][i] + 0.75 * seen[1][i] - 0.125 * seen[0][i];
    deviations.push_back(std::max(std::abs(between[0][i] - early), std::abs(between[1][i] - late)));
  }
  source.deviations.push_back(std::move(deviations));
}

std::vector<std::string> TimeWatch::warnings() const {
  std::vector<std::string> texts;
  const double most = kMeanDeviation * std::pow(largest_turn(integrator_), 3);
  double all = 0;
  for (std::size_t i = 0; i < smallest_.size(); ++i)
    if (largest_[i] >= smallest_[i]) all = std::max({all, std::abs(smallest_[i]), std::abs(largest_[i])});
  for (const Source& source : sources_) {
    std::size_t worst = 0;
    double largest = 0;
    for (std::size_t i = 0; i < smallest_.size(); ++i) {
      const double size = std::max(std::abs(smallest_[i]), std::abs(largest_[i]));
      const double range = std::max({largest_[i] - smallest_[i], kRoundingInTime * size, kRoundingOfAll * all});
      double sum = 0;
      for (const std::vector<double>& deviations : source.deviations)
        if (range > 0) sum += std::min(deviations[i] / range, kMostOfAStep);
      const double mean = source.deviations.empty() ? 0 : sum / static_cast<double>(source.deviations.size());
      if (mean > largest) largest = mean, worst = i;
    }
    if (!(largest > most)) continue;
    texts.push_back(fmt::format(
        "{} {} too fast for a step of {:.6g} s: between its points the acceleration of {} is not what {} can know of "
        "it; take a shorter step",
        source.input < 0 ? "laws of t"
                         : "input " + compilation_.model.inputs[static_cast<std::size_t>(source.input)].name,
        source.input < 0 ? "change" : "changes", settings_.step, compilation_.topology.bodies[worst].coordinate,
        name_of(integrator_)));
  }
  return texts;
}

}  // namespace mbgen
