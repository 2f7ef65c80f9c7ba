#include "compiler/text/json_text.hpp"

#include <nlohmann/json.hpp>

#include "compiler/text/characters.hpp"

namespace mbgen {

std::string json_text(const nlohmann::ordered_json& report) {
  return json_shown(report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

}  // namespace mbgen
