#pragma once
// Measures of generated code that need no clock, and the time of generation.

#include <optional>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen::compare {

struct CodeFacts {
  OperationCount operations;         ///< of one evaluation
  long hot_bytes = 0;                ///< machine code of the functions that compute accelerations, g++, this processor
  long text_bytes = 0;               ///< of the whole object
  double generation_seconds = 0;     ///< processor time from the model's text to the files
  double compile_seconds = 0;        ///< processor time for the emitted file, g++ with the flags of its CMake file
  std::optional<long> instructions;  ///< of one evaluation by callgrind, code for x86-64-v3; none without valgrind
};

/// Emits the solver of a model once more, compiles it and counts. Fails: UserError when g++ does not take it.
CodeFacts code_facts(const Model& model, const std::vector<LoadedState>& states);

}  // namespace mbgen::compare
