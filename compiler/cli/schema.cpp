// mbgen schema: the model format for machines and for people.

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "compiler/base/files.hpp"
#include "compiler/cli/commands.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/describe/schema_reference.hpp"
#include "compiler/model/model.hpp"

namespace mbgen::cli {
namespace {

struct SchemaOptions {
  bool json = true, markdown = false;
};

int run(const SchemaOptions& options) {
  std::string schema = model_schema();
  if (options.markdown) {
    print(schema_reference(nlohmann::ordered_json::parse(schema)));
  } else {
    print(schema.ends_with('\n') ? schema : schema + '\n');
  }
  return kDone;
}

}  // namespace

void add_schema(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<SchemaOptions>();
  NamedCommand command = application.add_command("schema", "print the JSON Schema of the model format");
  command.footer("Example: mbgen schema > mbgen.schema.json");
  command.add_flag("--markdown", options->markdown, "print it as a document for people instead");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
