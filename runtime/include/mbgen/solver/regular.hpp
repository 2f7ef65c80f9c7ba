#pragma once
// Solvers of regular positions alone: without all that a step does near singular positions of loops, in other charts of
// balls and where another partition is to be chosen. `mbgen simulate` starts with one, which compiles in half the time,
// and loads the whole solver at the first call that ends here. Up to there both give the same bits.

#include <type_traits>

#include "mbgen/status.hpp"

namespace mbgen {

/// Only of a solver of regular positions alone: the call is one for the whole solver; its results are untouched.
constexpr Code kNotRegular = static_cast<Code>(-6);

/// Whether a System, of blocks.hpp or of integrators.hpp, is one of regular positions alone. It has no
/// chosen_accelerations, or no functions of passages, and bool moves_far(const State& from, const State& to, double
/// least) const noexcept in place of watch_way.
template <class System, class = void>
inline constexpr bool kRegularOnly = false;
template <class System>
inline constexpr bool kRegularOnly<System, std::void_t<decltype(System::kRegularOnly)>> = System::kRegularOnly;

}  // namespace mbgen
