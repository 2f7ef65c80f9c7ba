// Sets of tyres and .tir files that are allowed and likely not meant, each with its note; and formats of files.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "compiler/reader/read_model.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

const std::string kHead = R"({ "mbgen": 1, "bodies": { "ground": { "points": { "c": [0, 0, 0.3] } },
    "wheel": { "mass": 20, "inertia": [1, 1, 1], "points": { "c": [0, 0, 0.3] } } },
  "joints": { "wheel": { "type": "free", "from": "ground.c", "to": "wheel.c" } }, )";

/// "message (hint)" of every note; of problems where the model is none.
std::vector<std::string> notes_of(const Result<Model>& model) {
  std::vector<std::string> texts;
  if (!model) return {to_text(model.problems())};
  for (const Diagnostic& note : model->notes)
    texts.push_back(note.message + (note.hint.empty() ? "" : " (" + note.hint + ")"));
  return texts;
}

/// Of two tyres of one set.
std::vector<std::string> of_set(const std::string& kind, const std::string& coefficients,
                                const std::string& fields = "") {
  const std::string tyre = R"({ "centre": "wheel.c", "data": "set", "stiffness": 2e5)" + fields + " }";
  return notes_of(read_model(kHead + R"("tyre_data": { "set": { "model": ")" + kind + R"(", "coefficients": )" +
                                 coefficients + R"( } }, "tyres": { "a": )" + tyre + R"(, "b": )" + tyre + " } }",
                             "test.json"));
}

std::string coefficients(const std::string& more) {
  return R"({ "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000, "NOMPRES": 2e5, )" + more + " }";
}
std::string pac2002(const std::string& more) { return R"({ "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000, )" + more + " }"; }

const std::string kX = R"("PCX1": 1.6, "PDX1": 1, "PKX1": 20)",
                  kY = R"("PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5)";
const std::string kCombined = R"("RBX1": 12, "RCX1": 1.1, "RBY1": 8, "RCY1": 1.1)";
using List = std::vector<std::string>;

TEST(TyreNotes, ASetThatHasItAllHasNone) {
  EXPECT_EQ(of_set("pac2002", pac2002(kX + "," + kY + "," + kCombined)), List());
  EXPECT_EQ(of_set("mf61", coefficients(kX + "," + kY + "," + kCombined)), List());
  EXPECT_EQ(of_set("pac2002", pac2002(kX + "," + kY), R"(, "combined_slip": "ellipse")"), List());
}

TEST(TyreNotes, NoForce) {
  const List none = {
      "the set has no longitudinal force at its nominal load (PCX1, PDX1, PKX1 are 0) (the tyre neither drives nor "
      "brakes)",
      "the set has no lateral force at its nominal load (PCY1, PDY1, PKY1, PKY2 are 0) (the tyre holds no course)"};
  EXPECT_EQ(of_set("pac2002", R"({ "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000 })"), none) << "once for two tyres";
  EXPECT_EQ(
      of_set("pac2002", pac2002(R"("PCX1": 1.6, "PDX1": 1, )" + kY)),
      List{"the set has no longitudinal force at its nominal load (PKX1 is 0) (the tyre neither drives nor brakes)"});
  const std::string without_friction = R"("PCY1": 1.3, "PKY1": -15, "PKY2": 1.5, )" + kX;
  const List no_friction = {"the set has no lateral force at its nominal load (PDY1 is 0) (the tyre holds no course)"};
  EXPECT_EQ(of_set("pac2002", pac2002(without_friction)), no_friction);
  EXPECT_EQ(of_set("mf61", coefficients(without_friction)), no_friction);
}

TEST(TyreNotes, SlipThatPushesTheWrongWay) {
  const std::string wrong_y = R"("PCY1": 1.3, "PDY1": 1, "PKY1": 15, "PKY2": 1.5, )" + kX + "," + kCombined;
  const List notes = {
      "cornering stiffness at the nominal load is -55385 N/rad: slip pushes the wrong way and brings energy (PKY1 is "
      "below 0, with y to the left)"};
  EXPECT_EQ(of_set("pac2002", pac2002(wrong_y)), notes);
  EXPECT_EQ(of_set("mf61", coefficients(wrong_y)), notes) << "PKY4 is 2";
  EXPECT_EQ(of_set("pac2002", pac2002(R"("PCX1": 1.6, "PDX1": 1, "PKX1": -20, )" + kY + "," + kCombined)),
            List{"longitudinal slip stiffness at the nominal load is -80000 N: slip pushes the wrong way and brings "
                 "energy (PKX1 is above 0)"});
  EXPECT_EQ(of_set("pac2002", pac2002(R"("PCX1": 1.6, "PDX1": -1, "PKX1": 20, )" + kY + "," + kCombined)),
            List{"longitudinal friction at the nominal load is -1, below 0"});
}

TEST(TyreNotes, PureSlipOnly) {
  const std::string rest =
      ": forces along and across together go beyond friction (\"combined_slip\": \"ellipse\" of the "
      "tyre shares friction between them)";
  EXPECT_EQ(of_set("pac2002", pac2002(kX + "," + kY)),
            List{"the set has coefficients of pure slip only (RBX1, RCX1, RBY1, RCY1 are 0)" + rest});
  EXPECT_EQ(of_set("mf61", coefficients(kX + "," + kY + R"(, "RBX1": 12, "RCX1": 1.1, "RBY1": 8)")),
            List{"the set has coefficients of pure slip only (RCY1 is 0)" + rest});
}

class TyreFiles : public ModelFiles {
 protected:
  List of_file(const std::string& tir, const std::string& fields = "") {
    write("tyre.tir", tir);
    write("wheel.json", kHead + R"("tyres": { "tyre": { "centre": "wheel.c", "tir": "tyre.tir")" + fields + " } } }");
    const Result<Model> model = read_model_file((directory_ / "wheel.json").string());
    if (model && !model->tyres.empty()) kind = model->tyres[0].model;
    return notes_of(model);
  }
  TyreModel kind = TyreModel::pac89;
};

const std::string kFile =
    "PCX1 = 1.6\nPDX1 = 1\nPKX1 = 20\nPCY1 = 1.3\nPDY1 = 1\nPKY1 = -15\nPKY2 = 1.5\nRBX1 = 12\nRCX1 = 1.1\nRBY1 = 8\n"
    "RCY1 = 1.1\n";
const std::string kSizes = "UNLOADED_RADIUS = 0.3\nFNOMIN = 4000\nVERTICAL_STIFFNESS = 2e5\n";

TEST_F(TyreFiles, FormatsAndTheirVersions) {
  const auto file = [&](const std::string& model) { return of_file(model + kFile + kSizes + "NOMPRES = 2e5\n"); };
  EXPECT_EQ(file("FITTYP = 52\n"), List());
  EXPECT_EQ(kind, TyreModel::pac2002);
  EXPECT_EQ(file("PROPERTY_FILE_FORMAT = 'MF-TYRE'\nFITTYP = 52\n"), List());
  EXPECT_EQ(kind, TyreModel::pac2002);
  for (const char* word : {"MF61", "MF62"}) {
    EXPECT_EQ(file("PROPERTY_FILE_FORMAT = '" + std::string(word) + "'\n"), List());
    EXPECT_EQ(kind, TyreModel::mf61);
  }
  EXPECT_EQ(file("PROPERTY_FILE_FORMAT = 'MF61'\nFITTYP = 62\n"), List());
  EXPECT_EQ(file("PROPERTY_FILE_FORMAT = 'PAC2002'\nFITTYP = 61\n"),
            List{"FITTYP 61 is followed, PROPERTY_FILE_FORMAT \"PAC2002\" says otherwise"});
  EXPECT_EQ(kind, TyreModel::mf61);
}

TEST_F(TyreFiles, NumbersThatAreNotInTheUnitsOfTheFile) {
  const std::string model = "PROPERTY_FILE_FORMAT = 'PAC2002'\n",
                    hint = " (is the number in the unit that [UNITS] says?)";
  EXPECT_EQ(of_file(model + "LENGTH = 'mm'\n" + kFile + kSizes),
            (List{"UNLOADED_RADIUS = 0.3 is 0.0003 m with LENGTH = 'mm', tyres have 0.02 to 3 m" + hint}));
  EXPECT_EQ(
      of_file(model + kFile + "UNLOADED_RADIUS = 300\nFNOMIN = 4000\nVERTICAL_STIFFNESS = 200\n"),
      (List{"UNLOADED_RADIUS = 300 is 300 m without LENGTH in [UNITS], that is in m, tyres have 0.02 to 3 m" + hint}));
  EXPECT_EQ(
      of_file(model + "LENGTH = 'meter'\n" + kFile +
              "UNLOADED_RADIUS = 0.3\nFNOMIN = 4000\nVERTICAL_STIFFNESS = 200\n"),
      (List{"VERTICAL_STIFFNESS = 200 is 200 N/m with LENGTH = 'meter': FNOMIN presses the tyre by 20 m, 66.7 of its "
            "radius" +
            hint}));
  EXPECT_EQ(
      of_file(model + "LENGTH = 'mm'\n" + kFile + "UNLOADED_RADIUS = 300\nFNOMIN = 4000\nVERTICAL_STIFFNESS = 200\n"),
      List());
}

TEST_F(TyreFiles, NotesOfTheSetStandAtTheFile) {
  write("tyre.tir", "PROPERTY_FILE_FORMAT = 'PAC2002'\n" + kSizes);
  write("wheel.json", kHead + R"("tyres": { "tyre": { "centre": "wheel.c", "tir": "tyre.tir" } } })");
  const Model model = read_file((directory_ / "wheel.json").string());
  ASSERT_EQ(model.notes.size(), 2u);
  EXPECT_EQ(std::filesystem::path(model.notes[0].where.file).filename(), "tyre.tir");
  EXPECT_EQ(model.notes[0].where.line, 3);
}

}  // namespace
}  // namespace mbgen
