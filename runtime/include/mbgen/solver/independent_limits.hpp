#pragma once
// When independent coordinates that an importer holds are no longer good enough: see independent.hpp.

namespace mbgen {

/// Condition of independent coordinates, see independent_condition, below which others are chosen: an integrator that
/// checks only the ends of its steps should reach it before kLostPivot.
constexpr double kWornPivot = 0.3;
/// The same at an event: root finding may stop slightly before it.
constexpr double kWornAtEvent = 0.33;
/// Condition below which a state in the independent coordinates does not determine the assembly mode.
constexpr double kLostPivot = 0.05;
/// Smallest pivot of independent coordinates, relative to full pivoting: a smaller ratio is ill-conditioned from the
/// start.
constexpr double kBadPivot = 0.01;

}  // namespace mbgen
