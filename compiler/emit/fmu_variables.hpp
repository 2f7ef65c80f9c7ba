#pragma once
// Variables of an FMU, their states, and what depends on what.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/emit/emit.hpp"
#include "compiler/emit/interface_text.hpp"

namespace mbgen {

/// A scalar variable; its value reference is its place in the list. The groups follow each other as mbgen/fmu.hpp
/// counts them: time, parameters, inputs, outputs with the energies, z, zd, zdd, x, xd.
struct FmuVariable {
  enum class Causality { independent, parameter, input, output, local };
  enum class Start { none, exact, approx, calculated };
  std::string name, unit, description;
  Causality causality = Causality::local;
  Start start = Start::calculated;
  double value = 0;        ///< at the start, where it is exact, approximate or an input's
  int derivative_of = -1;  ///< value reference of the state whose derivative it is
};

/// An unknown and the knowns that it depends on, as value references.
struct FmuUnknown {
  int variable = 0;
  std::set<int> dependencies;
};

/// The continuous states are the positions of all coordinates that no motion drives, the velocities of the independent
/// ones, and the auxiliary states. A dependent position is the guess from which its loop is closed: nothing depends on
/// it.
struct FmuLayout {
  std::vector<FmuVariable> variables;
  std::vector<int> positions, velocities;  ///< coordinates whose position or velocity is a state, ascending
  std::vector<FmuUnknown> outputs, derivatives, initial_unknowns;
};

/// programs: after the passes. initial: state at the start.
FmuLayout fmu_layout(const EmitContext& context, const Programs& programs, const InitialState& initial);

}  // namespace mbgen
