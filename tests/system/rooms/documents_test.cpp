// The table of architecture.md names the rooms of CMakeLists.txt, and no others.

#include <gtest/gtest.h>

#include <sstream>

#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

/// Folders of the product in the first column of the tables of a page: | `folder` | ... |
std::set<std::string> folders_in(const std::string& page) {
  std::set<std::string> found;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string folder = line.substr(3, line.find('`', 3) - 3);
    for (const char* top : {"compiler/", "runtime/", "workbench/"})
      if (folder.starts_with(top) && folder.find_first_of(".*{") == std::string::npos) found.insert(folder);
  }
  return found;
}

TEST(Documents, NameTheRoomsOfTheHouse) {
  std::set<std::string> directories;
  for (const auto& [name, room] : rooms_of_project())
    if (room.directory != "compiler") directories.insert(room.directory);
  const std::filesystem::path root = MBGEN_SOURCE_DIR;
  EXPECT_EQ(folders_in(text_of(root / "docs/build/architecture.md")), directories);
}

TEST(Documents, MadeUpTableIsRead) {
  EXPECT_EQ(folders_in("| folder | x |\n|---|---|\n| `compiler/a` | b |\n| `compiler/a.cpp` | c |\n| `tests` | d |\n"),
            std::set<std::string>{"compiler/a"});
}

}  // namespace
}  // namespace mbgen::house
