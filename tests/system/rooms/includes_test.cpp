// A source compiles by itself: names that it uses stand in headers that it includes, by other headers of ours at most.
// The release build compiles the sources of a room together, where a missing include is not seen.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "compiler/text/code_text.hpp"
#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

/// Headers of the standard library, and names of theirs; of a name that stands in several rows one header is enough.
const std::map<std::string, std::string> kStandard{
    {"algorithm",
     "sort stable_sort max min clamp find_if all_of any_of none_of transform fill reverse unique remove_if lower_bound "
     "upper_bound max_element min_element count_if copy rotate partition equal mismatch binary_search nth_element "
     "minmax"},
    {"array", "array"},
    {"atomic", "atomic"},
    {"bitset", "bitset"},
    {"charconv", "from_chars to_chars"},
    {"cmath",
     "sqrt sin cos tan atan atan2 abs fabs isfinite isnan floor ceil round hypot exp log pow cbrt fma lround copysign "
     "signbit asin acos tanh sinh cosh"},
    {"complex", "complex"},
    {"cstdlib", "abs getenv strtod strtol abort"},
    {"cstring", "memcpy strlen memcmp strerror"},
    {"deque", "deque"},
    {"exception", "exception_ptr rethrow_exception"},
    {"filesystem", "filesystem"},
    {"fstream", "ifstream ofstream"},
    {"functional", "function"},
    {"iomanip", "setw setprecision"},
    {"iostream", "cout cerr cin"},
    {"iterator", "back_inserter make_move_iterator"},
    {"limits", "numeric_limits"},
    {"map", "map multimap pair"},
    {"memory", "unique_ptr shared_ptr make_unique make_shared weak_ptr"},
    {"mutex", "mutex lock_guard unique_lock"},
    {"numbers", "numbers"},
    {"numeric", "accumulate iota inner_product"},
    {"optional", "optional nullopt"},
    {"queue", "priority_queue queue"},
    {"random", "mt19937 mt19937_64 uniform_real_distribution"},
    {"set", "set multiset"},
    {"span", "span"},
    {"sstream", "ostringstream istringstream stringstream"},
    {"stdexcept", "runtime_error logic_error invalid_argument out_of_range"},
    {"string", "string to_string string_view"},
    {"string_view", "string_view"},
    {"system_error", "error_code system_error"},
    {"thread", "thread"},
    {"tuple", "tuple tie"},
    {"type_traits", "is_same_v decay_t enable_if_t conditional_t is_floating_point_v"},
    {"unordered_map", "unordered_map"},
    {"unordered_set", "unordered_set"},
    {"utility", "exchange pair"},
    {"variant", "variant visit get_if holds_alternative monostate"},
    {"vector", "vector"}};

/// Headers that give a name of the standard library.
std::map<std::string, std::set<std::string>> headers_of_names() {
  std::map<std::string, std::set<std::string>> headers;
  for (const auto& [header, names] : kStandard) {
    std::istringstream words(names);
    for (std::string word; words >> word;) headers[word].insert(header);
  }
  return headers;
}

bool is_letter(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// A text without comments and literals, with its lines.
std::string code_of(const std::string& text) {
  std::string code;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::max(end_of_comment(text, at), end_of_literal(text, at));
    if (end == at) {
      code += text[at++];
    } else {
      at = end;
    }
  }
  return code;
}

struct Word {
  std::string text;
  std::string before;  ///< the word or sign before it
  char after;          ///< the sign behind it, 0 for a word
};

std::vector<Word> words_of(const std::string& code) {
  std::vector<Word> words;
  std::string before;
  for (std::size_t at = 0; at < code.size();) {
    if (std::isspace(static_cast<unsigned char>(code[at])) != 0) {
      ++at;
    } else if (!is_letter(code[at])) {
      const bool is_pair = code.compare(at, 2, "->") == 0 || code.compare(at, 2, "::") == 0;
      before = code.substr(at, is_pair ? 2 : 1);
      at += before.size();
    } else {
      std::size_t end = at;
      while (end < code.size() && is_letter(code[end])) ++end;
      std::size_t next = end;
      while (next < code.size() && std::isspace(static_cast<unsigned char>(code[next])) != 0) ++next;
      words.push_back(
          {code.substr(at, end - at), before, next < code.size() && !is_letter(code[next]) ? code[next] : '\0'});
      before = words.back().text;
      at = end;
    }
  }
  return words;
}

/// Words that stand before an expression.
bool is_keyword(const std::string& word) {
  static const std::set<std::string> keywords{"return", "else", "throw", "case", "do", "new", "const", "constexpr"};
  return keywords.contains(word);
}

/// Whether a word names something of two words, which hardly anything else is called.
bool is_telling(const std::string& name) {
  for (std::size_t i = 1; i + 1 < name.size(); ++i) {
    if (name[i] == '_' && is_letter(name[i - 1]) && name[0] != '_') return true;
    if (std::islower(static_cast<unsigned char>(name[i])) != 0 &&
        std::isupper(static_cast<unsigned char>(name[i + 1])) != 0)
      return true;
  }
  return false;
}

/// Whether a word can only be the type or the function of that name.
bool is_used(const Word& word) {
  return std::isupper(static_cast<unsigned char>(word.text[0])) != 0 || word.after == '(';
}

/// Names that a header declares at the margin: types and functions.
std::set<std::string> declared_in(const std::string& code) {
  std::set<std::string> names;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || !is_letter(line[0])) continue;
    const std::vector<Word> words = words_of(line);
    for (const Word& word : words) {
      const bool is_type = (word.before == "struct" || word.before == "class");
      const bool is_function = word.after == '(' && (is_letter(word.before.empty() ? '(' : word.before[0]) ||
                                                     word.before == ">" || word.before == "&" || word.before == "*");
      if (is_type || is_function || (word.before == "using" && word.after == '=')) names.insert(word.text);
      if (word.after == '(') break;
    }
  }
  return names;
}

struct File {
  std::vector<Word> words;
  std::set<std::string> declared;
  std::vector<std::string> ours;  ///< headers of ours that it includes
  std::set<std::string> standard;
};

File file_of(const std::string& text) {
  const std::string code = code_of(text);
  File file{words_of(code), declared_in(code), {}, {}};
  for (const Include& include : includes_of(text)) file.ours.push_back(include.path);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#include <")) file.standard.insert(line.substr(10, line.find('>') - 10));
  return file;
}

using Files = std::map<std::string, File>;

/// Names of ours that a file may not take from elsewhere: it declares them, or a thing of its own has that name.
std::set<std::string> own_names(const File& file) {
  std::set<std::string> names = file.declared;
  for (const Word& word : file.words) {
    const bool is_type = !word.before.empty() && is_letter(word.before[0]) && !is_keyword(word.before);
    if (is_type || word.before == "::" || word.before == ">" || word.before == "&" || word.before == "*")
      names.insert(word.text);
  }
  return names;
}

/// `file: ...` of names that no header of a file gives. Names of ours count where one header of its room, or of a room
/// that its room reaches, declares them.
std::vector<std::string> missing_includes(const Files& files, const Rooms& rooms) {
  Graph headers, uses;
  std::map<std::string, std::set<std::string>> declared;
  for (const auto& [path, file] : files) {
    headers[path] = {file.ours.begin(), file.ours.end()};
    if (path.ends_with(".hpp"))
      for (const std::string& name : file.declared) declared[name].insert(path);
  }
  for (const auto& [name, room] : rooms) uses[name] = room.uses;
  const std::map<std::string, std::set<std::string>> standard = headers_of_names();
  std::vector<std::string> found;
  for (const auto& [path, file] : files) {
    const std::optional<std::string> room = room_of(rooms, path);
    if (!room || *room == "runtime") continue;
    std::set<std::string> near = reached_from(uses, *room), reached = reached_from(headers, path);
    near.insert(*room);
    reached.insert(path);
    std::set<std::string> given;
    for (const std::string& header : reached)
      if (const auto at = files.find(header); at != files.end())
        given.insert(at->second.standard.begin(), at->second.standard.end());
    const std::set<std::string> own = own_names(file);
    std::set<std::string> missing;
    for (std::size_t i = 0; i < file.words.size(); ++i) {
      const Word& word = file.words[i];
      if (word.before == "." || word.before == "->") continue;
      if (word.before == "::" && i > 0 && file.words[i - 1].text == "std") {
        const auto at = standard.find(word.text);
        if (at == standard.end()) continue;
        bool is_given = false;
        for (const std::string& header : at->second) is_given = is_given || given.contains(header);
        if (!is_given) missing.insert("std::" + word.text + " needs <" + *at->second.begin() + ">");
      } else if (is_telling(word.text) && !own.contains(word.text) && is_used(word)) {
        const auto at = declared.find(word.text);
        if (at == declared.end() || at->second.size() != 1 || reached.contains(*at->second.begin())) continue;
        const std::optional<std::string> home = room_of(rooms, *at->second.begin());
        if (home && *home != "runtime" && near.contains(*home))
          missing.insert(word.text + " needs \"" + *at->second.begin() + "\"");
      }
    }
    for (const std::string& text : missing) found.push_back(path + ": " + text);
  }
  return found;
}

TEST(Includes, SourcesIncludeWhatTheyUse) {
  Files files;
  for (const auto& [path, text] : texts_below({"compiler", "runtime", "workbench"})) files[path] = file_of(text);
  for (const std::string& line : missing_includes(files, rooms_of_project())) ADD_FAILURE() << line;
}

TEST(Includes, MadeUpMissingOnesAreSeen) {
  const Rooms rooms = table_of_rooms("\nmbgen_room(low compiler/low)\nmbgen_room(high compiler/high mbgen_low)\n");
  Files files;
  files["compiler/low/shape.hpp"] = file_of("#include <vector>\nstruct RoundShape {\n};\nint side_of(int a);\n");
  files["compiler/high/good.cpp"] =
      file_of("#include \"compiler/low/shape.hpp\"\nstd::vector<RoundShape> f() { return {side_of(1)}; }\n");
  EXPECT_EQ(missing_includes(files, rooms), std::vector<std::string>{});
  files["compiler/high/bad.cpp"] = file_of(
      "// side_of\nstd::string f() { return \"RoundShape side_of\"; }\nauto g() { return side_of(RoundShape{}.x); }\n");
  EXPECT_EQ(missing_includes(files, rooms),
            (std::vector<std::string>{"compiler/high/bad.cpp: RoundShape needs \"compiler/low/shape.hpp\"",
                                      "compiler/high/bad.cpp: side_of needs \"compiler/low/shape.hpp\"",
                                      "compiler/high/bad.cpp: std::string needs <string>"}));
}

}  // namespace
}  // namespace mbgen::house
