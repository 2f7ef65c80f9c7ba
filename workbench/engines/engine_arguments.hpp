#pragma once
// Engine and form, as typed.

#include <optional>
#include <string>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

/// The form of this name, none for "". Fails: UserError for an unknown form.
std::optional<Form> chosen_form(const std::string& typed);

/// Engine and inputs as typed.
struct EngineArguments {
  EngineChoice choice;
  std::string linear_algebra, factorisation, stabilisation;  ///< "" for the default
  std::vector<std::string> inputs;                           ///< name=value
};

/// The engine that the arguments choose. Fails: UserError for an unknown linear algebra, factorisation or
/// stabilisation, for one that the engine does not offer, and for QR without Eigen.
EngineChoice chosen_engine(const EngineArguments& arguments);

}  // namespace mbgen
