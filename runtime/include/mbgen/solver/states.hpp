#pragma once
// Operations of integrators on states and rates of any System: arrays of doubles or floats or of vectors, or containers
// with size(), see integrators.hpp.

#include <cstddef>
#include <type_traits>

#include "mbgen/lanes/array_lanes.hpp"
#include "mbgen/math/precision.hpp"
#include "mbgen/number.hpp"
#include "mbgen/status.hpp"

namespace mbgen {

/// Rates of a whole state: of z, and of zd and x.
template <class System>
struct StateRates {
  decltype(System::State::zd) zd;
  typename System::Derivative derivative;
};

namespace integrator_detail {

template <class Value, std::size_t N>
constexpr std::size_t size_of(const Value (&)[N]) noexcept {
  return N;
}
template <class Container>
std::size_t size_of(const Container& values) noexcept {
  return values.size();
}

template <class Value, std::size_t N>
void copy(const Value (&from)[N], Value (&to)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) to[i] = from[i];
}
template <std::size_t N>
void copy(const double (&from)[N], double (&to)[N]) noexcept {
  copy_array(from, to);
}
template <std::size_t N>
void copy(const float (&from)[N], float (&to)[N]) noexcept {
  copy_array(from, to);
}
template <class Container>
void copy(const Container& from, Container& to) noexcept {
  to = from;
}

/// Charts of balls, where states have them.
template <class State>
auto copy_charts(const State& from, State& to, int) noexcept -> decltype(copy(from.charts, to.charts)) {
  copy(from.charts, to.charts);
}
template <class State>
void copy_charts(const State&, State&, long) noexcept {}

/// Member by member: the copy of a large struct would be a call of memcpy, which a bare target may not have.
template <class State>
void copy_state(const State& from, State& to) noexcept {
  copy(from.z, to.z);
  copy(from.zd, to.zd);
  copy(from.x, to.x);
  to.t = from.t;
  copy_charts(from, to, 0);
}

template <class System>
void copy_rates(const StateRates<System>& from, StateRates<System>& to) noexcept {
  copy(from.zd, to.zd);
  copy(from.derivative.zdd, to.derivative.zdd);
  copy(from.derivative.xd, to.derivative.xd);
}

/// to += weight * from.
template <class Values>
void add(double weight, const Values& from, Values& to) noexcept {
  const auto factor = static_cast<WeightOf<Values>>(weight);
  for (std::size_t i = 0; i < size_of(to); ++i) to[i] += factor * from[i];
}

template <class Values>
void clear(Values& values) noexcept {
  for (std::size_t i = 0; i < size_of(values); ++i) values[i] = 0;
}

template <class System>
Status evaluate(const System& system, const typename System::State& state, StateRates<System>& rates) noexcept {
  copy(state.zd, rates.zd);
  return system.derivative(state, rates.derivative);
}

/// Entry `i` of start + sum of weights[k] values[k].
template <class Values, class Weight, std::size_t K>
void combine_entry(const Values& start, const Weight (&weights)[K], const Values* const (&values)[K], std::size_t i,
                   Values& to) noexcept {
  std::decay_t<decltype(to[0])> sum{};
  for (std::size_t k = 0; k < K; ++k) sum += weights[k] * (*values[k])[i];
  to[i] = start[i] + sum;
}

/// to = start + sum of weights[k] values[k].
template <class Values, class Weight, std::size_t K>
void combine(const Values& start, const Weight (&weights)[K], const Values* const (&values)[K], Values& to) noexcept {
  for (std::size_t i = 0; i < size_of(start); ++i) combine_entry(start, weights, values, i, to);
}
/// The same of doubles or floats, in lanes.
template <class Real, std::size_t N, std::size_t K>
void combine(const Real (&start)[N], const Real (&weights)[K], const Real (*const (&values)[K])[N],
             Real (&to)[N]) noexcept {
  using namespace array_detail;
  const auto several = [&](std::size_t i) {
    constexpr int width = width_for<Real>(N);
    LanesOf<width, Real> sum = {};
    for (std::size_t k = 0; k < K; ++k) sum += weights[k] * lanes_at<width>(*values[k] + i);
    put_lanes(lanes_at<width>(start + i) + sum, to + i);
  };
  for_all<N, Real>(several, [&](std::size_t i) { combine_entry(start, weights, values, i, to); });
}

/// state = start + sum of weights[k] rates[k]; the time is the caller's. weights: s. The states must not overlap.
template <class System, std::size_t K>
void advance(const typename System::State& start, const double (&weights)[K],
             const StateRates<System>* const (&rates)[K], typename System::State& state) noexcept {
  WeightOf<decltype(System::State::z)> factors[K];
  const decltype(System::State::z)* zd[K];
  const decltype(System::State::zd)* zdd[K];
  const decltype(System::State::x)* xd[K];
  for (std::size_t k = 0; k < K; ++k) {
    factors[k] = static_cast<WeightOf<decltype(System::State::z)>>(weights[k]);
    zd[k] = &rates[k]->zd;
    zdd[k] = &rates[k]->derivative.zdd;
    xd[k] = &rates[k]->derivative.xd;
  }
  combine(start.z, factors, zd, state.z);
  combine(start.zd, factors, zdd, state.zd);
  combine(start.x, factors, xd, state.x);
}

/// False when an entry is not finite, or the sum of all overflows.
template <class Values>
bool sum_is_finite(const Values&) noexcept {
  return false;
}
template <class Real, std::size_t N, class = std::enable_if_t<kIsNumber<Real>>>
bool sum_is_finite(const Real (&values)[N]) noexcept {
  Total<Real> total(0);
  total.add(values, static_cast<int>(N));
  return is_finite(total.value());
}

/// Fails: not_a_number, auxiliary_not_a_number for values that are not finite.
template <class State>
Status check_finite(const State& state) noexcept {
  if (sum_is_finite(state.z) && sum_is_finite(state.zd) && sum_is_finite(state.x)) return {};
  for (std::size_t i = 0; i < size_of(state.z); ++i) {
    if (!is_finite(state.z[i]) || !is_finite(state.zd[i])) return {Code::not_a_number, static_cast<int>(i)};
  }
  for (std::size_t i = 0; i < size_of(state.x); ++i) {
    if (!is_finite(state.x[i])) return {Code::auxiliary_not_a_number, static_cast<int>(i)};
  }
  return {};
}

}  // namespace integrator_detail

}  // namespace mbgen
