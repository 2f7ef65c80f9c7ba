#pragma once
// The page's files, bundled by esbuild when mbgen is built (workbench/report/web) and embedded by embed.cmake.

#include <string_view>
#include <vector>

namespace mbgen {

struct PageFile {
  std::string_view path;  ///< "index.html", "report.css" or "report.js"
  std::string_view text;
};

/// The files; none if mbgen was built without Node.js.
const std::vector<PageFile>& report_page_files();

}  // namespace mbgen
