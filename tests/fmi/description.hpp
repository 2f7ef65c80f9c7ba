#pragma once
// The importer's part of a model description: names, references and dependencies. It is written by mbgen, element by
// element on lines of their own, and checked against the schemas by xmllint: no XML parser is needed here.

#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Variable {
  std::string name, causality, initial, variability;
  unsigned reference = 0;
  bool has_range = false;
  bool reinit = false;  ///< whether an event may change it
  double nominal = 1;
};

struct Unknown {
  unsigned reference = 0;
  std::set<unsigned> dependencies;
};

struct Description {
  std::string token, identifier;
  double step = 0;
  std::vector<Variable> variables;  ///< by reference
  std::vector<Unknown> outputs, derivatives;
  std::size_t indicators = 0;             ///< event indicators
  std::map<unsigned, unsigned> state_of;  ///< by reference of the derivative

  unsigned reference(const std::string& name) const {
    for (const Variable& variable : variables)
      if (variable.name == name) return variable.reference;
    throw std::runtime_error("no variable " + name);
  }
  /// An output whose name is taken has a prefix.
  unsigned output(const std::string& name) const {
    for (const Variable& variable : variables)
      if (variable.name == "y." + name) return variable.reference;
    return reference(name);
  }
  std::vector<unsigned> states() const {
    std::vector<unsigned> result;
    for (const Unknown& derivative : derivatives) result.push_back(state_of.at(derivative.reference));
    return result;
  }
};

inline std::string attribute(const std::string& line, const std::string& name) {
  std::smatch match;
  return std::regex_search(line, match, std::regex(" " + name + "=\"([^\"]*)\"")) ? match[1].str() : "";
}

inline Unknown unknown_of(const std::string& line, unsigned offset) {
  Unknown unknown;
  const std::string place = attribute(line, offset == 1 ? "index" : "valueReference");
  unknown.reference = static_cast<unsigned>(std::stoul(place)) - offset;
  std::istringstream list(attribute(line, "dependencies"));
  for (unsigned known = 0; list >> known;) unknown.dependencies.insert(known - offset);
  return unknown;
}

inline Description read_description(const std::string& path) {
  Description description;
  std::ifstream file(path);
  std::string section;
  unsigned offset = 0, last = 0;
  for (std::string line; std::getline(file, line);) {
    const std::string token = attribute(line, "guid") + attribute(line, "instantiationToken");
    if (!token.empty()) description.token = token;
    if (!attribute(line, "guid").empty()) offset = 1;
    if (!attribute(line, "numberOfEventIndicators").empty())
      description.indicators = std::stoul(attribute(line, "numberOfEventIndicators"));
    if (line.find("<EventIndicator ") != std::string::npos) ++description.indicators;
    if (!attribute(line, "modelIdentifier").empty()) description.identifier = attribute(line, "modelIdentifier");
    if (!attribute(line, "stepSize").empty())
      description.step = std::strtod(attribute(line, "stepSize").c_str(), nullptr);
    if (line.find("<Outputs>") != std::string::npos) section = "Output";
    if (line.find("<Derivatives>") != std::string::npos) section = "Derivative";
    if (line.find("<InitialUnknowns>") != std::string::npos) section = "";
    if (line.find(" causality=") != std::string::npos) {
      last = static_cast<unsigned>(std::stoul(attribute(line, "valueReference")));
      description.variables.push_back({attribute(line, "name"), attribute(line, "causality"),
                                       attribute(line, "initial"), attribute(line, "variability"), last});
    }
    if (!attribute(line, "max").empty()) description.variables.back().has_range = true;
    if (!attribute(line, "nominal").empty())
      description.variables.back().nominal = std::strtod(attribute(line, "nominal").c_str(), nullptr);
    if (attribute(line, "reinit") == "true") description.variables.back().reinit = true;
    if (!attribute(line, "derivative").empty()) {
      description.state_of[last] = static_cast<unsigned>(std::stoul(attribute(line, "derivative"))) - offset;
    }
    const bool is_output = line.find("<Output ") != std::string::npos;
    const bool is_derivative = line.find("<ContinuousStateDerivative ") != std::string::npos;
    const bool is_unknown = line.find("<Unknown ") != std::string::npos;
    if (is_output || (is_unknown && section == "Output")) description.outputs.push_back(unknown_of(line, offset));
    if (is_derivative || (is_unknown && section == "Derivative"))
      description.derivatives.push_back(unknown_of(line, offset));
  }
  if (description.token.empty() || description.variables.empty()) throw std::runtime_error("no description in " + path);
  return description;
}
