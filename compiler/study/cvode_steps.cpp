// The only source that knows SUNDIALS. Functions of CVODE are documented in its user guide (A. C. Hindmarsh et al.,
// version 6); its memory goes with the stepper.

#include "compiler/study/cvode_steps.hpp"

#ifdef MBGEN_SUNDIALS

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compiler/study/controlled_motion.hpp"
#include "mbgen/sampling.hpp"

namespace mbgen {
namespace {

/// Part of the tolerance that auxiliary states have, m: deflections of tyres and bristles are of small fractions of mm.
constexpr double kOfAuxiliaryState = 1e-3;
/// Error of the loops, in tolerances, at which the motion starts anew with closed ones.
constexpr double kOpenLoops = 100;
/// Steps of CVODE for one step of the table: more is no progress.
constexpr long kMostSteps = 500'000;
/// Part of the time to an event that is no time.
constexpr double kNoTime = 1e-12;
/// Vectors by which the fixed-point iteration is accelerated (Anderson).
constexpr int kAcceleration = 3;

template <class Object>
using Owned = std::unique_ptr<Object, std::function<void(Object*)>>;

class CvodeStepper : public Stepper {
 public:
  CvodeStepper(const Engine& engine, const InputsOverTime& inputs, const ErrorControl& control,
               ErrorControlRecord& record)
      : engine_(engine), inputs_(inputs), control_(control), record_(record), motion_(engine_, inputs_) {
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    context_ = {context, [](_SUNContext* c) { SUNContext_Free(&c); }};
  }

  Status step(GenericState& state, double h) override;

 private:
  /// Starts or goes on from a state at its time.
  Status start(GenericState state);
  void make(const GenericState& state);
  void make_solver();
  Status advance();
  /// What follows a step of CVODE to t_: the closed state, and whether to start anew.
  Status arrive(bool at_row);
  Status at(double t, GenericState& state);
  Status fail(int flag);
  void count();
  double next_row(double t) const;
  /// Sets the sampled values that are due, once at an instant.
  Status set_sampled(GenericState& state);

  static int rates(sunrealtype t, N_Vector y, N_Vector f, void* self);
  static int jacobian(sunrealtype t, N_Vector y, N_Vector f, SUNMatrix J, void* self, N_Vector scratch, N_Vector,
                      N_Vector);
  static void keep_message(int, const char*, const char*, char* message, void* self);

  Engine engine_;
  const InputsOverTime& inputs_;
  ErrorControl control_;
  ErrorControlRecord& record_;
  ControlledMotion motion_;
  Owned<_SUNContext> context_;
  Owned<_generic_N_Vector> y_, dense_, absolute_;
  Owned<_generic_SUNMatrix> matrix_;
  Owned<_generic_SUNLinearSolver> linear_;
  Owned<_generic_SUNNonlinearSolver> iteration_;
  Owned<void> cvode_;
  double t_ = 0;      ///< s, of the last step of CVODE
  double given_ = 0;  ///< s, of the state that was given last
  double end_ = 0;    ///< s: steps go no farther before the next start
  double sampled_ = HUGE_VAL;  ///< s, when sampled values were set last
  bool starts_anew_ = true;
  Status trouble_;             ///< of the last evaluation that failed since the last good step
  std::string message_;        ///< of CVODE
  ErrorControlRecord before_;  ///< counts up to the last start
};

int CvodeStepper::rates(sunrealtype t, N_Vector y, N_Vector f, void* self) {
  auto& stepper = *static_cast<CvodeStepper*>(self);
  const Status status = stepper.motion_.rates(t, N_VGetArrayPointer(y), N_VGetArrayPointer(f));
  if (!status.ok()) stepper.trouble_ = status;
  return status.ok() ? 0 : 1;  // 1: a shorter step may do
}

int CvodeStepper::jacobian(sunrealtype t, N_Vector y, N_Vector f, SUNMatrix J, void* self, N_Vector scratch, N_Vector,
                           N_Vector) {
  auto& stepper = *static_cast<CvodeStepper*>(self);
  const auto set = [&](std::size_t row, std::size_t column, double value) {
    SM_ELEMENT_D(J, static_cast<sunindextype>(row), static_cast<sunindextype>(column)) = value;
  };
  const Status status =
      stepper.motion_.jacobian(t, N_VGetArrayPointer(y), N_VGetArrayPointer(f), N_VGetArrayPointer(scratch), set);
  if (!status.ok()) stepper.trouble_ = status;
  return status.ok() ? 0 : 1;
}

void CvodeStepper::keep_message(int, const char*, const char*, char* message, void* self) {
  static_cast<CvodeStepper*>(self)->message_ = message;
}

double CvodeStepper::next_row(double t) const {
  const double none = kNoTime * std::max(1.0, std::abs(t));
  const double end = std::min(control_.end, next_instant(control_.periods.data(),
                                                         static_cast<int>(control_.periods.size()), t));
  for (const double row : inputs_.rows)
    if (row > t + none && row < end) return row;
  return end;
}

Status CvodeStepper::set_sampled(GenericState& state) {
  if (!engine_.sample || std::abs(state.t - sampled_) <= same_instant(state.t)) return {};
  sampled_ = state.t;
  bool any = false;
  return engine_.sample(state, 0, any);
}

void CvodeStepper::make(const GenericState& state) {
  motion_.begin(state, end_);
  const auto size = static_cast<sunindextype>(motion_.size());
  const auto vector = [&] { return Owned<_generic_N_Vector>(N_VNew_Serial(size, context_.get()), N_VDestroy); };
  y_ = vector();
  dense_ = vector();
  absolute_ = vector();
  for (sunindextype i = 0; i < size; ++i) {
    const bool is_auxiliary = i >= static_cast<sunindextype>(2 * state.z.size());
    NV_Ith_S(absolute_.get(), i) = control_.tolerance * (is_auxiliary ? kOfAuxiliaryState : 1.0);
  }
  const int method = control_.method == ErrorControl::Method::bdf ? CV_BDF : CV_ADAMS;
  cvode_ = {CVodeCreate(method, context_.get()), [](void* memory) { CVodeFree(&memory); }};
  motion_.copy(state, N_VGetArrayPointer(y_.get()));
  CVodeInit(cvode_.get(), rates, state.t, y_.get());
  CVodeSVtolerances(cvode_.get(), control_.tolerance, absolute_.get());
  CVodeSetUserData(cvode_.get(), this);
  CVodeSetErrHandlerFn(cvode_.get(), keep_message, this);
  make_solver();
}

void CvodeStepper::make_solver() {
  const auto size = static_cast<sunindextype>(motion_.size());
  if (control_.method == ErrorControl::Method::adams) {
    iteration_ = {SUNNonlinSol_FixedPoint(y_.get(), kAcceleration, context_.get()), SUNNonlinSolFree};
    CVodeSetNonlinearSolver(cvode_.get(), iteration_.get());
    return;
  }
  matrix_ = {SUNDenseMatrix(size, size, context_.get()), SUNMatDestroy};
  linear_ = {SUNLinSol_Dense(y_.get(), matrix_.get(), context_.get()), SUNLinSolFree};
  CVodeSetLinearSolver(cvode_.get(), linear_.get(), matrix_.get());
  CVodeSetJacFn(cvode_.get(), jacobian);
}

Status CvodeStepper::start(GenericState state) {
  engine_.set_inputs(inputs_.at(state.t));
  settle_charts(engine_.balls, state);
  Status status = engine_.project(state);
  if (status.ok()) status = set_sampled(state);
  if (!status.ok()) return status;
  end_ = next_row(state.t);
  t_ = state.t;
  if (cvode_) {
    motion_.begin(state, end_);
    motion_.copy(state, N_VGetArrayPointer(y_.get()));
    CVodeReInit(cvode_.get(), t_, y_.get());
    before_ = record_;
    ++before_.restarts;
  } else {
    make(state);
  }
  CVodeSetStopTime(cvode_.get(), end_);
  starts_anew_ = false;
  return {};
}

void CvodeStepper::count() {
  long steps = 0, rejected = 0, not_solved = 0, jacobians = 0;
  int order = 0;
  double size = 0;
  CVodeGetNumSteps(cvode_.get(), &steps);
  CVodeGetNumErrTestFails(cvode_.get(), &rejected);
  CVodeGetNumNonlinSolvConvFails(cvode_.get(), &not_solved);
  if (linear_) CVodeGetNumJacEvals(cvode_.get(), &jacobians);
  CVodeGetLastOrder(cvode_.get(), &order);
  CVodeGetLastStep(cvode_.get(), &size);
  record_.evaluations = motion_.evaluations();
  record_.steps = before_.steps + steps;
  record_.rejected = before_.rejected + rejected;
  record_.not_solved = before_.not_solved + not_solved;
  record_.jacobians = before_.jacobians + jacobians;
  record_.restarts = before_.restarts;
  record_.largest_order = std::max(record_.largest_order, order);
  if (!(size > 0)) return;
  record_.shortest = record_.shortest > 0 ? std::min(record_.shortest, size) : size;
  record_.longest = std::max(record_.longest, size);
}

Status CvodeStepper::fail(int flag) {
  const Status status = trouble_.ok() ? Status{Code::step_invalid, -1} : trouble_;
  record_.failure = flag == CV_SUCCESS ? fmt::format("more than {} steps at t = {:.10g} s", kMostSteps, t_) : message_;
  return status;
}

Status CvodeStepper::arrive(bool at_row) {
  GenericState closed;
  const double* y = N_VGetArrayPointer(y_.get());
  const Status status = motion_.close(t_, y, closed);
  if (!status.ok()) return status;
  motion_.follow(closed);
  std::vector<double> values(motion_.size());
  motion_.copy(closed, values.data());
  double open = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double weight = control_.tolerance * std::abs(values[i]) + NV_Ith_S(absolute_.get(), i);
    open = std::max(open, std::abs(values[i] - y[i]) / weight);
  }
  starts_anew_ = at_row || open > kOpenLoops || leaves_charts(engine_.balls, closed);
  return {};
}

Status CvodeStepper::advance() {
  if (starts_anew_) {
    GenericState state = motion_.guess();
    state.t = t_;
    if (const Status status = start(state); !status.ok()) return status;
  }
  const int flag = CVode(cvode_.get(), end_, y_.get(), &t_, CV_ONE_STEP);
  count();
  if (flag < 0) return fail(flag);
  trouble_ = {};
  return arrive(flag == CV_TSTOP_RETURN);
}

Status CvodeStepper::at(double t, GenericState& state) {
  if (t == t_) {
    state = motion_.guess();
    return {};
  }
  if (const int flag = CVodeGetDky(cvode_.get(), t, 0, dense_.get()); flag < 0) return fail(flag);
  return motion_.close(t, N_VGetArrayPointer(dense_.get()), state);
}

Status CvodeStepper::step(GenericState& state, double h) {
  const double target = std::min(state.t + h, control_.end);
  const double none = kNoTime * std::max(h, std::abs(target));
  if (!cvode_ || std::abs(state.t - given_) > none) {
    if (const Status status = start(state); !status.ok()) return status;
  }
  for (long steps = 0; t_ < target - none; ++steps) {
    if (steps == kMostSteps) return fail(CV_SUCCESS);
    if (const Status status = advance(); !status.ok()) return status;
  }
  const Status status = at(std::min(target, t_), state);
  if (status.ok()) given_ = state.t = target;
  return status;
}

}  // namespace

bool has_cvode() { return true; }

std::unique_ptr<Stepper> make_cvode_stepper(const Engine& engine, const InputsOverTime& inputs,
                                            const ErrorControl& control, ErrorControlRecord& record) {
  return std::make_unique<CvodeStepper>(engine, inputs, control, record);
}

}  // namespace mbgen

#else

namespace mbgen {

bool has_cvode() { return false; }

std::unique_ptr<Stepper> make_cvode_stepper(const Engine&, const InputsOverTime&, const ErrorControl&,
                                            ErrorControlRecord&) {
  return {};
}

}  // namespace mbgen

#endif
