// Modules of a room, a header with the source of its name, include no circle.

#include <gtest/gtest.h>

#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

/// The path of a file without its extension.
std::string module_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

void add_includes(const std::string& file, const std::string& text, Graph& modules) {
  std::set<std::string>& includes = modules[module_of(file)];
  for (const Include& include : includes_of(text))
    if (module_of(include.path) != module_of(file)) includes.insert(module_of(include.path));
}

/// Modules that include themselves by way of others.
std::set<std::string> circular(const Graph& modules) {
  std::set<std::string> found;
  for (const auto& [name, includes] : modules)
    if (reached_from(modules, name).contains(name)) found.insert(name);
  return found;
}

TEST(Modules, IncludeNoCircle) {
  Graph modules;
  for (const auto& [file, text] : texts_below({"compiler", "runtime", "workbench"})) add_includes(file, text, modules);
  EXPECT_GT(modules.size(), 400u);
  for (const std::string& module : circular(modules))
    ADD_FAILURE() << module << " includes itself by way of other modules";
}

TEST(Modules, MadeUpCircleIsSeen) {
  Graph modules;
  add_includes("a/b/door.cpp", "#include \"a/b/door.hpp\"\n#include \"a/b/part.hpp\"\n", modules);
  add_includes("a/b/part.hpp", "#include \"a/b/small.hpp\"\n", modules);
  EXPECT_EQ(circular(modules), std::set<std::string>{});
  add_includes("a/b/small.cpp", "#include \"a/b/door.hpp\"\n", modules);
  EXPECT_EQ(circular(modules), (std::set<std::string>{"a/b/door", "a/b/part", "a/b/small"}));
}

}  // namespace
}  // namespace mbgen::house
