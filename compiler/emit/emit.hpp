#pragma once
// The door of the emit room: Programs -> C++ text. The same input gives the same bytes on any machine.

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "compiler/trace/trace.hpp"

#include <string>
#include <vector>

namespace mbgen {

/// A file to write, path relative to the output directory.
struct EmittedFile {
  std::string path;
  std::string text;
};

struct EmitOptions {
  bool runtime_headers = true;   ///< add the runtime's headers under mbgen/, so that the directory stands alone
};

/// The specialised solver: <model>.hpp, <model>.cpp, <model>.json (manifest), CMakeLists.txt, and the runtime headers.
/// Requires: `programs` traced from the same model, topology and analysis.
std::vector<EmittedFile> emit(const Programs& programs, const Model& model, const Topology& topology,
                              const Analysis& analysis, const EmitOptions& options = {});

/// C++ identifier for a model name: unique within `taken`, no keyword, ASCII. Adds the result to `taken`.
std::string identifier(const std::string& name, std::vector<std::string>& taken);

}  // namespace mbgen
