#include "workbench/describe/equation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

#include "compiler/emit/quantity_names.hpp"
#include "compiler/text/similar_words.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// Begins the name of a negative, which users take in place of the value.
constexpr std::string_view kMinus = "minus_";

/// A name of a member as one word: "zdd_crank_pin" of "zdd[Coordinate::crank_pin]".
std::string as_word(std::string place) {
  static const std::regex kIndex(R"(\[(?:\w+::)?(\w+)\])");
  return std::regex_replace(place, kIndex, "_$1");
}

/// Reads the lines of a text one by one.
class EquationReader {
 public:
  void read(const std::string& line) {
    ++number_;
    if (line.starts_with("void compute_")) begin_program(line);
    if (const std::size_t text = line.find_first_not_of(' '); text != std::string::npos && line[text] == '/')
      read_comment(line.substr(text + 2));
    else
      read_code(line);
  }

  std::vector<EquationLine> lines;

 private:
  void begin_program(const std::string& line) {
    now_ = {};
    now_.program = line.substr(5, line.find('(') - 5);
  }

  void read_comment(const std::string& words) {
    if (now_.program.empty() || words.starts_with(" operations:")) return;
    if (words.starts_with(" --- ")) {
      now_.step = words.substr(5, words.rfind(" ---") - 5);
      now_.part.clear();
      return;
    }
    now_.part = is_in_comment_ ? now_.part + words : words.substr(1);
    is_in_comment_ = true;
  }

  void read_code(const std::string& line) {
    is_in_comment_ = false;
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) return;
    if (statement_.empty()) first_ = number_;
    statement_ += (statement_.empty() ? "" : " ") + line.substr(begin);
    if (line.find(';') == std::string::npos && !line.ends_with("{") && !line.ends_with("}")) return;
    read_statement(statement_);
    statement_.clear();
  }

  void read_statement(const std::string& statement) {
    static const std::regex kValue(R"((?:const|constexpr) (?:double|float) (\w+) = .*)"),
        kResult(R"(result\.(\S+) = .*)"), kAngle(R"(mbgen::sincos\(.*, (\w+), (\w+)\);)");
    std::smatch match;
    if (std::regex_match(statement, match, kValue)) add(match[1], statement);
    if (std::regex_match(statement, match, kResult)) add(as_word(match[1]), statement);
    if (std::regex_match(statement, match, kAngle))
      for (const int k : {1, 2}) add(match[k], statement);
  }

  void add(const std::string& name, const std::string& statement) {
    EquationLine line = now_;
    line.name = name;
    line.line = first_;
    line.statement = statement;
    lines.push_back(std::move(line));
  }

  EquationLine now_;
  std::string statement_;
  int number_ = 0, first_ = 0;
  bool is_in_comment_ = false;
};

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
  std::set<std::string> seen;
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

std::vector<EquationLine> equations_in(const std::string& text) {
  EquationReader reader;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) reader.read(line);
  return reader.lines;
}

std::string equation_text(const std::string& file, const std::string& text, const std::string& wanted) {
  const std::vector<EquationLine> all = equations_in(text);
  std::vector<const EquationLine*> found;
  for (const EquationLine& line : all)
    if (line.name == wanted || line.name == std::string(kMinus) + wanted) found.push_back(&line);
  if (!found.empty()) return lines_text(file, found);
  if (std::string of_part = part_text(file, wanted, all); !of_part.empty()) return of_part;
  throw UserError(fmt::format("--equation: the reading copy has no quantity \"{}\"\n  hint: did you mean {}?\n", wanted,
                              nearest(wanted, all)));
}

}  // namespace mbgen
