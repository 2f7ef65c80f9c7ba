#pragma once
// JSON without positions of its values, for small files beside a model: with comments, without repeated names.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace mbgen {

/// Why a text is not read.
struct JsonFault {
  std::string message;
  std::size_t byte = 0;    ///< in the text, of a fault of syntax or of a number
  std::string pointer;     ///< of a name that stands twice in its object, empty otherwise
  bool is_number = false;  ///< a number that no double holds
};

struct PlainJson {
  nlohmann::ordered_json value;
  std::optional<JsonFault> fault;
};

/// Faults are syntax, numbers that no double holds, and names that stand twice in one object, of which any reader would
/// ignore one.
PlainJson read_plain_json(const std::string& text);

}  // namespace mbgen
