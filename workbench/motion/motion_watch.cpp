#include "workbench/motion/motion_watch.hpp"

#include <algorithm>

namespace mbgen {

MotionWatch::MotionWatch(const Compilation& compilation, SolverSettings::Integrator integrator,
                         const SimulationSettings& settings, const GenericState& start, const InputsOverTime& inputs,
                         bool is_controlled)
    : compilation_(compilation),
      integrator_(integrator),
      settings_(settings),
      exchanges_(compilation, settings.step),
      turns_(compilation, integrator, settings.step),
      times_(compilation, integrator, settings, is_controlled ? nullptr : &inputs),
      modes_(compilation, start, inputs.at(start.t), integrator, settings) {}

void MotionWatch::add(const Sample& sample) {
  exchanges_.add(sample);
  if (settings_.is_error_controlled) return;
  turns_.add(sample);
  times_.add(sample);
  modes_.add(sample);
}

StepVerdict MotionWatch::judge(SimulationSummary& summary) const {
  if (exchanges_.scale() > 0) summary.energy.scale = std::max(summary.energy.net, exchanges_.scale());
  if (settings_.is_error_controlled) return {};
  StepVerdict verdict = judge_step(compilation_, integrator_, settings_, summary, modes_.modes(), modes_.energies(),
                                   turns_.longest_step());
  for (std::string& warning : turns_.warnings()) verdict.warnings.push_back(std::move(warning));
  for (std::string& warning : times_.warnings()) verdict.warnings.push_back(std::move(warning));
  return verdict;
}

}  // namespace mbgen
