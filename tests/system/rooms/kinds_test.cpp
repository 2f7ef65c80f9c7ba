// A kind of element is named where its own files and the lists are, and nobody walks lists of elements by name.

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

/// Files of the product that may name a kind: six of its own or with its place in a list, and those about a matter that
/// it has alone.
constexpr std::size_t kMostFiles = 14;
/// Files that may name three lists of a model or more.
constexpr std::size_t kMostWalkers = 5;

struct NamedKind {
  std::string type, key, list;  ///< BumpStop, bump_stop, bump_stops
};

std::string product_text(const std::string& file) { return text_of(fs::path(MBGEN_SOURCE_DIR) / file); }

/// First group of the first match behind a place.
std::string word_after(const std::string& text, std::size_t at, const char* pattern) {
  std::smatch match;
  return std::regex_search(text.begin() + static_cast<long>(at), text.end(), match, std::regex(pattern))
             ? match[1].str()
             : std::string();
}

/// The kinds of the headers in compiler/model/elements.
std::vector<NamedKind> kinds_of_project() {
  std::vector<NamedKind> kinds;
  const std::string head = "struct KindOf<";
  for (const std::string& file : sources_below({"compiler/model/elements"})) {
    const std::string text = product_text(file);
    for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head, at + head.size())) {
      NamedKind kind{word_after(text, at, "KindOf<(\\w+)>"), word_after(text, at, "\\*key = \"(\\w+)\""),
                     word_after(text, at, "return model\\.(\\w+);")};
      if (!kind.type.empty()) kinds.push_back(std::move(kind));
    }
  }
  return kinds;
}

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Whether a word stands in a text, behind `before` and not within a longer word.
bool has_word(const std::string& text, const std::string& word, const std::string& before = "") {
  const std::string wanted = before + word;
  for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    const bool begins = !before.empty() || at == 0 || !is_of_word(text[at - 1]);
    if (begins && (end == text.size() || !is_of_word(text[end]))) return true;
  }
  return false;
}

/// Keys of one word are words of the language, too.
bool names_kind(const std::string& text, const NamedKind& kind) {
  return has_word(text, kind.type) || (kind.key.find('_') != std::string::npos && has_word(text, kind.key));
}

std::string listed_files(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += "\n  " + file;
  return text;
}

TEST(Kinds, AreNamedInFewFiles) {
  const std::vector<NamedKind> kinds = kinds_of_project();
  EXPECT_GE(kinds.size(), 11u);
  const std::map<std::string, std::string> texts = texts_below({"compiler", "runtime", "workbench", "bench"});
  for (const NamedKind& kind : kinds) {
    if (kind.type == "Tyre") continue;  // wheels, roads, files of coefficients and rigs are about tyres alone
    std::vector<std::string> files;
    for (const auto& [file, text] : texts)
      if (names_kind(text, kind)) files.push_back(file);
    EXPECT_LE(files.size(), kMostFiles) << kind.type << " is named in " << files.size()
                                        << " files:" << listed_files(files);
    EXPECT_GE(files.size(), 5u) << kind.type;
  }
}

TEST(Kinds, AreWalkedByTheirList) {
  const std::vector<NamedKind> kinds = kinds_of_project();
  std::vector<std::string> walkers;
  for (const auto& [file, text] : texts_below({"compiler", "runtime", "workbench", "bench"})) {
    std::set<std::string> lists;
    for (const NamedKind& kind : kinds)
      for (const char* before : {"model.", "model_."})
        if (has_word(text, kind.list, before)) lists.insert(kind.list);
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
  const NamedKind stop{"BumpStop", "bump_stop", "bump_stops"};
  EXPECT_TRUE(names_kind("const BumpStop& stop", stop));
  EXPECT_TRUE(names_kind("\"bump_stop\"", stop));
  EXPECT_FALSE(names_kind("BumpStops, bump_stop_text", stop));
  EXPECT_TRUE(has_word("for (const auto& s : r.model.bump_stops)", "bump_stops", "model."));
  EXPECT_FALSE(has_word("model.bump_stops_of", "bump_stops", "model."));
}

}  // namespace
}  // namespace mbgen::house
