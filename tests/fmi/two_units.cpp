// Two FMUs of FMI 2 from their sources in one program, each with the functions of its own model. Their instances run in
// threads of their own, and have the bits that they have one after another.
//   two_units GUID_OF_PENDULUM GUID_OF_SLIDER_CRANK, each run over 200 steps
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

#include "fmi2FunctionTypes.h"

struct Functions {
  fmi2InstantiateTYPE* instantiate;
  fmi2SetupExperimentTYPE* setup;
  fmi2EnterInitializationModeTYPE* enter;
  fmi2ExitInitializationModeTYPE* leave;
  fmi2DoStepTYPE* step;
  fmi2GetRealTYPE* get;
  fmi2FreeInstanceTYPE* free;
};

extern "C" {
fmi2InstantiateTYPE pendulum_fmi2Instantiate, slider_crank_fmi2Instantiate;
fmi2SetupExperimentTYPE pendulum_fmi2SetupExperiment, slider_crank_fmi2SetupExperiment;
fmi2EnterInitializationModeTYPE pendulum_fmi2EnterInitializationMode, slider_crank_fmi2EnterInitializationMode;
fmi2ExitInitializationModeTYPE pendulum_fmi2ExitInitializationMode, slider_crank_fmi2ExitInitializationMode;
fmi2DoStepTYPE pendulum_fmi2DoStep, slider_crank_fmi2DoStep;
fmi2GetRealTYPE pendulum_fmi2GetReal, slider_crank_fmi2GetReal;
fmi2FreeInstanceTYPE pendulum_fmi2FreeInstance, slider_crank_fmi2FreeInstance;
}

constexpr Functions kPendulum = {pendulum_fmi2Instantiate,
                                 pendulum_fmi2SetupExperiment,
                                 pendulum_fmi2EnterInitializationMode,
                                 pendulum_fmi2ExitInitializationMode,
                                 pendulum_fmi2DoStep,
                                 pendulum_fmi2GetReal,
                                 pendulum_fmi2FreeInstance};
constexpr Functions kSliderCrank = {slider_crank_fmi2Instantiate,
                                    slider_crank_fmi2SetupExperiment,
                                    slider_crank_fmi2EnterInitializationMode,
                                    slider_crank_fmi2ExitInitializationMode,
                                    slider_crank_fmi2DoStep,
                                    slider_crank_fmi2GetReal,
                                    slider_crank_fmi2FreeInstance};

struct Job {
  const Functions& functions;
  const char* guid;
  double step;
  double values[5] = {};  ///< of the first variables, time among them
  bool is_done = false;
};

void run(Job& job) {
  const Functions& f = job.functions;
  const fmi2CallbackFunctions callbacks{nullptr, std::calloc, std::free, nullptr, nullptr};
  fmi2Component unit = f.instantiate("unit", fmi2CoSimulation, job.guid, "", &callbacks, 0, 0);
  if (unit == nullptr) return;
  bool is_well = f.setup(unit, 0, 0, 0, 0, 0) == fmi2OK && f.enter(unit) == fmi2OK && f.leave(unit) == fmi2OK;
  for (int i = 0; i < 200; ++i) is_well = is_well && f.step(unit, i * job.step, job.step, 0) == fmi2OK;
  const unsigned references[5] = {0, 1, 2, 3, 4};
  job.is_done = is_well && f.get(unit, references, 5, job.values) == fmi2OK;
  f.free(unit);
}

int main(int count, char** arguments) {
  if (count < 3) return 2;
  const Job pendulum{kPendulum, arguments[1], 1e-3}, slider_crank{kSliderCrank, arguments[2], 1e-4};
  std::vector<Job> alone = {pendulum, slider_crank, pendulum, slider_crank}, together = alone;
  for (Job& job : alone) run(job);
  std::vector<std::thread> threads;
  for (Job& job : together) threads.emplace_back(run, std::ref(job));
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (!alone[i].is_done || !together[i].is_done) return 1;
    if (std::memcmp(alone[i].values, together[i].values, sizeof alone[i].values) != 0) return 1;
  }
  std::printf("two FMUs in one program, at %g s and %g s\n", alone[0].values[0], alone[1].values[0]);
  // Without a unit each answers an error, and the GUID of another model is refused.
  Job wrong{kPendulum, arguments[2], 1e-3};
  run(wrong);
  return !wrong.is_done && kPendulum.step(nullptr, 0, 1, 0) == fmi2Error ? 0 : 1;
}
