// The door: files and their includes, merged and read section by section.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "compiler/model/model.hpp"
#include "compiler/model/raw.hpp"
#include "compiler/model/reader.hpp"

namespace mbgen {
namespace reading {
namespace {

namespace fs = std::filesystem;

/// The text of a file, or why there is none.
struct FileText {
  std::string text;
  std::string problem;
};

FileText read_text(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return {{}, "cannot read file, it does not exist"};
  if (fs::is_directory(path, error)) return {{}, "cannot read file, it is a directory"};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return {{}, "cannot read file"};
  std::string text, chunk(std::size_t{1} << 16, '\0');
  while (stream && text.size() <= kMaximumBytes) {
    stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk, 0, static_cast<std::size_t>(stream.gcount()));
  }
  if (text.size() > kMaximumBytes) return {{}, "file is larger than 64 MB"};
  return {std::move(text), {}};
}

std::string canonical(const std::string& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(path, error);
  return error ? path : result.string();
}

/// The files of a model in the order in which they are merged: includes before the file that includes them.
struct Files {
  std::vector<FileFields> merged;
  std::vector<std::string> open;   ///< canonical paths from the first file to the one being read
  std::vector<std::string> known;  ///< canonical paths of all files: one that is included twice counts once
  bool complete = true;            ///< false when the names that a file defines could not be read
};

void load(Reader& reader, Files& files, const std::string& file, std::string text);

/// Complains about a section that is no object.
bool is_map(Reader& reader, const Value& section) {
  if (section.kind == Value::Kind::object) return true;
  report(reader, section, "must be an object of named elements, got " + describe(section));
  return false;
}

void load_include(Reader& reader, Files& files, const std::string& file, const Value& item) {
  constexpr std::size_t kDeepest = 32;
  if (item.kind != Value::Kind::text) return report(reader, item, "must be the path of a file, got " + describe(item));
  const std::string path = (fs::path(file).parent_path() / item.text).lexically_normal().string();
  const std::string identity = canonical(path);
  const auto fail = [&](std::string message) {
    report(reader, item, std::move(message));
    files.complete = false;
  };
  if (const auto first = std::find(files.open.begin(), files.open.end(), identity); first != files.open.end()) {
    std::string cycle;
    for (auto step = first; step != files.open.end(); ++step) cycle += fs::path(*step).filename().string() + " -> ";
    return fail("cycle of includes, " + cycle + fs::path(identity).filename().string());
  }
  if (std::find(files.known.begin(), files.known.end(), identity) != files.known.end()) return;
  if (files.open.size() >= kDeepest) return fail(fmt::format("includes are nested deeper than {} files", kDeepest));
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool is_special = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  FileText content = is_special ? FileText{{}, "cannot read file, it is a device or pipe"} : read_text(path);
  if (!content.problem.empty()) return fail("include " + in_quotes(item.text) + ": " + content.problem);
  load(reader, files, path, std::move(content.text));
}

/// Parses a file and what it includes, and appends them to files.merged.
void load(Reader& reader, Files& files, const std::string& file, std::string text) {
  const bool first = reader.documents.empty();
  const auto index = static_cast<std::uint32_t>(reader.documents.size());
  Document& document = reader.documents.emplace_back();
  document.file = file;
  document.text = std::move(text);
  files.known.push_back(canonical(file));
  if (!parse_document(document, index, reader.problems)) {
    files.complete = false;
    return;
  }
  FileFields fields;
  if (!read_fields(reader, document.root, fields)) return;
  if (fields.version) {
    const bool known = fields.version->kind == Value::Kind::number && fields.version->number == 1;
    if (!known) report(reader, *fields.version, "version of the format must be 1, got " + describe(*fields.version));
  } else if (first) {
    report(reader, document.root, "key \"mbgen\" is missing", "write \"mbgen\": 1, the version of the format");
  }
  for (const Value* section : {fields.parameters, fields.inputs, fields.bodies, fields.joints}) {
    if (section && !is_map(reader, *section)) files.complete = false;
  }
  if (fields.include && fields.include->kind != Value::Kind::array) {
    report(reader, *fields.include, "must be an array of paths, got " + describe(*fields.include));
  } else if (fields.include) {
    files.open.push_back(canonical(file));
    for (const Value& item : fields.include->items) load_include(reader, files, file, item);
    files.open.pop_back();
  }
  files.merged.push_back(fields);
}

/// A body of an including file with nothing but points adds them to the body of an included file; so does any ground.
bool extends_body(const Entry& entry) {
  const auto& members = entry.value->members;
  const bool points_only =
      entry.value->kind == Value::Kind::object && members.size() == 1 && members[0].key == "points";
  return points_only || entry.name == "ground";
}

/// The entries of one section in all files.
Entries collect(Reader& reader, const Files& files, const Value* FileFields::*section) {
  Entries entries;
  NameMap<Place> places;
  for (const FileFields& file : files.merged) {
    const Value* map = file.*section;
    if (!map || !is_map(reader, *map)) continue;
    for (const Member& member : map->members) {
      const Entry entry{member.key, member.place, &member.value};
      const auto [first, is_new] = places.emplace(member.key, member.place);
      if (is_new && !is_valid_name(member.key))
        report(reader, member.place, "invalid name " + in_quotes(member.key), kNameRule);
      if (!is_new && first->second.file == member.place.file) continue;  // reported as a duplicate key
      if (!is_new && !(section == &FileFields::bodies && extends_body(entry))) {
        report(reader, member.place,
               fmt::format("name {} is defined twice, first at {}", in_quotes(member.key),
                           place_text(reader.documents, first->second, member.place)));
        continue;
      }
      entries.push_back(entry);
    }
  }
  return entries;
}

std::vector<const Value*> all_of(const Files& files, const Value* FileFields::*section) {
  std::vector<const Value*> values;
  for (const FileFields& file : files.merged) {
    if (file.*section) values.push_back(file.*section);
  }
  return values;
}

void read_gravity(Reader& reader, const Files& files) {
  const FieldInfo info{.name = "gravity", .shape = Shape::quantity_vector, .depends = Depends::parameters};
  for (const Value* value : all_of(files, &FileFields::gravity)) read_value(reader, *value, info, reader.model.gravity);
}

void read_sections(Reader& reader, const Files& files) {
  const auto entries = [&](const Value* FileFields::*section) { return collect(reader, files, section); };
  read_parameters(reader, entries(&FileFields::parameters));
  read_inputs(reader, entries(&FileFields::inputs));
  read_gravity(reader, files);
  read_bodies(reader, entries(&FileFields::bodies));
  read_joints(reader, entries(&FileFields::joints));
  read_rods(reader, entries(&FileFields::rods));
  read_springs(reader, entries(&FileFields::springs));
  read_joint_springs(reader, entries(&FileFields::joint_springs));
  read_frictions(reader, entries(&FileFields::frictions));
  read_air_springs(reader, entries(&FileFields::air_springs));
  read_forces(reader, entries(&FileFields::forces));
  read_joint_forces(reader, entries(&FileFields::joint_forces));
  const Entries tyre_data = entries(&FileFields::tyre_data);
  read_tyres(reader, tyre_data, entries(&FileFields::tyres));
  read_motions(reader, entries(&FileFields::motions));
  read_outputs(reader, entries(&FileFields::outputs));
  read_initial(reader, all_of(files, &FileFields::initial));
  read_solver(reader, all_of(files, &FileFields::solver));
}

/// The file's name without directory and extension, made a valid name.
std::string name_from_file(const std::string& file) {
  std::string name = fs::path(file).stem().string().substr(0, kLongestName);
  for (char& c : name) c = is_valid_name(std::string("_") + c) ? c : '_';
  return is_valid_name(name) ? name : "model";
}

void read_name(Reader& reader, const FileFields& file) {
  Model& model = reader.model;
  model.name = name_from_file(model.file);
  if (!file.name) return;
  if (file.name->kind != Value::Kind::text) {
    report(reader, *file.name, "must be a text, got " + describe(*file.name));
  } else if (!is_valid_name(file.name->text)) {
    report(reader, *file.name, "invalid name " + in_quotes(file.name->text), kNameRule);
  } else {
    model.name = file.name->text;
  }
}

/// FNV-1a, 64 bits, over the texts of all files in the order of reading.
std::string hash_of(const Documents& documents) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Document& document : documents) {
    for (const char byte : document.text) {
      hash ^= static_cast<unsigned char>(byte);
      hash *= 0x100000001b3u;
    }
  }
  return fmt::format("{:016x}", hash);
}

Result<Model> read(std::string_view text, const std::string& file_name, const std::vector<VariedParameter>& varied) {
  Reader reader;
  reader.varied = varied;
  Files files;
  reader.model.file = file_name;
  load(reader, files, file_name, std::string(text));
  // Names that could not be read would all be unknown: that problem comes first.
  if (files.complete && !files.merged.empty()) {
    read_name(reader, files.merged.back());
    read_sections(reader, files);
    if (all_of(files, &FileFields::bodies).empty()) report(reader, reader.documents[0].root, "model has no bodies");
  }
  if (!reader.problems.empty()) return to_diagnostics(reader.documents, std::move(reader.problems));
  reader.model.hash = hash_of(reader.documents);
  for (const Document& document : reader.documents) reader.model.files.push_back(document.file);
  return std::move(reader.model);
}

Result<Model> read_file(const std::string& path, const std::vector<VariedParameter>& varied) {
  FileText content = read_text(path);
  if (!content.problem.empty()) return Diagnostic{{path, 0, 0, {}, {}}, content.problem, {}, {}};
  return read(content.text, path, varied);
}

}  // namespace
}  // namespace reading

Result<Model> read_model(std::string_view text, const std::string& file_name) {
  return reading::read(text, file_name, {});
}

Result<Model> read_model_file(const std::string& path) { return reading::read_file(path, {}); }

Result<Model> read_varied_model(const std::string& path, const std::vector<VariedParameter>& varied) {
  return reading::read_file(path, varied);
}

}  // namespace mbgen
