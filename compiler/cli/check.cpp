// mbgen check: every problem of a model, or "ok".

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/dump.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/initial_state.hpp"
#include "compiler/cli/json_text.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/user_error.hpp"
#include "compiler/compile.hpp"

namespace mbgen::cli {
namespace {

struct CheckOptions {
  std::string model, dump;
  bool json = false;
};

using Json = nlohmann::ordered_json;

std::string to_json(const std::string& file, const Diagnostics& problems) {
  Json list = Json::array();
  for (const Diagnostic& problem : problems) {
    list.push_back({{"file", problem.where.file},
                    {"line", problem.where.line},
                    {"column", problem.where.column},
                    {"length", marked_length(problem.where.line_text, problem.where.column)},
                    {"pointer", problem.where.pointer},
                    {"message", problem.message},
                    {"hint", problem.hint}});
  }
  return json_text({{"model", file}, {"ok", problems.empty()}, {"problems", list}});
}

/// What is wrong with the model, or with the state that it starts from; what of that moves goes to standard error.
Diagnostics problems_of(const std::string& file) {
  const Result<Compilation> compilation = compile(file);
  if (!compilation) return compilation.problems();
  const Initial& initial = compilation->model.initial;
  if (!initial.equilibrium && initial.positions.empty() && initial.velocities.empty()) return {};
  try {
    noted_initial_state(*compilation, input_values(compilation->model, {}));
  } catch (const UserError& error) {
    return error.problems();
  }
  return {};
}

int run(const CheckOptions& options) {
  if (!options.dump.empty()) {
    print(dump_stage(options.model, options.dump));
    return kDone;
  }
  const Diagnostics problems = problems_of(options.model);
  if (options.json) {
    print(to_json(options.model, problems));
  } else if (problems.empty()) {
    print(fmt::format("{}: ok\n", options.model));
  } else {
    throw UserError(problems);
  }
  return problems.empty() ? kDone : kUserFault;
}

}  // namespace

void add_check(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = application.add_subcommand("check", "read and verify a model, report every problem at once");
  command->footer("Example: mbgen check models/coach.json");
  add_model_argument(*command, options->model);
  add_json_option(*command, options->json);
  add_dump_option(*command, options->dump);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
