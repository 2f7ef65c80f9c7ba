// mbgen schema: the model format for machines and for people.

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "compiler/model/model.hpp"
#include "compiler/reader/read_model.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/schema_reference.hpp"
#include "workbench/host/files.hpp"
#include "workbench/manoeuvre/manoeuvre.hpp"

namespace mbgen::cli {
namespace {

struct SchemaOptions {
  bool json = true, markdown = false, manoeuvre = false;
};

int run(const SchemaOptions& options) {
  if (options.manoeuvre) {
    print(options.markdown ? manoeuvre_reference() : manoeuvre_schema());
  } else {
    print(options.markdown ? schema_reference(nlohmann::ordered_json::parse(model_schema())) : model_schema());
  }
  return kDone;
}

}  // namespace

void add_schema(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<SchemaOptions>();
  NamedCommand command = application.add_command("schema", "print the JSON Schema of the model format");
  command.footer("Example: mbgen schema > mbgen.schema.json");
  command.add_flag("--markdown", options->markdown, "print it as a document for people instead");
  command.add_flag("--manoeuvre", options->manoeuvre, "of manoeuvre files instead");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
