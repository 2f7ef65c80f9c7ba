#include "compiler/model/diagnostic.hpp"

#include <fmt/format.h>

namespace mbgen {
namespace {

/// Blanks up to the column, with the line's own tabs and without the tails of UTF-8 characters, so that the caret
/// aligns.
std::string padding(const std::string& line, int column) {
  std::string blanks;
  for (int i = 0; i + 1 < column && i < static_cast<int>(line.size()); ++i) {
    const unsigned char byte = static_cast<unsigned char>(line[static_cast<std::size_t>(i)]);
    if ((byte & 0xC0u) == 0x80u) continue;
    blanks += byte == '\t' ? '\t' : ' ';
  }
  return blanks;
}

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
  const Where& where = diagnostic.where;
  std::string text = where.file;
  if (where.line > 0) text += fmt::format(":{}:{}", where.line, where.column);
  text += ": ";
  if (!where.pointer.empty()) text += where.pointer + ": ";
  text += diagnostic.message + "\n";
  const std::string& line = diagnostic.source_line.empty() ? where.line_text : diagnostic.source_line;
  if (!line.empty()) text += "  " + line + "\n  " + padding(line, where.column) + "^\n";
  if (!diagnostic.hint.empty()) text += "  hint: " + diagnostic.hint + "\n";
  return text;
}

std::string to_text(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += to_text(diagnostic);
  return text;
}

}  // namespace mbgen
