#pragma once
// The XML files of an FMU.

#include <string>
#include <vector>

#include "compiler/emit/fmu_variables.hpp"

namespace mbgen {

/// What an importer must give back to instantiate: of the model's content and mbgen's version.
std::string fmu_token(const Model& model);

/// `modelDescription.xml`. sources: files to compile, relative to `sources/`.
std::string model_description(const EmitContext& context, const FmuLayout& fmu, FmiVersion version,
                              const std::vector<std::string>& sources);

/// `sources/buildDescription.xml` of FMI 3.
std::string build_description(const EmitContext& context, const std::vector<std::string>& sources);

}  // namespace mbgen
