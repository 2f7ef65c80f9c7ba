#include "workbench/cost/call_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace mbgen {
namespace {

/// The quoted value after `key` in a line of the file, "" when there is none.
std::string value_of(const std::string& line, const std::string& key) {
  const std::size_t at = line.find(key + ": \"");
  if (at == std::string::npos) return "";
  const std::size_t start = at + key.size() + 3, end = line.find('"', start);
  return end == std::string::npos ? "" : line.substr(start, end - start);
}

/// "four_bar::step_rk4" of "mbgen::Status four_bar::step_rk4(const Parameters&, ...) [with ...]".
std::string plain_name(const std::string& declaration) {
  std::string name = declaration.substr(0, declaration.find('('));
  // An unnamed namespace has brackets of its own braces in g++'s words: {anonymous}.
  const std::size_t space = name.find_last_of(" *&");
  return space == std::string::npos ? name : name.substr(space + 1);
}

void add_function(const std::string& line, CallGraph& graph) {
  constexpr const char* kLine = "\\n";  // as the file writes it
  const std::string title = value_of(line, "title"), label = value_of(line, "label");
  CalledFunction& function = graph[title];
  function.name = plain_name(label.substr(0, label.find(kLine)));
  const std::size_t bytes = label.find(" bytes (");
  if (bytes == std::string::npos) return;
  const std::size_t start = label.rfind(kLine, bytes) + 2;
  if (label.compare(bytes, 16, " bytes (dynamic)") == 0) {
    throw std::runtime_error(fmt::format("the frame of {} has no bound", function.name));
  }
  function.frame = std::max(function.frame, std::strtol(label.c_str() + start, nullptr, 10));
  function.is_outside = false;
  function.is_local = title.find(':') != std::string::npos;
}

class DeepestPath {
 public:
  explicit DeepestPath(const CallGraph& graph) : graph_(graph) {}

  const CallPath& from(const std::string& title) {
    const auto [place, is_new] = known_.try_emplace(title);
    if (!is_new) {
      if (place->second.titles.empty()) throw std::runtime_error(fmt::format("{} calls itself", title));
      return place->second;
    }
    const CalledFunction& function = graph_.at(title);
    CallPath deepest;
    for (const std::string& called : function.calls) {
      const CallPath& path = from(called);
      if (path.bytes > deepest.bytes) deepest = path;
    }
    deepest.bytes += function.frame;
    deepest.titles.insert(deepest.titles.begin(), title);
    return known_[title] = deepest;
  }

 private:
  const CallGraph& graph_;
  std::map<std::string, CallPath> known_;  ///< without titles while they are looked for
};

}  // namespace

void add_call_graph(const std::string& text, CallGraph& graph) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("node:")) add_function(line, graph);
    if (!line.starts_with("edge:")) continue;
    const std::string target = value_of(line, "targetname");
    graph[value_of(line, "sourcename")].calls.insert(target);
    graph.try_emplace(target);
  }
}

CallPath deepest_path(const CallGraph& graph, const std::string& title) { return DeepestPath(graph).from(title); }

}  // namespace mbgen
