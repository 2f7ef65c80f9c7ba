#pragma once
// Common parts of commands that write pages.

#include <string>

namespace mbgen::cli {

/// Fails: UserError if this mbgen was built without the page. asked: command or option that needs it.
void require_report_page(const std::string& asked);

}  // namespace mbgen::cli
