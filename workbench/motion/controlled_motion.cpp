#include "workbench/motion/controlled_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbgen {
namespace {

/// Largest change of a coordinate, rad or m, by closing the loops of a trial state: beyond it another assembly mode is
/// likely.
constexpr double kLargestClosing = 0.1;

GenericState with_values(GenericState state, double t, const double* y) {
  state.t = t;
  for (std::vector<double>* part : {&state.z, &state.zd, &state.x}) {
    std::copy_n(y, part->size(), part->begin());
    y += part->size();
  }
  return state;
}

double side_of(double condition) { return condition >= 0 ? 1 : -1; }

}  // namespace

void ControlledMotion::begin(const GenericState& state, double end) {
  guess_ = state;
  end_ = end;
}

void ControlledMotion::copy(const GenericState& state, double* y) const {
  for (const std::vector<double>* part : {&state.z, &state.zd, &state.x}) y = std::copy(part->begin(), part->end(), y);
}

std::vector<double> ControlledMotion::inputs_at(double t) const {
  return inputs_.at(std::min(t, std::nextafter(end_, -std::numeric_limits<double>::infinity())));
}

Status ControlledMotion::close(double t, const double* y, GenericState& state) const {
  state = with_values(guess_, t, y);
  engine_.set_inputs(inputs_at(t));
  const Status status = engine_.project(state);
  if (!status.ok()) return status;
  for (std::size_t i = 0; i < state.z.size(); ++i)
    if (!(std::abs(state.z[i] - y[i]) <= kLargestClosing)) return {Code::loop_not_closed, -1};
  return {};
}

Status ControlledMotion::rates_of(const GenericState& closed, double* f) const {
  ++evaluations_;
  GenericDerivative derivative;
  const LoadedState at{closed, std::vector<double>(closed.z.size(), 0.0)};
  const Status status = engine_.accelerations(at, derivative);
  if (!status.ok()) return status;
  if (!sides_.empty()) keep_sides(closed, derivative);
  for (const std::vector<double>* part :
       std::initializer_list<const std::vector<double>*>{&closed.zd, &derivative.zdd, &derivative.xd})
    f = std::copy(part->begin(), part->end(), f);
  return {};
}

void ControlledMotion::keep_sides(const GenericState& closed, GenericDerivative& rates) const {
  if (std::ranges::any_of(closed.charts, [](double chart) { return chart != 0; })) return;
  const std::vector<double> inputs = inputs_at(closed.t);
  std::vector<double> own = corners_->conditions(closed, inputs);
  for (double& side : own) side = side_of(side);
  std::vector<double> kept = own;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (sides_[i] != 0) kept[i] = sides_[i];
  if (kept == own) return;
  const GenericDerivative change = corners_->difference(closed, inputs, kept, own);
  if (!check_finite(change).ok()) return;
  for (std::size_t i = 0; i < change.zdd.size(); ++i) rates.zdd[i] += change.zdd[i];
  for (std::size_t i = 0; i < change.xd.size(); ++i) rates.xd[i] += change.xd[i];
}

GenericState ControlledMotion::open(double t, const double* y) const {
  return in_users_angles(engine_.balls, with_values(guess_, t, y));
}

std::vector<double> ControlledMotion::conditions(double t, const double* y) const {
  return corners_->conditions(open(t, y), inputs_at(t));
}

GenericDerivative ControlledMotion::change_by(double t, const double* y, const std::vector<double>& sides) const {
  std::vector<double> from = conditions(t, y), to;
  for (std::size_t i = 0; i < from.size(); ++i) {
    from[i] = sides_[i] != 0 ? sides_[i] : side_of(from[i]);
    to.push_back(sides[i] != 0 ? sides[i] : from[i]);
  }
  return corners_->difference(open(t, y), inputs_at(t), to, from);
}

Status ControlledMotion::rates(double t, const double* y, double* f) const {
  GenericState closed;
  const Status status = close(t, y, closed);
  return status.ok() ? rates_of(closed, f) : status;
}

}  // namespace mbgen
