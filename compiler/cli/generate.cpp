// mbgen generate: the specialised solver, as files.

#include <fmt/format.h>

#include <filesystem>
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

struct Options {
  std::string model, form, directory, dump;
  EmitOptions emit;
  bool c_interface = false, json = false;
};

/// The initial state of the model, at the default inputs.
InitialState start_of(const Compilation& compilation) {
  std::vector<double> inputs;
  for (const Input& input : compilation.model.inputs) inputs.push_back(input.default_value);
  GenericState state = initial_state(compilation, inputs);
  return {std::move(state.z), std::move(state.zd), std::move(state.x)};
}

int run(const Options& options) {
  if (!options.dump.empty()) {
    print(dump_stage(options.model, options.dump));
    return kDone;
  }
  if (options.directory.empty()) throw UserError("generate: --out DIR is required\n");
  const Compilation compilation = expect(compile(options.model, chosen_form(options.form)));
  EmitOptions emitted = options.emit;
  if (options.c_interface) emitted.c_interface = start_of(compilation);
  std::vector<NamedText> files;
  std::vector<std::string> paths;
  for (EmittedFile& file : emit(compilation, emitted)) {
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
  command->add_flag("--c-api", options->c_interface,
                    "add an interface in C99 (<model>_c.h, <model>_c.cpp) and a Python module over it (<model>.py)");
  add_form_option(*command, options->form);
  add_batch_option(*command, options->emit.lanes);
  add_json_option(*command, options->json);
  add_dump_option(*command, options->dump);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
