#pragma once
// All checks along a motion that its single steps cannot make.

#include <vector>

#include "workbench/motion/exchange_meter.hpp"
#include "workbench/motion/mode_watch.hpp"
#include "workbench/motion/step_verdict.hpp"
#include "workbench/motion/time_watch.hpp"
#include "workbench/motion/turn_watch.hpp"

namespace mbgen {

/// Takes the samples of one motion. If an integrator chooses its own steps, only the energy scale is computed.
class MotionWatch {
 public:
  /// start: of the motion; inputs: of the run. is_controlled: whether a manoeuvre moves inputs. It keeps references to
  /// compilation and inputs.
  MotionWatch(const Compilation& compilation, SolverSettings::Integrator integrator, const SimulationSettings& settings,
              const GenericState& start, const InputsOverTime& inputs, bool is_controlled);

  void add(const Sample& sample);
  /// Sets the scale of the motion's energy balance, and judges its steps.
  StepVerdict judge(SimulationSummary& summary) const;

 private:
  const Compilation& compilation_;
  SolverSettings::Integrator integrator_;
  SimulationSettings settings_;
  ExchangeMeter exchanges_;
  TurnWatch turns_;
  TimeWatch times_;
  ModeWatch modes_;
};

}  // namespace mbgen
