#include "workbench/describe/notes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compiler/analysis/notes.hpp"
#include "compiler/analysis/unrestrained.hpp"
#include "workbench/host/message.hpp"

namespace mbgen {

Diagnostics all_notes(const Compilation& compilation) {
  Diagnostics notes = compilation.model.notes;
  for (Diagnostic& note : analysis_notes(compilation.model, compilation.topology, compilation.analysis))
    notes.push_back(std::move(note));
  for (Diagnostic& note : unrestrained_motions(compilation.model, compilation.topology, compilation.analysis))
    notes.push_back(std::move(note));
  return grouped(std::move(notes));
}

void count_notes(const Compilation& compilation) {
  const std::size_t count = all_notes(compilation).size();
  if (count == 0) return;
  const std::string& file = compilation.model.file;
  print_message("{0}: {1} on the model, mbgen check {0} prints {2}\n", file,
                count == 1 ? "1 note" : fmt::format("{} notes", count), count == 1 ? "it" : "them");
}

std::string note_text(const Diagnostic& note) {
  const std::string place = note.where.line > 0
                                ? fmt::format("{}:{}:{}", note.where.file, note.where.line, note.where.column)
                                : note.where.file;
  std::string text = fmt::format("{}: note: {}\n", place, note.message);
  if (!note.hint.empty()) text += fmt::format("  hint: {}\n", note.hint);
  return text;
}

void print_notes(const Diagnostics& notes) {
  for (const Diagnostic& note : notes) print_message("{}", note_text(note));
}

nlohmann::ordered_json diagnostics_json(const Diagnostics& diagnostics) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Diagnostic& one : diagnostics) {
    list.push_back({{"file", one.where.file},
                    {"line", one.where.line},
                    {"column", one.where.column},
                    {"length", marked_length(one.where.line_text, one.where.column)},
                    {"pointer", one.where.pointer},
                    {"message", one.message},
                    {"hint", one.hint}});
  }
  return list;
}

}  // namespace mbgen
