#include "workbench/search/found_model.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"

namespace mbgen {

std::map<std::string, std::string> parameter_places(const std::string& model_file) {
  const Model model = expect(read_model_file(model_file));
  std::map<std::string, std::string> places;
  std::map<std::string, nlohmann::json> files;
  for (const Parameter& parameter : model.parameters) {
    const std::string pointer = "/parameters/" + parameter.name;
    if (parameter.where.pointer != pointer || parameter.where.file.empty()) continue;
    nlohmann::json& file = files[parameter.where.file];
    if (file.is_null()) file = nlohmann::json::parse(read_text(parameter.where.file), nullptr, false, true);
    const nlohmann::json::json_pointer place(pointer);
    if (!file.is_object() || !file.contains(place)) continue;
    const nlohmann::json& value = file[place];
    places[parameter.name] = value.is_object() && value.contains("value") ? pointer + "/value" : pointer;
  }
  return places;
}

namespace {

/// The place of a parameter. Fails: UserError.
const std::string& place_of(const std::map<std::string, std::string>& places, const std::string& name,
                            const std::string& model, const std::string& path) {
  const auto found = places.find(name);
  if (found != places.end()) return found->second;
  throw UserError(fmt::format(
      "{}: cannot hold \"{}\", which belongs to an instance in {}\n  hint: give the model a parameter of its "
      "own, which the instance uses, or leave out --out and take the value from the table\n",
      path, name, model));
}

}  // namespace

void require_places(const std::string& model_file, const std::vector<std::string>& names, const std::string& path) {
  const Model model = expect(read_model_file(model_file));
  const std::map<std::string, std::string> places = parameter_places(model_file);
  for (const std::string& name : names)
    for (const Parameter& parameter : model.parameters)
      if (parameter.name == name) place_of(places, name, model_file, path);
}

std::string text_of(const FoundModel& found, const std::string& path) {
  namespace fs = std::filesystem;
  const std::map<std::string, std::string> places = parameter_places(found.model_file);
  nlohmann::ordered_json replaced = nlohmann::ordered_json::object();
  for (const auto& [name, value] : found.values) replaced[place_of(places, name, found.model_file, path)] = value;
  const fs::path directory = fs::absolute(path).parent_path();
  const std::string file = fs::absolute(found.model_file).lexically_relative(directory).generic_string();
  return json_text({{"mbgen", 1},
                    {"name", found.name},
                    {"description", found.description},
                    {"include", {{{"file", file}, {"replace", replaced}}}}});
}

}  // namespace mbgen
