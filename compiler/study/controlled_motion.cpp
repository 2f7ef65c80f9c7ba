#include "compiler/study/controlled_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbgen {
namespace {

/// rad or m by which closing the loops may move a coordinate of a trial state: more is another way to close them.
constexpr double kLargestClosing = 0.1;

}  // namespace

void ControlledMotion::begin(const GenericState& state, double end) {
  guess_ = state;
  end_ = end;
}

void ControlledMotion::copy(const GenericState& state, double* y) const {
  for (const std::vector<double>* part : {&state.z, &state.zd, &state.x}) y = std::copy(part->begin(), part->end(), y);
}

Status ControlledMotion::close(double t, const double* y, GenericState& state) const {
  state = guess_;
  state.t = t;
  for (std::vector<double>* part : {&state.z, &state.zd, &state.x}) {
    std::copy_n(y, part->size(), part->begin());
    y += part->size();
  }
  y -= size();
  engine_.set_inputs(inputs_.at(std::min(t, std::nextafter(end_, -std::numeric_limits<double>::infinity()))));
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
  for (const std::vector<double>* part :
       std::initializer_list<const std::vector<double>*>{&closed.zd, &derivative.zdd, &derivative.xd})
    f = std::copy(part->begin(), part->end(), f);
  return {};
}

Status ControlledMotion::rates(double t, const double* y, double* f) const {
  GenericState closed;
  const Status status = close(t, y, closed);
  return status.ok() ? rates_of(closed, f) : status;
}

}  // namespace mbgen
