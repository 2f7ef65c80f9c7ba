// mbgen report: a result as one HTML page.

#include "workbench/cli/html_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/cli/result_labels.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/motion/result_file.hpp"
#include "workbench/report/report.hpp"

namespace mbgen::cli {
namespace {

struct HtmlReportOptions {
  std::vector<std::string> results;
  std::string model, file;
  std::vector<std::string> set;
};

/// Entry of the model in the description of a result's run. Fails: UserError if it is missing or belongs to another
/// table.
nlohmann::json run_of(const Results& results, const std::string& path) {
  if (results.run.empty()) {
    throw UserError(
        fmt::format("{}: nothing says which model this is of, {} is missing; give --model\n", path, run_file(path)));
  }
  const nlohmann::json run = nlohmann::json::parse(results.run, nullptr, false);
  const auto has = [&](const char* key, const auto& is_right) { return run.contains(key) && is_right(run[key]); };
  const auto text = [](const nlohmann::json& value) { return value.is_string(); };
  const auto count = [&](const nlohmann::json& value) { return value == results.rows(); };
  if (!run.is_object() || !has("model_file", text) || !has("model_hash", text)) {
    throw UserError(fmt::format("{}: no description of a run by mbgen simulate; give --model\n", run_file(path)));
  }
  if (!has("rows", count)) {
    throw UserError(fmt::format("{}: of another table, with {} rows instead of {}; simulate again or give --model\n",
                                run_file(path), run.value("rows", nlohmann::json()).dump(), results.rows()));
  }
  return run;
}

std::vector<std::string> strings_of(const nlohmann::json& array) {
  std::vector<std::string> strings;
  for (const nlohmann::json& value : array) {
    if (value.is_string()) strings.push_back(value);
  }
  return strings;
}

/// Parameters given on the command line of a run.
std::vector<std::string> set_of(const nlohmann::json& run) {
  const auto place = run.is_object() ? run.find("set") : run.end();
  return run.is_object() && place != run.end() && place->is_array() ? strings_of(*place) : std::vector<std::string>();
}

/// The model of a result: the requested one, else the unchanged one named in the run, with the requested parameters,
/// else those of the run. Fails: UserError.
Model model_of(const Results& results, const std::string& path, const HtmlReportOptions& options) {
  if (!options.model.empty()) {
    const nlohmann::json run = nlohmann::json::parse(results.run, nullptr, false);
    return read_set_model(options.model, options.set.empty() ? set_of(run) : options.set);
  }
  const nlohmann::json run = run_of(results, path);
  const std::filesystem::path directory = std::filesystem::path(path).parent_path();
  const std::string file = (directory / run["model_file"].get<std::string>()).lexically_normal().string();
  Model model = read_set_model(file, set_of(run));
  if (model.hash == run["model_hash"]) return model;
  throw UserError(fmt::format("{}: changed since {} was written; simulate again, or give --model to take it as it is\n",
                              model.file, path));
}

/// A result with its model.
struct PageResult {
  std::string file;  ///< without its directory
  Results results;
  Model model;
  Topology topology;
  Analysis analysis;
  ReportSource source() const { return {model, topology, analysis, results}; }
};

PageResult page_result(const std::string& path, const HtmlReportOptions& options) {
  PageResult result{std::filesystem::path(path).filename().string(), read_result_file(path), {}, {}, {}};
  result.model = model_of(result.results, path, options);
  require_other_file(options.file, result.model.files);
  result.topology = expect(build_topology(result.model));
  result.analysis = expect(analyse(result.model, result.topology));
  return result;
}

int run(const HtmlReportOptions& options) {
  constexpr std::size_t kMostResults = 8;  // as many colours as there are
  require_report_page("report");
  if (options.results.size() > kMostResults)
    throw UserError(fmt::format("report: {} results, a page shows at most {}; mbgen plot draws the curves of more\n",
                                options.results.size(), kMostResults));
  for (const std::string& path : options.results) require_other_file(options.file, {path, run_file(path)});
  std::vector<PageResult> all;
  for (const std::string& path : options.results) all.push_back(page_result(path, options));
  const std::vector<std::string> labels =
      result_labels(options.results, [&](std::size_t i) { return all[i].results.run; });
  std::vector<OtherResult> others;
  std::vector<std::string> read;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) others.push_back({all[i].source(), all[i].file, labels[i]});
    read.insert(read.end(), all[i].model.files.begin(), all[i].model.files.end());
  }
  write_file(options.file, expect(report_html(all[0].source(), all[0].file, labels[0], others)), read);
  return kDone;
}

}  // namespace

void require_report_page(const std::string& asked) {
  if (has_report_page()) return;
  throw UserError(asked +
                  ": this mbgen was built without reports; install nodejs and npm (Debian: apt-get install nodejs npm) "
                  "and build it again with -DMBGEN_REPORTS=ON, with access to registry.npmjs.org\n");
}

void add_report(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<HtmlReportOptions>();
  NamedCommand command =
      application.add_command("report", "write a result as a page: animation, plots, summary, topology (HTML)");
  command.footer(
      "Example: mbgen simulate models/coach.json --duration 5 --out coach.csv\n"
      "         mbgen report coach.csv -o coach.html\n"
      "The page is one file that needs no network. A result says which model it is of, in FILE.run.json beside a CSV\n"
      "table and inside a MAT file; --model names it where that is missing or the model has changed. Further results\n"
      "are drawn translucent beside the first one, their curves in its plots.");
  command.add_option("RESULT", options->results, "tables of mbgen simulate (CSV or MAT)").required();
  const Option model =
      command.add_option("--model", options->model, "the model (default: the one that the result names)");
  add_set_option(command, options->set).needs(model);
  command.add_option("-o,--out", options->file, "the page; - for standard output").required();
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
