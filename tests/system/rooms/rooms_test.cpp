// The guard of the rooms: an include that the table of rooms in CMakeLists.txt does not allow fails.

#include <gtest/gtest.h>

#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

using Lines = std::vector<std::string>;

Graph uses_of(const Rooms& rooms) {
  Graph uses;
  for (const auto& [name, room] : rooms) uses[name] = room.uses;
  return uses;
}

TEST(Rooms, EveryIncludeIsInTheTable) {
  const Rooms rooms = rooms_of_project();
  int includes = 0;
  for (const std::string& file : sources_below({"compiler", "runtime", "workbench"})) {
    const std::string text = text_of(std::filesystem::path(MBGEN_SOURCE_DIR) / file);
    includes += text.find("\n#include \"") != std::string::npos;
    for (const std::string& line : forbidden_includes(rooms, file, text)) ADD_FAILURE() << line;
  }
  EXPECT_GT(includes, 300) << "files that include ours: the guard has read too few";
}

TEST(Rooms, NoRoomUsesItself) {
  const Rooms rooms = rooms_of_project();
  EXPECT_GT(rooms.size(), 30u);
  for (const auto& [name, room] : rooms)
    EXPECT_FALSE(reached_from(uses_of(rooms), name).contains(name)) << "room " << name << " uses itself";
}

/// Doors and uses that are named and not used make the house look other than it is.
TEST(Rooms, EveryDoorAndEveryUseIsUsed) {
  const Rooms rooms = rooms_of_project();
  Rooms unused = rooms;
  for (const std::string& file : sources_below({"compiler", "runtime", "workbench"})) {
    const std::optional<std::string> from = room_of(rooms, file);
    for (const Include& include : includes_of(text_of(std::filesystem::path(MBGEN_SOURCE_DIR) / file))) {
      const std::optional<std::string> to = room_of(rooms, include.path);
      if (!from || !to || *from == *to) continue;
      unused.at(*from).uses.erase(*to);
      unused.at(*to).doors.erase(*path_in(rooms.at(*to), include.path));
    }
  }
  for (const auto& [name, room] : unused) {
    for (const std::string& door : room.doors) ADD_FAILURE() << "no room uses the door " << door << " of room " << name;
    for (const std::string& used : room.uses)
      if (rooms.contains(used)) ADD_FAILURE() << "room " << name << " names room " << used << " and does not use it";
  }
}

const char* const kMadeUpTable = R"(
# mbgen_room(cellar compiler/cellar mbgen_roof)
mbgen_room(cellar compiler/cellar fmt::fmt)
mbgen_doors(cellar door.hpp stairs/up.hpp)
set(mbgen_folders_cellar stairs)
mbgen_room(floor compiler/floor
  mbgen_cellar mbgen_runtime)
mbgen_doors(floor door.hpp)
mbgen_room(roof compiler/roof mbgen_floor)
)";

TEST(Rooms, MadeUpHouseAllowsTheIncludesOfItsTable) {
  const Rooms rooms = table_of_rooms(kMadeUpTable);
  EXPECT_EQ(forbidden_includes(rooms, "compiler/floor/a.cpp",
                               "#include \"compiler/cellar/door.hpp\"\n#include \"compiler/cellar/stairs/up.hpp\"\n"
                               "#include \"compiler/floor/b.hpp\"\n#include \"mbgen/status.hpp\"\n#include <vector>\n"),
            Lines{});
  EXPECT_EQ(forbidden_includes(rooms, "compiler/cellar/stairs/a.cpp", "#include \"compiler/cellar/b.hpp\"\n"), Lines{});
}

TEST(Rooms, MadeUpIncludesAgainstTheTableFail) {
  const Rooms rooms = table_of_rooms(kMadeUpTable);
  const auto found = [&](const char* file, const char* text) { return forbidden_includes(rooms, file, text); };
  EXPECT_EQ(found("compiler/floor/a.cpp", "#include <map>\n#include \"compiler/roof/door.hpp\"\n"),
            Lines{"compiler/floor/a.cpp:2: room floor does not use room roof: compiler/roof/door.hpp"});
  EXPECT_EQ(found("compiler/roof/a.cpp", "#include \"compiler/cellar/door.hpp\"\n"),
            Lines{"compiler/roof/a.cpp:1: room roof does not use room cellar: compiler/cellar/door.hpp"})
      << "a floor is skipped";
  EXPECT_EQ(found("compiler/roof/a.cpp", "#include \"compiler/floor/b.hpp\"\n"),
            Lines{"compiler/roof/a.cpp:1: compiler/floor/b.hpp is no door of room floor"});
  EXPECT_EQ(found("compiler/roof/a.cpp", "#include \"compiler/shed/door.hpp\"\n"),
            Lines{"compiler/roof/a.cpp:1: compiler/shed/door.hpp stands in no room"});
  EXPECT_EQ(found("compiler/shed/a.cpp", ""), Lines{"compiler/shed/a.cpp:1: stands in no room"});
  EXPECT_EQ(found("compiler/floor/attic/a.cpp", ""), Lines{"compiler/floor/attic/a.cpp:1: stands in no room"});
}

TEST(Rooms, MadeUpCircleIsSeen) {
  const Rooms rooms =
      table_of_rooms("\nmbgen_room(hen compiler/hen mbgen_egg)\nmbgen_room(egg compiler/egg mbgen_hen)\n");
  EXPECT_TRUE(reached_from(uses_of(rooms), "hen").contains("hen"));
}

}  // namespace
}  // namespace mbgen::house
