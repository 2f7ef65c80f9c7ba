// Nobody walks lists of elements by name.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

namespace fs = std::filesystem;

/// Files that may name three lists of a model or more.
constexpr std::size_t kMostWalkers = 5;

std::string product_text(const std::string& file) { return text_of(fs::path(MBGEN_SOURCE_DIR) / file); }

/// First group of the first match behind a place.
std::string word_after(const std::string& text, std::size_t at, const char* pattern) {
  std::smatch match;
  return std::regex_search(text.begin() + static_cast<long>(at), text.end(), match, std::regex(pattern))
             ? match[1].str()
             : std::string();
}

/// Lists in the model of the kinds in compiler/model/elements.
std::vector<std::string> lists_of_project() {
  std::vector<std::string> lists;
  const std::string head = "struct KindOf<";
  for (const std::string& file : sources_below({"compiler/model/elements"})) {
    const std::string text = product_text(file);
    for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head, at + head.size())) {
      const std::string list = word_after(text, at, "return model\\.(\\w+);");
      if (!list.empty()) lists.push_back(list);
    }
  }
  return lists;
}

/// Whether a word stands in a text, behind `before` and not within a longer word.
bool has_word(const std::string& text, const std::string& word, const std::string& before) {
  const std::string wanted = before + word;
  for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    if (end == text.size() || !is_of_word(text[end])) return true;
  }
  return false;
}

std::string listed_files(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += "\n  " + file;
  return text;
}

TEST(Kinds, AreWalkedByTheirList) {
  const std::vector<std::string> kinds = lists_of_project();
  EXPECT_GE(kinds.size(), 11u);
  std::vector<std::string> walkers;
  for (const auto& [file, text] : texts_below({"compiler", "runtime", "workbench", "bench"})) {
    std::set<std::string> lists;
    for (const std::string& list : kinds)
      for (const char* before : {"model.", "model_."})
        if (has_word(text, list, before)) lists.insert(list);
    if (lists.size() >= 3) walkers.push_back(file);
  }
  EXPECT_LE(walkers.size(), kMostWalkers)
      << "three lists of elements by name, where each_element walks all:" << listed_files(walkers);
}

// The page shows the made-up element as the patch adds it.
TEST(Kinds, ExampleOfThePageStandsInThePatch) {
  const std::string page = product_text("docs/build/architecture.md");
  const std::string fence = "```cpp\n";
  const std::size_t begin = page.find(fence, page.find("## A force element")) + fence.size();
  const std::string example = page.substr(begin, page.find("```", begin) - begin);
  ASSERT_GT(example.size(), 300u);
  std::string added;
  std::istringstream lines(example);
  for (std::string line; std::getline(lines, line);) added += "+" + line + "\n";
  EXPECT_NE(product_text("tests/system/element_kind/one_way_damper.patch").find(added), std::string::npos) << added;
}

TEST(Kinds, AreFoundAsWords) {
  EXPECT_TRUE(has_word("for (const auto& s : r.model.bump_stops)", "bump_stops", "model."));
  EXPECT_FALSE(has_word("model.bump_stops_of", "bump_stops", "model."));
}

}  // namespace
}  // namespace mbgen::house
