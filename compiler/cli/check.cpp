// mbgen check: every problem of a model, or "ok".

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/dump.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/initial_state.hpp"
#include "compiler/cli/json_text.hpp"
#include "compiler/cli/notes.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/user_error.hpp"
#include "compiler/compile.hpp"

namespace mbgen::cli {
namespace {

struct CheckOptions {
  std::string model, dump;
  bool json = false;
};

struct Findings {
  Diagnostics problems, notes;
};

/// What is wrong with the model or the state that it starts from, or what there is to say of them.
Findings findings_of(const std::string& file) {
  const Result<Compilation> compilation = decide(file);
  if (!compilation) return {compilation.problems(), {}};
  Findings findings{{}, compilation->model.notes};
  const Initial& initial = compilation->model.initial;
  if (!initial.equilibrium && initial.positions.empty() && initial.velocities.empty()) return findings;
  try {
    const Start start = initial_start(*compilation, input_values(compilation->model, {}));
    for (Diagnostic& note : moved_notes(*compilation, start.moved)) findings.notes.push_back(std::move(note));
  } catch (const UserError& error) {
    findings.problems = error.problems();
  }
  return findings;
}

int run(const CheckOptions& options) {
  if (!options.dump.empty()) {
    print(dump_stage(options.model, options.dump));
    return kDone;
  }
  const auto [problems, notes] = findings_of(options.model);
  if (options.json) {
    print(json_text({{"model", options.model},
                     {"ok", problems.empty()},
                     {"problems", diagnostics_json(problems)},
                     {"notes", diagnostics_json(notes)}}));
  } else if (problems.empty()) {
    print_notes(notes);
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
  command->footer(
      "Example: mbgen check models/coach.json\n"
      "Standard error has notes of what is not wrong: what the model does not use of its tyre files, and how far "
      "initial\n"
      "values that do not fit together are moved.");
  add_model_argument(*command, options->model);
  add_json_option(*command, options->json);
  add_dump_option(*command, options->dump);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
