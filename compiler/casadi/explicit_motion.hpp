#pragma once
// The motion as xd = f(x, u, p, t) and y = h(x, u, p, t) over independent coordinates: the programs of a solver, one
// put into the other.

#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/solver/layout.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Places of the arguments, one after another: x (positions and velocities of the independent coordinates, auxiliary
/// states), u (inputs), p (tunable parameters), t.
struct ArgumentLayout {
  std::vector<int> free;  ///< independent coordinates, ascending
  int auxiliary = 0, inputs = 0, parameters = 0;

  int count() const { return static_cast<int>(free.size()); }
  int states() const { return 2 * count() + auxiliary; }
  int input(int i) const { return states() + i; }
  int parameter(int i) const { return input(inputs) + i; }
  int time() const { return parameter(parameters); }
};

ArgumentLayout argument_layout(const SolverLayout& layout, const Topology& topology, const Analysis& analysis);

/// Programs over the positions of all coordinates (Array::z), of which the dependent ones are closed or a guess, the
/// velocities of the independent ones (zd), x, t, in and par. Array::pivot, inertia and hold are monitors: those of
/// multipliers follow those of accelerations.
struct ExplicitMotion {
  Program closing;  ///< Newton step of the closures: dz, residual, pivot; empty where there is nothing to close
  Program rates;    ///< zd and zdd of the independent coordinates, in this order, by their places in `free`; xd
  Program outputs;  ///< y
};

ExplicitMotion explicit_motion(const Programs& programs, const SolverLayout& layout, const ArgumentLayout& arguments);

/// Derivatives of the rates and of the outputs along a direction of the arguments, Array::seed by the places of
/// ArgumentLayout; the monitors themselves. Dependent positions and velocities follow by the implicit function theorem:
/// the Newton step at a closed position does not depend on the dependent ones. `closing` is empty.
ExplicitMotion explicit_slopes(const Programs& programs, const SolverLayout& layout, const ArgumentLayout& arguments);

/// A derivative along a direction in two programs: `factors` reads no direction, and gives the values that
/// `directions` needs as Array::derived, beside the monitors.
struct SplitSlopes {
  Program factors, directions;
};

SplitSlopes split_slopes(const Program& slopes);

/// Per value: whether it depends on the direction, Array::seed.
std::vector<bool> along_direction(const Program& program);

}  // namespace mbgen
