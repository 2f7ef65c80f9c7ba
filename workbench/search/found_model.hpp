#pragma once
// Found values as a model that includes the one that was searched.

#include <map>
#include <string>
#include <vector>

namespace mbgen {

/// Where a model writes its parameters: JSON Pointers of the values that an including file can replace.
std::map<std::string, std::string> parameter_places(const std::string& model_file);

/// Whether values can be written as a model. names: of the parameters; path: its file. Fails: UserError for a parameter
/// that no file of the model writes in its own "parameters", as one of an instance.
void require_places(const std::string& model_file, const std::vector<std::string>& names, const std::string& path);

/// The journal of a search beside the model that it writes, "" for one that writes none.
inline std::string journal_beside(const std::string& out) { return out.empty() ? "" : out + ".journal"; }

/// A model of the values.
struct FoundModel {
  std::string name, description;
  std::string model_file;                              ///< included
  std::vector<std::pair<std::string, double>> values;  ///< of parameters
};

/// Its text, for a file with this path. Fails: UserError, as require_places.
std::string text_of(const FoundModel& found, const std::string& path);

}  // namespace mbgen
