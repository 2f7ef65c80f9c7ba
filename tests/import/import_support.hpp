#pragma once
// Robots of tests/import, imported and analysed.

#include <fstream>
#include <iterator>

#include "tests/support/mechanism_support.hpp"
#include "workbench/import/import.hpp"

namespace mbgen::testing {

inline std::optional<std::string> content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// A text as if it were a file in tests/import.
inline ImportRequest request_of(const std::string& name, std::string text) {
  return {.file = name,
          .text = std::move(text),
          .loops_file = "loops.json",
          .loops = {},
          .read = [](const std::string& path) { return content_of(source_path("tests/import/" + path)); }};
}

inline ImportedModel imported_text(const ImportRequest& request) {
  Result<ImportedModel> model = import_robot(request);
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return *model;
}

/// A robot of tests/import, with the sidecar of this name where there is one.
inline ImportedModel imported(const std::string& name, const std::string& loops = {}) {
  ImportRequest request = request_of(name, content_of(source_path("tests/import/" + name)).value());
  if (!loops.empty()) request.loops = content_of(source_path("tests/import/" + loops)).value();
  return imported_text(request);
}

}  // namespace mbgen::testing
