#pragma once
// Files of templates/, runtime/include and models/starters that are compiled into mbgen (written by embed.cmake).

#include <string_view>
#include <vector>

namespace mbgen {

struct EmbeddedFile {
  std::string_view path;  ///< relative to the source tree, for example "templates/solver.cpp.in"
  std::string_view text;
};

const std::vector<EmbeddedFile>& embedded_files();

}  // namespace mbgen
