// A car that a new user types from a table of hardpoints, with one mistake each, and the exact text that mbgen says of
// it.
//
// tests/errors/car has the good car; tests/errors/car/mistakes/NAME.txt is one mistake as a page to read:
//   # for people
//   file car.json     the file that the next lines change; a new one where there is none
//   - old text        stands exactly once in the file
//   + new text        in place of it; without this line it is left out
//   | a line          is added to the file
//   $ mbgen check car.json
//   exit 1
// and behind it standard error, byte for byte. MBGEN_UPDATE=1 cli_test --gtest_filter='*CarMistakes*' rewrites it from
// the command on: read the difference before committing it.
#include <optional>
#include <regex>

#include "tests/support/cli_support.hpp"
#include "tests/support/expected_text.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

const fs::path kCarFolder = fs::path(kSource) / "tests" / "errors" / "car";

std::vector<std::string> mistakes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kCarFolder / "mistakes")) {
    if (entry.path().extension() == ".txt") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class CarWithFiles : public CommandLine {
 protected:
  CarWithFiles() {
    for (const auto& entry : fs::directory_iterator(kCarFolder)) {
      if (entry.is_regular_file()) fs::copy_file(entry.path(), path(entry.path().filename().string()));
    }
  }
};

class CarMistakes : public CarWithFiles, public ::testing::WithParamInterface<std::string> {
 protected:
  void replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = read(file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file << " has no " << from;
    ASSERT_EQ(text.find(from, at + 1), std::string::npos) << file << " has twice " << from;
    write(file, text.replace(at, from.size(), to));
  }

  /// Makes the mistake. Result: the page up to its command, and the command.
  std::pair<std::string, std::string> make(std::istream& page) {
    std::string line, file, head;
    std::optional<std::string> old;
    const auto leave_out = [&] {
      if (old) replace(file, *old, "");
      old.reset();
    };
    while (std::getline(page, line)) {
      head += line + "\n";
      if (line.starts_with("$ mbgen ")) {
        leave_out();
        return {head, line.substr(8)};
      }
      if (line.starts_with("+ ") && old) {
        replace(file, *old, line.substr(2));
        old.reset();
        continue;
      }
      leave_out();
      if (line.starts_with("file ")) {
        file = line.substr(5);
      } else if (line.starts_with("- ")) {
        old = line.substr(2);
      } else if (line.starts_with("| ")) {
        write(file, read(file) + line.substr(2) + "\n");
      } else {
        EXPECT_TRUE(line.starts_with("#")) << line;
      }
    }
    ADD_FAILURE() << "the page has no command";
    return {head, ""};
  }
};

/// The text without what an iteration came to that found nothing, which is not the same with every compiler.
std::string without_search(const std::string& text) {
  const std::regex search("(near the initial state[:;]|stays open by) [^\n]*");
  return std::regex_replace(text, search, "$1 ...");
}

TEST_P(CarMistakes, AreToldByPlaceCauseAndNextStep) {
  const fs::path page = kCarFolder / "mistakes" / (GetParam() + ".txt");
  std::ifstream stream(page);
  const auto [head, command] = make(stream);
  ASSERT_FALSE(command.empty());
  const bool compiles = (command.starts_with("simulate") || command.starts_with("sweep")) &&
                        command.find("--engine generic") == std::string::npos;
  ASSERT_FALSE(compiles) << "a mistake is told without a compiler";
  const Outcome run = mbgen(command);
  testing::expect_text(page, fmt::format("{}exit {}\n{}", head, run.exit_code, without_search(run.err)));
  EXPECT_TRUE(run.exit_code == 1 || (run.exit_code == 0 && !run.err.empty())) << "nothing is said of it";
  // A file with its line or without, or the option that was mistyped; and no crowd of followers.
  EXPECT_TRUE(std::regex_search(run.err, std::regex("^([a-z]+\\.[a-z]+:|--[a-z-]+[: ]|simulate: )"))) << run.err;
  EXPECT_LE(std::count(run.err.begin(), run.err.end(), '\n'), 9) << run.err;
}

INSTANTIATE_TEST_SUITE_P(One, CarMistakes, ::testing::ValuesIn(mistakes()),
                         [](const auto& info) { return info.param; });

TEST_F(CarWithFiles, AreSixtyMistakes) { EXPECT_GE(mistakes().size(), 60u); }

// The good car itself, through the commands of the mistakes: nothing is noted, nothing refused.
TEST_F(CarWithFiles, WithoutAMistakeIsSilent) {
  for (const char* command :
       {"check car.json", "check axles.json", "equilibrium car.json", "linearize car.json --at equilibrium",
        "kc axles.json front -o k", "simulate car.json --engine generic --duration 0.1 --input steer=0.05 --out o.csv",
        "simulate car.json --engine generic --manoeuvre brake.json --duration 0.1 --out o.csv",
        "sweep car.json --vary fl_spring=30e3,40e3 --metric 'max(height)' --engine generic "
        "--duration 0.01 --out s.csv"}) {
    const Outcome run = mbgen(command);
    EXPECT_EQ(run.exit_code, 0) << command << run.err;
    const bool is_progress = std::string_view(command).starts_with("sweep");
    EXPECT_TRUE(is_progress || run.err.find("note: ") == std::string::npos) << command << run.err;
    EXPECT_EQ(run.err.find("warning"), std::string::npos) << command << run.err;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
