#pragma once
// What integrators do with states and rates of any System: arrays of doubles or of their vectors, or containers with
// size(), see integrators.hpp.

#include <cmath>
#include <cstddef>
#include <type_traits>

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
template <class Container>
void copy(const Container& from, Container& to) noexcept {
  to = from;
}

/// Member by member: the copy of a large struct would be a call of memcpy, which a bare target may not have.
template <class State>
void copy_state(const State& from, State& to) noexcept {
  copy(from.z, to.z);
  copy(from.zd, to.zd);
  copy(from.x, to.x);
  to.t = from.t;
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
  for (std::size_t i = 0; i < size_of(to); ++i) to[i] += weight * from[i];
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

/// state = start + sum of weights[k] rates[k]; the time is the caller's. weights: s.
template <class System, int N>
void advance(const typename System::State& start, const double (&weights)[N],
             const StateRates<System>* const (&rates)[N], typename System::State& state) noexcept {
  using Value = std::decay_t<decltype(start.z[0])>;
  for (std::size_t i = 0; i < size_of(start.z); ++i) {
    Value dz{}, dzd{};
    for (int k = 0; k < N; ++k) {
      dz += weights[k] * rates[k]->zd[i];
      dzd += weights[k] * rates[k]->derivative.zdd[i];
    }
    state.z[i] = start.z[i] + dz;
    state.zd[i] = start.zd[i] + dzd;
  }
  for (std::size_t i = 0; i < size_of(start.x); ++i) {
    Value dx{};
    for (int k = 0; k < N; ++k) dx += weights[k] * rates[k]->derivative.xd[i];
    state.x[i] = start.x[i] + dx;
  }
}

/// not_a_number when a coordinate, velocity or auxiliary state is not finite.
template <class State>
Status check_finite(const State& state) noexcept {
  for (std::size_t i = 0; i < size_of(state.z); ++i) {
    if (!std::isfinite(state.z[i]) || !std::isfinite(state.zd[i])) return {Code::not_a_number, static_cast<int>(i)};
  }
  for (std::size_t i = 0; i < size_of(state.x); ++i) {
    if (!std::isfinite(state.x[i])) return {Code::not_a_number, -1};
  }
  return {};
}

}  // namespace integrator_detail

}  // namespace mbgen
