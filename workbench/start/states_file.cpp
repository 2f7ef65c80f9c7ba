#include "workbench/start/states_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <nlohmann/json.hpp>

#include "compiler/text/plain_json.hpp"
#include "compiler/text/similar_words.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/host/files.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// A value of the file and the way to it, for messages.
struct Entry {
  const Json& value;
  std::string path;  ///< file and JSON pointer
};

[[noreturn]] void fail(const std::string& path, const std::string& message) {
  throw UserError(fmt::format("{}: {}\n", path, message));
}

Json parse(const std::string& text, const std::string& path) {
  PlainJson json = read_plain_json(text);
  if (!json.fault) return std::move(json.value);
  if (json.fault->pointer.empty()) fail(path, "no JSON: " + json.fault->message);
  fail(path + ": " + json.fault->pointer, json.fault->message);
}

/// Names that differ by one letter at most; one or two letters only by their case.
bool is_misspelt(std::string_view name, std::string_view known) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == known || (std::min(name.size(), known.size()) > 2 && edit_distance(lower, known) <= 1);
}

/// Other fields are ignored, but not one that was meant to be known: its numbers would not count.
void refuse_misspelt(const Entry& entry, const std::vector<std::string_view>& fields) {
  for (const auto& [name, value] : entry.value.items()) {
    if (std::ranges::find(fields, name) != fields.end()) continue;
    for (const std::string_view field : fields) {
      if (is_misspelt(name, field))
        fail(entry.path, fmt::format("unknown field \"{}\"; did you mean \"{}\"?", name, field));
    }
  }
}

/// A number; null is one that is not finite, as writers of JSON put it.
double read_number(const Entry& entry) {
  if (entry.value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!entry.value.is_number()) fail(entry.path, fmt::format("must be a number, found {}", entry.value.type_name()));
  return entry.value.get<double>();
}

std::vector<double> read_numbers(const Entry& entry, std::size_t size) {
  if (!entry.value.is_array()) fail(entry.path, fmt::format("must be an array, found {}", entry.value.type_name()));
  if (entry.value.size() != size) {
    fail(entry.path, fmt::format("must have {} numbers, found {}", size, entry.value.size()));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < size; ++i) {
    numbers.push_back(read_number({entry.value[i], fmt::format("{}/{}", entry.path, i)}));
  }
  return numbers;
}

/// Numbers of a field, in the order of the model; empty when the field is missing.
std::vector<double> read_coordinates(const Entry& state, const char* field, const StatesFile& file) {
  const auto found = state.value.find(field);
  if (found == state.value.end()) return {};
  const std::vector<double> numbers = read_numbers({*found, state.path + "/" + field}, file.coordinate.size());
  std::vector<double> values(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) values[file.coordinate[i]] = numbers[i];
  return values;
}

std::vector<std::string> input_names(const Model& model) {
  std::vector<std::string> names;
  for (const Input& input : model.inputs) names.push_back(input.name);
  return names;
}

std::string unknown_name(const char* what, const std::string& name, const std::vector<std::string>& known) {
  const std::string hint = did_you_mean(name, {known.begin(), known.end()});
  return fmt::format("the model has no {} \"{}\"{}{}", what, name, hint.empty() ? "" : "; ", hint);
}

void read_order(const Entry& entry, const Topology& topology, StatesFile& file) {
  if (!entry.value.is_array()) fail(entry.path, "must be an array of coordinate names");
  std::vector<bool> taken(static_cast<std::size_t>(topology.size()), false);
  for (std::size_t i = 0; i < entry.value.size(); ++i) {
    const std::string path = fmt::format("{}/{}", entry.path, i);
    if (!entry.value[i].is_string()) fail(path, "must be the name of a coordinate");
    const std::string name = entry.value[i].get<std::string>();
    const int coordinate = find_coordinate(topology, name);
    if (coordinate < 0) fail(path, unknown_name("coordinate", name, coordinate_names(topology)));
    if (taken[coordinate]) fail(path, fmt::format("coordinate \"{}\" stands twice", name));
    taken[coordinate] = true;
    file.joint_order.push_back(name);
    file.coordinate.push_back(coordinate);
  }
  std::vector<std::string> missing;
  for (int i = 0; i < topology.size(); ++i) {
    if (!taken[i]) missing.push_back(topology.bodies[i].coordinate);
  }
  if (!missing.empty()) fail(entry.path, fmt::format("coordinates are missing: {}", fmt::join(missing, ", ")));
}

void read_inputs(const Entry& entry, const Model& model, std::vector<double>& inputs) {
  if (!entry.value.is_object()) fail(entry.path, "must be an object of input names and values");
  for (const auto& [name, value] : entry.value.items()) {
    const auto found = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&name = name](const Input& input) { return input.name == name; });
    if (found == model.inputs.end()) fail(entry.path, unknown_name("input", name, input_names(model)));
    inputs[static_cast<std::size_t>(found - model.inputs.begin())] = read_number({value, entry.path + "/" + name});
  }
}

FileState read_state(const Entry& entry, const Compilation& compilation, const StatesFile& file,
                     const std::vector<double>& default_inputs) {
  if (!entry.value.is_object()) fail(entry.path, fmt::format("must be an object, found {}", entry.value.type_name()));
  refuse_misspelt(entry, {"z", "zd", "tau", "x", "t", "inputs", "zdd"});
  FileState state;
  GenericState& values = state.at.state;
  values = reference_state(compilation);
  state.at.tau = values.zd;
  state.inputs = default_inputs;
  if (!entry.value.contains("z")) fail(entry.path, "\"z\" is missing");
  values.z = read_coordinates(entry, "z", file);
  if (entry.value.contains("zd")) values.zd = read_coordinates(entry, "zd", file);
  if (entry.value.contains("tau")) state.at.tau = read_coordinates(entry, "tau", file);
  if (entry.value.contains("x")) values.x = read_numbers({entry.value["x"], entry.path + "/x"}, values.x.size());
  if (entry.value.contains("t")) values.t = read_number({entry.value["t"], entry.path + "/t"});
  if (entry.value.contains("inputs")) {
    read_inputs({entry.value["inputs"], entry.path + "/inputs"}, compilation.model, state.inputs);
  }
  return state;
}

/// Expected accelerations where the file has them; whatever else stands there is none of ours.
std::vector<double> read_expected(const Json& state, const StatesFile& file) {
  const auto found = state.find("zdd");
  if (found == state.end() || !found->is_array() || found->size() != file.coordinate.size()) return {};
  const auto is_number = [](const Json& value) { return value.is_number(); };
  if (!std::all_of(found->begin(), found->end(), is_number)) return {};
  return read_coordinates({state, ""}, "zdd", file);
}

/// Accelerations of some coordinates, NaN of the others: an object of their names, or an array with null for none.
std::vector<double> read_given(const Entry& state, const Topology& topology, const StatesFile& file) {
  std::vector<double> given(file.coordinate.size(), std::numeric_limits<double>::quiet_NaN());
  const auto found = state.value.find("zdd");
  if (found == state.value.end()) return given;
  const std::string path = state.path + "/zdd";
  if (found->is_array() && found->size() == given.size()) {
    for (std::size_t i = 0; i < given.size(); ++i)
      if ((*found)[i].is_number()) given[file.coordinate[i]] = (*found)[i].get<double>();
  }
  if (!found->is_object()) return given;
  for (const auto& [name, value] : found->items()) {
    const int coordinate = find_coordinate(topology, name);
    if (coordinate < 0) fail(path, unknown_name("coordinate", name, coordinate_names(topology)));
    given[coordinate] = read_number({value, path + "/" + name});
  }
  return given;
}

}  // namespace

StatesFile read_states(const std::string& path, const Compilation& compilation,
                       const std::vector<double>& default_inputs) {
  return parse_states(read_text(path, reading::kMostBytesOfTree), path, compilation, default_inputs);
}

StatesFile parse_states(const std::string& text, const std::string& path, const Compilation& compilation,
                        const std::vector<double>& default_inputs) {
  const Json json = parse(text, path);
  if (!json.is_object() || !json.contains("states") || !json["states"].is_array()) {
    fail(path, "must be an object with an array \"states\"");
  }
  refuse_misspelt({json, path}, {"states", "joint_order"});
  StatesFile file;
  const Json model_order = coordinate_names(compilation.topology);
  const bool has_order = json.contains("joint_order");
  read_order({has_order ? json["joint_order"] : model_order, path + ": /joint_order"}, compilation.topology, file);
  const Json& states = json["states"];
  for (std::size_t i = 0; i < states.size(); ++i) {
    file.states.push_back(
        read_state({states[i], fmt::format("{}: /states/{}", path, i)}, compilation, file, default_inputs));
    file.states.back().zdd = read_expected(states[i], file);
    file.states.back().given_zdd =
        read_given({states[i], fmt::format("{}: /states/{}", path, i)}, compilation.topology, file);
  }
  return file;
}

std::vector<double> in_file_order(const StatesFile& file, const std::vector<double>& values) {
  std::vector<double> ordered;
  for (const int coordinate : file.coordinate) ordered.push_back(values[coordinate]);
  return ordered;
}

}  // namespace mbgen
