// Interface of the reader: the sections of all files, read one after the other.
#include "compiler/reader/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "compiler/model/model.hpp"
#include "compiler/reader/elements/actuator.hpp"
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/read_states.hpp"
#include "compiler/reader/reader.hpp"
#include "compiler/reader/tables/read_tables.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/read_text.hpp"

namespace mbgen {
namespace reading {
namespace {

namespace fs = std::filesystem;

/// A body with points only in an including file adds them to the body of an included file; so does any ground.
bool extends_body(const Entry& entry) {
  const auto& members = entry.value->members;
  const bool points_only =
      entry.value->kind == Value::Kind::object && members.size() == 1 && members[0].key == "points";
  return points_only || entry.name == "ground";
}

/// First definition of a name.
struct FirstPlace {
  Place place;
  std::size_t scope = 0;
};

/// Reports a duplicate name.
void report_twice(Reader& reader, const Entry& entry, const FirstPlace& first) {
  std::string where = place_text(reader.documents, first.place, entry.place);
  const std::string& instance = reader.scopes[first.scope].path;
  if (first.scope != entry.scope)
    where += instance.empty() ? " of the model" : fmt::format(" of instance {}", in_quotes(instance));
  report(reader, entry.place, fmt::format("name {} is defined twice, first at {}", in_quotes(entry.name), where),
         first.scope != entry.scope ? "give the instance another prefix or suffix" : "");
}

/// Whether an instance is another one or inside it.
bool is_inside(const Reader& reader, std::size_t instance, std::size_t outer) {
  while (instance > outer) instance = reader.scopes[instance].parent;
  return instance == outer;
}

/// Names of the bodies defined by instances; definitions inside an instance precede its additions to them.
NameMap<std::size_t> bodies_of_instances(Reader& reader) {
  NameMap<std::size_t> names;
  for (std::size_t scope = 1; scope < reader.scopes.size(); ++scope) {
    const InScope in_scope(reader, scope);
    for (const FileFields& file : reader.scopes[scope].files) {
      if (!file.bodies) continue;
      for (const Member& member : file.bodies->members) {
        const std::string name = full_name(current_scope(reader).visible.front(), member.key);
        if (is_outer_body(reader, member.key)) continue;
        const auto [first, is_new] = names.emplace(name, scope);
        if (!is_new && is_inside(reader, scope, first->second)) first->second = scope;
      }
    }
  }
  return names;
}

/// Adds the entries of one map to those of its section. inner: for a map of bodies, the bodies defined by instances.
void collect_map(Reader& reader, const Value& map, const NameMap<std::size_t>* inner, NameMap<FirstPlace>& places,
                 Entries& entries) {
  for (const Member& member : map.members) {
    const std::string name = full_name(current_scope(reader).visible.front(), member.key);
    Entry entry{name, member.key, member.place, &member.value, reader.scope};
    if (inner) {
      const auto defined = inner->find(name);
      const bool by_instance = defined != inner->end() && defined->second != reader.scope &&
                               is_inside(reader, defined->second, reader.scope) && extends_body(entry);
      entry.adds_points = by_instance || is_outer_body(reader, member.key);
    }
    if (entry.adds_points) {
      entries.push_back(entry);
      continue;
    }
    const auto [first, is_new] = places.emplace(name, FirstPlace{member.place, reader.scope});
    if (is_new && !is_valid_name(member.key)) {
      report(reader, member.place, "invalid name " + in_quotes(member.key), kNameRule);
    } else if (is_new && !is_valid_name(name)) {
      report(reader, member.place, "invalid name " + in_quotes(name), kNameRule);
    }
    const bool same_scope = first->second.scope == reader.scope;
    if (!is_new && same_scope && first->second.place.file == member.place.file) continue;  // a duplicate key
    if (!is_new && !(inner && same_scope && extends_body(entry))) {
      report_twice(reader, entry, first->second);
      continue;
    }
    entries.push_back(entry);
  }
}

/// The entries of one section in all files: the model's own, then the entries of each instance.
Entries collect(Reader& reader, const Value* FileFields::*section) {
  Entries entries;
  NameMap<FirstPlace> places;
  NameMap<std::size_t> inner;
  const bool bodies = section == &FileFields::bodies;
  if (bodies) inner = bodies_of_instances(reader);
  for (std::size_t scope = 0; scope < reader.scopes.size(); ++scope) {
    const InScope in_scope(reader, scope);
    for (const FileFields& file : reader.scopes[scope].files) {
      const Value* map = file.*section;
      if (!map) continue;
      if (map->kind == Value::Kind::object) {
        collect_map(reader, *map, bodies ? &inner : nullptr, places, entries);
      } else {
        report(reader, *map, "must be an object of named elements, got " + describe(*map));
      }
    }
  }
  return entries;
}

std::vector<Part> parts_of(const Reader& reader, std::size_t scope, const Value* FileFields::*section) {
  std::vector<Part> parts;
  for (const FileFields& file : reader.scopes[scope].files) {
    if (file.*section) parts.push_back({file.*section, scope});
  }
  return parts;
}

/// Initial values of the instances, innermost first, then of the model.
std::vector<Part> initial_parts(const Reader& reader) {
  std::vector<std::size_t> order;
  for (std::size_t scope = 0; scope < reader.scopes.size(); ++scope) order.push_back(scope);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return reader.scopes[a].visible.size() > reader.scopes[b].visible.size();
  });
  std::vector<Part> parts;
  for (const std::size_t scope : order) {
    for (const Part& part : parts_of(reader, scope, &FileFields::initial)) parts.push_back(part);
  }
  return parts;
}

void read_gravity(Reader& reader) {
  const FieldInfo info{.name = "gravity", .shape = Shape::quantity_vector, .depends = Depends::parameters};
  for (const Part& part : parts_of(reader, 0, &FileFields::gravity)) {
    read_value(reader, *part.value, info, reader.model.gravity);
  }
}

void read_sections(Reader& reader) {
  const auto entries = [&](const Value* FileFields::*section) { return collect(reader, section); };
  read_parameters(reader, entries(&FileFields::parameters));
  read_tables(reader, entries(&FileFields::tables));
  read_maps(reader, entries(&FileFields::maps));
  read_inputs(reader, entries(&FileFields::inputs));
  add_host_inputs(reader, entries(&FileFields::roads));
  const Entries actuators = entries(&SectionOf<Actuator>::section);  // their inputs and rods are known before them
  add_actuator_inputs(reader, actuators);
  read_gravity(reader);
  read_hardpoints(reader, entries(&FileFields::hardpoints));
  place_instances(reader);
  ComposedParts made;
  each_composition([&]<class Fields>(Composition<Fields> composition) {
    section_of(composition).compose(reader, entries(&SectionOf<Fields>::section), made);
  });
  compose_rotors(reader, actuators, made);
  read_bodies(reader, with_composed(reader, entries(&FileFields::bodies), made.bodies));
  reader.has_bodies = true;
  read_joints(reader, with_composed(reader, entries(&FileFields::joints), made.joints));
  check_inertias(reader);
  read_rods(reader, with_composed(reader, entries(&FileFields::rods), made.rods), actuators);
  read_couplings(reader, with_composed(reader, entries(&FileFields::couplings), made.couplings));
  std::array<Entries, ElementKinds::count> elements;
  each_section([&]<class Kind>(KindOf<Kind>) {
    elements[kKindIndex<Kind>] = with_composed(reader, entries(&SectionOf<Kind>::section), made.of<Kind>());
  });
  name_lines(reader, elements);
  const Entries outputs = entries(&FileFields::outputs);
  name_outputs(reader, outputs);
  const StateEntries states{entries(&FileFields::states), entries(&FileFields::values), entries(&FileFields::sensors),
                            entries(&FileFields::delays), entries(&FileFields::sampled)};
  read_states(reader, states);
  read_roads(reader, entries(&FileFields::roads));
  reader.tyre_data = entries(&FileFields::tyre_data);
  each_section([&]<class Kind>(KindOf<Kind>) { section_of(Leader<Kind>()).read(reader, elements[kKindIndex<Kind>]); });
  check_state_names(reader, states);
  const Entries motions = entries(&FileFields::motions);
  read_motions(reader, motions);
  act_on_motions(reader, actuators, motions);
  make_second_rates(reader);
  read_axles(reader, entries(&FileFields::axles));
  read_vehicle(reader, parts_of(reader, 0, &FileFields::vehicle));
  read_outputs(reader, outputs);
  observe_outputs(reader);
  read_shapes(reader, with_composed(reader, entries(&FileFields::shapes), made.shapes));
  read_initial(reader, initial_parts(reader));
  read_solver(reader, parts_of(reader, 0, &FileFields::solver));
  finish_lags(reader);
  finish_hardpoints(reader);
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

/// Hash of the texts of all files in the order of reading.
std::string hash_of(const Documents& documents) {
  Hash hash;
  for (const Document& document : documents) hash.add_bytes(document.text);
  return hash.text();
}

Result<Model> read(std::string_view text, const std::string& file_name, const std::vector<VariedParameter>& varied) {
  Reader reader;
  reader.varied = varied;
  reader.model.file = file_name;
  // After a failure names are unknown, so further messages would be misleading.
  if (load_files(reader, file_name, std::string(text))) {
    const FileFields& asked_for = reader.scopes[0].files.back();
    read_name(reader, asked_for);
    reader.model.about = asked_for;
    read_sections(reader);
    if (reader.model.bodies.empty() && parts_of(reader, 0, &FileFields::bodies).empty())
      report(reader, reader.documents[0].root, "model has no bodies");
  }
  if (!reader.problems.empty()) return to_diagnostics(reader.documents, std::move(reader.problems));
  note_unlikely(reader);
  for (Diagnostic& note : to_diagnostics(reader.documents, std::move(reader.notes)))
    reader.model.notes.push_back(std::move(note));
  if (!reader.samples->empty()) reader.model.samples = std::move(reader.samples);
  reader.model.hash = hash_of(reader.documents);
  for (const Document& document : reader.documents) reader.model.files.push_back(document.file);
  return std::move(reader.model);
}

Result<Model> read_file(const std::string& path, const std::vector<VariedParameter>& varied) {
  FileText content = read_text(path);
  if (!content.problem.empty()) return Diagnostic{{path, 0, 0, {}, {}}, content.problem, hint_of_missing(path), {}};
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
