#include "workbench/motion/motion_judge.hpp"

#include <algorithm>

#include "workbench/motion/branch_guard.hpp"
#include "workbench/motion/contact_watch.hpp"
#include "workbench/motion/controlled_engine.hpp"
#include "workbench/motion/input_bounds.hpp"
#include "workbench/motion/load_watch.hpp"
#include "workbench/motion/road_watch.hpp"
#include "workbench/motion/step_error_watch.hpp"
#include "workbench/motion/table_watch.hpp"
#include "workbench/motion/touch_watch.hpp"

namespace mbgen {
namespace {

/// The engine of a task with steps that are looked at.
Engine guarded_engine(const MotionTask& task, const std::shared_ptr<ErrorControlRecord>& record) {
  // Steps of error control are looked at one by one.
  if (record) {
    ErrorControl control = *task.error_control;
    control.end = task.start.t + static_cast<double>(task.settings.steps) * task.settings.step;
    return with_error_control(task.compilation, task.engine, task.inputs, control, record);
  }
  return with_branch_guard(task.compilation, task.engine);
}

}  // namespace

MotionJudge::MotionJudge(const MotionTask& task)
    : compilation_(task.compilation),
      integrator_(task.integrator),
      settings_(task.settings),
      inputs_(task.control ? nullptr : &task.inputs),
      exchanges_(task.compilation, task.settings.step),
      turns_(task.compilation, task.integrator, task.settings.step),
      relative_(is_cartesian(task.engine.name) ? make_generic_engine(task.compilation, {}) : task.engine),
      times_(task.compilation, relative_, task.integrator, task.settings, inputs_),
      modes_(task.compilation, relative_, task.start, task.inputs.at(task.start.t), task.integrator, task.settings) {
  settings_.is_error_controlled = task.is_error_controlled();
  ContactWatch contacts(task.compilation);
  needs_multipliers_ = contacts.needs_multipliers();
  watch_by(std::move(contacts));
  watch_by(LoadWatch(task.compilation.model));
  watch_by(RoadWatch(task.compilation, task.start));
  watch_by(TableWatch(task.compilation, task.settings));
  watch_by(TouchWatch(task.compilation, settings_));
  watch_by(StepErrorWatch(task.compilation, relative_, task.integrator, settings_, inputs_));
}

void MotionJudge::add(const Sample& sample) {
  exchanges_.add(sample);
  for (const Watcher& watcher : watchers_) watcher.add(sample);
  if (settings_.is_error_controlled) return;
  turns_.add(sample);
  times_.add(sample);
  modes_.add(sample);
}

StepVerdict MotionJudge::judge(SimulationSummary& summary) const {
  if (exchanges_.scale() > 0) summary.energy.scale = std::max(summary.energy.net, exchanges_.scale());
  StepVerdict verdict;
  if (!settings_.is_error_controlled) {
    verdict = judge_step(compilation_, integrator_, settings_, summary, modes_.modes(), modes_.energies(),
                         turns_.longest_step());
    for (std::string& warning : turns_.warnings()) verdict.warnings.push_back(std::move(warning));
    for (std::string& warning : times_.warnings()) verdict.warnings.push_back(std::move(warning));
  }
  for (const Watcher& watcher : watchers_) watcher.judge(summary, verdict);
  if (inputs_ != nullptr) judge_inputs(compilation_.model, *inputs_, verdict);
  return verdict;
}

JudgedMotion judged_motion(const MotionTask& task, const std::function<void(const Sample&)>& on_sample) {
  MotionJudge judge(task);
  JudgedMotion motion;
  if (task.is_error_controlled()) motion.control = std::make_shared<ErrorControlRecord>();
  SimulationSettings settings = task.settings;
  settings.is_error_controlled = task.is_error_controlled();
  settings.has_multipliers = judge.needs_multipliers();
  const auto take = [&](const Sample& sample) {
    judge.add(sample);
    on_sample(sample);
  };
  motion.summary =
      simulate(guarded_engine(task, motion.control), task.start, task.inputs, settings, take, task.control);
  motion.verdict = judge.judge(motion.summary);
  return motion;
}

}  // namespace mbgen
