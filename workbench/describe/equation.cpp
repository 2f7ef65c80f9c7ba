#include "workbench/describe/equation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "compiler/emit/quantity_names.hpp"
#include "compiler/text/similar_words.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/describe/equation_lines.hpp"
#include "workbench/describe/equation_words.hpp"

namespace mbgen {
namespace {

/// Begins the name of a negative, which users take in place of the value.
constexpr std::string_view kMinus = "minus_";

/// The place of a line: file and line, program, step, part.
std::string place_text(const std::string& file, const EquationLine& line) {
  std::string text = fmt::format("{}:{}", file, line.line);
  for (const std::string* words : {&line.program, &line.step, &line.part})
    if (!words->empty()) text += ", " + *words;
  return text + "\n";
}

std::string lines_text(const std::string& file, const std::vector<const EquationLine*>& lines) {
  const std::string& name = lines.front()->name;
  const bool is_negative = name.starts_with(kMinus);
  const QuantityName kind = quantity_of(is_negative ? name.substr(kMinus.size()) : name);
  std::string text = name;
  if (is_negative) text += ": its negative is the";
  if (!kind.prefix.empty())
    text += fmt::format("{} {}{}{}", is_negative ? "" : ":", kind.words, kind.unit.empty() ? "" : ", ", kind.unit);
  text += "\n";
  for (const EquationLine* line : lines) text += "  " + place_text(file, *line) + "    " + line->statement + "\n";
  return text;
}

/// Whether a part of the model is in the name of a quantity: "carrier_left" in "Ic_carrier_left_zz".
bool is_of_part(const std::string& name, const std::string& part) {
  const std::size_t at = ("_" + name + "_").find("_" + part + "_");
  return at != std::string::npos;
}

/// The quantities of a part, each once, at its first line.
std::string part_text(const std::string& file, const std::string& part, const std::vector<EquationLine>& all) {
  std::string text;
  std::set<std::string> seen = names_of_parts(all);
  for (const EquationLine& line : all) {
    const bool is_heading = line.part == part || line.part.starts_with(part + ": ");
    if (!is_of_part(line.name, part) && !(is_heading && !quantity_of(line.name).prefix.empty())) continue;
    if (!seen.insert(line.name).second) continue;
    text += fmt::format("  {:<32} {}:{}{}{}\n", line.name, file, line.line, line.step.empty() ? "" : ", ", line.step);
  }
  return text.empty() ? "" : part + "\n" + text;
}

/// The rest of a name behind its kind: "carrier_left_zz" of "Ic_carrier_left_zz".
std::string_view tail_of(std::string_view name) { return name.substr(std::min(name.find('_'), name.size())); }

/// Changes from a query to the nearest name.
int distance_to_nearest(const std::string& wanted, const std::vector<EquationLine>& all) {
  int least = static_cast<int>(wanted.size());
  for (const EquationLine& line : all) least = std::min(least, edit_distance(line.name, wanted));
  return least;
}

/// The quantities that fit the words of a query, "" for a name that is typed wrong or a query without a known word.
std::string fitting_text(const std::string& file, const std::string& wanted, const std::vector<EquationLine>& all,
                         const PartWords& parts) {
  constexpr std::size_t kMost = 16;
  constexpr int kTyped = 2;  // changes that are taken for a slip of the keyboard
  int words = 0;
  const std::vector<FittingLine> fitting = fitting_lines(all, wanted, parts, words);
  if (fitting.empty()) return "";
  const int matched = fitting.front().matched;
  if (matched < words && (2 * matched < words || distance_to_nearest(wanted, all) <= kTyped)) return "";
  std::string text = fmt::format("no quantity is named \"{}\"; {} of its words fit:\n", wanted,
                                 matched == words ? "all" : fmt::format("{} of {}", matched, words));
  for (std::size_t i = 0; i < std::min(fitting.size(), kMost); ++i) {
    const EquationLine& line = *fitting[i].line;
    const bool is_negative = line.name.starts_with(kMinus);
    const QuantityName kind = quantity_of(is_negative ? line.name.substr(kMinus.size()) : line.name);
    text += fmt::format("  {:<32} {}:{}  {}{}{}\n", line.name, file, line.line, kind.words,
                        kind.unit.empty() ? "" : ", ", kind.unit);
  }
  if (fitting.size() > kMost) text += fmt::format("  ... and {} more\n", fitting.size() - kMost);
  return text;
}

/// "a", "b" or "c": the names with the fewest changes to a word. Another kind of the same part is near.
std::string nearest(const std::string& wanted, const std::vector<EquationLine>& all) {
  constexpr std::size_t kMost = 3;
  constexpr int kOfAnotherPart = 2;
  std::set<std::pair<int, std::string>> by_distance;
  for (const EquationLine& line : all)
    by_distance.emplace(edit_distance(line.name, wanted) + (tail_of(line.name) == tail_of(wanted) ? 0 : kOfAnotherPart),
                        line.name);
  std::string text;
  const int least = by_distance.begin()->first;
  std::size_t count = 0;
  for (const auto& [distance, name] : by_distance) {
    if (distance > least + 1 || count == kMost) break;
    text += (count++ == 0 ? "\"" : ", \"") + name + "\"";
  }
  return text;
}

}  // namespace

std::string equation_text(const std::string& file, const std::string& text, const std::string& wanted,
                          const std::map<std::string, std::string>& parts) {
  const std::vector<EquationLine> all = equations_in(text);
  std::vector<const EquationLine*> found;
  for (const EquationLine& line : all)
    if (line.name == wanted || line.name == std::string(kMinus) + wanted) found.push_back(&line);
  if (!found.empty()) return lines_text(file, found);
  // "force_front_left" begins the names of actions on bodies, but its words fit the forces of the tyre.
  const bool is_part = parts.empty() || parts.contains(wanted);
  const std::string of_part = part_text(file, wanted, all);
  if (is_part && !of_part.empty()) return of_part;
  if (std::string fitting = fitting_text(file, wanted, all, parts); !fitting.empty()) return fitting;
  if (!of_part.empty()) return of_part;
  throw UserError(fmt::format("--equation: the reading copy has no quantity \"{}\"\n  hint: did you mean {}?\n", wanted,
                              nearest(wanted, all)));
}

}  // namespace mbgen
