#include "workbench/describe/equation_lines.hpp"

#include <regex>
#include <sstream>
#include <string_view>

namespace mbgen {
namespace {

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

}  // namespace

std::vector<EquationLine> equations_in(const std::string& text) {
  EquationReader reader;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) reader.read(line);
  return reader.lines;
}

std::set<std::string> names_of_parts(const std::vector<EquationLine>& all) {
  constexpr std::string_view kPart = "_part_";
  std::set<std::string> names, parts;
  for (const EquationLine& line : all) names.insert(line.name);
  for (const std::string& name : names) {
    const std::size_t at = name.rfind(kPart);
    if (at == std::string::npos || name.find_first_not_of("0123456789", at + kPart.size()) != std::string::npos)
      continue;
    if (names.contains(name.substr(0, at))) parts.insert(name);
  }
  return parts;
}

}  // namespace mbgen
