// mbgen report: a result as one HTML page.

#include "workbench/cli/html_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/motion_table.hpp"
#include "workbench/motion/result_file.hpp"
#include "workbench/report/report.hpp"

namespace mbgen::cli {
namespace {

struct HtmlReportOptions {
  std::string result, model, file;
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
Model model_of(const Results& results, const HtmlReportOptions& options) {
  if (!options.model.empty()) {
    const nlohmann::json run = nlohmann::json::parse(results.run, nullptr, false);
    return read_set_model(options.model, options.set.empty() ? set_of(run) : options.set);
  }
  const nlohmann::json run = run_of(results, options.result);
  const std::filesystem::path directory = std::filesystem::path(options.result).parent_path();
  const std::string file = (directory / run["model_file"].get<std::string>()).lexically_normal().string();
  Model model = read_set_model(file, set_of(run));
  if (model.hash == run["model_hash"]) return model;
  throw UserError(fmt::format("{}: changed since {} was written; simulate again, or give --model to take it as it is\n",
                              model.file, options.result));
}

int run(const HtmlReportOptions& options) {
  require_report_page("report");
  require_other_file(options.file, {options.result, run_file(options.result)});
  Results results = read_result_file(options.result);
  const Model model = model_of(results, options);
  require_other_file(options.file, model.files);
  const Topology topology = expect(build_topology(model));
  const Analysis analysis = expect(analyse(model, topology));
  const std::string file = std::filesystem::path(options.result).filename().string();
  write_file(options.file, expect(report_html({model, topology, analysis, results}, file)), model.files);
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
      "table and inside a MAT file; --model names it where that is missing or the model has changed.");
  command.add_option("RESULT", options->result, "table of mbgen simulate (CSV or MAT)").required();
  const Option model =
      command.add_option("--model", options->model, "the model (default: the one that the result names)");
  add_set_option(command, options->set).needs(model);
  command.add_option("-o,--out", options->file, "the page; - for standard output").required();
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
