// Tyre files: the sets of the reference data written as .tir give the reference forces.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/model/tyres.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

class TirFile : public testing::TestWithParam<const char*> {
 protected:
  TirFile() : directory_(std::filesystem::temp_directory_path() / ("mbgen_tir_test_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(directory_);
  }
  ~TirFile() override { std::filesystem::remove_all(directory_); }

  /// A wheel whose tyre is of the file.
  Result<Model> wheel(const std::string& tir, const std::string& fields) {
    std::ofstream(directory_ / "tyre.tir", std::ios::binary) << tir;
    return read_model(R"({ "mbgen": 1, "bodies": { "ground": { "points": { "c": [0, 0, 0.5] } },
        "wheel": { "mass": 1, "inertia": [1, 1, 1], "points": { "c": [0, 0, 0.5] } } },
      "joints": { "wheel": { "type": "free", "from": "ground.c", "to": "wheel.c" } },
      "tyres": { "tyre": { "centre": "wheel.c", "tir": "tyre.tir")" +
                          fields + "} } }",
                      (directory_ / "wheel.json").string());
  }

  std::filesystem::path directory_;
};

/// A file in the manner of Adams, in millimetres.
std::string tir_of(const nlohmann::json& parameters) {
  std::string text =
      "[MDI_HEADER]\r\nFILE_TYPE = 'tir'\r\n$ a comment = 1\r\n[UNITS]\r\nLENGTH = 'mm'\r\nFORCE  ='newton' $ unit\r\n"
      "ANGLE = 'radians'\r\n[MODEL]\r\nPROPERTY_FILE_FORMAT = 'PAC2002'\r\nTYRESIDE = 'LEFT'\r\n"
      "[SHAPE]\r\n{radial width}\r\n1.0 0.5\r\n[VERTICAL]\r\nvertical_stiffness = 1.0e3 ! N/mm\r\nVERTICAL_DAMPING = "
      "5\r\n"
      "QSY1 = 8D-3\r\nPTX1 = 1.5\r\nPTY1 = 1.2\r\nPTY2 = 2.5\r\nPPX1 = 0\r\n";
  for (const auto& [name, value] : parameters.items()) {
    const double number = value.get<double>() * (name == "UNLOADED_RADIUS" ? 1000 : 1);
    text += fmt::format("{:<18}= {}   $ {}\r\n", name, number, name);
  }
  return text;
}

TEST_P(TirFile, GivesTheReferenceForces) {
  const auto data = nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/tyre_magic_formula.json"));
  const nlohmann::json& set = data[GetParam()];
  const Result<Model> model = wheel(tir_of(set["parameters"]), "");
  ASSERT_TRUE(model) << to_text(model.problems());
  std::vector<double> values;
  for (const Quantity& coefficient : model->tyres[0].coefficients) values.push_back(coefficient.value);
  const auto pac2002 = Pac2002<double>::from_fields(values.data());
  double error[3] = {}, scale[3] = {};
  for (const std::vector<double> row : set["rows"]) {
    const TyreForces<double> forces = magic_formula_pac2002(pac2002, row[0], row[1], row[2], row[3]);
    const double computed[3] = {forces.fx, forces.fy, forces.mz};
    for (std::size_t i = 0; i < 3; ++i) {
      error[i] = std::max(error[i], std::abs(computed[i] - row[7 + i]));
      scale[i] = std::max(scale[i], std::abs(row[7 + i]));
    }
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(error[i], 1e-11 * scale[i]);  // rounding of the reference values
}

INSTANTIATE_TEST_SUITE_P(Sets, TirFile,
                         testing::Values("citybus_315_80_R22.5", "feda_335_65_R22.5_95psi", "mfeval_MF52_sample"),
                         [](const auto& set) { return std::string(set.param).substr(0, 4); });

TEST_F(TirFile, GivesWhatTheModelDoesNot) {
  const nlohmann::json least = {{"UNLOADED_RADIUS", 0.5}, {"FNOMIN", 4000}};
  const Result<Model> with_length = wheel(tir_of(least), R"(, "relaxation_x": 0.4)");
  ASSERT_TRUE(with_length) << to_text(with_length.problems());
  EXPECT_DOUBLE_EQ(with_length->tyres[0].relaxation_x.value, 0.4);
  EXPECT_FALSE(with_length->tyres[0].over_load_x) << "a length of the model stays as it is";
  EXPECT_TRUE(with_length->tyres[0].over_load_y);
  const Result<Model> model = wheel(tir_of(least), R"(, "damping": 70)");
  ASSERT_TRUE(model) << to_text(model.problems());
  const Tyre& tyre = model->tyres[0];
  EXPECT_DOUBLE_EQ(tyre.radius.value, 0.5);
  EXPECT_DOUBLE_EQ(tyre.stiffness.value, 1e6);
  EXPECT_DOUBLE_EQ(tyre.damping.value, 70);
  EXPECT_DOUBLE_EQ(tyre.rolling_resistance.value, 0.008);
  EXPECT_DOUBLE_EQ(tyre.relaxation_x.value, 0.75);
  EXPECT_NEAR(tyre.relaxation_y.value, 0.5 * 1.2 * std::sin(2 * std::atan(1 / 2.5)), 1e-15);
}

/// The reference set of MF 6.1 as a file, lengths in mm.
std::string tir61_of(const nlohmann::json& parameters) {
  std::string text =
      "[UNITS]\nLENGTH = 'mm'\n[MODEL]\nPROPERTY_FILE_FORMAT = 'USER'\nFITTYP = 61\n[OPERATING_CONDITIONS]\n"
      "INFLPRES = 0.25\n[VERTICAL]\nVERTICAL_STIFFNESS = 210\nLCZ = 1.1\nVERTICAL_DAMPING = 0.05\n"
      "[STRUCTURAL]\nLONGITUDINAL_STIFFNESS = 358.066\nLATERAL_STIFFNESS = 102\nPCFX1 = 0.2\n"
      "[TURNSLIP_COEFFICIENTS]\nPECP1 = 0.5\nQ_FCX = 0.1\n";
  for (const auto& [name, value] : parameters.items()) {
    const double mm = name == "UNLOADED_RADIUS" || name == "LONGVL" ? 1e3 : name == "NOMPRES" ? 1e-6 : 1;
    text += fmt::format("{} = {}\n", name, value.get<double>() * mm);
  }
  return text;
}

TEST_F(TirFile, Of61GivesTheReferenceSetInSi) {
  const auto data = nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/tyre_mf61.json"));
  const Result<Model> model = wheel(tir61_of(data["parameters"]), "");
  ASSERT_TRUE(model) << to_text(model.problems());
  const Tyre& tyre = model->tyres[0];
  ASSERT_EQ(tyre.model, TyreModel::mf61);
  std::vector<double> values;
  for (const Quantity& coefficient : tyre.coefficients) values.push_back(coefficient.value);
  for (std::size_t i = 0; i < kMf61Count; ++i) {
    const std::string_view name = kMf61Fields[i].name;
    if (name.ends_with("_STIFFNESS") || name == "PCFX1") continue;  // of the file alone
    const double expected = data["parameters"].value(kMf61Fields[i].name, kMf61Fields[i].default_value);
    EXPECT_NEAR(values[i], expected, 1e-15 * std::abs(expected)) << kMf61Fields[i].name;
  }
  EXPECT_DOUBLE_EQ(tyre.radius.value, 0.317);
  EXPECT_DOUBLE_EQ(tyre.stiffness.value, 1.1 * 210e3);
  EXPECT_DOUBLE_EQ(tyre.damping.value, 50);
  EXPECT_DOUBLE_EQ(tyre.pressure.value, 250e3);
  EXPECT_DOUBLE_EQ(tyre.rolling_resistance.value, 0.01);
  // Slip stiffness at nominal load over the stiffness of the carcass: Fz0 (PKX1) LKX over 358 N/mm;
  // PKY1 Fz0 sin(PKY4 atan(1 / PKY2)) LKY over 102 N/mm.
  EXPECT_NEAR(tyre.relaxation_x.value, 4100 * 23.5 * 1.01 / 358066, 1e-9);
  EXPECT_NEAR(tyre.relaxation_y.value, 20.3 * 4100 * std::sin(2.02 * std::atan(1 / 1.62)) * 1.03 / 102e3, 1e-9);
  EXPECT_TRUE(tyre.over_load_x && tyre.over_load_y);
  ASSERT_EQ(model->notes.size(), 1u);
  EXPECT_EQ(model->notes[0].message,
            "the model does not use turn slip (PECP1); radius and stiffness over load and speed (Q_FCX)");
}

TEST_F(TirFile, TurnSlipActsWhereTheModelOrUseModeAsksForIt) {
  nlohmann::json set =
      nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/tyre_mf61.json"))["parameters"];
  set.update(
      nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/tyre_mf61_turn_slip.json"))["parameters"]);
  set.erase("PECP1");  // in tir61_of already, as 0.5
  const auto turning = [&](double mode, const std::string& fields, double yaw = 0) {
    set["USE_MODE"] = mode;
    set["YAW_STIFFNESS"] = yaw;
    return wheel(tir61_of(set), fields);
  };
  for (const auto& [mode, fields, acts] : {std::tuple(125, "", true),
                                           {25, "", true},
                                           {124, "", false},
                                           {124, R"(, "turn_slip": true)", true},
                                           {5, R"(, "turn_slip": false)", false}}) {
    const Result<Model> model = turning(mode, fields);
    ASSERT_TRUE(model) << to_text(model.problems());
    const Tyre& tyre = model->tyres[0];
    EXPECT_EQ(tyre.turn_slip, acts) << mode << fields;
    EXPECT_EQ(tyre.parking.has_value(), acts);
    EXPECT_EQ(tyre.coefficients[tyre_field_index(kMf61Fields, "PDXP1")].value, acts ? 0.4 : 0);
    EXPECT_EQ(model->notes[0].message.find("turn slip (") == std::string::npos, acts) << model->notes[0].message;
  }
  const TyrePatch soft = *turning(125, "", 4e6)->tyres[0].parking, own = *turning(125, "")->tyres[0].parking;
  EXPECT_DOUBLE_EQ(own.radius.value, 0.2 * 0.317 * 1.05);
  EXPECT_DOUBLE_EQ(own.load.value, 4100);
  // Slopes at nominal load of the moment over alpha (t Ky) and over spin (K_zgammar0 R0 / (1 - eps)), the latter over
  // half the patch; Q_DZ2 and others of df_z are nothing there.
  const double cornering = 20.3 * 4100 * std::sin(2.02 * std::atan(1 / 1.62)) * 1.03, trail = 0.097 * 0.317 * 1.02;
  const double of_spin = 4100 * 0.317 * 0.11 * 0.95 * 0.317 / (1 - 0.5);
  const double patch = cornering * trail + of_spin / std::sqrt(0.317 * 4100 / 231e3);
  EXPECT_NEAR(own.stiffness.value, patch, 1e-9 * patch);
  EXPECT_NEAR(1 / soft.stiffness.value, 1 / patch + 1 / 4e3, 1e-12) << "4e6 N mm in series";
  const TyrePatch given = *turning(125, R"(, "parking": { "stiffness": 1234, "load": 3000 })")->tyres[0].parking;
  EXPECT_EQ(given.stiffness.value, 1234);
  EXPECT_EQ(given.load.value, 3000);
  EXPECT_EQ(given.radius.value, own.radius.value);
  set.erase("QDRP1");
  const Result<Model> without = turning(125, "");
  ASSERT_TRUE(without) << to_text(without.problems());
  EXPECT_FALSE(without->tyres[0].turn_slip);
  EXPECT_EQ(without->notes.back().message, "turn slip, for which USE_MODE asks, is not in the file");
  EXPECT_FALSE(turning(125, R"(, "turn_slip": true)"));
}

TEST_F(TirFile, GivesTheCamsOfAnEnvelope) {
  nlohmann::json cams = {{"UNLOADED_RADIUS", 0.5}, {"FNOMIN", 4000},     {"ELLIPS_SHIFT", 0.8},
                         {"ELLIPS_LENGTH", 1.1},   {"Q_RA1", 0.7},       {"ELLIPS_HEIGHT", 1.05},
                         {"Q_RA2", 0.6},           {"ELLIPS_ORDER", 1.7}};
  cams.update({{"PCX1", 1.6}, {"PDX1", 1}, {"PKX1", 20}, {"PCY1", 1.3}, {"PDY1", 1}, {"PKY1", -15}, {"PKY2", 1.5}});
  cams.update({{"RBX1", 12}, {"RCX1", 1.1}, {"RBY1", 8}, {"RCY1", 1.1}});
  const Result<Model> model = wheel(tir_of(cams), R"(, "enveloping": { "height": 0.9 })");
  ASSERT_TRUE(model) << to_text(model.problems());
  const TyreEnvelope& envelope = *model->tyres[0].envelope;
  const double deflection = 4000 / (1e6 * 0.5);  // over the radius
  EXPECT_DOUBLE_EQ(envelope.base, 0.8 * 2 * (0.6 * deflection + 0.7 * std::sqrt(deflection)));
  EXPECT_DOUBLE_EQ(envelope.length, 1.1);
  EXPECT_DOUBLE_EQ(envelope.height, 0.9) << "the model's own";
  EXPECT_DOUBLE_EQ(envelope.order, 1.7);
  ASSERT_EQ(model->notes.size(), 1u);
  EXPECT_EQ(model->notes[0].message, "the model does not use tables (SHAPE)");
  const Result<Model> point = wheel(tir_of(cams), "");
  ASSERT_TRUE(point) << to_text(point.problems());
  EXPECT_FALSE(point->tyres[0].envelope);
  EXPECT_NE(point->notes[0].message.find("contact patch (ELLIPS_HEIGHT, ELLIPS_LENGTH"), std::string::npos);
  cams["ELLIPS_ORDER"] = -1;
  const Result<Model> bad = wheel(tir_of(cams), R"(, "enveloping": {})");
  ASSERT_FALSE(bad);
  EXPECT_NE(to_text(bad.problems()).find("key ELLIPS_ORDER must be positive"), std::string::npos);
}

TEST_F(TirFile, Of61TakesStiffnessFromItsPolynomial) {
  const Result<Model> model =
      wheel("FITTYP = 62\nUNLOADED_RADIUS = 0.3\nFNOMIN = 4000\nNOMPRES = 2e5\nQ_FZ1 = 12\nQ_FZ2 = 16\n", "");
  ASSERT_TRUE(model) << to_text(model.problems());
  EXPECT_DOUBLE_EQ(model->tyres[0].stiffness.value, 4000 / 0.3 * std::sqrt(144 + 4 * 16));
  EXPECT_DOUBLE_EQ(model->tyres[0].pressure.value, 2e5);
}

const std::string kLeastTir =
    "UNLOADED_RADIUS = 0.5\nFNOMIN = 4000\nVERTICAL_STIFFNESS = 2e5\nPCX1 = 1.6\nPDX1 = 1.1\nPKX1 = 20\nPCY1 = 1.3\n"
    "PDY1 = 1\nPKY1 = -15\nPKY2 = 1.5\nRBX1 = 12\nRCX1 = 1.1\nRBY1 = 8\nRCY1 = 1.1\n";

TEST_F(TirFile, NotesOnceWhatTheModelDoesNotUse) {
  const Result<Model> model = wheel(
      "[MDI_HEADER]\nOWNER = 'me'\n[UNITS]\nLENGTH = 'meter'\nMASS = 'kg'\n[MODEL]\nPROPERTY_FILE_FORMAT = 'PAC2002'\n"
      "USE_MODE = 14\n[DIMENSION]\nWIDTH = 0.3\n[LONG_SLIP_RANGE]\nKPUMAX = 1\n[VERTICAL]\n" +
          kLeastTir +
          "[LATERAL]\nPTY1 = 1\nPTY3 = 0\nLSGAL = 1\nLIP = 1\n  PPY1 = 0.4\nPPX2 = -1E-1\nPKY11 = 0\n"
          "[TURNSLIP_COEFFICIENTS]\nPECP1 = 0.7\nPECP2 = 0.0\n[SHAPE]\n{radial width}\n1.0 0.5\n0.9 1.0\n",
      R"(}, "again": { "centre": "wheel.c", "tir": "tyre.tir")");
  ASSERT_TRUE(model) << to_text(model.problems());
  ASSERT_EQ(model->notes.size(), 1u);
  const Diagnostic& note = model->notes[0];
  EXPECT_EQ(note.hint, "PKY11: did you mean \"PKY1\"?");
  EXPECT_EQ(note.message,
            "the model does not use turn slip (PECP1); inflation pressure (PPX2, PPY1); unknown names (PKY11); "
            "tables (SHAPE)");
  EXPECT_EQ(std::filesystem::path(note.where.file).filename(), "tyre.tir");
  EXPECT_EQ(note.where.line, 33);
  EXPECT_EQ(note.where.column, 3);
}

TEST_F(TirFile, NotesNothingOfAFileThatIsUsedAsAWhole) {
  const Result<Model> model = wheel("PROPERTY_FILE_FORMAT = 'PAC2002'\nANGLE = 'rad'\nQSY1 = 0.01\n" + kLeastTir, "");
  ASSERT_TRUE(model) << to_text(model.problems());
  EXPECT_TRUE(model->notes.empty());
}

TEST_F(TirFile, NotesNoMoreNamesThanOneReads) {
  std::string tir = "PROPERTY_FILE_FORMAT = 'PAC2002'\nbad key\t= 1\n7 = 1\n= 1\n" + kLeastTir;
  for (int i = 1; i <= 30; ++i) tir += fmt::format("PDXP{0} = 1\nODD{0} = 1\n", i);
  const Result<Model> model = wheel(tir, "");
  ASSERT_TRUE(model) << to_text(model.problems());
  ASSERT_EQ(model->notes.size(), 1u);
  const std::string& message = model->notes[0].message;
  EXPECT_NE(message.find("PDXP8, PDXP9); "), std::string::npos) << message;
  EXPECT_NE(message.find("unknown names (\"\", \"7\", \"BAD KEY\", ODD1, "), std::string::npos) << message;
  EXPECT_NE(message.find("ODD17 and 21 more)"), std::string::npos) << message;
  EXPECT_EQ(model->notes[0].where.line, 2);
}

}  // namespace
}  // namespace mbgen
