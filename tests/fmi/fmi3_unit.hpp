#pragma once
// An FMU of FMI 3 behind the functions that the importer asks for.

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>

#include "description.hpp"
#include "fmi3Functions.h"
#include "library.hpp"

inline int messages_3 = 0;

inline void log_3(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message) {
  if (std::getenv("FMI_LOG") != nullptr) std::fprintf(stderr, "[%s] %s\n", category, message);
  last_message = message;
  last_category = category;
  ++messages_3;
}

class Unit3 {
 public:
  static constexpr int kVersion = 3;
  /// Called between the inner steps of a communication step, with the time and whether inputs may be set.
  using AtPoint = std::function<void(double, bool)>;

  Unit3(const Library& library, const Description& description, bool is_exchange, bool = true, AtPoint at_point = {})
      : library_(library), at_point_(std::move(at_point)) {
    const char* token = description.token.c_str();
    instance_ = is_exchange ? call<fmi3InstantiateModelExchangeTYPE>("fmi3InstantiateModelExchange")(
                                  "unit", token, nullptr, false, true, nullptr, log_3)
                            : instantiate_with(token);
    require(instance_ != nullptr, "fmi3Instantiate");
  }
  ~Unit3() { call<fmi3FreeInstanceTYPE>("fmi3FreeInstance")(instance_); }
  Unit3(const Unit3&) = delete;
  Unit3& operator=(const Unit3&) = delete;

  double next_event = std::numeric_limits<double>::infinity();  ///< s, as the last event has told

  int setup(double start, double stop) {
    return call<fmi3EnterInitializationModeTYPE>("fmi3EnterInitializationMode")(instance_, false, 0, start,
                                                                                stop > start, stop);
  }
  int leave() { return simple("fmi3ExitInitializationMode"); }
  int get(const std::vector<unsigned>& references, std::vector<double>& values) {
    values.resize(references.size());
    return call<fmi3GetFloat64TYPE>("fmi3GetFloat64")(instance_, references.data(), references.size(), values.data(),
                                                      values.size());
  }
  int set(const std::vector<unsigned>& references, const std::vector<double>& values) {
    return call<fmi3SetFloat64TYPE>("fmi3SetFloat64")(instance_, references.data(), references.size(), values.data(),
                                                      values.size());
  }
  int step(double t, double h) {
    bool event = true, end = true, early = true;
    double last = -1;
    const int status = call<fmi3DoStepTYPE>("fmi3DoStep")(instance_, t, h, true, &event, &end, &early, &last);
    if (status == fmi3OK)
      require(!event && !end && !early && std::abs(last - t - h) < 0.5 * h + 1e-9 * std::abs(t),
              "fmi3DoStep's answers");
    return status;
  }
  int nominals(std::vector<double>& values) {
    return call<fmi3GetNominalsOfContinuousStatesTYPE>("fmi3GetNominalsOfContinuousStates")(instance_, values.data(),
                                                                                            values.size());
  }
  int set_time(double t) { return call<fmi3SetTimeTYPE>("fmi3SetTime")(instance_, t); }
  int set_states(const std::vector<double>& x) {
    return call<fmi3SetContinuousStatesTYPE>("fmi3SetContinuousStates")(instance_, x.data(), x.size());
  }
  int states(std::vector<double>& x) {
    size_t count = 0;
    const int status = call<fmi3GetNumberOfContinuousStatesTYPE>("fmi3GetNumberOfContinuousStates")(instance_, &count);
    if (status != fmi3OK) return status;
    if (count != x.size()) return fmi3Error;
    return call<fmi3GetContinuousStatesTYPE>("fmi3GetContinuousStates")(instance_, x.data(), x.size());
  }
  int derivatives(std::vector<double>& x) {
    return call<fmi3GetContinuousStateDerivativesTYPE>("fmi3GetContinuousStateDerivatives")(instance_, x.data(),
                                                                                            x.size());
  }
  int indicators(std::vector<double>& z) {
    size_t count = 0;
    require(call<fmi3GetNumberOfEventIndicatorsTYPE>("fmi3GetNumberOfEventIndicators")(instance_, &count) == fmi3OK &&
                count == z.size(),
            "as many indicators as the description has");
    return call<fmi3GetEventIndicatorsTYPE>("fmi3GetEventIndicators")(instance_, z.data(), z.size());
  }
  int completed(bool& event) {
    bool end = false;
    return call<fmi3CompletedIntegratorStepTYPE>("fmi3CompletedIntegratorStep")(instance_, true, &event, &end);
  }
  int enter_event() { return simple("fmi3EnterEventMode"); }
  int update(bool& has_changed) {
    bool more = true, end = true, nominals = true, timed = true;
    double next = 0;
    const int status = call<fmi3UpdateDiscreteStatesTYPE>("fmi3UpdateDiscreteStates")(instance_, &more, &end, &nominals,
                                                                                      &has_changed, &timed, &next);
    require(status != fmi3OK || (!more && !end && !nominals), "fmi3UpdateDiscreteStates' answers");
    next_event = timed ? next : std::numeric_limits<double>::infinity();
    return status;
  }
  int enter_continuous() { return simple("fmi3EnterContinuousTimeMode"); }
  int terminate() { return simple("fmi3Terminate"); }
  int reset() { return simple("fmi3Reset"); }
  int save(void*& state) { return call<fmi3GetFMUStateTYPE>("fmi3GetFMUState")(instance_, &state); }
  int restore(void* state) { return call<fmi3SetFMUStateTYPE>("fmi3SetFMUState")(instance_, state); }
  int forget(void*& state) { return call<fmi3FreeFMUStateTYPE>("fmi3FreeFMUState")(instance_, &state); }
  int serialise(void* state, std::vector<char>& bytes) {
    size_t size = 0;
    const int status = call<fmi3SerializedFMUStateSizeTYPE>("fmi3SerializedFMUStateSize")(instance_, state, &size);
    bytes.resize(size);
    auto* place = reinterpret_cast<fmi3Byte*>(bytes.data());
    return status != 0 ? status
                       : call<fmi3SerializeFMUStateTYPE>("fmi3SerializeFMUState")(instance_, state, place, size);
  }
  int deserialise(const std::vector<char>& bytes, void*& state) {
    return call<fmi3DeserializeFMUStateTYPE>("fmi3DeserializeFMUState")(
        instance_, reinterpret_cast<const fmi3Byte*>(bytes.data()), bytes.size(), &state);
  }
  int directional(const std::vector<unsigned>& unknowns, const std::vector<unsigned>& knowns,
                  const std::vector<double>& seeds, std::vector<double>& rates) {
    rates.resize(unknowns.size());
    return call<fmi3GetDirectionalDerivativeTYPE>("fmi3GetDirectionalDerivative")(
        instance_, unknowns.data(), unknowns.size(), knowns.data(), knowns.size(), seeds.data(), seeds.size(),
        rates.data(), rates.size());
  }
  int adjoint(const std::vector<unsigned>& unknowns, const std::vector<unsigned>& knowns,
              const std::vector<double>& seeds, std::vector<double>& weights) {
    weights.resize(knowns.size());
    return call<fmi3GetAdjointDerivativeTYPE>("fmi3GetAdjointDerivative")(instance_, unknowns.data(), unknowns.size(),
                                                                          knowns.data(), knowns.size(), seeds.data(),
                                                                          seeds.size(), weights.data(), weights.size());
  }
  int log(bool on, const std::vector<const char*>& categories) {
    return call<fmi3SetDebugLoggingTYPE>("fmi3SetDebugLogging")(instance_, on, categories.size(), categories.data());
  }
  /// Calls that the FMU does not support; every one must be refused. Result: how many.
  int refusals() {
    for (const char* name : {"fmi3EnterConfigurationMode", "fmi3ExitConfigurationMode", "fmi3EvaluateDiscreteStates",
                             "fmi3EnterStepMode"}) {
      require(simple(name) == fmi3Error, name);
    }
    const unsigned reference = 1;
    double value = 0;
    bool truth = false;
    int32_t whole = 0;
    size_t count = 0;
    require(call<fmi3GetInt32TYPE>("fmi3GetInt32")(instance_, &reference, 1, &whole, 1) == fmi3Error, "GetInt32");
    require(call<fmi3GetBooleanTYPE>("fmi3GetBoolean")(instance_, &reference, 1, &truth, 1) == fmi3Error, "GetBoolean");
    require(call<fmi3GetClockTYPE>("fmi3GetClock")(instance_, &reference, 1, &truth) == fmi3Error, "GetClock");
    require(call<fmi3GetOutputDerivativesTYPE>("fmi3GetOutputDerivatives")(instance_, &reference, 1, &whole, &value,
                                                                           1) == fmi3Error,
            "GetOutputDerivatives");
    require(call<fmi3GetNumberOfVariableDependenciesTYPE>("fmi3GetNumberOfVariableDependencies")(instance_, 1,
                                                                                                 &count) == fmi3Error,
            "GetNumberOfVariableDependencies");
    require(call<fmi3ActivateModelPartitionTYPE>("fmi3ActivateModelPartition")(instance_, 1, 0) == fmi3Error,
            "ActivateModelPartition");
    require(call<fmi3InstantiateScheduledExecutionTYPE>("fmi3InstantiateScheduledExecution")(
                "unit", "", nullptr, false, true, nullptr, log_3, nullptr, nullptr, nullptr) == nullptr,
            "InstantiateScheduledExecution");
    return 12;
  }
  void* instantiate_with(const char* token, const std::vector<unsigned>& intermediate = {}, bool event_mode = false) {
    return call<fmi3InstantiateCoSimulationTYPE>("fmi3InstantiateCoSimulation")(
        "unit", token, nullptr, false, true, event_mode, true, intermediate.data(), intermediate.size(), this, log_3,
        at_point_ ? update_between : nullptr);
  }

 private:
  template <class Function>
  Function* call(const char* name) const {
    return library_.function<Function>(name);
  }
  static void update_between(fmi3InstanceEnvironment unit, double time, bool set, bool get, bool finished, bool early,
                             bool* asks_for_return, double* return_time) {
    require(get && finished && !early, "what an intermediate update allows");
    *asks_for_return = true;  // which the unit does not do
    *return_time = time;
    static_cast<Unit3*>(unit)->at_point_(time, set);
  }
  int simple(const char* name) { return library_.function<fmi3Status(fmi3Instance)>(name)(instance_); }
  const Library& library_;
  AtPoint at_point_;
  fmi3Instance instance_ = nullptr;
};
