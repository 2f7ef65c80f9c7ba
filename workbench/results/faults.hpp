#pragma once
// Faults of a file of a table.

#include <optional>
#include <string>
#include <string_view>

#include "compiler/text/diagnostic.hpp"

namespace mbgen {

/// A fault of a line of a file, line 0 for the whole file.
Diagnostic table_fault(const std::string& file, int line, std::string message, std::string hint = {});

/// Refuses bytes that are no text, control characters but for tabs and ends of lines, before any of them is repeated in
/// a message. kind: of the file that is expected. Fails: Diagnostic with line and column of the first.
std::optional<Diagnostic> no_text(std::string_view bytes, const std::string& file, const char* kind);

}  // namespace mbgen
