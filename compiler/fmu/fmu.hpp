#pragma once
// The door of the FMU room: Programs -> the files of a Functional Mock-up Unit of FMI 2 or 3. The same input gives the
// same bytes on any machine.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/emit/files.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Of the Functional Mock-up Interface.
enum class FmiVersion { two = 2, three = 3 };

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
FmuFiles emit_fmu(const Programs& programs, const WrittenPrograms& emitted, const Model& model,
                  const Topology& topology, const Analysis& analysis, const InitialState& initial, FmiVersion version);

/// Name of an input, parameter or output in an FMU: its own name, or with a prefix where that is taken: `time` is the
/// independent variable.
std::string fmu_input_name(const std::string& name);
std::string fmu_parameter_name(const std::string& name);
std::string fmu_output_name(const Model& model, const std::string& name);

}  // namespace mbgen
