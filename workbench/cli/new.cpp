// mbgen new: a commented starting model.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "compiler/emit/embedded.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/host/files.hpp"

namespace mbgen::cli {
namespace {

struct NewOptions {
  std::string kind, output;
  bool list = false, force = false, json = false;
};

/// A file of models/starters.
struct Starter {
  std::string kind;     ///< its name without extension
  std::string purpose;  ///< its first line
  std::string_view text;
};

std::vector<Starter> starters() {
  constexpr std::string_view kRoom = "models/starters/", kExtension = ".json", kComment = "// ";
  std::vector<Starter> list;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.path.starts_with(kRoom)) continue;
    const std::string_view name = file.path.substr(kRoom.size(), file.path.size() - kRoom.size() - kExtension.size());
    const std::string_view line = file.text.substr(0, file.text.find('\n'));
    list.push_back({std::string(name), std::string(line.substr(kComment.size())), file.text});
  }
  return list;
}

void print_list(const std::vector<Starter>& list, bool json) {
  if (json) {
    auto items = nlohmann::ordered_json::array();
    for (const Starter& starter : list) items.push_back({{"kind", starter.kind}, {"purpose", starter.purpose}});
    return print(json_text({{"starters", items}}));
  }
  std::string text;
  for (const Starter& starter : list) text += fmt::format("{:<16} {}\n", starter.kind, starter.purpose);
  print(text);
}

const Starter& find_starter(const std::vector<Starter>& list, const std::string& kind) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Starter& one) { return one.kind == kind; });
  if (found != list.end()) return *found;
  std::string known;
  for (const Starter& starter : list) known += (known.empty() ? "" : ", ") + starter.kind;
  throw UserError(fmt::format("mbgen new: unknown kind \"{}\"\n  hint: known: {}\n", kind, known));
}

int run(const NewOptions& options) {
  const std::vector<Starter> list = starters();
  if (options.list) {
    print_list(list, options.json);
    return kDone;
  }
  if (options.kind.empty()) throw UserError("mbgen new: KIND is missing\n  hint: mbgen new --list names the kinds\n");
  const Starter& starter = find_starter(list, options.kind);
  const std::string path = options.output.empty() ? starter.kind + ".json" : options.output;
  std::error_code ignored;
  if (!options.force && !is_standard_output(path) &&
      std::filesystem::exists(std::filesystem::symlink_status(path, ignored)))
    throw UserError(
        fmt::format("{}: file exists\n  hint: name another one with --out, or overwrite it with --force\n", path));
  write_file(path, starter.text, {});
  if (is_standard_output(path)) return kDone;
  print(options.json ? json_text({{"kind", starter.kind}, {"file", path}}) : path + "\n");
  return kDone;
}

}  // namespace

void add_new(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<NewOptions>();
  NamedCommand command = application.add_command("new", "write a commented model to start from");
  command.footer("Example: mbgen new double_wishbone --out corner.json");
  command.add_option("KIND", options->kind, "which one, see --list");
  command.add_option("-o,--out", options->output, "file to write; default KIND.json");
  command.add_flag("--list", options->list, "list the kinds, each with its mechanism");
  command.add_flag("--force", options->force, "overwrite the file when it exists");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
