#include "workbench/describe/equation_words.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <string_view>
#include <tuple>

#include "compiler/emit/quantity_names.hpp"
#include "compiler/model/element_kinds.hpp"

namespace mbgen {
namespace {

using Words = std::vector<std::string>;

/// "front roll bar" of "Front_roll-bar": small letters; a plural loses its s.
Words words_of(std::string_view text) {
  constexpr std::size_t kShortestPlural = 4;
  Words words;
  std::string word;
  const auto end_word = [&] {
    if (word.size() >= kShortestPlural && word.back() == 's' && word[word.size() - 2] != 's') word.pop_back();
    if (!word.empty()) words.push_back(word);
    word.clear();
  };
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else
      end_word();
  }
  end_word();
  return words;
}

/// Phrases with one meaning, by the word that stands for them.
std::string with_one_word(std::string query) {
  static const std::pair<std::regex, const char*> kPhrases[] = {
      {std::regex(R"((anti[-_ ]?)?roll[-_ ]?bars?|sway[-_ ]?bars?|stabili[sz]ers?([-_ ]?bars?)?|arb\b)",
                  std::regex::icase),
       "bar"},
      {std::regex(R"(\btires?\b)", std::regex::icase), "tyre"},
      {std::regex(R"(\btorques?\b)", std::regex::icase), "moment"},
      {std::regex(R"(\bbounce\b)", std::regex::icase), "heave"},
      {std::regex(R"(\b(first|second) moments\b)"), "integral"},
      {std::regex(R"(\b(speed|rate)\b)", std::regex::icase), "velocity"},
      {std::regex(R"(\bload\b)", std::regex::icase), "vertical force"}};
  for (const auto& [phrase, word] : kPhrases) query = std::regex_replace(query, phrase, word);
  return query;
}

/// Words of a query that tell something.
Words words_of_query(const std::string& query) {
  static const std::set<std::string> kEmpty = {"a", "an", "the", "of", "at", "in", "on", "for", "to", "and"};
  Words words;
  for (const std::string& word : words_of(with_one_word(query)))
    if (!kEmpty.contains(word)) words.push_back(word);
  return words;
}

/// Words for names by the field's habits.
std::string words_by_habit(const std::string& name) {
  static constexpr std::string_view kBars[] = {"_arb", "_bar", "_anti", "_stabilis", "_stabiliz", "_sway"};
  static constexpr std::pair<std::string_view, const char*> kEnds[] = {
      {"_rx", " roll"}, {"_about_x", " roll"}, {"_ry", " pitch"}, {"_about_y", " pitch"},
      {"_rz", " yaw"},  {"_about_z", " yaw"},  {"_tz", " heave"}, {"_along_z", " heave"}};
  std::string words;
  const auto is_in = [&](std::string_view part) { return name.find(part) != std::string::npos; };
  if (std::ranges::any_of(kBars, is_in)) words += " bar";
  for (const auto& [end, meaning] : kEnds)
    if (name.ends_with(end)) words += meaning;
  return words;
}

bool contains(const Words& words, const std::string& word) { return std::ranges::find(words, word) != words.end(); }

/// Words of the kinds of quantities, by prefix.
using KindWords = std::map<std::string_view, Words>;

KindWords kind_words() {
  KindWords kinds{{"", {}}};
  for (const QuantityName& kind : quantity_names())
    kinds[kind.prefix] = words_of(with_one_word(std::string(kind.words)));
  return kinds;
}

/// A name under its kind, with all words for it.
struct Described {
  Words own;    ///< of the name without its kind
  Words parts;  ///< further ones, of the parts of the model in it
  Words kind;   ///< of the kind of quantity
};

Described described(const std::string& name, const PartWords& parts, const KindWords& kinds) {
  constexpr std::string_view kMinus = "minus_";
  const std::string plain = name.starts_with(kMinus) ? name.substr(kMinus.size()) : name;
  const QuantityName kind = quantity_of(plain);
  const std::string rest = plain.substr(std::min(kind.prefix.size(), plain.size()));
  Described words{words_of(rest), words_of(words_by_habit(rest)), kinds.at(kind.prefix)};
  words.kind.push_back(words_of(kind.prefix).empty() ? "" : words_of(kind.prefix).front());
  const std::string within = rest + "_";
  std::vector<const PartWords::value_type*> met;
  for (const auto& part : parts)
    if (within.find("_" + part.first + "_") != std::string::npos) met.push_back(&part);
  for (const auto* part : met) {
    // "drag" in "drag_link" is no part of its own.
    const auto is_in = [&](const auto* other) {
      return other != part && ("_" + other->first + "_").find("_" + part->first + "_") != std::string::npos;
    };
    if (std::ranges::any_of(met, is_in)) continue;
    for (std::string& word : words_of(part->second)) words.parts.push_back(std::move(word));
  }
  return words;
}

}  // namespace

PartWords part_words(const Model& model, const Topology& topology) {
  PartWords words;
  each_kind([&](auto kind) {
    for (const auto& element : kind.list(model)) words[element.name] += std::string(" ") + kind.words;
  });
  for (const Rod& rod : model.rods) words[rod.name] += " rod";
  for (const Loop& loop : topology.loops) words[loop.name] += " loop";
  for (const TreeBody& body : topology.bodies) words[body.name] += " body";
  for (const TreeBody& body : topology.bodies) words[body.coordinate] += " coordinate";
  return words;
}

std::vector<FittingLine> fitting_lines(const std::vector<EquationLine>& all, const std::string& query,
                                       const PartWords& parts, int& words) {
  const Words wanted = words_of_query(query);
  words = static_cast<int>(wanted.size());
  const KindWords kinds = kind_words();
  const std::set<std::string> of_sums = names_of_parts(all);
  // Words of the query that fit, then the length of the name by words, then the order of the text.
  std::vector<std::tuple<int, int, std::size_t>> found;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (quantity_of(all[i].name).prefix.empty() || of_sums.contains(all[i].name)) continue;
    if (!seen.insert(all[i].name).second) continue;
    const Described name = described(all[i].name, parts, kinds);
    int matched = 0, of_part = 0, left = static_cast<int>(name.own.size());
    for (const std::string& word : wanted) {
      const bool is_own = contains(name.own, word), is_of_part = is_own || contains(name.parts, word);
      if (is_own) --left;
      if (is_of_part) ++of_part;
      if (is_of_part || contains(name.kind, word)) ++matched;
    }
    if (matched > 0 && (of_part > 0 || matched == words)) found.emplace_back(-matched, left, i);
  }
  std::ranges::sort(found);
  std::vector<FittingLine> lines;
  for (const auto& [matched, left, i] : found)
    if (matched == std::get<0>(found.front())) lines.push_back({&all[i], -matched});
  return lines;
}

}  // namespace mbgen
