#pragma once
// Decisions of the analysis as bytes, for another run of the same mbgen on the same machine.

#include <optional>
#include <string>
#include <string_view>

#include "compiler/analysis/findings.hpp"

namespace mbgen {

std::string bytes_of(const Analysis& analysis);

/// The same decisions to the last bit, nothing where the bytes are none of bytes_of.
std::optional<Analysis> analysis_of_bytes(std::string_view bytes);

}  // namespace mbgen
