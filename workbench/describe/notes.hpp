#pragma once
// Notes: messages about a file without an error.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compiler/compile.hpp"
#include "compiler/text/diagnostic.hpp"

namespace mbgen {

/// Notes on unused parts of a model's files, on locked loops and their modes, and on unconstrained bodies.
Diagnostics all_notes(const Compilation& compilation);

/// One note as text, without the quoted line of the file.
std::string note_text(const Diagnostic& note);

/// Prints notes on standard error.
void print_notes(const Diagnostics& notes);

/// Prints the number of notes, and the command to read them, on standard error; nothing for none.
void count_notes(const Compilation& compilation);

/// Problems or notes as a JSON array.
nlohmann::ordered_json diagnostics_json(const Diagnostics& diagnostics);

}  // namespace mbgen
