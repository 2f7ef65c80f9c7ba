#pragma once
// Parts of an FMU for people and for the diagrams of importers.

#include <string>

#include "compiler/emit/fmu_description.hpp"

namespace mbgen {

/// `documentation/index.html`: the model's description, its variables, bodies and joints.
std::string documentation(const EmitContext& context, const FmuLayout& fmu, FmiVersion version);

/// `terminalsAndIcons/terminalsAndIcons.xml` of FMI 3: a bus of the inputs, one of the outputs, and the icon.
std::string terminals_and_icons(const FmuLayout& fmu);

}  // namespace mbgen
