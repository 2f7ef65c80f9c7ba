#include "tests/system/rooms/house.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace mbgen::house {
namespace {

namespace fs = std::filesystem;

const std::string kRuntimeHeaders = "runtime/include/mbgen";

/// The words in the parentheses of each call of a CMake function at the start of a line.
std::vector<std::vector<std::string>> calls(const std::string& cmake, const std::string& head) {
  std::vector<std::vector<std::string>> found;
  for (std::size_t at = cmake.find("\n" + head); at != std::string::npos; at = cmake.find("\n" + head, at + 1)) {
    const std::size_t first = at + 1 + head.size();
    std::istringstream words(cmake.substr(first, cmake.find(')', first) - first));
    std::vector<std::string>& call = found.emplace_back();
    for (std::string word; words >> word;) call.push_back(word);
  }
  return found;
}

}  // namespace

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Rooms table_of_rooms(const std::string& cmake) {
  Rooms rooms{{"runtime", {kRuntimeHeaders, {"fmu", "lanes", "math", "solver", "tyres"}, {}, {}}}};
  for (const std::vector<std::string>& call : calls(cmake, "mbgen_room(")) {
    Room& room = rooms[call.at(0)];
    room.directory = call.at(1);
    for (std::size_t i = 2; i < call.size(); ++i)
      if (call[i].starts_with("mbgen_")) room.uses.insert(call[i].substr(6));
  }
  for (auto& [name, room] : rooms)
    for (const std::vector<std::string>& call : calls(cmake, "set(mbgen_folders_" + name + " "))
      room.folders.insert(call.begin(), call.end());
  for (const std::vector<std::string>& call : calls(cmake, "mbgen_doors("))
    rooms[call.at(0)].doors.insert(call.begin() + 1, call.end());
  return rooms;
}

Rooms rooms_of_project() { return table_of_rooms(text_of(fs::path(MBGEN_SOURCE_DIR) / "CMakeLists.txt")); }

std::vector<Include> includes_of(const std::string& text) {
  const std::string head = "#include \"";
  std::vector<Include> found;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (!line.starts_with(head)) continue;
    std::string path = line.substr(head.size(), line.find('"', head.size()) - head.size());
    if (path.starts_with("mbgen/")) path = "runtime/include/" + path;
    found.push_back({number, std::move(path)});
  }
  return found;
}

std::optional<std::string> path_in(const Room& room, const std::string& file) {
  if (!file.starts_with(room.directory + "/")) return {};
  const std::string below = file.substr(room.directory.size() + 1);
  const std::size_t slash = below.find('/');
  if (slash != std::string::npos && !room.folders.contains(below.substr(0, slash))) return {};
  return below;
}

std::optional<std::string> room_of(const Rooms& rooms, const std::string& file) {
  for (const auto& [name, room] : rooms)
    if (path_in(room, file)) return name;
  return {};
}

std::vector<std::string> forbidden_includes(const Rooms& rooms, const std::string& file, const std::string& text) {
  const std::optional<std::string> from = room_of(rooms, file);
  if (!from) return {file + ":1: stands in no room"};
  std::vector<std::string> found;
  for (const auto& [number, included] : includes_of(text)) {
    const std::optional<std::string> to = room_of(rooms, included);
    const std::string place = file + ":" + std::to_string(number) + ": ";
    if (!to) {
      found.push_back(place + included + " stands in no room");
    } else if (*to == *from) {
      continue;
    } else if (!rooms.at(*from).uses.contains(*to)) {
      found.push_back(place + "room " + *from + " does not use room " + *to + ": " + included);
    } else if (*to != "runtime" && !rooms.at(*to).doors.contains(*path_in(rooms.at(*to), included))) {
      found.push_back(place + included + " is no door of room " + *to);
    }
  }
  return found;
}

std::set<std::string> reached_from(const Graph& graph, const std::string& node) {
  std::set<std::string> reached;
  std::vector<std::string> open{node};
  while (!open.empty()) {
    const auto found = graph.find(open.back());
    open.pop_back();
    if (found == graph.end()) continue;
    for (const std::string& next : found->second)
      if (reached.insert(next).second) open.push_back(next);
  }
  return reached;
}

std::vector<std::string> sources_below(const std::vector<std::string>& folders) {
  const fs::path root = MBGEN_SOURCE_DIR;
  std::vector<std::string> found;
  for (const std::string& folder : folders) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".cpp" || extension == ".hpp") found.push_back(fs::relative(entry.path(), root).string());
    }
  }
  std::ranges::sort(found);
  return found;
}

std::map<std::string, std::string> texts_below(const std::vector<std::string>& folders) {
  std::map<std::string, std::string> texts;
  for (const std::string& file : sources_below(folders)) texts[file] = text_of(fs::path(MBGEN_SOURCE_DIR) / file);
  const std::string kinds = "compiler/model/elements/";
  for (const char* floor : {"compiler/formulation/elements/", "runtime/judges/elements/"}) {
    std::string includes;
    for (const auto& [file, text] : texts)
      if (file.starts_with(kinds) && texts.contains(floor + file.substr(kinds.size())))
        includes += "#include \"" + (floor + file.substr(kinds.size())) + "\"\n";
    if (!includes.empty()) texts[std::string(floor) + "every_kind.hpp"] = includes;
  }
  return texts;
}

}  // namespace mbgen::house
