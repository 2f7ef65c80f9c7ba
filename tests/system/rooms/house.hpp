#pragma once
// The house as CMakeLists.txt tells it: rooms, what they use, their doors.

#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mbgen::house {

struct Room {
  std::string directory;
  std::set<std::string> folders;  ///< of its directory, that belong to it
  std::set<std::string> uses;     ///< names of rooms
  std::set<std::string> doors;    ///< headers that other rooms include, relative to the directory
};

using Rooms = std::map<std::string, Room>;

std::string text_of(const std::filesystem::path& path);

/// Whether a letter belongs to an identifier.
inline bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The rooms of a CMake file, by its lines mbgen_room(NAME DIRECTORY DEPENDENCY...), set(mbgen_folders_NAME FOLDER...)
/// and mbgen_doors(NAME HEADER...), with the headers of emitted code as room "runtime". Dependencies that are no rooms
/// are packages.
Rooms table_of_rooms(const std::string& cmake);

/// The table of the project itself.
Rooms rooms_of_project();

/// An include of ours.
struct Include {
  int line;
  std::string path;  ///< as written, but for headers of emitted code: from the root of the project
};
std::vector<Include> includes_of(const std::string& text);

/// The room that a file belongs to, which is relative to the root.
std::optional<std::string> room_of(const Rooms& rooms, const std::string& file);

/// The path of a file below the directory of a room, nothing where it belongs to another.
std::optional<std::string> path_in(const Room& room, const std::string& file);

/// `file:line: ...` of every include of ours that the table does not allow: of a room that the room does not name, or
/// of a header that is no door.
std::vector<std::string> forbidden_includes(const Rooms& rooms, const std::string& file, const std::string& text);

/// All that a node of a graph reaches. graph: per node the next ones.
using Graph = std::map<std::string, std::set<std::string>>;
std::set<std::string> reached_from(const Graph& graph, const std::string& node);

/// Sources (.cpp, .hpp) below some folders of the project, relative to it, in order.
std::vector<std::string> sources_below(const std::vector<std::string>& folders);

/// The sources of the product below some folders by their paths, with the headers that every_kind.cmake writes.
std::map<std::string, std::string> texts_below(const std::vector<std::string>& folders);

}  // namespace mbgen::house
