// Few files of the product are about an element: its own, one a floor or some, the lists, and those that name it.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "tests/system/rooms/house.hpp"

namespace mbgen::house {
namespace {

namespace fs = std::filesystem;
using Words = std::set<std::string>;

/// Files of the product that an element may touch.
constexpr std::size_t kMostTouched = 12;

/// Subjects with machinery beyond an element: wheels, roads, rigs; motors in inverse dynamics and transmissions.
const Words kSubjects = {"tyre", "actuator"};
/// Words with other senses in the product: of coefficients of tyres, contact points, sums of forces, containers.
const Words kOtherSenses = {"friction", "contact", "joint_force", "applied_force", "tyre", "actuator", "map"};

struct Element {
  std::string stem;  ///< of its files: bump_stop
  Words names;       ///< identifiers: BumpStop, and others that its headers in the model declare
  Words lists;       ///< members of Model
  Words quoted;      ///< words of the model format
};

/// A text of the product, without comments.
struct Source {
  Words names;     ///< identifiers
  Words members;   ///< behind "model." and "model_."
  Words literals;  ///< texts in quotes
};

/// End of a comment that begins at a place, npos where none does.
std::size_t end_of_comment(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "/*") == 0) return std::min(text.size(), text.find("*/", at)) + 2;
  const bool begins = text.compare(at, 2, "//") == 0 && (at == 0 || text[at - 1] != ':');
  return begins ? std::min(text.size(), text.find('\n', at)) : std::string::npos;
}

Source source_of(const std::string& text) {
  Source source;
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t end = end_of_comment(text, at); end != std::string::npos) {
      at = end;
    } else if (text[at] == '"') {
      std::size_t end = at + 1;
      while (end < text.size() && text[end] != '"' && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
      source.literals.insert(text.substr(at + 1, end - at - 1));
      at = end + 1;
    } else if (is_of_word(text[at])) {
      std::size_t end = at;
      while (end < text.size() && is_of_word(text[end])) ++end;
      const std::string word = text.substr(at, end - at);
      source.names.insert(word);
      const std::string before = text.substr(at < 7 ? 0 : at - 7, std::min<std::size_t>(at, 7));
      if (before.ends_with("model.") || before.ends_with("model_.")) source.members.insert(word);
      at = end;
    } else {
      ++at;
    }
  }
  return source;
}

/// "BumpStopLaw" and "bump_stop_law" are "_bump_stop_law_".
std::string in_parts(const std::string& name) {
  std::string parts = "_";
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]))) parts += '_';
    parts += static_cast<char>(std::tolower(c));
  }
  return parts + "_";
}

bool is_within(const std::string& name, const std::string& stem) {
  const std::string parts = in_parts(name);
  return parts.find("_" + stem + "_") != std::string::npos || parts.find("_" + stem + "s_") != std::string::npos;
}

bool meets(const Words& a, const Words& b) {
  return std::ranges::any_of(a, [&](const std::string& word) { return b.contains(word); });
}

bool names_element(const Source& source, const Element& element) {
  const bool by_stem = !kOtherSenses.contains(element.stem) && std::ranges::any_of(source.names, [&](const auto& name) {
    return is_within(name, element.stem);
  });
  return by_stem || meets(element.names, source.names) || meets(element.lists, source.members) ||
         meets(element.quoted, source.literals);
}

Words groups(const std::string& text, const char* pattern) {
  Words found;
  const std::regex regex(pattern, std::regex::ECMAScript | std::regex::multiline);
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at)
    found.insert(std::ranges::find_if((*at).begin() + 1, (*at).end(), [](const auto& m) { return m.matched; })->str());
  return found;
}

/// Elements with a header on the model's floor, those that stand for others, and maps.
std::vector<Element> elements_of_product() {
  const fs::path root = MBGEN_SOURCE_DIR;
  std::vector<Element> elements = {
      {"map", {"CharacteristicMap", "MapFields", "map_coefficients", "read_maps", "maps"}, {}, {"maps"}}};
  for (const std::string& file : sources_below({"compiler/model/elements"})) {
    const std::string text = text_of(root / file);
    if (text.find("struct KindOf<") == std::string::npos || file.ends_with("/kind.hpp")) continue;
    Element element{
        fs::path(file).stem().string(),
        groups(text, "^(?:struct|enum class) (\\w+)|^(?:inline |constexpr |template <>\\n)*[\\w:<> ]+ (k[A-Z]\\w+) ="),
        groups(text, "return model\\.(\\w+);"), groups(text, "section = \"(\\w+)\"")};
    element.names.erase("KindOf");
    for (const std::string& key : groups(text, "\\*key = \"(\\w+)\""))
      if (key.find('_') != std::string::npos)
        element.quoted.insert(key);  // keys of one word are words of the language, too
    elements.push_back(std::move(element));
  }
  const std::string raw = text_of(root / "compiler/reader/raw.hpp");
  for (const std::string& list : groups(raw, "using Compositions = Kinds<([^>]*)>"))
    for (const std::string& fields : groups(list, "(\\w+)Fields")) {
      const std::string parts = in_parts(fields), stem = parts.substr(1, parts.size() - 2);
      elements.push_back({stem, {fields + "Fields"}, {}, {stem, stem + "s"}});
    }
  return elements;
}

/// The element whose own file it is, by folder and name.
const Element* owner_of(const std::string& file, const std::vector<Element>& elements) {
  const std::string name = file.substr(file.rfind('/') + 1);
  for (const Element& element : elements) {
    const bool singular = name.starts_with(element.stem + ".") || name.starts_with(element.stem + "_");
    if (file.find("/elements/") != std::string::npos ? singular : name.starts_with(element.stem + "s."))
      return &element;
  }
  return nullptr;
}

/// Files of the product: sources, pages of the report, frames of emitted files, the build.
std::map<std::string, Source> product() {
  const fs::path root = MBGEN_SOURCE_DIR;
  const std::string build = std::regex_replace(text_of(root / "CMakeLists.txt"), std::regex("/\\*"), "/");  // globs
  std::map<std::string, Source> files = {{"CMakeLists.txt", source_of(build)}};
  for (const std::string& file : sources_below({"compiler", "runtime", "workbench"}))
    files[file] = source_of(text_of(root / file));
  for (const char* folder : {"templates", "workbench/report/web/src"})
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder))
      files[fs::relative(entry.path(), root).string()] = source_of(text_of(entry.path()));
  return files;
}

/// Own files, and all that name the element but those of other elements, which build on it.
std::vector<std::string> touched_by(const Element& element, const std::vector<Element>& elements,
                                    const std::map<std::string, Source>& files) {
  std::vector<std::string> touched;
  for (const auto& [file, source] : files) {
    const Element* owner = owner_of(file, elements);
    if (owner ? owner->stem == element.stem : names_element(source, element)) touched.push_back(file);
  }
  return touched;
}

TEST(Elements, TouchFewFiles) {
  const std::vector<Element> elements = elements_of_product();
  EXPECT_GE(elements.size(), 15u);
  const std::map<std::string, Source> files = product();
  for (const Element& element : elements) {
    if (kSubjects.contains(element.stem)) continue;
    const std::vector<std::string> touched = touched_by(element, elements, files);
    std::string list;
    for (const std::string& file : touched) list += "\n  " + file;
    EXPECT_LE(touched.size(), kMostTouched) << element.stem << " touches " << touched.size() << " files:" << list;
    EXPECT_GE(touched.size(), element.stem == "anti_roll_bar" ? 4u : 6u) << element.stem << list;
    RecordProperty(element.stem, static_cast<int>(touched.size()));
  }
}

TEST(Elements, AreFoundByTheirNames) {
  const Element stop{"bump_stop", {"BumpStop"}, {"bump_stops"}, {"bump_stops"}};
  EXPECT_TRUE(names_element(source_of("void f(const BumpStop& s);"), stop));
  EXPECT_TRUE(names_element(source_of("bump_stop_law(p)"), stop));
  EXPECT_TRUE(names_element(source_of("kBumpStops + 1"), stop));
  EXPECT_TRUE(names_element(source_of("section(\"bump_stops\")"), stop));
  EXPECT_FALSE(names_element(source_of("// a BumpStop\nint a; /* bump_stop */"), stop));
  EXPECT_FALSE(names_element(source_of("say(\"the bump_stop is hit\")"), stop));
  EXPECT_FALSE(names_element(source_of("bump(stop)"), stop));
  const Element contact{"contact", {"SurfaceContact"}, {"contacts"}, {"contacts"}};
  EXPECT_FALSE(names_element(source_of("contact_of_tyre(); road.contacts"), contact));
  EXPECT_TRUE(names_element(source_of("for (auto& c : r.model.contacts)"), contact));
  EXPECT_EQ(in_parts("AntiRollBar"), "_anti_roll_bar_");
}

}  // namespace
}  // namespace mbgen::house
