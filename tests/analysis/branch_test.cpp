// Rank belongs to the branch of the reference, and statically determinate structures are models like others.

#include <map>

#include "compiler/analysis/notes.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr const char* kRefused = "tests/data/refused/";

Mechanism refused(const std::string& name) { return load(kRefused + name + ".json"); }

std::string notes_of(const Mechanism& m) {
  std::string text;
  for (const Diagnostic& note : analysis_notes(m.model, m.topology, m.analysis))
    text += note.where.pointer + ": " + note.message + " (" + note.hint + ")\n";
  return text;
}

int ranks_above(const BlockAnalysis& block) {
  int above = 0;
  for (const RankCount& seen : block.certificate.ranks) above += seen.rank > block.rank ? seen.configurations : 0;
  return above;
}

/// Freedoms by geometry: a table on equal parallel eccentrics, a delta robot, a line-symmetric chain of six pins.
TEST(Branch, SpecialGeometryMovesAlthoughOtherAssemblyModesAreRigid) {
  for (const auto& [name, freedoms] : std::map<std::string, int>{{"shaker", 1}, {"deltaR", 3}, {"bricard", 1}}) {
    const Mechanism m = refused(name);
    const BlockAnalysis& block = m.analysis.blocks[0];
    EXPECT_EQ(m.analysis.degrees_of_freedom, freedoms) << name;
    EXPECT_EQ(static_cast<int>(block.independent.size()), freedoms) << name;
    EXPECT_TRUE(block.certificate.immobile.empty()) << name;
    EXPECT_GT(ranks_above(block), 0) << name;
    EXPECT_GE(block.certificate.steps, 10) << name;
    for (const RedundantEquation& equation : block.certificate.redundant) EXPECT_LT(equation.residual, 1e-10) << name;
    EXPECT_NE(notes_of(m).find("other assembly modes"), std::string::npos) << notes_of(m);
  }
}

TEST(Branch, AReferenceWithTheRankOfAllModesIsNotWalked) {
  const Mechanism m = load("models/four_bar.json");
  EXPECT_EQ(ranks_above(m.analysis.blocks[0]), 0);
  EXPECT_EQ(notes_of(m), "");
}

TEST(Structure, IsAcceptedWithANoteOfWhatItLocks) {
  EXPECT_EQ(notes_of(refused("arm_on_ball")),
            "/joints/hand: loop \"hand\" holds coordinates waist, shoulder, elbow in place (a structure is solved like "
            "anything else; a mechanism needs joints with more freedoms)\n");
  for (const auto& [name, freedoms] : std::map<std::string, int>{{"m4", 2},
                                                                 {"m7", 2},
                                                                 {"k0_s20261127", 1},
                                                                 {"k0_s20261140", 1},
                                                                 {"k0_s20261160", 2},
                                                                 {"k0_s20261175", 2},
                                                                 {"k0_s20261198", 3},
                                                                 {"k1_s31030", 1}}) {
    const Mechanism m = refused(name);
    EXPECT_EQ(m.analysis.degrees_of_freedom, freedoms) << name;
    EXPECT_NE(notes_of(m).find("in place"), std::string::npos) << name << notes_of(m);
  }
}

/// The axis that was hardly meant to lock its loop is named.
TEST(Structure, NamesTheAxisThatLocksIt) {
  const std::string notes = notes_of(refused("tilted_axis_with_a_ball"));
  EXPECT_NE(notes.find("the axis of joint \"lever_pin\" is 5.71 deg off"), std::string::npos) << notes;
}

/// In their plane these are statically determinate, and hardly: 2 mm of height, 1 mm of unequal length.
TEST(Structure, SaysThatItIsBarelyHeld) {
  for (const char* name : {"flat_truss", "cranks_of_unequal_length", "unequal_cranks_in_a_block"}) {
    const std::string notes = notes_of(refused(name));
    EXPECT_NE(notes.find("in place, barely (smallest singular value "), std::string::npos) << name << notes;
  }
}

}  // namespace
}  // namespace mbgen
