// Comments start with their subject, and sources use few phrases that a reader stumbles over.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

constexpr std::array kBadStarts = {"What", "Those that", "Those who", "That which"};
constexpr std::array kBadPhrases = {"what is", "what are", "those that", "those who", "that of"};

bool begins_with_word(std::string_view text, std::string_view word) {
  return text.starts_with(word) &&
         (text.size() == word.size() || !std::isalnum(static_cast<unsigned char>(text[word.size()])));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// Text of the comment on a line, empty without one. marks: of comments in the language of the file.
std::string_view comment_on(std::string_view line, const std::vector<std::string>& marks) {
  std::size_t first = line.npos;
  for (const std::string& mark : marks) first = std::min(first, line.find(mark));
  if (first == line.npos && marks.size() > 1 && trimmed(line).starts_with("* ")) first = line.find('*');
  if (first == line.npos) return "";
  const std::size_t text = line.find_first_not_of("/*!<#", first);
  return text == line.npos ? "" : trimmed(line.substr(text));
}

/// Whether a sentence of a comment begins badly. goes_on: a sentence of the line above goes on.
bool has_bad_start(std::string_view comment, bool goes_on) {
  for (std::size_t at = goes_on ? comment.find(". ") : 0; at != comment.npos; at = comment.find(". ", at + 1)) {
    const std::string_view sentence = trimmed(comment.substr(comment[at] == '.' ? at + 1 : at));
    for (const char* start : kBadStarts)
      if (begins_with_word(sentence, start)) return true;
  }
  return false;
}

/// Marks of comments by the name of a file; empty for files without comments.
std::vector<std::string> marks_of(const fs::path& file) {
  const std::string name = file.filename().string(), extension = file.extension().string();
  for (const char* like_c : {".cpp", ".hpp", ".c", ".h", ".js", ".mjs", ".css", ".json"})
    if (extension == like_c) return {"//", "/*"};
  if (extension == ".in") return {"//", "/*", "#"};
  for (const char* like_shell : {".sh", ".py", ".cmake", ".flags", ".awk", ".dict", ".clang-tidy", ".clang-format"})
    if (extension == like_shell || name == like_shell) return {"#"};
  return name == "CMakeLists.txt" || file.parent_path().filename() == ".ci" ? Lines{"#"} : Lines{};
}

/// `file:line: ...` of comments with a sentence that begins badly.
Lines bad_comments(const std::string& file, const std::string& text) {
  const Lines marks = marks_of(file);
  Lines found;
  if (marks.empty()) return found;
  std::istringstream lines(text);
  bool goes_on = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string_view comment = comment_on(line, marks);
    if (has_bad_start(comment, goes_on))
      found.push_back(file + ":" + std::to_string(number) + ": " + std::string(comment));
    goes_on = !comment.empty() && comment.back() != '.' && comment.back() != ':';
  }
  return found;
}

/// Files below the folders of the tree and beside them, relative to it; dependencies and builds are no part of it.
Lines files_of_tree() {
  const fs::path root = MBGEN_SOURCE_DIR;
  Lines found;
  for (const fs::directory_entry& entry : fs::directory_iterator(root))
    if (entry.is_regular_file()) found.push_back(entry.path().filename().string());
  for (const char* folder : {".ci", "bench", "cmake", "compiler", "docs", "examples", "generated", "models", "runtime",
                             "templates", "tests", "workbench"})
    for (auto entry = fs::recursive_directory_iterator(root / folder); entry != fs::recursive_directory_iterator();
         ++entry) {
      if (entry->is_directory() && (entry->path().filename() == "node_modules" || entry->path().filename() == "build"))
        entry.disable_recursion_pending();
      else if (entry->is_regular_file())
        found.push_back(fs::relative(entry->path(), root).string());
    }
  return found;
}

/// A source in one line, small letters, where neither ends of lines nor those of adjacent strings part a phrase.
std::string running_text(const std::string& source) {
  std::string text;
  std::istringstream lines(source);
  for (std::string line; std::getline(lines, line);) {
    std::string_view rest = trimmed(line);
    while (!rest.empty() && (rest[0] == '/' || rest[0] == '*' || rest[0] == '<')) rest.remove_prefix(1);
    rest = trimmed(rest);
    if (text.ends_with("\" ") && rest.starts_with('"')) {
      text.resize(text.size() - 2);
      rest.remove_prefix(1);
    }
    text += std::string(rest) + " ";
  }
  std::ranges::transform(text, text.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

int count_of_phrases(const std::string& source) {
  const std::string text = running_text(source);
  int count = 0;
  for (const std::string phrase : kBadPhrases)
    for (std::size_t at = text.find(phrase); at != text.npos; at = text.find(phrase, at + 1))
      count += begins_with_word(std::string_view(text).substr(at), phrase) && (at == 0 || !std::isalnum(text[at - 1]));
  return count;
}

/// Phrases of kBadPhrases that a room may have. Lower a number when a room has fewer; raise none.
const std::map<std::string, int> kMostPhrases = {{"reader", 1}};

TEST(Comments, BeginWithTheirSubject) {
  int files = 0;
  for (const std::string& file : files_of_tree()) {
    files += !marks_of(file).empty();
    for (const std::string& line : bad_comments(file, text_of(fs::path(MBGEN_SOURCE_DIR) / file)))
      ADD_FAILURE() << line << "\n  begin with the subject of the sentence";
  }
  EXPECT_GT(files, 1500) << "the guard has read too few";
}

TEST(Comments, PhrasesOfRoomsOnlyBecomeFewer) {
  const Rooms rooms = rooms_of_project();
  std::map<std::string, int> counts;
  for (const std::string& file : sources_below({"compiler", "runtime", "workbench"}))
    if (const std::optional<std::string> room = room_of(rooms, file))
      counts[*room] += count_of_phrases(text_of(fs::path(MBGEN_SOURCE_DIR) / file));
  for (const auto& [room, count] : counts) {
    const auto listed = kMostPhrases.find(room);
    const int most = listed == kMostPhrases.end() ? 0 : listed->second;
    EXPECT_LE(count, most) << "room " << room << ": too many phrases like \"what is\", \"those that\", \"that of\" in "
                           << "comments and texts; name the thing, and use one relative clause";
  }
}

TEST(Comments, MadeUpBadCommentsAreSeen) {
  const std::string bad = std::string("Wh") + "at";
  const auto found = [&](const char* file, const std::string& text) { return bad_comments(file, text).size(); };
  EXPECT_EQ(bad_comments("a/b.cpp", "int a;\n/// " + bad + " it is.\n"), Lines{"a/b.cpp:2: " + bad + " it is."});
  EXPECT_EQ(found("b.hpp", "int a;  ///< " + bad + " it is\n"), 1u);
  EXPECT_EQ(found("b.js", "/** " + bad + " it is. */\n/*\n * A word.\n * " + bad + " it is.\n */\n"), 2u);
  EXPECT_EQ(found("b.sh", "# It runs. " + bad + " it runs.\n"), 1u);
  EXPECT_EQ(found("x.in", "{{^a}}\n/// " + bad + " it is\n"), 1u);
  EXPECT_EQ(found("b.cmake",
                  "# Tho"
                  "se that run.\nset(a b)  # Tho"
                  "se who run.\n"),
            2u);
  EXPECT_EQ(found("b.cpp", "// It runs the program of\n// " + bad + " Ltd.\n// " + bad + "ever it is.\n"), 0u);
  EXPECT_EQ(found("b.txt", "# " + bad + " it is\n"), 0u);
}

TEST(Comments, MadeUpPhrasesAreCounted) {
  EXPECT_EQ(count_of_phrases("// Gives what\n// is known, and That of others.\n"), 2);
  EXPECT_EQ(count_of_phrases("f(\"tho\"\n  \"se that run\");\n"), 1);
  EXPECT_EQ(count_of_phrases("// somewhat is, what isotopes are\n"), 0);
}

}  // namespace
}  // namespace mbgen::house
