// OpenCRG files as programs write them: filled records, each format of numbers, v told in several ways. The files are
// our own, tests/data/opencrg/kinds, with heights of (8 section + column) / 64 at every 0.5 m along and 0.25 m across.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "compiler/formats/crg_file.hpp"
#include "compiler/formats/crg_road.hpp"

namespace mbgen {
namespace {

std::string bytes_of(const std::string& file) {
  std::ifstream stream(std::string(MBGEN_SOURCE_DIR) + "/tests/data/opencrg/kinds/" + file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

struct Kind {
  const char* name;
  std::size_t sections, columns;
  double right = -1;  ///< v of the first column
  std::vector<std::string> notes = {};
};

class CrgKind : public ::testing::TestWithParam<Kind> {};

TEST_P(CrgKind, HasTheRightHeights) {
  const Kind& kind = GetParam();
  CrgRoad road;
  const std::optional<CrgProblem> problem = read_crg(bytes_of(std::string(kind.name) + ".crg"), road);
  ASSERT_FALSE(problem) << problem->line << ": " << problem->message;
  ASSERT_EQ(road.sections(), kind.sections);
  ASSERT_EQ(road.v.size(), kind.columns);
  for (std::size_t i = 0; i < kind.sections; ++i)
    for (std::size_t k = 0; k < kind.columns; ++k) {
      const auto section = static_cast<double>(i), column = static_cast<double>(k);
      EXPECT_EQ(height_of(road, {0.5 * section, kind.right + 0.25 * column}), (8 * section + column) / 64)
          << i << " " << k;
    }
  EXPECT_DOUBLE_EQ(road.end(), 0.5 * static_cast<double>(kind.sections - 1));
  std::vector<std::string> notes;
  for (const CrgProblem& note : road.notes) notes.push_back(std::to_string(note.line) + ": " + note.message);
  EXPECT_EQ(notes, kind.notes);
}

const Kind kKinds[] = {
    {"krbi_3_padded", 5, 3},
    {"kdbi_3_padded", 5, 3},
    {"lrfi_3", 5, 3},
    {"ldfi_3", 5, 3},
    {"krbi_7_padded", 4, 7},
    {"kdbi_7_padded", 4, 7},
    {"lrfi_7", 4, 7},
    {"ldfi_7", 4, 7},
    {"krbi_19_padded", 6, 19},
    {"kdbi_19_padded", 6, 19},
    {"lrfi_19", 6, 19},
    {"ldfi_19", 6, 19},
    {"lrfi_3_filled", 5, 3},
    {"krbi_3_without_end", 5, 3},
    {"kdbi_7_without_end", 4, 7},
    {"krbi_7_not_padded", 4, 7},
    {"kdbi_3_phi_slope_banking", 5, 3},
    {"krbi_3_v_by_left", 5, 3},
    {"krbi_3_at_v", 5, 3},
    {"krbi_3_v_from_0",
     5,
     3,
     0,
     {"8: file does not tell where its long sections begin: v is taken from 0 to 0.5, as the C API of ASAM takes it"}},
    {"lrfi_3_odd_numbers",
     5,
     3,
     -1,
     {"5: REFERENCE_LINE_END_U = 2.0+e00 is read as 2, as the C API of ASAM reads it",
      "16: 0.0+e00 is read as 0, as the C API of ASAM reads it"}},
    {"krbi_3_end_before",
     5,
     3,
     -1,
     {"15: REFERENCE_LINE_END_U = 2 asks for 5 sections, file has 7: those beyond are left out"}},
    {"lrfi_3_end_beyond", 5, 3, -1, {"15: REFERENCE_LINE_END_U = 4 asks for 9 sections, file has 5: all are read"}},
};

INSTANTIATE_TEST_SUITE_P(Files, CrgKind, ::testing::ValuesIn(kKinds), [](const auto& info) { return info.param.name; });

// A last section with one height is a gap like any other, no filling.
TEST(CrgKinds, AGapInTheLastSectionIsNoFilling) {
  CrgRoad road;
  ASSERT_FALSE(read_crg(bytes_of("krbi_3_gap_at_the_end.crg"), road));
  ASSERT_EQ(road.sections(), 5u);
  for (const double v : {-1.0, -0.75, -0.5}) EXPECT_EQ(height_of(road, {2, v}), 34.0 / 64);
}

TEST(CrgKinds, DataThatAreCutOffAreRefused) {
  CrgRoad road;
  const std::optional<CrgProblem> problem = read_crg(bytes_of("krbi_3_cut_off.crg"), road);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->line, 15u);
  EXPECT_EQ(problem->message, "data are cut off: REFERENCE_LINE_END_U = 20 asks for 41 sections, file has 5");
}

TEST(CrgKinds, AFileNamesTheOneWithTheData) {
  const std::string naming = bytes_of("by_file.crg"), data = bytes_of("krbi_3_padded.crg");
  EXPECT_EQ(named_crg_file(naming), "krbi_3_padded.crg") << "written in two lines";
  EXPECT_EQ(named_crg_file(data), "");
  const std::string_view texts[] = {naming, data};
  CrgRoad road;
  ASSERT_FALSE(read_crg(texts, road));
  EXPECT_EQ(road.sections(), 5u);
  EXPECT_EQ(road.modifiers, (CrgEntries{{"REFLINE_OFFSET_Z", 2}}));
  // Its modifiers take the place of those of the data, its other blocks stay.
  std::string with_own = data;
  with_own.insert(with_own.find("$KD_DEFINITION"),
                  "$ROAD_CRG_MODS\nSCALE_Z_GRID = 5\n$ROAD_CRG_OPTS\nBORDER_MODE_U = 3\n");
  const std::string_view own[] = {naming, with_own};
  ASSERT_FALSE(read_crg(own, road));
  EXPECT_EQ(road.modifiers, (CrgEntries{{"REFLINE_OFFSET_Z", 2}}));
  EXPECT_EQ(road.options, (CrgEntries{{"BORDER_MODE_U", 3}}));
  EXPECT_EQ(height_of(road, {0.5, -1}), 8.0 / 64);
  const auto problem = [&](const std::string& text) {
    const std::string_view all[] = {naming, text};
    return read_crg(all, road);
  };
  ASSERT_TRUE(problem("$KD_DEFINITION\n"));
  EXPECT_EQ(problem("$KD_DEFINITION\n")->file, 1u);
  EXPECT_EQ(read_crg(naming + "$$$$\n", road)->message,
            "file has data of its own, and names another one that has them");
  EXPECT_EQ(read_crg("$ROAD_CRG_FILE\n/data/$ROADS/a.crg\n", road)->message,
            "file name \"/data/$ROADS/a.crg\" has an environment variable, which mbgen does not read");
}

}  // namespace
}  // namespace mbgen
