// The only source that includes SUNDIALS. The user guide of CVODE (A. C. Hindmarsh et al., version 6) documents its
// functions; the stepper owns its memory.

#include "workbench/motion/cvode_steps.hpp"

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

#include "mbgen/sampling.hpp"
#include "workbench/motion/controlled_motion.hpp"
#include "workbench/motion/cvode_limits.hpp"

namespace mbgen {
namespace {

template <class Object>
using Owned = std::unique_ptr<Object, std::function<void(Object*)>>;

class CvodeStepper : public Stepper {
 public:
  CvodeStepper(ControlledMotion motion, BranchGuard guard, const ErrorControl& control, ErrorControlRecord& record)
      : control_(control), record_(record), motion_(std::move(motion)), leaps_(std::move(guard)) {
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    context_ = {context, [](_SUNContext* c) { SUNContext_Free(&c); }};
  }

  Status step(GenericState& state, double h) override;

 private:
  /// Starts or continues from a state at its time.
  Status start(GenericState state);
  /// Holds the sides of the corners on which the motion starts.
  void take_sides();
  void make(const GenericState& state);
  void make_solver();
  Status advance();
  /// Follows a step of CVODE to t_: closes the state, and decides whether to start anew. flag: of the step.
  Status arrive(int flag);
  /// Handles the corners at t_; whether the rates change by more than the tolerance allows.
  bool passes_corners();
  /// Whether the motion left a corner on the side that is not held, contrary to its direction of approach. It then
  /// steps back, and continues on no side of this corner.
  bool went_astray();
  /// Restarts the motion from the step before the last one.
  void step_back();
  /// Whether a corner is neither looked for nor held on a side until the next row.
  bool is_passed_freely(std::size_t corner) const { return stays_[corner] != 0 || corners_ >= kMostCorners; }
  Status at(double t, GenericState& state);
  Status fail(int flag);
  void count();
  double next_row(double t) const;
  /// Sets the sampled values that are due, once per instant.
  Status set_sampled(GenericState& state);

  static int rates(sunrealtype t, N_Vector y, N_Vector f, void* self);
  static int jacobian(sunrealtype t, N_Vector y, N_Vector f, SUNMatrix J, void* self, N_Vector scratch, N_Vector,
                      N_Vector);
  static int conditions(sunrealtype t, N_Vector y, sunrealtype* values, void* self);
  static void keep_message(int, const char*, const char*, char* message, void* self);

  ErrorControl control_;
  ErrorControlRecord& record_;
  ControlledMotion motion_;
  LeapWatch leaps_;
  Owned<_SUNContext> context_;
  Owned<_generic_N_Vector> y_, dense_, absolute_;
  Owned<_generic_SUNMatrix> matrix_;
  Owned<_generic_SUNLinearSolver> linear_;
  Owned<_generic_SUNNonlinearSolver> iteration_;
  Owned<void> cvode_;
  double t_ = 0;               ///< s, of the last step of CVODE
  double given_ = 0;           ///< s, of the state that was given last
  double end_ = 0;             ///< s: steps go no farther before the next start
  double sampled_ = HUGE_VAL;  ///< s, when sampled values were set last
  bool starts_anew_ = true;
  int corners_ = 0;            ///< arrivals at corners since the last row of the table
  GenericState start_, last_;  ///< of the last start
  std::vector<int> crossed_,
      loose_;                  ///< per corner: passed at the last start, upwards 1 or downwards -1; held on no side
  std::vector<int> stays_;     ///< per corner: 1 where the motion stays at it, since the last row of the table
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

int CvodeStepper::conditions(sunrealtype t, N_Vector y, sunrealtype* values, void* self) {
  auto& stepper = *static_cast<CvodeStepper*>(self);
  const std::vector<double> found = stepper.motion_.conditions(t, N_VGetArrayPointer(y));
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool is_at_corner = t == stepper.start_.t && (stepper.crossed_[i] != 0 || found[i] == 0);
    const bool is_known = !is_at_corner && std::isfinite(found[i]) && !stepper.is_passed_freely(i);
    values[i] = !is_known ? 0.0 : found[i] == 0 ? kUpperSide : found[i];
  }
  return 0;
}

void CvodeStepper::keep_message(int, const char*, const char*, char* message, void* self) {
  static_cast<CvodeStepper*>(self)->message_ = message;
}

double CvodeStepper::next_row(double t) const {
  const double none = kNoTime * std::max(1.0, std::abs(t));
  const double end =
      std::min(control_.end, next_instant(control_.periods.data(), static_cast<int>(control_.periods.size()), t));
  for (const double row : motion_.inputs().rows)
    if (row > t + none && row < end) return row;
  return end;
}

Status CvodeStepper::set_sampled(GenericState& state) {
  const Engine& engine = motion_.engine();
  if (!engine.sample || std::abs(state.t - sampled_) <= same_instant(state.t)) return {};
  sampled_ = state.t;
  bool any = false;
  return engine.sample(state, 0, any);
}

void CvodeStepper::make(const GenericState& state) {
  const auto size = static_cast<sunindextype>(motion_.size());
  const auto vector = [&] { return Owned<_generic_N_Vector>(N_VNew_Serial(size, context_.get()), N_VDestroy); };
  for (Owned<_generic_N_Vector>* of : {&y_, &dense_, &absolute_}) *of = vector();
  for (sunindextype i = 0; i < size; ++i)
    NV_Ith_S(absolute_.get(), i) = control_.tolerance * motion_.size_of(static_cast<std::size_t>(i));
  const int method = control_.method == ErrorControl::Method::bdf ? CV_BDF : CV_ADAMS;
  cvode_ = {CVodeCreate(method, context_.get()), [](void* memory) { CVodeFree(&memory); }};
  motion_.copy(state, N_VGetArrayPointer(y_.get()));
  CVodeInit(cvode_.get(), rates, state.t, y_.get());
  CVodeSVtolerances(cvode_.get(), control_.tolerance, absolute_.get());
  CVodeSetUserData(cvode_.get(), this);
  CVodeSetErrHandlerFn(cvode_.get(), keep_message, this);
  make_solver();
  if (motion_.corners() == 0) return;
  CVodeRootInit(cvode_.get(), static_cast<int>(motion_.corners()), conditions);
  CVodeSetNoInactiveRootWarn(cvode_.get());
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
  const Engine& engine = motion_.engine();
  engine.set_inputs(motion_.inputs().at(state.t));
  settle_charts(engine.balls, state);
  Status status = engine.project(state);
  if (status.ok()) status = set_sampled(state);
  if (!status.ok()) return status;
  end_ = next_row(state.t);
  t_ = state.t;
  start_ = last_ = state;
  motion_.begin(state, end_);
  take_sides();
  if (cvode_) {
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

void CvodeStepper::take_sides() {
  const std::size_t corners = motion_.corners();
  for (std::vector<int>* of : {&crossed_, &loose_, &stays_}) of->resize(corners);
  if (corners == 0) return;
  std::vector<double> y(motion_.size());
  motion_.copy(start_, y.data());
  std::vector<double> sides = motion_.conditions(t_, y.data());
  for (std::size_t i = 0; i < corners; ++i) {
    const int side = sides[i] > 0 ? 1 : sides[i] < 0 ? -1 : 0;
    sides[i] = loose_[i] != 0 || is_passed_freely(i) ? 0 : crossed_[i] != 0 ? crossed_[i] : side;
  }
  motion_.hold(std::move(sides));
}

bool CvodeStepper::passes_corners() {
  std::vector<int> found(motion_.corners());
  CVodeGetRootInfo(cvode_.get(), found.data());
  double h = 0;
  CVodeGetLastStep(cvode_.get(), &h);
  h *= kBesideCorner;
  if (CVodeGetDky(cvode_.get(), t_ - h, 0, dense_.get()) != CV_SUCCESS) {  // the step has just begun: rounding found it
    std::ranges::transform(found, stays_, stays_.begin(), [](int at, int stays) { return at != 0 ? 1 : stays; });
    return true;
  }
  // At this distance beyond the corner, laws that depend on the changed ones have changed their side too.
  N_VLinearSum(2, y_.get(), -1, dense_.get(), dense_.get());
  const double *y = N_VGetArrayPointer(y_.get()), *beyond = N_VGetArrayPointer(dense_.get());
  std::vector<double> sides = motion_.conditions(t_ + h, beyond);
  for (std::size_t i = 0; i < found.size(); ++i)
    sides[i] = found[i] != 0 ? found[i] : sides[i] > 0 ? 1 : sides[i] < 0 ? -1 : 0;
  const GenericDerivative jump = motion_.change_by(t_, y, sides), later = motion_.change_by(t_ + h, beyond, sides);
  const double step = h / kBesideCorner;
  bool is_large = false;
  const auto look_at = [&](const std::vector<double>& now, const std::vector<double>& then, std::size_t first) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double slope = (then[i] - now[i]) / h;
      const double weight =
          control_.tolerance * std::abs(y[first + i]) + NV_Ith_S(absolute_.get(), static_cast<sunindextype>(first + i));
      is_large = is_large || !(std::abs(now[i]) * step + std::abs(slope) * step * step / 2 <= weight);
    }
  };
  look_at(jump.zdd, later.zdd, jump.zdd.size());
  look_at(jump.xd, later.xd, 2 * jump.zdd.size());
  motion_.hold(std::move(sides));
  if (!is_large) return false;
  crossed_ = std::move(found);
  loose_.assign(loose_.size(), 0);
  ++record_.corners;
  return true;
}

bool CvodeStepper::went_astray() {
  const std::vector<double>& sides = motion_.sides();
  const std::vector<double> now = motion_.conditions(t_, N_VGetArrayPointer(y_.get()));
  bool any = false;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!(now[i] * sides[i] < 0)) continue;
    loose_[i] = 1;
    any = true;
  }
  if (!any) return false;
  ++corners_;
  step_back();
  return true;
}

void CvodeStepper::step_back() {
  t_ = last_.t;
  motion_.follow(last_);
  starts_anew_ = true;
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

Status CvodeStepper::arrive(int flag) {
  GenericState closed;
  const double* y = N_VGetArrayPointer(y_.get());
  const Status status = motion_.close(t_, y, closed);
  if (!status.ok()) return status;
  if (leaps_.look(last_, closed)) {
    step_back();
    const Status leapt = leaps_.status();
    if (!leapt.ok()) record_.failure = fmt::format("At t = {:.10g} s steps of every length leave the branch", t_);
    return leapt;
  }
  motion_.follow(closed);
  std::vector<double> values(motion_.size());
  motion_.copy(closed, values.data());
  double open = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double weight = control_.tolerance * std::abs(values[i]) + NV_Ith_S(absolute_.get(), i);
    open = std::max(open, std::abs(values[i] - y[i]) / weight);
  }
  corners_ += flag == CV_ROOT_RETURN ? 1 : 0;
  const bool is_at_corner = flag == CV_ROOT_RETURN && passes_corners();
  starts_anew_ = is_at_corner || corners_ == kMostCorners || flag == CV_TSTOP_RETURN || open > kOpenLoops ||
                 leaves_charts(motion_.engine().balls, closed);
  if (!is_at_corner && motion_.corners() > 0) {
    crossed_.assign(crossed_.size(), 0);
    if (flag != CV_ROOT_RETURN && went_astray()) return {};
  }
  last_ = closed;
  return {};
}

Status CvodeStepper::advance() {
  if (starts_anew_) {
    GenericState state = motion_.guess();
    state.t = t_;
    if (const Status status = start(state); !status.ok()) return status;
  }
  CVodeSetMaxStep(cvode_.get(), leaps_.longest(t_));
  const int flag = CVode(cvode_.get(), end_, y_.get(), &t_, CV_ONE_STEP);
  count();
  if (flag < 0) return fail(flag);
  trouble_ = {};
  return arrive(flag);
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
  corners_ = 0;
  stays_.assign(stays_.size(), 0);
  for (long steps = 0; t_ < target - none; ++steps) {
    if (steps == kMostSteps) return fail(CV_SUCCESS);
    if (const Status status = advance(); !status.ok()) return status;
  }
  const Status status = at(std::min(target, t_), state);
  if (!status.ok()) return status;
  given_ = state.t = target;
  return graver(status, leaps_.take_notice());
}

}  // namespace

bool has_cvode() { return true; }

std::unique_ptr<Stepper> make_cvode_stepper(ControlledMotion motion, BranchGuard guard, const ErrorControl& control,
                                            ErrorControlRecord& record) {
  return std::make_unique<CvodeStepper>(std::move(motion), std::move(guard), control, record);
}

}  // namespace mbgen

#else

namespace mbgen {

bool has_cvode() { return false; }

std::unique_ptr<Stepper> make_cvode_stepper(ControlledMotion, BranchGuard, const ErrorControl&, ErrorControlRecord&) {
  return {};
}

}  // namespace mbgen

#endif
