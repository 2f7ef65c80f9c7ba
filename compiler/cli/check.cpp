// mbgen check: every problem of a model, or "ok".

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/dump.hpp"
#include "compiler/cli/files.hpp"
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

std::string to_json(const std::string& file, const Result<Compilation>& compilation) {
  const Diagnostics none;
  return json_text({{"model", file},
                    {"ok", bool(compilation)},
                    {"problems", diagnostics_json(compilation ? none : compilation.problems())},
                    {"notes", diagnostics_json(compilation ? compilation->model.notes : none)}});
}

int run(const CheckOptions& options) {
  if (!options.dump.empty()) {
    print(dump_stage(options.model, options.dump));
    return kDone;
  }
  const Result<Compilation> compilation = compile(options.model);
  if (options.json) {
    print(to_json(options.model, compilation));
  } else if (compilation) {
    for (const Diagnostic& note : compilation->model.notes) fmt::print(stderr, "{}", note_text(note));
    print(fmt::format("{}: ok\n", options.model));
  } else {
    throw UserError(compilation.problems());
  }
  return compilation ? kDone : kUserFault;
}

}  // namespace

void add_check(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = application.add_subcommand("check", "read and verify a model, report every problem at once");
  command->footer(
      "Example: mbgen check models/coach.json\n"
      "What the model does not use of its tyre files is told on standard error, one note per file.");
  add_model_argument(*command, options->model);
  add_json_option(*command, options->json);
  add_dump_option(*command, options->dump);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
