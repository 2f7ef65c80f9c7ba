#pragma once
// Notes: messages of a command about a file in which nothing is wrong.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compiler/compile.hpp"
#include "compiler/text/diagnostic.hpp"

namespace mbgen {

/// Notes on unused parts of a model's files, on locked loops and their modes, and on bodies that nothing holds.
Diagnostics all_notes(const Compilation& compilation);

/// One note as people read it, without the line of text that it names.
std::string note_text(const Diagnostic& note);

/// Notes on standard error.
void print_notes(const Diagnostics& notes);

/// How many notes there are and where to read them, on standard error; nothing for none.
void count_notes(const Compilation& compilation);

/// Problems or notes as machines read them, an array.
nlohmann::ordered_json diagnostics_json(const Diagnostics& diagnostics);

}  // namespace mbgen
