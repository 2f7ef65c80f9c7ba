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

std::string fitted_model(const FitResult& result, const std::string& path) {
  namespace fs = std::filesystem;
  const std::map<std::string, std::string> places = parameter_places(result.model_file);
  nlohmann::ordered_json replaced = nlohmann::ordered_json::object();
  const auto replace = [&](const std::string& name, double value) {
    const auto found = places.find(name);
    if (found == places.end())
      throw UserError(fmt::format(
          "{}: cannot hold \"{}\", which belongs to an instance of {}\n  hint: give the model a parameter of its own, "
          "which the instance uses, or leave out --out and use --set {}={}\n",
          path, name, result.model_file, name, value));
    replaced[found->second] = value;
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
