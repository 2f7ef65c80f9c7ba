#pragma once
// The texts of an FMU's files: a function each.

#include <string>
#include <vector>

#include "compiler/fmu/variables.hpp"

namespace mbgen {

/// `<model>_directional.hpp`: the programs differentiated along a direction.
std::string directional_header_text(const EmitContext& context);

/// `<model>_directional.cpp`. programs: after the passes, not contracted; context.programs is not looked at.
std::string directional_source_text(const EmitContext& context, const Programs& programs);

/// `modelDescription.xml`. sources: files to compile, relative to `sources/`.
std::string model_description(const EmitContext& context, const FmuLayout& fmu, FmiVersion version,
                              const std::vector<std::string>& sources);

/// Token that an importer must give back to instantiate: of the model's content and mbgen's version.
std::string fmu_token(const Model& model);

/// `sources/buildDescription.xml`, as FMI 3 has it; importers take it from units of FMI 2, too.
std::string build_description(const EmitContext& context, FmiVersion version, const std::vector<std::string>& sources);

/// `documentation/index.html`: the model's description, its variables, bodies and joints.
std::string documentation(const EmitContext& context, const FmuLayout& fmu, FmiVersion version);

/// `terminalsAndIcons/terminalsAndIcons.xml` of FMI 3: a bus of the inputs, one of the outputs, and the icon.
std::string terminals_and_icons(const FmuLayout& fmu);

}  // namespace mbgen
