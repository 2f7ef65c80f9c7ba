// mbgen new: a commented starting model.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "compiler/emit/embedded.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/read_text.hpp"
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

/// A file of models/starters, and of its folder of vehicles.
struct StarterFile {
  std::string name;  ///< with extension
  std::string_view text;
};

struct Starter {
  std::string kind;                ///< its name without extension
  std::string purpose;             ///< its first line
  std::vector<StarterFile> files;  ///< the model, then the files that it or one of these uses
};

std::vector<StarterFile> starter_files() {
  std::vector<StarterFile> list;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.path.starts_with("models/starters/")) continue;
    list.push_back({std::string(file.path.substr(file.path.rfind('/') + 1)), file.text});
  }
  return list;
}

/// Places of a file's name in a text, as a whole word.
std::vector<std::size_t> mentions_of(std::string_view text, std::string_view name) {
  std::vector<std::size_t> places;
  for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const char before = at == 0 ? ' ' : text[at - 1];
    if (before != '_' && !std::isalnum(static_cast<unsigned char>(before))) places.push_back(at);
  }
  return places;
}

/// A part of vehicles or a manoeuvre: no kind of its own.
bool is_beside(const StarterFile& file) {
  return file.text.starts_with("// Part: ") || file.text.starts_with("// Manoeuvre");
}

/// Adds the parts and manoeuvres that the last files mention, and the models that they include, until none is new.
void add_mentioned(const std::vector<StarterFile>& all, std::vector<StarterFile>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const StarterFile& other : all) {
      const auto is_it = [&](const StarterFile& one) { return one.name == other.name; };
      if (std::any_of(files.begin(), files.end(), is_it)) continue;
      const bool is_used = is_beside(other) ? !mentions_of(files[i].text, other.name).empty()
                                            : files[i].text.find('"' + other.name + '"') != std::string_view::npos;
      if (!is_used) continue;
      files.push_back(other);
    }
  }
}

/// The kinds by name: files whose first line does not call them a part of one, or a manoeuvre.
std::vector<Starter> starters() {
  constexpr std::string_view kExtension = ".json", kComment = "// ";
  const std::vector<StarterFile> all = starter_files();
  std::vector<Starter> list;
  for (const StarterFile& file : all) {
    const std::string_view line = file.text.substr(0, file.text.find('\n')).substr(kComment.size());
    if (is_beside(file)) continue;
    Starter starter{file.name.substr(0, file.name.size() - kExtension.size()), std::string(line), {file}};
    add_mentioned(all, starter.files);
    list.push_back(std::move(starter));
  }
  std::sort(list.begin(), list.end(), [](const Starter& a, const Starter& b) { return a.kind < b.kind; });
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

/// Path of the model: a folder takes it under its own name.
std::string path_of_model(const std::string& output, const Starter& starter) {
  const std::string& name = starter.files.front().name;
  if (output.empty()) return name;
  std::error_code ignored;
  const bool is_folder = output.ends_with('/') || std::filesystem::is_directory(output, ignored);
  return is_folder ? (std::filesystem::path(output) / name).string() : output;
}

/// Paths of all files, the model first and the others beside it.
std::vector<std::string> paths_of(const std::string& model, const Starter& starter) {
  std::vector<std::string> paths = {model};
  const std::filesystem::path folder = std::filesystem::path(model).parent_path();
  for (std::size_t i = 1; i < starter.files.size(); ++i) {
    paths.push_back((folder / starter.files[i].name).string());
    if (paths.back() == model)
      throw UserError(
          fmt::format("{}: a file of {} that stands beside the model has this name\n  hint: name another one "
                      "with --out\n",
                      model, starter.kind));
  }
  return paths;
}

/// The text of a file, in which the model has the name under which it is written: in the model itself wherever it
/// stands, in the others where they include it.
std::string text_beside(const StarterFile& file, const std::string& name_of_model, const std::string& written) {
  std::string text(file.text);
  std::vector<std::size_t> places = mentions_of(file.text, name_of_model);
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    const bool is_included = *place > 0 && text[*place - 1] == '"';
    if (is_included || file.name == name_of_model) text.replace(*place, name_of_model.size(), written);
  }
  return text;
}

/// A file and the text that it gets.
struct WrittenStarter {
  std::string path, text;
};

/// Refuses files that exist. One that stands beside the model may: as another kind has left it, with the same text.
void refuse_existing(const std::vector<WrittenStarter>& files) {
  std::string text;
  for (const WrittenStarter& file : files) {
    std::error_code ignored;
    if (!std::filesystem::exists(std::filesystem::symlink_status(file.path, ignored))) continue;
    const bool is_left = &file != files.data() && reading::read_regular_file(file.path).text == file.text;
    if (!is_left) text += fmt::format("{}: file exists\n", file.path);
  }
  if (!text.empty()) throw UserError(text + "  hint: name another one with --out, or overwrite it with --force\n");
}

/// Writes all files or none; the model comes last.
void write_all(const std::vector<WrittenStarter>& files) {
  if (files.size() == 1) return write_file(files.front().path, files.front().text, {});
  std::vector<NamedText> texts;
  for (const WrittenStarter& file : files)
    texts.push_back({std::filesystem::path(file.path).filename().string(), file.text});
  std::rotate(texts.begin(), texts.begin() + 1, texts.end());
  const std::filesystem::path folder = std::filesystem::path(files.front().path).parent_path();
  write_files(folder.empty() ? "." : folder, texts, {});
}

int run(const NewOptions& options) {
  const std::vector<Starter> list = starters();
  if (options.list) {
    print_list(list, options.json);
    return kDone;
  }
  if (options.kind.empty()) throw UserError("mbgen new: KIND is missing\n  hint: mbgen new --list names the kinds\n");
  const Starter& starter = find_starter(list, options.kind);
  const std::string model = path_of_model(options.output, starter);
  if (is_standard_output(model) && starter.files.size() > 1)
    throw UserError(
        fmt::format("mbgen new: {} is {} files, standard output takes one\n  hint: name a folder: --out {}/\n",
                    starter.kind, starter.files.size(), starter.kind));
  if (is_standard_output(model)) {
    print(starter.files.front().text);
    return kDone;
  }
  const std::vector<std::string> paths = paths_of(model, starter);
  const std::string &name = starter.files.front().name, written = std::filesystem::path(model).filename().string();
  std::vector<WrittenStarter> files;
  for (std::size_t i = 0; i < paths.size(); ++i)
    files.push_back({paths[i], text_beside(starter.files[i], name, written)});
  if (!options.force) refuse_existing(files);
  write_all(files);
  std::string text;
  for (const std::string& path : paths) text += path + "\n";
  print(options.json ? json_text({{"kind", starter.kind}, {"file", model}, {"files", paths}}) : text);
  return kDone;
}

}  // namespace

void add_new(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<NewOptions>();
  NamedCommand command = application.add_command("new", "write a commented model to start from");
  command.footer("Example: mbgen new double_wishbone --out corner.json");
  command.add_option("KIND", options->kind, "which one, see --list");
  command.add_option("-o,--out", options->output,
                     "file to write, or a folder; default KIND.json. Its other files lie beside it");
  command.add_flag("--list", options->list, "list the kinds, each with its mechanism");
  command.add_flag("--force", options->force, "overwrite files that exist");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
