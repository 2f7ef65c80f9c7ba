#include "workbench/cli/result_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mbgen::cli {
namespace {

/// The varied values of a kept case of a study; null for other results.
nlohmann::ordered_json case_of(const std::string& description) {
  const auto run = nlohmann::ordered_json::parse(description, nullptr, false);
  return run.is_object() && run.contains("case") && run["case"].is_object() ? run["case"] : nlohmann::ordered_json();
}

}  // namespace

std::vector<std::string> result_labels(const std::vector<std::string>& paths,
                                       const std::function<std::string(std::size_t)>& run_of) {
  std::vector<nlohmann::ordered_json> cases;
  for (std::size_t i = 0; i < paths.size(); ++i) cases.push_back(case_of(run_of(i)));
  std::vector<std::string> labels(paths.size());
  for (const auto& item : cases.front().items()) {
    const std::string name = item.key();
    const auto is_equal = [&](const nlohmann::ordered_json& one) {
      return one.contains(name) && one[name] == cases.front()[name];
    };
    if (std::all_of(cases.begin(), cases.end(), is_equal)) continue;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (!cases[i].contains(name) || !cases[i][name].is_number()) return paths;
      labels[i] += fmt::format("{}{} = {:.6g}", labels[i].empty() ? "" : ", ", name, cases[i][name].get<double>());
    }
  }
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (labels[i].empty()) labels[i] = paths[i];
  return labels;
}

}  // namespace mbgen::cli
