// Every rule of the reader: tests/errors/<rule>.json is a bad model, <rule>.txt the exact text of its messages.
// After a wanted change: MBGEN_UPDATE=1 model_test rewrites the texts; read the difference before committing it.
#include "compiler/model/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "compiler/reader/read_model.hpp"
#include "tests/support/expected_text.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

const fs::path kErrors = fs::path(MBGEN_SOURCE_DIR) / "tests" / "errors";

std::vector<std::string> names_with(const std::string& extension) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(kErrors)) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Rule : public ::testing::TestWithParam<std::string> {};

TEST_P(Rule, HasItsExactMessage) {
  fs::current_path(kErrors);  // messages name files as they were given
  const Result<Model> result = read_model_file(GetParam() + ".json");
  ASSERT_FALSE(result) << "the bad model was accepted";
  testing::expect_text(kErrors / (GetParam() + ".txt"), to_text(result.problems()));
}

std::string rule_name(const ::testing::TestParamInfo<std::string>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Errors, Rule, ::testing::ValuesIn(names_with(".json")), rule_name);

TEST(Rules, EveryTextHasItsModel) {
  const std::vector<std::string> models = names_with(".json"), texts = names_with(".txt");
  EXPECT_EQ(models, texts);
  EXPECT_GT(models.size(), 150u);
}

TEST(Rules, MessagesAreLowerCaseWithoutFullStop) {
  fs::current_path(kErrors);
  for (const std::string& name : names_with(".json")) {
    const Result<Model> result = read_model_file(name + ".json");
    ASSERT_FALSE(result) << name;
    for (const Diagnostic& problem : result.problems()) {
      ASSERT_FALSE(problem.message.empty()) << name;
      EXPECT_FALSE(std::isupper(static_cast<unsigned char>(problem.message.front())))
          << name << ": " << problem.message;
      EXPECT_NE(problem.message.back(), '.') << name << ": " << problem.message;
      EXPECT_GT(problem.where.line, 0) << name;
      EXPECT_GT(problem.where.column, 0) << name;
    }
  }
}

TEST(Rules, ProblemsComeInOrderOfPosition) {
  const Result<Model> result = read_model_file((kErrors / "many_at_once.json").string());
  ASSERT_FALSE(result);
  const Diagnostics& problems = result.problems();
  EXPECT_GE(problems.size(), 10u);
  const bool sorted = std::is_sorted(problems.begin(), problems.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
  });
  EXPECT_TRUE(sorted) << to_text(problems);
}

TEST(Diagnostic, CaretStandsUnderTheColumn) {
  const Diagnostic problem{{"m.json", 3, 5, "/a"}, "must be positive, got -1", "use another", "\t\xC3\xA9 -1"};
  // Column 5 in bytes is the minus sign: a tab, one character of two bytes, a blank.
  EXPECT_EQ(to_text(problem),
            "m.json:3:5: /a: must be positive, got -1\n  \t\xC3\xA9 -1\n  \t  ^~\n  hint: use another\n");
}

TEST(Diagnostic, TildesCoverWhatIsMeant) {
  const auto marked = [](const std::string& line, int column) {
    return line.substr(static_cast<std::size_t>(column - 1), static_cast<std::size_t>(marked_length(line, column)));
  };
  const std::string line = R"("k\"e": { "at": "arm.B", "mass": -1.5e-3, "x": [é] })";
  EXPECT_EQ(marked(line, 1), R"("k\"e")");
  EXPECT_EQ(marked(line, 9), "{");
  EXPECT_EQ(marked(line, 18), "arm");
  EXPECT_EQ(marked(line, 34), "-1.5e-3");
  EXPECT_EQ(marked(line, 49), "é");
  EXPECT_EQ(marked_length(line, 200), 1);
  EXPECT_EQ(marked_length("\"open", 1), 5);
}

TEST(Diagnostic, ColoursForATerminal) {
  const Diagnostic problem{{"m.json", 3, 2, "/a"}, "must be positive, got -1", "use another", " -1"};
  EXPECT_EQ(to_text(problem, Style::coloured),
            "\033[1mm.json:3:2:\033[0m /a: \033[1;31mmust be positive, got -1\033[0m\n   -1\n   "
            "\033[1;32m^~\033[0m\n  \033[36mhint:\033[0m use another\n");
}

TEST(Diagnostic, WithoutALineOnlyTheFileIsNamed) {
  const Diagnostic problem{{"m.json", 0, 0, ""}, "cannot read file", "", ""};
  EXPECT_EQ(to_text(problem), "m.json: cannot read file\n");
}

}  // namespace
}  // namespace mbgen
