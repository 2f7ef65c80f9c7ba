// Slips of comments in emitted code: headings without a title, counts of one, legends of names that do not occur.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "compiler/compile.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool has(const std::string& text, const char* pattern) { return std::regex_search(text, std::regex(pattern)); }

void expect_no_slips(const std::string& text, const std::string& where) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t at = line.find("//");
    if (at == std::string::npos) continue;
    const std::string comment = line.substr(at);
    EXPECT_FALSE(has(comment, ": ;|: \\.|; ;|---  *---|, *;")) << where << ":" << number << ": " << line;
    EXPECT_FALSE(has(comment, "\\b(\\d+) to \\1\\b")) << where << ":" << number << ": " << line;
    EXPECT_FALSE(has(comment, "\\bthe 1 (constants|programs|objects)\\b")) << where << ":" << number << ": " << line;
  }
  if (text.find("// Names, followed by") == std::string::npos) return;
  EXPECT_EQ(has(text, "//   K: second moments|\\bK second moments"), has(text, "\\bK_[a-z]")) << where;
}

TEST(Slips, AreInNoCommittedFile) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(MBGEN_SOURCE_DIR) / "generated")) {
    const fs::path& path = entry.path();
    if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
    expect_no_slips(text_of(path), path.filename().string());
    ++files;
  }
  EXPECT_GE(files, 8);
}

TEST(Slips, AreInNoSolverOfAStarter) {
  for (const auto& entry : fs::directory_iterator(fs::path(MBGEN_SOURCE_DIR) / "models/starters")) {
    if (entry.path().extension() != ".json") continue;
    const Result<Compilation> compilation = compile(entry.path().string());
    ASSERT_TRUE(compilation) << to_text(compilation.problems());
    for (const EmittedFile& file : emit(*compilation, {.runtime_headers = false, .lanes = 4}))
      if (!file.path.ends_with(".json") && !file.path.ends_with(".txt"))
        expect_no_slips(file.text, entry.path().filename().string() + " " + file.path);
  }
}

}  // namespace
}  // namespace mbgen
