#pragma once
// Variables of an FMU, their states, and their dependencies.

#include <set>
#include <string>
#include <vector>

#include "compiler/emit/context.hpp"
#include "compiler/fmu/fmu.hpp"

namespace mbgen {

/// A scalar variable; its value reference is its place in the list. The groups follow each other as mbgen/fmu.hpp
/// counts them: time, tunable parameters, inputs, outputs with the energies, z, zd, zdd, x, xd, q, qd, qdd, parameters
/// of the start, event indicators.
struct FmuVariable {
  enum class Causality { independent, parameter, input, output, local };
  enum class Start { none, exact, approx, calculated };
  Slot slot;  ///< number of the programs that it shows; of a state in place of a coordinate, that coordinate's
  std::string name, unit, description;
  Causality causality = Causality::local;
  Start start = Start::calculated;
  double value = 0;        ///< at the start, where it is exact, approximate or an input's
  int derivative_of = -1;  ///< value reference of the variable whose derivative it is
  Presentation shown = {};
  bool is_fixed = false;     ///< of a parameter: it acts before the initialisation only
  bool reinit = false;       ///< whether an event may change this state
  bool is_discrete = false;  ///< whether it changes at instants alone: a sampled value
};

/// An unknown and the knowns that it depends on, as value references.
struct FmuUnknown {
  int variable = 0;
  std::set<int> dependencies;
};

/// The continuous states are positions and velocities of the independent coordinates, and the auxiliary states but for
/// sampled values, which are discrete. Where an event may choose another independent coordinate of a loop block, the
/// states are q and qd, which are those of the chosen coordinate; so they are for balls whose angles an event may
/// exchange; else they are z and zd. Where bodies roll, more positions are free than velocities: these are no states,
/// and the FMU has co-simulation alone.
struct FmuLayout {
  std::vector<FmuVariable> variables;
  std::vector<int> independent;  ///< coordinates at the start, ascending
  std::vector<int> chosen;       ///< places among them where an event may choose another one, or other angles
  std::vector<int> block_of;     ///< per coordinate: loop block whose coordinates are chosen, else -1
  std::vector<int> undriven;     ///< coordinates that no motion drives
  bool has_states = true;        ///< whether importers may integrate the model
  std::vector<int>
      indicator_blocks;  ///< of the event indicators: a loop block whose coordinates are chosen, -1 for balls
  std::vector<FmuUnknown> outputs, derivatives, initial_unknowns;
};

/// programs: after the passes. initial: state at the start. version: decides whether tunable parameters are among what
/// outputs and derivatives depend on; FMI 2 knows them at the initialisation only.
FmuLayout fmu_layout(const EmitContext& context, const Programs& programs, const InitialState& initial,
                     FmiVersion version);

/// Adds an event indicator of each loop block whose coordinates may be chosen, after its first loop, and one of all
/// balls.
void add_indicators(const EmitContext& context, FmuLayout& fmu);

/// Nominal values of the continuous states: 1 rad or the extent of the model, as much per second, or what they start
/// with where that is more; a tenth of a tyre's radius for its slips. They stay whatever coordinates are chosen.
void add_nominals(const EmitContext& context, const InitialState& initial, FmuLayout& fmu);

}  // namespace mbgen
