#pragma once
// Helpers of the fuzz targets.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "compiler/text/diagnostic.hpp"

namespace mbgen::fuzz {

/// Ends the process where a promise is broken, so that libFuzzer keeps the input.
inline void require(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Diagnostics say something, and stand inside the text when they name a line of it.
inline void require_places(const Diagnostics& problems, const std::string& text) {
  require(!problems.empty(), "no result has diagnostics");
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  for (const Diagnostic& problem : problems) {
    require(!problem.message.empty(), "a diagnostic has a message");
    require(problem.where.line >= 0 && problem.where.line <= lines, "a diagnostic stands inside the text");
    require(problem.where.column >= 0 && static_cast<std::size_t>(problem.where.column) <= text.size() + 1,
            "a diagnostic stands inside its line");
  }
  require(!to_text(problems).empty(), "diagnostics have a text");
}

}  // namespace mbgen::fuzz
