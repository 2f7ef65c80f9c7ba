#pragma once
// When independent coordinates that an importer holds are no longer good enough: see held.hpp.

namespace mbgen {

/// How well held coordinates serve, see held_service, below which others are chosen: an integrator that looks at the
/// end of its steps alone should meet this before it meets kLostPivot.
constexpr double kWornPivot = 0.3;
/// The same at an event: who found it by a root may stand a little before it.
constexpr double kWornAtEvent = 0.33;
/// The same below which a state in the held coordinates no longer tells the ways of assembly apart.
constexpr double kLostPivot = 0.05;
/// The smallest pivot of held coordinates over that of full pivoting: a smaller share is bad from the start.
constexpr double kBadPivot = 0.01;

}  // namespace mbgen
