// mbgen schema: the JSON Schema of the model format.

#include <memory>
#include <string>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/model/model.hpp"

namespace mbgen::cli {

void add_schema(CLI::App& application, int& exit_code) {
  CLI::App* command = application.add_subcommand("schema", "print the JSON Schema of the model format");
  command->footer("Example: mbgen schema > mbgen.schema.json");
  const auto json = std::make_shared<bool>(true);
  add_json_option(*command, *json);
  command->callback([json, &exit_code] {
    std::string schema = model_schema();
    if (!schema.ends_with('\n')) schema += '\n';
    print(schema);
    exit_code = kDone;
  });
}

}  // namespace mbgen::cli
