// Files of 400 lines, functions of 60, folders of 70 sources at most.

#include <gtest/gtest.h>

#include <sstream>

#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLines = 400, kMostOfAFunction = 60, kMostOfAFolder = 70;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t indent_of(const std::string& line) { return line.find_first_not_of(' '); }

/// Whether a line opens a table.
bool opens_table(const std::string& line) {
  for (const char* end : {"= {", "{{", "({", "return {", "std::array{"})
    if (line.ends_with(end)) return true;
  return false;
}

/// Lines of a function without the rows of its tables, which are data: what stands deeper than the line that opens one.
int lines_of_code(const std::vector<std::string>& lines, std::size_t first, std::size_t last) {
  int count = 0;
  for (std::size_t i = first; i <= last; ++i) {
    ++count;
    if (!opens_table(lines[i])) continue;
    const std::size_t indent = indent_of(lines[i]);
    while (i < last && (lines[i + 1].empty() || indent_of(lines[i + 1]) > indent)) ++i;
  }
  return count;
}

/// `file:line: ...` of functions at the margin that are too long. Requires: the format of clang-format.
std::vector<std::string> long_functions(const std::string& file, const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<std::string> found;
  for (std::size_t last = 1; last < lines.size(); ++last) {
    if (lines[last] != "}") continue;
    std::size_t first = last - 1;
    while (first > 0 && (lines[first].empty() || lines[first][0] == ' ' || lines[first][0] == '#')) --first;
    const int count = lines_of_code(lines, first, last);
    if (count > kMostOfAFunction)
      found.push_back(file + ":" + std::to_string(first + 1) + ": function of " + std::to_string(count) + " lines");
  }
  return found;
}

TEST(Sizes, FilesAndFunctionsAreShort) {
  for (const std::string& file : sources_below({"compiler", "runtime", "workbench", "tests", "bench", "examples"})) {
    if (file.starts_with("tests/golden")) continue;
    const std::string text = text_of(fs::path(MBGEN_SOURCE_DIR) / file);
    EXPECT_LE(lines_of(text).size(), kMostLines) << file;
    for (const std::string& line : long_functions(file, text)) ADD_FAILURE() << line;
  }
}

TEST(Sizes, FoldersAreSmall) {
  std::map<std::string, int> folders;
  for (const std::string& file : sources_below({"compiler", "runtime", "workbench", "tests", "bench"}))
    ++folders[fs::path(file).parent_path().string()];
  for (const auto& [folder, count] : folders) EXPECT_LE(count, kMostOfAFolder) << folder;
}

TEST(Sizes, MadeUpLongFunctionIsSeen) {
  std::string body;
  for (int i = 0; i < 59; ++i) body += "  f();\n";
  const std::string head = "/// Long.\nint g(int a,\n      int b) {\n";
  EXPECT_EQ(long_functions("a.cpp", head + body + "}\n"), std::vector<std::string>{"a.cpp:2: function of 62 lines"});
  std::string rows;
  for (int i = 0; i < 59; ++i) rows += "    1,\n";
  const std::string table = "int g() {\n  static const int table[] = {\n" + rows + "  };\n  return table[0];\n}\n";
  EXPECT_EQ(long_functions("a.cpp", table), std::vector<std::string>{});
}

}  // namespace
}  // namespace mbgen::house
