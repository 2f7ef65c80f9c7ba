#pragma once
// The command line as a user meets it: a directory of one's own, files, commands, exit codes, output.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace mbgen::cli_test {

using Json = nlohmann::json;

inline const std::string kSource = MBGEN_SOURCE_DIR;
inline constexpr const char* kEngines[] = {"generated", "generic"};

/// Result of one run.
struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

/// A table as `simulate` writes it.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  std::size_t column(const std::string& name) const {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return i;
    }
    ADD_FAILURE() << "no column " << name;
    return 0;
  }
  double at(std::size_t row, const std::string& name) const { return rows.at(row).at(column(name)); }
  double last(const std::string& name) const { return at(rows.size() - 1, name); }
};

/// Largest error of the accelerations over the largest acceleration of the state, over all states of a reference, which
/// has them under `key`.
inline double worst_error(const Json& answer, const Json& reference, const std::string& key = "zdd") {
  double worst = 0;
  for (std::size_t s = 0; s < reference["states"].size(); ++s) {
    EXPECT_EQ(answer["states"][s]["status"], "ok");
    const std::vector<double> expected = reference["states"][s][key], actual = answer["states"][s]["zdd"];
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      error = std::max(error, std::abs(actual.at(i) - expected[i]));
      largest = std::max(largest, std::abs(expected[i]));
    }
    worst = std::max(worst, error / largest);
  }
  return worst;
}

/// Two tables of one motion: every column but the residuals differs by less than `tolerance` of its largest value.
/// Columns that stay near zero are measured against a thousandth of their unit.
inline void expect_same_motion(const Table& one, const Table& other, double tolerance) {
  ASSERT_EQ(one.names, other.names);
  ASSERT_EQ(one.rows.size(), other.rows.size());
  for (std::size_t c = 0; c < one.names.size(); ++c) {
    if (one.names[c].starts_with("residual")) continue;
    double largest = 1e-3, error = 0;
    for (std::size_t row = 0; row < one.rows.size(); ++row) {
      largest = std::max(largest, std::abs(one.rows[row][c]));
      error = std::max(error, std::abs(other.rows[row][c] - one.rows[row][c]));
    }
    EXPECT_LT(error / largest, tolerance) << one.names[c];
  }
}

/// A pendulum of one point mass: 2 m below its pin, which turns about y; positive angles move it to -x.
inline const char* const kPendulum = R"({
  "mbgen": 1, "name": "pendulum", "gravity": [0, 0, -9.81],
  "inputs": { "torque": { "unit": "N m", "default": 0 } },
  "bodies": {
    "ground": { "points": { "O": [0, 0, 0] } },
    "bob": { "mass": 3, "com": [0, 0, -2], "inertia": [0, 0, 0], "points": { "O": [0, 0, 0], "tip": [0, 0, -2] } }
  },
  "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "bob.O", "axis": "y" } },
  "joint_forces": { "motor": { "joint": "pin", "force": "torque" } },
  "outputs": { "height": { "unit": "m", "point": "bob.tip", "quantity": "position", "axis": "z" } },
  "initial": { "positions": { "pin": 0.5 } }
})";

/// A planar four-bar linkage closed by a revolute joint: five equations of rank two.
inline const char* const kFourBar = R"({
  "mbgen": 1, "name": "four_bar",
  "bodies": {
    "ground": { "points": { "A": [0, 0, 0], "D": [0.4, 0, 0] } },
    "crank": { "mass": 0.8, "com": [0.05, 0, 0.02], "inertia": [1e-4, 7e-4, 7e-4],
               "points": { "A": [0, 0, 0], "B": [0.1, 0, 0.05] } },
    "coupler": { "mass": 1.5, "com": [0.27, 0, 0.12], "inertia": [1e-3, 2e-2, 2e-2],
                 "points": { "B": [0.1, 0, 0.05], "C": [0.45, 0, 0.2] } },
    "rocker": { "mass": 1.1, "com": [0.42, 0, 0.1], "inertia": [1e-3, 4e-3, 4e-3],
                "points": { "D": [0.4, 0, 0], "C": [0.45, 0, 0.2] } }
  },
  "joints": {
    "crank_pin": { "type": "revolute", "from": "ground.A", "to": "crank.A", "axis": "y" },
    "elbow": { "type": "revolute", "from": "crank.B", "to": "coupler.B", "axis": "y" },
    "rocker_pin": { "type": "revolute", "from": "ground.D", "to": "rocker.D", "axis": "y" },
    "tip": { "type": "revolute", "from": "coupler.C", "to": "rocker.C", "axis": "y", "cut": true }
  },
  "initial": { "positions": { "crank_pin": 0.6 }, "velocities": { "crank_pin": 3 } }
})";

/// Runs mbgen in a directory that is removed afterwards.
class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    std::string name = (std::filesystem::temp_directory_path() / "mbgen-cli-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    directory_ = name;
    // Solvers that one test compiled serve the next: the key of the cache is the code itself.
    set("MBGEN_PROGRESS", "0");  // no lines that depend on the time
    set("XDG_CACHE_HOME", (std::filesystem::path(MBGEN_BINARY).parent_path() / "cli_test_cache").string());
  }
  ~CommandLine() override { std::filesystem::remove_all(directory_); }

  /// A variable of the environment for the runs to come.
  void set(const std::string& name, const std::string& value) { environment_[name] = value; }

  std::filesystem::path path(const std::string& name) const { return directory_ / name; }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name).string();
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path(name));
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  /// `mbgen ARGUMENTS`, in the shell's syntax, with the test's directory as the current one.
  Outcome mbgen(const std::string& arguments, const std::string& standard_output = ".out") const {
    return shell(fmt::format("'{}' {}", MBGEN_BINARY, arguments), standard_output);
  }

  /// Any command in that directory.
  Outcome shell(const std::string& words, const std::string& standard_output = ".out") const {
    std::string command = fmt::format("cd '{}' && ", directory_.string());
    for (const auto& [name, value] : environment_) command += fmt::format("{}='{}' ", name, value);
    command += fmt::format("{} >{} 2>.err", words, standard_output);
    const int state = std::system(command.c_str());
    return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, read(".out"), read(".err")};
  }

  /// The JSON that a successful run prints.
  Json json_of(const std::string& arguments) const {
    const Outcome run = mbgen(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments << "\n" << run.err;
    return Json::parse(run.out, nullptr, false);
  }

  Table table(const std::string& name) const {
    Table table;
    std::istringstream text(read(name));
    std::string line, field;
    std::getline(text, line);
    for (std::istringstream header(line); std::getline(header, field, ',');) table.names.push_back(field);
    while (std::getline(text, line)) {
      table.rows.emplace_back();
      for (std::istringstream row(line); std::getline(row, field, ',');) table.rows.back().push_back(std::stod(field));
    }
    return table;
  }

  /// Names of all files in the directory but those of the test itself.
  std::vector<std::string> leftovers() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory_)) {
      const std::string name = entry.path().filename().string();
      if (name != ".out" && name != ".err") names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  std::filesystem::path directory_;
  std::map<std::string, std::string> environment_;
};

}  // namespace mbgen::cli_test
