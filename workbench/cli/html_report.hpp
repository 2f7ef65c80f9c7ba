#pragma once
// Common parts of the commands that write pages.

#include <string>

namespace mbgen::cli {

/// Fails: UserError when this mbgen was built without the page. asked: the command or option that needs it.
void require_report_page(const std::string& asked);

}  // namespace mbgen::cli
