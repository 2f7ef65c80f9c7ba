// The guard of the rooms: an include that the table of rooms in CMakeLists.txt does not allow fails.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::string kRuntimeHeaders = "runtime/include/mbgen";

struct Room {
  std::string directory;
  std::set<std::string> uses;  ///< names of rooms
};

using Rooms = std::map<std::string, Room>;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The lines `mbgen_room(name directory dependencies...)` of a CMake file. Dependencies that are no rooms are packages.
Rooms table_of_rooms(const std::string& cmake) {
  const std::string head = "\nmbgen_room(";
  Rooms rooms{{"runtime", {kRuntimeHeaders, {}}}};
  for (std::size_t at = cmake.find(head); at != std::string::npos; at = cmake.find(head, at + 1)) {
    const std::size_t first = at + head.size();
    std::istringstream words(cmake.substr(first, cmake.find(')', first) - first));
    std::string name, word;
    words >> name;
    Room& room = rooms[name];
    words >> room.directory;
    while (words >> word)
      if (word.starts_with("mbgen_")) room.uses.insert(word.substr(6));
  }
  return rooms;
}

/// Adds what the rooms that a room uses use themselves.
void close(Rooms& rooms) {
  for (bool grows = true; grows;) {
    grows = false;
    for (auto& [name, room] : rooms) {
      std::set<std::string> all = room.uses;
      for (const std::string& used : room.uses)
        if (const auto found = rooms.find(used); found != rooms.end())
          all.insert(found->second.uses.begin(), found->second.uses.end());
      grows = grows || all.size() > room.uses.size();
      room.uses = std::move(all);
    }
  }
}

/// The room whose directory holds the file, directly.
std::optional<std::string> room_of(const Rooms& rooms, const std::string& file) {
  const std::string directory = file.starts_with("mbgen/") ? kRuntimeHeaders : fs::path(file).parent_path().string();
  const auto found =
      std::find_if(rooms.begin(), rooms.end(), [&](const auto& room) { return room.second.directory == directory; });
  return found == rooms.end() ? std::nullopt : std::optional<std::string>(found->first);
}

/// `file:line: ...` of every include of ours that the table does not allow. Requires: the table is closed.
std::vector<std::string> forbidden_includes(const Rooms& rooms, const std::string& file, const std::string& text) {
  const std::optional<std::string> from = room_of(rooms, file);
  if (!from) return {file + ":1: stands in no room"};
  std::vector<std::string> found;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string head = "#include \"";
    if (!line.starts_with(head)) continue;
    const std::string included = line.substr(head.size(), line.find('"', head.size()) - head.size());
    const std::optional<std::string> to = room_of(rooms, included);
    const std::string place = file + ":" + std::to_string(number) + ": ";
    if (!to) {
      found.push_back(place + included + " stands in no room");
    } else if (*to != *from && !rooms.at(*from).uses.contains(*to)) {
      found.push_back(place + "room " + *from + " does not use room " + *to + ": " + included);
    }
  }
  return found;
}

TEST(Rooms, EveryIncludeIsInTheTable) {
  const fs::path root = MBGEN_SOURCE_DIR;
  Rooms rooms = table_of_rooms(text_of(root / "CMakeLists.txt"));
  close(rooms);
  int includes = 0;
  for (const char* top : {"compiler", "runtime"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp") continue;
      const std::string text = text_of(entry.path());
      includes += text.find("\n#include \"") != std::string::npos;
      for (const std::string& line : forbidden_includes(rooms, fs::relative(entry.path(), root).string(), text))
        ADD_FAILURE() << line;
    }
  }
  EXPECT_GT(includes, 300) << "files that include ours: the guard has read too few";
}

TEST(Rooms, NoRoomUsesItself) {
  Rooms rooms = table_of_rooms(text_of(fs::path(MBGEN_SOURCE_DIR) / "CMakeLists.txt"));
  close(rooms);
  EXPECT_GT(rooms.size(), 20u);
  for (const auto& [name, room] : rooms) EXPECT_FALSE(room.uses.contains(name)) << "room " << name << " uses itself";
}

const char* const kMadeUpTable = R"(
# mbgen_room(cellar compiler/cellar mbgen_roof)
mbgen_room(cellar compiler/cellar fmt::fmt)
mbgen_room(floor compiler/floor
  mbgen_cellar mbgen_runtime)
mbgen_room(roof compiler/roof mbgen_floor)
)";

TEST(Rooms, MadeUpHouseAllowsWhatItsTableNames) {
  Rooms rooms = table_of_rooms(kMadeUpTable);
  close(rooms);
  const std::string text =
      "#include \"compiler/cellar/door.hpp\"\n#include \"compiler/roof/b.hpp\"\n"
      "#include \"mbgen/status.hpp\"\n#include <vector>\n";
  EXPECT_EQ(forbidden_includes(rooms, "compiler/roof/a.cpp", text), std::vector<std::string>{});
}

TEST(Rooms, MadeUpIncludesAgainstTheTableFail) {
  Rooms rooms = table_of_rooms(kMadeUpTable);
  close(rooms);
  const auto found = [&](const char* file, const char* text) { return forbidden_includes(rooms, file, text); };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(found("compiler/floor/a.cpp", "#include <map>\n#include \"compiler/roof/door.hpp\"\n"),
            Lines{"compiler/floor/a.cpp:2: room floor does not use room roof: compiler/roof/door.hpp"});
  EXPECT_EQ(found("compiler/cellar/a.cpp", "#include \"mbgen/status.hpp\"\n"),
            Lines{"compiler/cellar/a.cpp:1: room cellar does not use room runtime: mbgen/status.hpp"});
  EXPECT_EQ(found("compiler/roof/a.cpp", "#include \"compiler/shed/door.hpp\"\n"),
            Lines{"compiler/roof/a.cpp:1: compiler/shed/door.hpp stands in no room"});
  EXPECT_EQ(found("compiler/shed/a.cpp", ""), Lines{"compiler/shed/a.cpp:1: stands in no room"});
}

TEST(Rooms, MadeUpCircleIsSeen) {
  Rooms rooms = table_of_rooms("\nmbgen_room(hen compiler/hen mbgen_egg)\nmbgen_room(egg compiler/egg mbgen_hen)\n");
  close(rooms);
  EXPECT_TRUE(rooms.at("hen").uses.contains("hen"));
}

/// A header with the source of its name counts as one module. Per module of a room: the modules that it includes.
using Modules = std::map<std::string, std::set<std::string>>;

void add_includes(const std::string& directory, const fs::path& file, const std::string& text, Modules& modules) {
  std::set<std::string>& includes = modules[file.stem().string()];
  std::istringstream lines(text);
  const std::string head = "#include \"" + directory + "/";
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(head)) continue;
    const std::string stem = line.substr(head.size(), line.find('.', head.size()) - head.size());
    if (stem != file.stem().string()) includes.insert(stem);
  }
}

/// Modules that include themselves by way of others.
std::set<std::string> circular(Modules modules) {
  for (bool grows = true; grows;) {
    grows = false;
    for (auto& [name, includes] : modules) {
      std::set<std::string> all = includes;
      for (const std::string& included : includes)
        if (const auto found = modules.find(included); found != modules.end())
          all.insert(found->second.begin(), found->second.end());
      grows = grows || all.size() > includes.size();
      includes = std::move(all);
    }
  }
  std::set<std::string> found;
  for (const auto& [name, includes] : modules)
    if (includes.contains(name)) found.insert(name);
  return found;
}

TEST(Rooms, ModulesOfARoomIncludeNoCircle) {
  const fs::path root = MBGEN_SOURCE_DIR;
  for (const auto& [name, room] : table_of_rooms(text_of(root / "CMakeLists.txt"))) {
    Modules modules;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / room.directory)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".cpp" || extension == ".hpp")
        add_includes(name == "runtime" ? "mbgen" : room.directory, entry.path(), text_of(entry.path()), modules);
    }
    for (const std::string& module : circular(modules))
      ADD_FAILURE() << room.directory << "/" << module << " includes itself by way of other modules of its room";
  }
}

TEST(Rooms, MadeUpCircleOfModulesIsSeen) {
  Modules modules;
  add_includes("a/b", "a/b/door.cpp", "#include \"a/b/door.hpp\"\n#include \"a/b/part.hpp\"\n", modules);
  add_includes("a/b", "a/b/part.hpp", "#include \"a/b/small.hpp\"\n", modules);
  EXPECT_EQ(circular(modules), std::set<std::string>{});
  add_includes("a/b", "a/b/small.cpp", "#include \"a/b/door.hpp\"\n", modules);
  EXPECT_EQ(circular(modules), (std::set<std::string>{"door", "part", "small"}));
}

}  // namespace
