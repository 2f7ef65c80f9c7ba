#include "compiler/text/plain_json.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// An object or array that is being read.
struct Level {
  std::set<std::string> names = {};  ///< of an object, so far
  std::string last = {};             ///< its last one
  std::size_t items = 0;             ///< of an array, so far
};

/// Watches a text being parsed.
struct RepeatedName {
  std::vector<Level> levels = {};
  std::string pointer = {};  ///< of the first one

  std::string pointer_of_last() const {
    std::string text;
    for (const Level& level : levels) text += "/" + (level.names.empty() ? std::to_string(level.items) : level.last);
    return text;
  }

  void name(const std::string& name) {
    const bool is_new = levels.back().names.insert(name).second;
    levels.back().last = name;
    if (!is_new && pointer.empty()) pointer = pointer_of_last();
  }

  void see(Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::key) return name(parsed.get<std::string>());
    if (event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start) {
      levels.emplace_back();
      return;
    }
    if (event != Json::parse_event_t::value) levels.pop_back();
    if (!levels.empty()) ++levels.back().items;
  }
};

/// The message of an exception without its number, as in "[json.exception.parse_error.101] parse error at line 1".
std::string words_of(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t bracket = text.find("] ");
  return bracket == std::string::npos ? text : text.substr(bracket + 2);
}

/// Where the number stands that the message of an overflow quotes.
std::size_t place_of_quoted(const std::string& text, const std::string& message) {
  const std::size_t first = message.find('\''), last = message.rfind('\'');
  if (first == std::string::npos || last <= first) return 0;
  const std::size_t found = text.find(message.substr(first + 1, last - first - 1));
  return found == std::string::npos ? 0 : found;
}

}  // namespace

PlainJson read_plain_json(const std::string& text) {
  constexpr bool kThrows = true, kIgnoreComments = true;
  RepeatedName repeated;
  const auto watch = [&](int, Json::parse_event_t event, const Json& parsed) {
    repeated.see(event, parsed);
    return true;
  };
  try {
    PlainJson result{Json::parse(text, watch, kThrows, kIgnoreComments), std::nullopt};
    if (!repeated.pointer.empty()) result.fault = JsonFault{"stands twice", 0, repeated.pointer, false};
    return result;
  } catch (const Json::parse_error& error) {
    const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    return {Json(), JsonFault{words_of(error), std::min(byte, text.size()), {}, false}};
  } catch (const Json::exception& error) {
    return {Json(), JsonFault{words_of(error), place_of_quoted(text, words_of(error)), {}, true}};
  }
}

}  // namespace mbgen
