#pragma once
// An FMU of FMI 2 behind the functions that the importer asks for.

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "description.hpp"
#include "fmi2Functions.h"
#include "library.hpp"

inline int messages = 0;

inline void log_2(fmi2ComponentEnvironment, fmi2String instance, fmi2Status, fmi2String category, fmi2String format,
                  ...) {
  char text[300];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (std::getenv("FMI_LOG") != nullptr) std::fprintf(stderr, "%s [%s] %s\n", instance, category, text);
  ++messages;
  last_message = text;
  last_category = category;
}

class Unit2 {
 public:
  static constexpr int kVersion = 2;
  Unit2(const Library& library, const Description& description, bool is_exchange, bool gives_memory = true)
      : library_(library),
        callbacks_{log_2, gives_memory ? std::calloc : nullptr, gives_memory ? std::free : nullptr, nullptr, nullptr} {
    component_ = call<fmi2InstantiateTYPE>("fmi2Instantiate")(
        "unit", is_exchange ? fmi2ModelExchange : fmi2CoSimulation, description.token.c_str(), "", &callbacks_, 0, 1);
    require(component_ != nullptr, "fmi2Instantiate");
  }
  ~Unit2() { call<fmi2FreeInstanceTYPE>("fmi2FreeInstance")(component_); }
  Unit2(const Unit2&) = delete;
  Unit2& operator=(const Unit2&) = delete;

  double next_event = std::numeric_limits<double>::infinity();  ///< s, as the last event has told

  int setup(double start, double stop) {
    const int status =
        call<fmi2SetupExperimentTYPE>("fmi2SetupExperiment")(component_, 0, 0, start, stop > start, stop);
    return status != 0 ? status : call<fmi2EnterInitializationModeTYPE>("fmi2EnterInitializationMode")(component_);
  }
  int leave() { return simple("fmi2ExitInitializationMode"); }
  int get(const std::vector<unsigned>& references, std::vector<double>& values) {
    values.resize(references.size());
    return call<fmi2GetRealTYPE>("fmi2GetReal")(component_, references.data(), references.size(), values.data());
  }
  int set(const std::vector<unsigned>& references, const std::vector<double>& values) {
    return call<fmi2SetRealTYPE>("fmi2SetReal")(component_, references.data(), references.size(), values.data());
  }
  int step(double t, double h) { return call<fmi2DoStepTYPE>("fmi2DoStep")(component_, t, h, 0); }
  int nominals(std::vector<double>& values) {
    return call<fmi2GetNominalsOfContinuousStatesTYPE>("fmi2GetNominalsOfContinuousStates")(component_, values.data(),
                                                                                            values.size());
  }
  int set_time(double t) { return call<fmi2SetTimeTYPE>("fmi2SetTime")(component_, t); }
  int set_states(const std::vector<double>& x) {
    return call<fmi2SetContinuousStatesTYPE>("fmi2SetContinuousStates")(component_, x.data(), x.size());
  }
  int states(std::vector<double>& x) {
    return call<fmi2GetContinuousStatesTYPE>("fmi2GetContinuousStates")(component_, x.data(), x.size());
  }
  int derivatives(std::vector<double>& x) {
    return call<fmi2GetDerivativesTYPE>("fmi2GetDerivatives")(component_, x.data(), x.size());
  }
  int indicators(std::vector<double>& z) {
    return call<fmi2GetEventIndicatorsTYPE>("fmi2GetEventIndicators")(component_, z.data(), z.size());
  }
  int completed(bool& event) {
    fmi2Boolean enter = 0, end = 0;
    const int status =
        call<fmi2CompletedIntegratorStepTYPE>("fmi2CompletedIntegratorStep")(component_, 1, &enter, &end);
    event = enter != 0;
    return status;
  }
  int enter_event() { return simple("fmi2EnterEventMode"); }
  int update(bool& has_changed) {
    fmi2EventInfo info{};
    const int status = call<fmi2NewDiscreteStatesTYPE>("fmi2NewDiscreteStates")(component_, &info);
    has_changed = info.valuesOfContinuousStatesChanged != 0;
    next_event = info.nextEventTimeDefined ? info.nextEventTime : std::numeric_limits<double>::infinity();
    return status;
  }
  int enter_continuous() { return simple("fmi2EnterContinuousTimeMode"); }
  int terminate() { return simple("fmi2Terminate"); }
  int reset() { return simple("fmi2Reset"); }
  int save(void*& state) { return call<fmi2GetFMUstateTYPE>("fmi2GetFMUstate")(component_, &state); }
  int restore(void* state) { return call<fmi2SetFMUstateTYPE>("fmi2SetFMUstate")(component_, state); }
  int forget(void*& state) { return call<fmi2FreeFMUstateTYPE>("fmi2FreeFMUstate")(component_, &state); }
  int serialise(void* state, std::vector<char>& bytes) {
    size_t size = 0;
    const int status = call<fmi2SerializedFMUstateSizeTYPE>("fmi2SerializedFMUstateSize")(component_, state, &size);
    bytes.resize(size);
    return status != 0
               ? status
               : call<fmi2SerializeFMUstateTYPE>("fmi2SerializeFMUstate")(component_, state, bytes.data(), size);
  }
  int deserialise(const std::vector<char>& bytes, void*& state) {
    return call<fmi2DeSerializeFMUstateTYPE>("fmi2DeSerializeFMUstate")(component_, bytes.data(), bytes.size(), &state);
  }
  int directional(const std::vector<unsigned>& unknowns, const std::vector<unsigned>& knowns,
                  const std::vector<double>& seeds, std::vector<double>& rates) {
    rates.resize(unknowns.size());
    return call<fmi2GetDirectionalDerivativeTYPE>("fmi2GetDirectionalDerivative")(
        component_, unknowns.data(), unknowns.size(), knowns.data(), knowns.size(), seeds.data(), rates.data());
  }
  int set_derivatives(const std::vector<unsigned>& references, const std::vector<int>& orders,
                      const std::vector<double>& values) {
    return call<fmi2SetRealInputDerivativesTYPE>("fmi2SetRealInputDerivatives")(
        component_, references.data(), references.size(), orders.data(), values.data());
  }
  int log(bool on, const std::vector<const char*>& categories) {
    return call<fmi2SetDebugLoggingTYPE>("fmi2SetDebugLogging")(component_, on ? 1 : 0, categories.size(),
                                                                categories.data());
  }
  /// Calls that the FMU does not support; every one must be refused. Result: how many.
  int refusals() {
    const unsigned reference = 1;
    double value = 0;
    int whole = 0;
    fmi2String text = nullptr;
    fmi2Status status = fmi2OK;
    require(call<fmi2CancelStepTYPE>("fmi2CancelStep")(component_) == fmi2Error, "CancelStep");
    require(call<fmi2SetRealInputDerivativesTYPE>("fmi2SetRealInputDerivatives")(component_, &reference, 1, &whole,
                                                                                 &value) == fmi2Error,
            "SetRealInputDerivatives");
    require(call<fmi2GetRealOutputDerivativesTYPE>("fmi2GetRealOutputDerivatives")(component_, &reference, 1, &whole,
                                                                                   &value) == fmi2Error,
            "GetRealOutputDerivatives");
    require(call<fmi2GetIntegerTYPE>("fmi2GetInteger")(component_, &reference, 1, &whole) == fmi2Error, "GetInteger");
    require(call<fmi2GetBooleanTYPE>("fmi2GetBoolean")(component_, &reference, 1, &whole) == fmi2Error, "GetBoolean");
    require(call<fmi2GetStringTYPE>("fmi2GetString")(component_, &reference, 1, &text) == fmi2Error, "GetString");
    require(call<fmi2GetStatusTYPE>("fmi2GetStatus")(component_, fmi2DoStepStatus, &status) == fmi2Discard,
            "GetStatus");
    require(call<fmi2SetDebugLoggingTYPE>("fmi2SetDebugLogging")(component_, 1, 1, &(text = "noise")) == fmi2Error,
            "SetDebugLogging");
    return 8;
  }
  void* instantiate_with(const char* token) {
    return call<fmi2InstantiateTYPE>("fmi2Instantiate")("unit", fmi2CoSimulation, token, "", &callbacks_, 0, 1);
  }

 private:
  template <class Function>
  Function* call(const char* name) const {
    return library_.function<Function>(name);
  }
  int simple(const char* name) { return library_.function<fmi2Status(fmi2Component)>(name)(component_); }
  const Library& library_;
  fmi2CallbackFunctions callbacks_;
  fmi2Component component_ = nullptr;
};
