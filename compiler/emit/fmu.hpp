#pragma once
// The files of a Functional Mock-up Unit, of FMI 2 or 3.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/emit/files.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "compiler/trace/trace.hpp"

namespace mbgen {

/// An FMU before it is compiled and packed.
struct FmuFiles {
  std::string identifier;            ///< modelIdentifier: the name of the solver
  std::vector<EmittedFile> packed;   ///< modelDescription.xml and everything under sources/
  std::vector<EmittedFile> headers;  ///< the standard's, for compiling here; importers have their own
  std::vector<std::string> sources;  ///< files of sources/ that are compiled
  std::string large;                 ///< the one of them that is large, and called too seldom to be made fast
};

/// programs: after the passes, with all that depends on parameters; emitted: as they are emitted. initial: the model's,
/// loops closed.
FmuFiles emit_fmu(const Programs& programs, const Programs& emitted, const Model& model, const Topology& topology,
                  const Analysis& analysis, const InitialState& initial, FmiVersion version);

}  // namespace mbgen
