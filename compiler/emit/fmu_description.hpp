#pragma once
// The XML files of an FMU.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/emit/fmu_variables.hpp"

namespace mbgen {

/// Token that an importer must give back to instantiate: of the model's content and mbgen's version.
std::string fmu_token(const Model& model);

/// `modelDescription.xml`. sources: files to compile, relative to `sources/`.
std::string model_description(const EmitContext& context, const FmuLayout& fmu, FmiVersion version,
                              const std::vector<std::string>& sources);

/// `sources/buildDescription.xml`, as FMI 3 has it; importers take it from units of FMI 2, too.
std::string build_description(const EmitContext& context, FmiVersion version, const std::vector<std::string>& sources);

/// A text between tags or as the value of an attribute.
std::string xml_text(std::string_view text);

/// A number, "" for none.
std::string number_or_none(const std::optional<double>& number);

}  // namespace mbgen
