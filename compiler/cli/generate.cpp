// mbgen generate: the specialised solver, as files.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/dump.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/json_text.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/user_error.hpp"
#include "compiler/compile.hpp"

namespace mbgen::cli {
namespace {

struct Options {
  std::string model, form, directory, dump;
  EmitOptions emit;
  bool json = false;
};

int run(const Options& options) {
  if (!options.dump.empty()) {
    print(dump_stage(options.model, options.dump));
    return kDone;
  }
  if (options.directory.empty()) throw UserError("generate: --out DIR is required\n");
  const Compilation compilation = expect(compile(options.model, chosen_form(options.form)));
  std::vector<NamedText> files;
  std::vector<std::string> paths;
  for (EmittedFile& file : emit(compilation, options.emit)) {
    paths.push_back((std::filesystem::path(options.directory) / file.path).string());
    require_other_file(paths.back(), options.model);  // the manifest is named like the model
    files.push_back({std::move(file.path), std::move(file.text)});
  }
  write_files(options.directory, files);
  if (options.json) {
    print(json_text({{"model", compilation.model.name}, {"files", paths}}));
  } else {
    for (const std::string& path : paths) print(path + "\n");
  }
  return kDone;
}

}  // namespace

void add_generate(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = application.add_subcommand("generate", "write the specialised C++ solver of a model");
  command->footer(
      "Example: mbgen generate models/coach.json --out coach_solver\n"
      "Prints the files that it wrote; DIR/CMakeLists.txt builds them alone.");
  add_model_argument(*command, options->model);
  command->add_option("--out", options->directory, "directory of the files; made when it is missing");
  command->add_flag_callback(
      "--no-runtime", [options] { options->emit.runtime_headers = false; },
      "leave out the runtime's headers (mbgen/*.hpp)");
  add_form_option(*command, options->form);
  add_batch_option(*command, options->emit.lanes);
  add_json_option(*command, options->json);
  add_dump_option(*command, options->dump);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
