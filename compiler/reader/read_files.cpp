// Files: an included file is merged into its includer, a placed one becomes a separate scope for each instance.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "compiler/reader/included.hpp"
#include "compiler/text/read_text.hpp"

namespace mbgen::reading {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepest = 32;            ///< nesting of includes and instances
constexpr std::size_t kMostInstances = 10'000;  ///< far beyond practical models; nested instances multiply

std::string canonical(const std::string& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(path, error);
  return error ? path : result.string();
}

/// State of the reading of all files.
struct Loading {
  std::vector<std::string> open;  ///< canonical paths from the first file to the one being read
  std::vector<Changes*> changes;  ///< of the includes on the way to the file, the outermost first
  std::size_t bytes = 0;          ///< of text, counted again for each instance
  bool complete = true;           ///< false if names defined in a file could not be read
  /// The first scope of each prefix and suffix: scopes with equal ones have common names.
  std::map<std::pair<std::string, std::string>, std::size_t> levels = {{{}, 0}};
};

void load(Reader& reader, Loading& loading, std::size_t document);

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

/// Index of the parsed file, which is read if it is new; nothing, with a problem, if it cannot be read or parsed. what:
/// "include" or "file", for messages.
std::optional<std::size_t> open_file(Reader& reader, Loading& loading, const Value& item, const NamedFile& file,
                                     std::string_view what) {
  const auto fail = [&](std::string message, std::string hint = {}) {
    report(reader, item, std::move(message), std::move(hint));
    loading.complete = false;
    return std::nullopt;
  };
  const auto cycle_start = std::find(loading.open.begin(), loading.open.end(), file.identity);
  if (cycle_start != loading.open.end()) {
    std::string cycle;
    for (auto step = cycle_start; step != loading.open.end(); ++step) cycle += file_name(*step) + " -> ";
    return fail(fmt::format("cycle of {}s, {}{}", what, cycle, file_name(file.identity)));
  }
  if (loading.open.size() >= kDeepest) return fail(fmt::format("{}s are nested deeper than {} files", what, kDeepest));
  for (std::size_t i = 0; i < reader.documents.size(); ++i) {
    if (reader.documents[i].identity != file.identity) continue;
    if (!reader.documents[i].parsed) loading.complete = false;
    return reader.documents[i].parsed ? std::optional(i) : std::nullopt;
  }
  FileText content = read_regular_file(file.path);
  if (!content.problem.empty())
    return fail(fmt::format("{} {}: {}", what, in_quotes(item.text), content.problem), hint_of_missing(file.path));
  const std::size_t index = add_document(reader, file.path, std::move(content.text));
  reader.documents[index].identity = file.identity;
  Document& document = reader.documents[index];
  const std::size_t problems = reader.problems.size();
  document.parsed = parse_document(document, static_cast<std::uint32_t>(index), reader.problems);
  if (reader.problems.size() > problems) loading.complete = false;  // the content of a duplicate key is unknown too
  return document.parsed ? std::optional(index) : std::nullopt;
}

/// Includes a file. item: its path, relative to the file in which that stands. changes: of its content, and of the
/// files that it includes.
void load_file(Reader& reader, Loading& loading, const Value& item, Changes& changes) {
  const NamedFile named = beside(reader.documents[item.place.file].file, item.text);
  const bool open = std::find(loading.open.begin(), loading.open.end(), named.identity) != loading.open.end();
  for (const FileFields& known : current_scope(reader).files) {
    if (open || reader.documents[known.document].identity != named.identity) continue;
    if (!changes.empty())
      report(reader, item, fmt::format("file {} is included before, without these changes", in_quotes(item.text)),
             "make them where it is included first");
    return;
  }
  const auto document = open_file(reader, loading, item, named, "include");
  if (!document) return;
  loading.changes.push_back(&changes);
  load(reader, loading, *document);
  loading.changes.pop_back();
  if (loading.complete) report_unmade(reader, item.text, changes);
}

void load_include(Reader& reader, Loading& loading, const Value& item) {
  Changes changes;
  if (item.kind == Value::Kind::text) return load_file(reader, loading, item, changes);
  if (item.kind != Value::Kind::object)
    return report(reader, item, "must be the path of a file, got " + describe(item));
  IncludeFields include;
  const std::size_t problems = reader.problems.size();
  read_fields(reader, item, include);
  changes = read_changes(reader, include);
  if (reader.problems.size() > problems) loading.complete = false;
  if (include.file) load_file(reader, loading, *find(item, "file"), changes);
}

/// Reports a section that is no object.
bool is_map(Reader& reader, const Value& section) {
  if (section.kind == Value::Kind::object) return true;
  report(reader, section, "must be an object of named elements, got " + describe(section));
  return false;
}

/// Reports affixes that give no valid names.
bool check_affixes(Reader& reader, const Value& value, const Scope& scope) {
  bool valid = true;
  for (const std::string_view key : {"prefix", "suffix"}) {
    const auto& text = key == "prefix" ? scope.instance.prefix : scope.instance.suffix;
    const bool starts = key == "suffix";  // with what follows a letter
    if (!text || text->empty() || is_valid_name((starts ? "_" : "") + *text)) continue;
    report(reader, *find(value, key), fmt::format("invalid {} {}", key, in_quotes(*text)), kNameRule);
    valid = false;
  }
  return valid;
}

void read_connections(Reader& reader, Scope& scope) {
  const Value* connect = scope.instance.connect;
  if (!connect) return;
  if (connect->kind != Value::Kind::object) {
    report(reader, *connect, "must be an object of bodies, got " + describe(*connect));
    return;
  }
  for (const Member& member : connect->members) {
    if (member.value.kind != Value::Kind::text) {
      report(reader, member.value, "must be the name of a body, got " + describe(member.value));
    } else {
      scope.connections.emplace(member.key, &member.value);
    }
  }
}

/// The scope of an instance, without its files.
Scope scope_of_instance(const Reader& reader, Loading& loading, const std::string& name, InstanceFields instance) {
  const Scope& parent = current_scope(reader);
  Scope scope;
  scope.path = parent.path.empty() ? name : parent.path + "." + name;
  scope.parent = reader.scope;
  scope.instance = std::move(instance);
  scope.keeps_direction = parent.keeps_direction || scope.instance.parallel.value_or(false);
  const bool is_named = scope.instance.prefix || scope.instance.suffix;
  const std::string prefix = is_named ? scope.instance.prefix.value_or("") : name + "_";
  const Level& outer = parent.visible.front();
  const std::string before = outer.before + prefix, after = scope.instance.suffix.value_or("") + outer.after;
  const std::size_t level = loading.levels.emplace(std::pair(before, after), reader.scopes.size()).first->second;
  scope.visible = {{level, before, after}};
  scope.visible.insert(scope.visible.end(), parent.visible.begin(), parent.visible.end());
  return scope;
}

void load_instance(Reader& reader, Loading& loading, const Member& member) {
  InstanceFields instance;
  const bool named = is_valid_name(member.key);
  if (!named) report(reader, member.place, "invalid name " + in_quotes(member.key), kNameRule);
  const bool readable = read_fields(reader, member.value, instance);
  loading.complete = loading.complete && named && readable && instance.file;
  if (!readable || !instance.file) return;
  if (reader.scopes.size() > kMostInstances) {
    if (loading.complete) report(reader, member.place, fmt::format("model has more than {} instances", kMostInstances));
    loading.complete = false;
    return;
  }
  const Value& path = *find(member.value, "file");
  if (path.kind != Value::Kind::text) {
    loading.complete = false;
    return;
  }
  Scope scope = scope_of_instance(reader, loading, member.key, std::move(instance));
  scope.file = path.text;
  read_connections(reader, scope);
  if (!check_affixes(reader, member.value, scope)) loading.complete = false;
  const auto document =
      open_file(reader, loading, path, beside(reader.documents[path.place.file].file, path.text), "instance");
  if (!document) return;
  reader.scopes.push_back(std::move(scope));
  const InScope in_scope(reader, reader.scopes.size() - 1);
  const std::vector<Changes*> of_includes = std::exchange(loading.changes, {});
  load(reader, loading, *document);
  loading.changes = of_includes;
}

void load_parts(Reader& reader, Loading& loading, const Document& document, const FileFields& fields) {
  loading.open.push_back(document.identity);
  if (fields.include && fields.include->kind != Value::Kind::array) {
    report(reader, *fields.include, "must be an array of paths, got " + describe(*fields.include));
  } else if (fields.include) {
    for (const Value& item : fields.include->items) load_include(reader, loading, item);
  }
  reader.scopes[reader.scope].files.push_back(fields);
  if (fields.instances && is_map(reader, *fields.instances)) {
    for (const Member& member : fields.instances->members) load_instance(reader, loading, member);
  }
  loading.open.pop_back();
}

/// Reports a file of mbgen that is no model. Result: whether it is one.
bool is_other_file(Reader& reader, const Document& document) {
  if (find(document.root, "mbgen")) return false;
  const std::string name = file_name(document.file);
  const struct {
    std::string_view key, kind;
    std::string hint;
  } others[] = {{"mbgen_manoeuvre", "a manoeuvre", "mbgen simulate MODEL --manoeuvre " + name},
                {"mbgen_run", "the record of a run", "mbgen report shows it, by the name of its table"}};
  for (const auto& [key, kind, hint] : others) {
    const Member* member = find_member(document.root, key);
    if (!member) continue;
    report(reader, member->place, fmt::format("the file is {}, not a model", kind), hint);
    return true;
  }
  return false;
}

/// Whether a key resembles the name of a section: its names are then unknown, and messages on their uses would be
/// misleading.
bool has_misspelt_section(const Value& root) {
  std::vector<std::string_view> known;
  for (const Field<FileFields>& row : fields<FileFields>()) known.push_back(row.info.name);
  const auto is_misspelt = [&](const Member& member) {
    return member.value.kind == Value::Kind::object &&
           std::find(known.begin(), known.end(), member.key) == known.end() &&
           did_you_mean(member.key, known).starts_with("did you mean");
  };
  return std::any_of(root.members.begin(), root.members.end(), is_misspelt);
}

/// Reads the sections of a parsed file, its included files and its instances.
void load(Reader& reader, Loading& loading, std::size_t index) {
  const Document& document = reader.documents[index];
  loading.bytes += document.text.size();
  if (loading.bytes > kMaximumBytes) {
    if (loading.complete)
      report(reader, document.root, "files of the model have more than 64 MB, each instance counted");
    loading.complete = false;
    return;
  }
  const Value* root = &document.root;
  for (auto change = loading.changes.rbegin(); change != loading.changes.rend(); ++change)
    root = &with_changes(reader, *root, **change);
  FileFields fields;
  fields.document = index;
  if (is_other_file(reader, document) || !read_fields(reader, *root, fields)) {
    loading.complete = false;
    return;
  }
  if (has_misspelt_section(*root)) loading.complete = false;
  if (fields.format) {
    const bool known = fields.format->kind == Value::Kind::number && fields.format->number == 1;
    if (!known) report(reader, *fields.format, "version of the format must be 1, got " + describe(*fields.format));
  } else if (index == 0) {
    report(reader, document.root, "key \"mbgen\" is missing", "write \"mbgen\": 1, the version of the format");
  }
  for (const Value* section :
       {fields.parameters, fields.inputs, fields.hardpoints, fields.bodies, fields.joints, fields.instances}) {
    if (section && !is_map(reader, *section)) loading.complete = false;
  }
  load_parts(reader, loading, document, fields);
}

}  // namespace

NamedFile beside(const std::string& file, const std::string& named) {
  const std::string path = (fs::path(file).parent_path() / named).lexically_normal().string();
  return {path, canonical(path)};
}

std::size_t add_document(Reader& reader, const std::string& file, std::string text) {
  Document& document = reader.documents.emplace_back();
  document.file = file;
  document.text = std::move(text);
  return reader.documents.size() - 1;
}

bool load_files(Reader& reader, const std::string& file, std::string text) {
  const std::size_t first = add_document(reader, file, std::move(text));
  Document& document = reader.documents[first];
  document.identity = canonical(file);
  document.parsed = parse_document(document, static_cast<std::uint32_t>(first), reader.problems);
  if (!document.parsed) return false;
  Loading loading;
  loading.complete = reader.problems.empty();
  load(reader, loading, first);
  reader.names.coordinates.resize(reader.scopes.size());
  return loading.complete && !reader.scopes[0].files.empty();
}

}  // namespace mbgen::reading
