// Headings of emitted solvers: a value named after a body or a coordinate stands under that one's heading.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "compiler/compile.hpp"

namespace mbgen {
namespace {

/// The fast solver of a model.
std::string solver_text(const std::string& name) {
  const Result<Compilation> compilation = compile(MBGEN_SOURCE_DIR "/models/" + name + ".json");
  for (const EmittedFile& file : emit(*compilation, {.runtime_headers = false}))
    if (file.path == name + ".cpp") return file.text;
  return "";
}

/// The coordinate of every body, by the legend of the file.
std::map<std::string, std::string> coordinates_of_bodies(const std::string& text) {
  static const std::regex kLine(R"(//   (\S+): (\S+), (?:revolute|prismatic), on .*)");
  std::map<std::string, std::string> coordinates;
  std::istringstream file(text);
  std::smatch match;
  for (std::string line; std::getline(file, line);)
    if (std::regex_match(line, match, kLine)) coordinates[match[1]] = match[2];
  return coordinates;
}

/// Start of the heading for the body or coordinate in a value's name, "" for a value that is named after neither.
std::string heading_of(const std::string& name, const std::map<std::string, std::string>& coordinates) {
  static const std::regex kOfBody("(?:R|r|v|w|a|alpha|f|n)_(\\w+?)(?:_[xyz]){1,2}(?:_\\d+)?");
  static const std::regex kOfCoordinate("(?:u|b|Q)_(\\w+?)(?:_[xyz])?(?:_\\d+)?");
  std::smatch match;
  for (const auto& [body, coordinate] : coordinates) {
    const std::string heading = body + ": " + coordinate + ",";
    if (std::regex_match(name, match, kOfBody) && match[1] == body) return heading;
    if (std::regex_match(name, match, kOfCoordinate) && match[1] == coordinate) return heading;
  }
  return "";
}

/// "arm_left_and_right_pin" of two bodies that are mirror images or twins: what they have in common before and after
/// stands once.
std::string name_of_both(const std::string& first, const std::string& second) {
  static const std::regex kCommon("((?:\\w+_)?)(\\w+?)((?:_\\w+)?),\\1(\\w+?)\\3");
  return std::regex_replace(first + "," + second, kCommon, "$1$2_and_$4$3");
}

/// Whether a pair of this name stands under a heading of both bodies. Names of several pairs may be the same.
bool stands_under_both(const std::string& name, const std::string& heading,
                       const std::map<std::string, std::string>& coordinates) {
  for (const auto& [a, of_a] : coordinates)
    for (const auto& [b, of_b] : coordinates) {
      const bool names_both = heading.starts_with(a + ": " + of_a + ",") &&
                              heading.find("; and likewise " + b + ": " + of_b + ",") != std::string::npos;
      if (names_both && !heading_of(name, {{name_of_both(a, b), name_of_both(of_a, of_b)}}).empty()) return true;
    }
  return false;
}

class EmittedHeadings : public testing::TestWithParam<const char*> {};

// A copy of a result that a call for many angles left in an array is a reading of it, and stands where it is read.
TEST_P(EmittedHeadings, namedValuesStandUnderTheirBody) {
  static const std::regex kValue(R"(  (?:const (?:double|Pair) |w\d+\.)(\w+) = (.*))");
  static const std::regex kReading(R"((?:mbgen::pair_at\()?(?:w\d+\.)?(?:sines|cosines)\w*(?:\[\d+\]| \+ \d+\));)");
  const std::string name = GetParam(), text = solver_text(name);
  const auto coordinates = coordinates_of_bodies(text);
  std::istringstream file(text);
  std::string heading;
  bool is_hot = false, goes_on = false;
  int named = 0, pairs = 0, number = 0;
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.find("void compute_") != std::string::npos) {
      is_hot = line.find("void compute_accelerations") != std::string::npos;
      heading.clear();
    }
    if (line.starts_with("  // --- "))
      heading.clear();
    else if (line.starts_with("  // "))
      heading = (goes_on ? heading + " " : "") + line.substr(5);
    goes_on = line.starts_with("  // ") && !line.starts_with("  // --- ");
    if (!is_hot || !std::regex_match(line, match, kValue) || std::regex_match(match[2].str(), kReading)) continue;
    static const std::regex kPairOfBodies("(?:R|r|v|w|a|alpha|f|n)_\\w+_and_\\w+(?:_[xyz]){1,2}(?:_\\d+)?");
    if (std::regex_match(match[1].str(), kPairOfBodies)) {
      ++pairs;
      EXPECT_TRUE(stands_under_both(match[1], heading, coordinates))
          << name << ".cpp:" << number << ": " << match[1] << " under " << heading;
    }
    const std::string wanted = heading_of(match[1], coordinates);
    if (wanted.empty()) continue;
    ++named;
    EXPECT_TRUE(heading.starts_with(wanted)) << name << ".cpp:" << number << ": " << match[1] << " under " << heading;
  }
  EXPECT_EQ(pairs > 10, name == "coach_mechanism") << pairs << " pairs named after two bodies";
  EXPECT_GT(named, 4) << "values named after bodies: the test has read too little";
}

INSTANTIATE_TEST_SUITE_P(Models, EmittedHeadings, testing::Values("four_bar", "pulled_wheel", "coach_mechanism"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace mbgen
