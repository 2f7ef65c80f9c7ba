// Hostile names and texts: emitted code, build file and manifest stay what they are.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "compiler/compile.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

using Names = std::vector<std::string>;
using Json = nlohmann::ordered_json;

/// Words of the language and the model's own meanings, which parameters and inputs may not have.
const std::set<std::string> kMeanings = {"pi",   "t",    "z",    "zd",    "sqrt", "sin",   "cos",  "tan",
                                         "asin", "acos", "atan", "atan2", "exp",  "log",   "tanh", "abs",
                                         "min",  "max",  "pow",  "sign",  "step", "select"};

/// Every identifier of a text that a model may use as a name.
Names words_of(const std::string& text) {
  static const std::regex word("[A-Za-z_][A-Za-z0-9_]{0,63}(?![A-Za-z0-9_])");
  std::set<std::string> words;
  for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) words.insert(at->str());
  return {words.begin(), words.end()};
}

/// Pendulums side by side. Every name is one of a joint, a body, an output, and a parameter or an input in turn; its
/// unit is the one at its place, the last when there are fewer.
Compilation pendulums(const Names& names, const Names& units = {"1"}, const std::string& file = "model.json") {
  const Json origin = Json::parse(R"({ "O": [0, 0, 0] })");
  Json model = {{"mbgen", 1}, {"bodies", {{"ground", {{"points", origin}}}}}};
  std::string torque = "0";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string &name = names[i], &unit = units[std::min(i, units.size() - 1)];
    const std::string body = name == "ground" ? "earth" : name;
    model["bodies"][body] = {{"mass", 1}, {"com", {1, 0, 0}}, {"inertia", {1, 1, 1}}, {"points", origin}};
    model["joints"][name] = {{"type", "revolute"}, {"from", "ground.O"}, {"to", body + ".O"}, {"axis", "y"}};
    model["outputs"][name] = {{"unit", unit}, {"joint", name}};
    if (kMeanings.count(name)) continue;
    if (i % 2 == 0) model["parameters"][name] = {{"value", 1}, {"unit", unit}, {"tunable", true}};
    if (i % 2 == 1) model["inputs"][name] = {{"unit", unit}};
    if (i < 100) torque += " + " + name;  // enough of them in the code
  }
  model["joint_forces"]["torque"] = {{"joint", names.front()}, {"force", torque}};
  const Result<Model> result = read_model(model.dump(), file);
  if (!result) throw std::runtime_error(to_text(result.problems()).substr(0, 2000));
  return *compile(*result);
}

/// Solver, batch interface and driver.
std::vector<EmittedFile> all_files(const Compilation& compilation) {
  constexpr int kLanes = 4;
  std::vector<EmittedFile> files = emit(compilation, {.runtime_headers = false, .lanes = kLanes});
  files.push_back(emit_driver(compilation.model, kLanes));
  return files;
}

class Hostile : public testing::TestWithParam<Compiler> {
 protected:
  void SetUp() override {
    if (!is_installed(GetParam())) GTEST_SKIP() << GetParam().command << " is not installed";
  }

  std::string include() const {
    return " -I" + directory_.path().string() + " -I" MBGEN_SOURCE_DIR "/runtime/include ";
  }

  /// Text of all that the solver's files include, in the compiler's own dialect. option: -E, -dM -E
  std::string preprocessed(const std::string& option) const {
    write(directory_.path(), {"all.cpp",
                              "#include <cstring>\n#include <new>\n#include \"mbgen/driver.hpp\"\n"
                              "#include \"mbgen/solver.hpp\"\n#include \"mbgen/elementary.hpp\"\n"});
    return run(GetParam().command + include() + "-std=gnu++17 -P " + option + " " +
               (directory_.path() / "all.cpp").string())
        .text;
  }

  /// Messages of the compiler on the files, in its own dialect, which has more macros than the standard; empty when it
  /// takes them.
  std::string complaints(const std::vector<EmittedFile>& files) const {
    std::string text;
    for (const EmittedFile& file : files) write(directory_.path(), file);
    for (const EmittedFile& file : files) {
      if (!file.path.ends_with(".cpp")) continue;
      const Finished result = run(compile_command(GetParam()) + " -std=gnu++17 -Wno-psabi -fsyntax-only" + include() +
                                  (directory_.path() / file.path).string());
      if (result.code != 0) text += result.text.substr(0, 2000);
    }
    return text;
  }

  TemporaryDirectory directory_;
};

TEST_P(Hostile, macrosOfTheHeadersNameNothing) {
  Names macros;
  std::istringstream lines(preprocessed("-dM -E"));
  for (std::string line; std::getline(lines, line);) {
    static const std::regex plain("#define ([A-Za-z][A-Za-z0-9_]{0,63}) .*");
    if (std::smatch match; std::regex_match(line, match, plain)) macros.push_back(match[1]);
  }
  ASSERT_GT(macros.size(), 100u);
  EXPECT_EQ(complaints(all_files(pendulums(macros))), "");
}

TEST_P(Hostile, wordsOfTheLanguageAndOfTheCodeNameNothing) {
  constexpr const char* kLanguage =
      "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class "
      "compl "
      "concept const consteval constexpr constinit const_cast continue co_await co_return co_yield decltype default "
      "delete do double dynamic_cast else enum explicit export extern false float for friend goto if import inline int "
      "long module mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
      "register reinterpret_cast requires return short signed sizeof static static_assert static_cast struct switch "
      "template this thread_local throw true try typedef typeid typename union unsigned using virtual void volatile "
      "wchar_t while xor xor_eq final override main __func__ _Pragma __attribute__ __int128 typeof asm__ defined";
  std::string code;
  for (const EmittedFile& file : all_files(pendulums({"pin", "push"}))) code += file.text;
  code = std::regex_replace(code, std::regex("//[^\n]*|\"[^\"\n]*\""), "");
  const Names words = words_of(code + kLanguage);
  ASSERT_GT(words.size(), 300u);
  EXPECT_EQ(complaints(all_files(pendulums(words))), "");
}

TEST_P(Hostile, solversHaveNamespacesOfTheirOwn) {
  const Names words = words_of(preprocessed("-E"));
  ASSERT_GT(words.size(), 1000u);
  std::string text = "#include \"all.cpp\"\n";
  for (const std::string& word : words) {
    Model model;
    model.name = word;
    text += fmt::format("namespace {} {{ class Of_{}; }}\n", solver_name(model), word);
  }
  write(directory_.path(), {"namespaces.cpp", text + "int main() { return 0; }\n"});
  const Finished result = run(GetParam().command + include() + "-std=gnu++17 -fsyntax-only " +
                              (directory_.path() / "namespaces.cpp").string());
  EXPECT_EQ(result.code, 0) << result.text.substr(0, 2000);
}

TEST_P(Hostile, namesOfTheInterfaceNameSolvers) {
  for (const char* name : {"Dynamics", "lanes", "batch"}) {
    Compilation compilation = pendulums({"pin"});
    compilation.model.name = name;
    EXPECT_EQ(complaints(all_files(compilation)), "") << name;
  }
}

/// Texts that people may put where the format takes any: units.
const Names kTexts = {"\"; int evil = 1; //",
                      "*/ int evil; /*",
                      "end\\",
                      "?\?/",
                      "a ?\?/\n int evil;",
                      "\n#error evil\n",
                      "\r#error evil\r",
                      "\\n\\\"%s%n{}{{solver}}${PROJECT_NAME}",
                      "m\u00b2/s \u65e5\u672c",
                      "\u202e;evil\u2066",
                      "\u2028#error evil",
                      "</script><script>alert(1)</script>",
                      "R\"(x)\"",
                      "\x01\x1f\x7f\t",
                      std::string(256, 'u')};

/// Prints the units, each with its final zero, and the acceleration of the first joint.
constexpr const char* kPrintingMain = R"(#include "model.hpp"
#include <cstdio>
#include <cstring>
int main() {
  for (const char* unit : model::kInputUnits) std::fwrite(unit, 1, std::strlen(unit) + 1, stdout);
  model::State state{};
  const double tau[model::kCoordinates] = {2};
  model::Derivative derivative{};
  const bool ok = model::accelerations({}, {}, state, tau, derivative).ok();
  std::printf("%.17g", ok ? derivative.zdd[0] : -1);
}
)";

TEST_P(Hostile, unitsComeThroughAndDoNothing) {
  Names names, units;
  for (const std::string& text : kTexts) {
    // One parameter and one input each.
    for (const char* kind : {"parameter", "input"}) {
      names.push_back(fmt::format("{}_{}", kind, units.size()));
      units.push_back(text);
    }
  }
  const Compilation compilation = pendulums(names, units);
  const std::vector<EmittedFile> files = all_files(compilation);
  EXPECT_EQ(complaints(files), "");
  const std::string base = (directory_.path() / "model").string();
  write(directory_.path(), {"main.cpp", kPrintingMain});
  const Finished built = run(compile_command(GetParam()) + " -O0" + include() + "-o " + base + " " + base + ".cpp " +
                             (directory_.path() / "main.cpp").string());
  ASSERT_EQ(built.code, 0) << built.text.substr(0, 2000);
  std::string expected;
  for (const std::string& text : kTexts) expected += text + '\0';
  const std::string printed = run(base).text;
  EXPECT_EQ(printed.substr(0, expected.size()), expected);
  // Moments about the pin: 2 N m asked, 15 parameters of 1 N m each, gravity on the lever of 1 m; inertia 1 + 1.
  EXPECT_NEAR(std::stod(printed.substr(expected.size())), (2 + 15 + 9.81) / 2, 1e-12);
}

TEST_P(Hostile, fileNamesStayInTheirComments) {
  const Names files = {"evil\\",
                       "a\nint evil;.json",
                       "?\?/",
                       "\xff\xfe\xe2\x80.json",
                       "*/ \"quoted\" ${x} #[[.json",
                       "..\\..\\evil.json",
                       "\u202e.json",
                       "\xed\xa0\x80",
                       std::string(4000, '#')};
  std::string code, build = "cmake_minimum_required(VERSION 3.16)\nset(count 0)\n";
  Compilation compilation = pendulums({"pin"});
  for (const std::string& file : files) {
    compilation.model.file = file;
    for (const EmittedFile& emitted : emit(compilation)) {
      // Text that the banner swallows is missing at the end.
      const bool is_build = emitted.path == "CMakeLists.txt";
      if (!is_build && emitted.path != "model.hpp") continue;
      const std::size_t end = emitted.text.find("\n", emitted.text.find("Made by")) + 1;
      const std::string banner = emitted.text.substr(0, end);
      if (is_build) build += banner + "math(EXPR count \"${count} + 1\")\n";
      if (!is_build) code += banner + fmt::format("inline int after_{}() {{ return 1; }}\n", &file - files.data());
    }
  }
  code += "int main() { return 0";
  for (std::size_t i = 0; i < files.size(); ++i) code += fmt::format(" + after_{}()", i);
  const std::string path = (directory_.path() / "banners").string();
  write(directory_.path(), {"banners.cpp", code + "; }\n"});
  write(directory_.path(), {"banners.cmake", build + "message(\"counted ${count}\")\n"});
  const Finished compiled = run(compile_command(GetParam()) + " -o " + path + " " + path + ".cpp");
  ASSERT_EQ(compiled.code, 0) << compiled.text.substr(0, 2000);
  EXPECT_EQ(WEXITSTATUS(run(path).code), static_cast<int>(files.size()));
  EXPECT_EQ(run("cmake -P " + path + ".cmake").text, fmt::format("counted {}\n", files.size()));
}

INSTANTIATE_TEST_SUITE_P(Compilers, Hostile,
                         testing::Values(Compiler{"g++", CompilerFamily::gnu},
                                         Compiler{"clang++", CompilerFamily::clang}),
                         [](const auto& info) { return info.param.family == CompilerFamily::gnu ? "gnu" : "clang"; });

}  // namespace
}  // namespace mbgen::test
