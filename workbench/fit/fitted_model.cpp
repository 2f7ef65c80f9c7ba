// The result of a fit as a model that includes the fitted one.

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/fit/fit.hpp"
#include "workbench/host/files.hpp"

namespace mbgen::fit {

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

std::string before_sign(const std::string& text) { return text.substr(0, text.find('=')); }

}  // namespace

void require_places(const FitArguments& arguments, const std::string& path) {
  const std::string& file = arguments.model.path;
  const Model model = expect(read_model_file(file));
  const std::map<std::string, std::string> places = parameter_places(file);
  for (const std::vector<std::string>* texts : {&arguments.free, &arguments.model.set})
    for (const std::string& text : *texts) {
      const std::string name = before_sign(text);
      for (const Parameter& parameter : model.parameters)
        if (parameter.name == name) place_of(places, name, file, path);
    }
}

std::string fitted_model(const FitResult& result, const std::string& path) {
  namespace fs = std::filesystem;
  const std::map<std::string, std::string> places = parameter_places(result.model_file);
  nlohmann::ordered_json replaced = nlohmann::ordered_json::object();
  const auto replace = [&](const std::string& name, double value) {
    replaced[place_of(places, name, result.model_file, path)] = value;
  };
  for (const VariedParameter& parameter : result.set)
    if (parameter.name != kStepOfMotion) replace(parameter.name, *parameter.value);
  for (std::size_t u = 0; u < result.unknowns.size(); ++u)
    if (result.unknowns[u].kind == Unknown::Kind::parameter) replace(result.unknowns[u].name, result.values[u]);
  const fs::path directory = fs::absolute(path).parent_path();
  const std::string file = fs::absolute(result.model_file).lexically_relative(directory).generic_string();
  return json_text({{"mbgen", 1},
                    {"name", result.model + "_fitted"},
                    {"description", "values found by mbgen fit"},
                    {"include", {{{"file", file}, {"replace", replaced}}}}});
}

}  // namespace mbgen::fit
