#pragma once
// One judge of a motion: all that looks along it is wired here, whoever runs it.

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "workbench/motion/error_control.hpp"
#include "workbench/motion/exchange_meter.hpp"
#include "workbench/motion/mode_watch.hpp"
#include "workbench/motion/step_verdict.hpp"
#include "workbench/motion/time_watch.hpp"
#include "workbench/motion/turn_watch.hpp"

namespace mbgen {

/// A motion that is to be computed and judged.
struct MotionTask {
  const Compilation& compilation;  ///< outlives the motion
  const Engine& engine;
  SolverSettings::Integrator integrator;
  SimulationSettings settings;
  const GenericState& start;
  const InputsOverTime& inputs;  ///< outlive the motion
  std::optional<ErrorControl> error_control = {};
  InputControl control = {};  ///< of a manoeuvre, which moves the inputs: they are not known before

  bool is_error_controlled() const { return error_control.has_value(); }
};

/// Takes the samples of one motion. Of the step there is no verdict where an integrator chooses its own steps.
class MotionJudge {
 public:
  explicit MotionJudge(const MotionTask& task);

  /// Whether the motion's samples need their multipliers.
  bool needs_multipliers() const { return needs_multipliers_; }
  void add(const Sample& sample);
  /// Gives the energy balance of the motion its scale, and finds how far the motion is to be trusted.
  StepVerdict judge(SimulationSummary& summary) const;

 private:
  struct Watcher {
    std::function<void(const Sample&)> add;
    std::function<void(const SimulationSummary&, StepVerdict&)> judge;
  };
  template <class Watch>
  void watch_by(Watch watch) {
    const auto kept = std::make_shared<Watch>(std::move(watch));
    watchers_.push_back(
        {[kept](const Sample& sample) { kept->add(sample); },
         [kept](const SimulationSummary& summary, StepVerdict& verdict) { kept->judge(summary, verdict); }});
  }

  const Compilation& compilation_;
  SolverSettings::Integrator integrator_;
  SimulationSettings settings_;
  const InputsOverTime* inputs_;  ///< null in a manoeuvre, which moves them: they are not known before
  ExchangeMeter exchanges_;
  TurnWatch turns_;
  Engine relative_;  ///< the motion's own, or the generic one in place of a judge
  TimeWatch times_;
  ModeWatch modes_;
  std::vector<Watcher> watchers_;  ///< of other things than the step
  bool needs_multipliers_ = false;
};

/// A motion and how far it is to be trusted.
struct JudgedMotion {
  SimulationSummary summary;
  StepVerdict verdict;
  std::shared_ptr<ErrorControlRecord> control = {};  ///< of a motion with error control
};

/// Simulates and judges. Steps that leap from one branch to another fail. on_sample: see simulate. Fails: UserError, as
/// simulate and the control do.
JudgedMotion judged_motion(const MotionTask& task, const std::function<void(const Sample&)>& on_sample);

}  // namespace mbgen
