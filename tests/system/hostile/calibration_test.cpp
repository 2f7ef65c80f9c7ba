// Calibration files of models whose names and units are those of the format itself, or break out of its strings.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compiler/compile.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/a2l_grammar.hpp"

namespace mbgen::test {
namespace {

using CalibrationJson = nlohmann::ordered_json;

/// A pendulum with a parameter, an input and an output of this name and unit.
Compilation named_pendulum(const std::string& name, const std::string& unit, const std::string& model_name) {
  const CalibrationJson origin = CalibrationJson::parse(R"({ "O": [0, 0, 0] })");
  CalibrationJson model = {{"mbgen", 1}, {"bodies", {{"ground", {{"points", origin}}}}}};
  model["bodies"]["bob"] = {{"mass", 1}, {"com", {1, 0, 0}}, {"inertia", {1, 1, 1}}, {"points", origin}};
  model["joints"][name] = {{"type", "revolute"}, {"from", "ground.O"}, {"to", "bob.O"}, {"axis", "y"}};
  model["outputs"][name] = {{"unit", unit}, {"expression", "t"}};
  model["parameters"][name] = {{"value", 1}, {"unit", unit}, {"tunable", true}};
  model["inputs"]["push"] = {{"unit", unit}};
  model["joint_forces"]["torque"] = {{"joint", name}, {"force", name + " + push"}};
  Result<Model> result = read_model(model.dump(), "model.json");
  if (!result) throw std::runtime_error(to_text(result.problems()));
  result->name = model_name;
  return *compile(*result);
}

std::string calibration_of(const Compilation& compilation) {
  const InitialState start{{0}, {0}, {}};
  for (const EmittedFile& file :
       emit(compilation, {.runtime_headers = false, .initial = start, .c_interface = true, .calibration = true})) {
    if (file.path.ends_with(".a2l")) return file.text;
  }
  throw std::runtime_error("no calibration file");
}

/// The unit that a measurement or characteristic is shown with.
std::string unit_of(const A2lItem& module, const A2lItem& item, int place) {
  if (item.arguments.at(place) == "NO_COMPU_METHOD") return "";
  for (const A2lItem* method : module.all("COMPU_METHOD")) {
    if (method->arguments[0] == item.arguments[place]) return method->arguments[4];
  }
  throw std::runtime_error("no unit of " + item.arguments[0]);
}

TEST(HostileCalibration, wordsOfTheFormatNameWhatTheyLike) {
  for (const char* name : {"PROJECT", "MODULE", "VALUE", "SYMBOL_LINK", "ROOT", "GROUP", "begin", "end", "class", "i",
                           "NO_COMPU_METHOD", "_", "a__b"}) {
    SCOPED_TRACE(name);
    const A2lItem module = read_a2l(calibration_of(named_pendulum(name, "m", name)));
    EXPECT_EQ(module.all("CHARACTERISTIC").size(), 1u);
    // push; the output and three energies; angle, rate, time.
    EXPECT_EQ(module.all("MEASUREMENT").size(), 1u + 4u + 3u);
    EXPECT_EQ(module.child("CHARACTERISTIC").arguments[1], name);
  }
}

TEST(HostileCalibration, unitsComeThroughAndStayInTheirStrings) {
  const std::vector<std::string> units = {"",          "1",          "N/m",       "N m",      "\"",
                                          "\\",        "a\"b\\c",    "/* m */",   "/begin X", "\" /end MODULE \"",
                                          "m\u00b2/s", "{{solver}}", "%s ${x} {}"};
  for (const std::string& unit : units) {
    SCOPED_TRACE(unit);
    const std::string text = calibration_of(named_pendulum("k", unit, "model"));
    const A2lItem module = read_a2l(text);
    const std::string shown = unit_of(module, module.child("CHARACTERISTIC"), 6);
    EXPECT_EQ(shown.substr(0, unit.size()), unit);
    EXPECT_LE(shown.size(), unit.size() + 1);  // comments end a final backslash with a full stop
    EXPECT_EQ(unit_of(module, *module.all("MEASUREMENT").front(), 3), shown);
  }
}

TEST(HostileCalibration, textsAreOnOneLineAndOfBoundedLength) {
  const std::string longest(256, 'u'), character = "\u65e5";
  const std::pair<std::string, std::string> units[] = {{"a\nb\r\tc\x01", "a b  c "},
                                                       {longest, longest.substr(0, 255)},
                                                       {longest.substr(0, 253) + character, longest.substr(0, 253)}};
  for (const auto& [unit, shown] : units) {
    const A2lItem module = read_a2l(calibration_of(named_pendulum("k", unit, "\xff\xfe\n\"/end PROJECT")));
    EXPECT_EQ(unit_of(module, module.child("CHARACTERISTIC"), 6), shown);
    EXPECT_EQ(module.arguments[1], "   \"/end PROJECT");
  }
  read_a2l(calibration_of(named_pendulum("k", "m", std::string(200, 'm'))));
}

TEST(HostileCalibration, theReaderRefusesWhatIsWrong) {
  const std::string text = calibration_of(named_pendulum("k", "N m", "model"));
  EXPECT_NO_THROW(read_a2l(text));
  const std::pair<const char*, const char*> damages[] = {{"ASAP2_VERSION 1 60", "ASAP2_VERSION 1"},
                                                         {"/end MEASUREMENT", "/end CHARACTERISTIC"},
                                                         {"/end PROJECT", ""},
                                                         {"FLOAT64_IEEE model.unit", "FLOAT64 model.unit"},
                                                         {"MEASUREMENT model.inputs.push", "MEASUREMENT model..push"},
                                                         {"        model.inputs.push\n", ""},
                                                         {"        model.z.k\n", "        model.z.l\n"},
                                                         {"COMPU_METHOD model.unit.N_m", "COMPU_METHOD model.unit.N"},
                                                         {"SYMBOL_LINK \"model_a2l_inputs\"", "SYMBOL_LINK"},
                                                         {"VALUE 0x0", "VALUE 0q0"},
                                                         {"\"%16.9\"", "\"16\""},
                                                         {"\"k\"", "\"k"}};
  for (const auto& [whole, broken] : damages) {
    std::string damaged = text;
    const std::size_t at = damaged.find(whole);
    ASSERT_NE(at, std::string::npos) << whole;
    for (std::size_t next = at; next != std::string::npos; next = damaged.find(whole, next + 1)) {
      damaged.replace(next, std::string(whole).size(), broken);
      if (std::string(broken).find(whole) != std::string::npos || std::string(whole).find("        ") != 0) break;
    }
    EXPECT_THROW(read_a2l(damaged), std::runtime_error) << whole;
  }
}

}  // namespace
}  // namespace mbgen::test
