#pragma once
// Labels of several results in one picture or page.

#include <functional>
#include <string>
#include <vector>

namespace mbgen::cli {

/// The varied values in which kept cases of a study differ, else the paths. run_of: the description of a result's run.
std::vector<std::string> result_labels(const std::vector<std::string>& paths,
                                       const std::function<std::string(std::size_t)>& run_of);

}  // namespace mbgen::cli
