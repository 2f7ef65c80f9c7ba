// OpenCRG files: what the ASAM C API answers to them, and files that are none.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compiler/formats/crg_road.hpp"
#include "compiler/formats/crg_unsupported.hpp"

namespace mbgen {
namespace {

std::string bytes_of_road(const std::string& file) {
  std::ifstream stream(std::string(MBGEN_SOURCE_DIR) + "/tests/data/opencrg/" + file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

class CrgFile : public ::testing::TestWithParam<std::string> {};

/// The text of a file with another block before its parameters.
std::string with_block(std::string text, const std::string& block) {
  const std::size_t at = text.find("$ROAD_CRG");
  EXPECT_NE(at, std::string::npos);
  return text.insert(at, block + "$\n");
}

// The API's own modifiers move the right border of the start into the origin where the file tells it, see README.md
// beside the answers; here the file asks for it.
TEST_P(CrgFile, AnswersAsTheApiOfAsam) {
  const std::string text = bytes_of_road(GetParam() + ".crg");
  const bool is_moved = GetParam() != "handmade_curved_minimalist";
  CrgRoad road;
  ASSERT_FALSE(read_crg(
      is_moved ? with_block(text, "$ROAD_CRG_MODS\nREFPOINT_U_FRACTION = 0\nREFPOINT_V_FRACTION = 0\n") : text, road));
  road = relocated(road);
  const nlohmann::json answers = nlohmann::json::parse(bytes_of_road(GetParam() + ".json"));
  int compared = 0;
  for (const nlohmann::json& point : answers.at("points")) {
    const auto near = [&](const char* what, double value) {
      if (point.at(what).is_null()) return;
      ++compared;
      EXPECT_NEAR(value, point.at(what).get<double>(), 1e-9) << what << " at " << point;
    };
    const CrgPlace at{point.at("u"), point.at("v")};
    const PlanePlace place = plane_place(road, at);
    near("x", place.x);
    near("y", place.y);
    near("z", height_of(road, at));
    near("heading", course_of(road, at).heading);
    near("curvature", course_of(road, at).curvature);
    const CrgPlace back = road_place(road, {point.at("x"), point.at("y")});
    near("u_of_xy", back.u);
    near("v_of_xy", back.v);
    near("z_of_xy", height_of(road, back));
  }
  EXPECT_GE(compared, 700);
}

INSTANTIATE_TEST_SUITE_P(Files, CrgFile,
                         ::testing::Values("handmade_arc", "handmade_banked", "handmade_circle", "handmade_curved",
                                           "handmade_curved_minimalist", "handmade_sloped", "handmade_straight",
                                           "handmade_vtest", "belgian_block"),
                         [](const auto& info) { return info.param; });

/// A file of text data with the lines of its blocks and of its data.
std::string file_of(const std::string& parameters, const std::string& columns, const std::string& data) {
  return "$CT\n$ROAD_CRG\n" + parameters + "$KD_Definition\n" + columns + "$$$$\n" + data;
}
const std::string kStep = "REFERENCE_LINE_INCREMENT = 1\n";
const std::string kTwoSections = "#:LRFI\nD:long section at v = -1,m\nD:long section at v = 1,m\n";
const std::string kRows = " 0.1000000 0.2000000\n 0.3000000 0.4000000\n";

TEST(CrgText, IsReadWithItsSections) {
  CrgRoad road;
  ASSERT_FALSE(read_crg(file_of(kStep, kTwoSections, kRows), road));
  EXPECT_NEAR(height_of(road, {0.5, 0}), 0.25, 1e-7);
  // Missing heights are those beside them.
  ASSERT_FALSE(read_crg(file_of(kStep, kTwoSections, "****       0.2000000\n 0.3000000*\n"), road));
  EXPECT_NEAR(height_of(road, {0, -1}), 0.2, 1e-7);
  EXPECT_NEAR(height_of(road, {1, 1}), 0.3, 1e-7);
}

// Offsets are not scaled and count for missing heights alone.
TEST(CrgText, MissingHeightsAreWhatTheirModeSays) {
  const std::string columns = kTwoSections + "D:long section at v = 3,m\nD:long section at v = 5,m\n";
  const std::string rows = "****       0.2500000*          0.5000000\n 0.3750000****      ****       0.1250000\n";
  const auto heights = [&](const std::string& lines) {
    CrgRoad road;
    EXPECT_FALSE(read_crg(with_block(file_of(kStep, columns, rows), "$ROAD_CRG_MODS\n" + lines), road));
    return road.heights;
  };
  using List = std::vector<double>;
  EXPECT_EQ(heights("GRID_NAN_MODE = 2\n"), (List{0.25, 0.25, 0.25, 0.5, 0.375, 0.375, 0.375, 0.125}));
  EXPECT_EQ(heights("GRID_NAN_OFFSET = 0.5\n"), (List{0.75, 0.25, 0.75, 0.5, 0.375, 0.875, 0.875, 0.125}));
  EXPECT_EQ(heights("GRID_NAN_MODE = 1\nSCALE_Z_GRID = 2\n"), (List{0, 0.5, 0, 1, 0.75, 0, 0, 0.25}));
  EXPECT_EQ(heights("GRID_NAN_MODE = 1\nGRID_NAN_OFFSET = 0.5\nSCALE_Z_GRID = 2\n"),
            (List{0.5, 0.5, 0.5, 1, 0.75, 0.5, 0.5, 0.25}));
  CrgRoad road;
  const auto problem = read_crg(with_block(file_of(kStep, columns, rows), "$ROAD_CRG_MODS\nGRID_NAN_MODE = 0\n"), road);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->message, "section 1 has no height at v = -1, and GRID_NAN_MODE = 0 leaves it so");
  // A file without gaps is as good with it.
  EXPECT_FALSE(read_crg(with_block(file_of(kStep, kTwoSections, kRows), "$ROAD_CRG_MODS\nGRID_NAN_MODE = 0\n"), road));
}

TEST(CrgText, ThatIsNoRoadSaysWhereAndWhy) {
  const auto problem = [](const std::string& text) {
    CrgRoad road;
    const std::optional<CrgProblem> found = read_crg(text, road);
    return found ? std::to_string(found->line) + ": " + found->message : "";
  };
  EXPECT_EQ(problem(""), "0: file has no data: no line of $$$$ ends its text part");
  EXPECT_EQ(problem("a\nb\n"), "2: file has no data: no line of $$$$ ends its text part");
  EXPECT_EQ(problem(file_of("REFERENCE_LINE_INCREMENT = much\n", kTwoSections, kRows)),
            "3: REFERENCE_LINE_INCREMENT must be a number, got \"much\"");
  EXPECT_EQ(problem(with_block(file_of(kStep, kTwoSections, kRows), "$ROAD_CRG_MODS\nSCALE_WIDTH = 0\n")),
            "3: SCALE_WIDTH must be positive, got 0");
  EXPECT_EQ(problem(file_of("", kTwoSections, kRows)), "3: REFERENCE_LINE_INCREMENT must be above 1e-6 m, got 0");
  EXPECT_EQ(problem(file_of(kStep, "#:XRFI\n", kRows)),
            "5: data format must be one of LRFI, LDFI, KRBI, KDBI, got \"XRFI\"");
  EXPECT_EQ(problem(file_of(kStep, "#:LRFI\nD:wind,m/s\n", kRows)), "6: unknown column \"WIND\"");
  EXPECT_EQ(problem(file_of(kStep, "#:LRFI\nD:long section at v = 1,m\nD:long section at v = -1,m\n", kRows)),
            "4: v of long sections must increase, -1 comes after 1");
  EXPECT_EQ(problem(file_of(kStep, "#:LRFI\nD:long section 1,m\nD:long section 2,m\n", kRows)),
            "4: file does not tell the v of its long sections");
  EXPECT_EQ(problem(file_of(kStep, kTwoSections, " 0.1000000\n")), "9: section has 1 numbers, 2 columns are defined");
  EXPECT_EQ(problem(file_of(kStep, kTwoSections, " 0.1000000 0.2x00000\n")), "9: must be a number, got \"0.2x00000\"");
  EXPECT_EQ(problem(file_of(kStep, kTwoSections, " 0.1000000 0.2000000\n")),
            "8: a road needs 2 sections of data, file has 1");
  EXPECT_EQ(problem(file_of(kStep, kTwoSections, "****      ****\n 0.1000000 0.2000000\n")),
            "0: section 1 has no height");
}

CrgRoad road_of(const std::string& text) {
  CrgRoad road;
  const std::optional<CrgProblem> problem = read_crg(text, road);
  EXPECT_FALSE(problem) << problem->line << ": " << problem->message;
  return relocated(road);
}
std::string mods(const std::string& lines) { return "$ROAD_CRG_MODS\n" + lines; }

// Factors act on what they name alone: heights are linear in them.
TEST(CrgModifiers, Scale) {
  const std::string file = bytes_of_road("handmade_curved.crg"), sloped = bytes_of_road("handmade_sloped.crg"),
                    banked = bytes_of_road("handmade_banked.crg");
  const CrgPlace at{7.3, 0.4};
  const auto height = [&](const std::string& text, CrgPlace place) { return height_of(road_of(text), place); };
  EXPECT_NEAR(height(with_block(file, mods("SCALE_Z_GRID = 2\n")), at), 2 * height(file, at), 1e-9);
  EXPECT_NEAR(height(with_block(file, mods("SCALE_Z_GRID = 0\n")), at), height(file, at), 1e-15) << "0 stands for none";
  // Of the slope and the banking alone: what is left without them is the same, so differences are linear.
  for (const auto& [text, name] : {std::pair(sloped, "SCALE_SLOPE"), std::pair(banked, "SCALE_BANKING")}) {
    const auto scaled = [&, &file_of = text, option = std::string(name)](const std::string& factor) {
      return height(with_block(file_of, mods(option + " = " + factor + "\n")), at);
    };
    EXPECT_NEAR(scaled("3") - scaled("2"), scaled("2") - scaled("1"), 1e-12) << name;
    EXPECT_GT(std::abs(scaled("2") - scaled("1")), 1e-3) << name;
  }
  const CrgRoad road = road_of(file), longer = road_of(with_block(file, mods("SCALE_LENGTH = 2\nSCALE_WIDTH = 3\n")));
  EXPECT_NEAR(height_of(longer, {2 * at.u, 3 * at.v}), height_of(road, at), 1e-12);
  EXPECT_NEAR(plane_place(longer, {2 * at.u, 0}).x, 2 * plane_place(road, {at.u, 0}).x, 1e-9);
  EXPECT_NEAR(plane_place(longer, {2 * at.u, 0}).y, 2 * plane_place(road, {at.u, 0}).y, 1e-9);
  const CrgRoad straight = road_of(with_block(file, mods("SCALE_CURVATURE = 0\n")));
  EXPECT_NEAR(plane_place(straight, at).x, at.u, 1e-12);
  EXPECT_NEAR(plane_place(straight, at).y, at.v, 1e-12);
}

// A road that is turned about a place and shifted has its heights where that takes their places.
TEST(CrgModifiers, TurnAndShift) {
  const std::string file = bytes_of_road("handmade_curved.crg");
  const CrgRoad road = road_of(file),
                moved = road_of(with_block(file, mods("REFLINE_ROTCENTER_X = 1\nREFLINE_ROTCENTER_Y = 2\n"
                                                      "REFLINE_OFFSET_PHI = 0.5\nREFLINE_OFFSET_X = 3\n"
                                                      "REFLINE_OFFSET_Y = 4\nREFLINE_OFFSET_Z = 5\n")));
  for (const CrgPlace at : {CrgPlace{7.3, 0.4}, CrgPlace{25, -1}}) {
    const PlanePlace before = plane_place(road, at), after = plane_place(moved, at);
    const double c = std::cos(0.5), s = std::sin(0.5), dx = before.x - 1, dy = before.y - 2;
    EXPECT_NEAR(after.x, 1 + 3 + c * dx - s * dy, 1e-9);
    EXPECT_NEAR(after.y, 2 + 4 + s * dx + c * dy, 1e-9);
    EXPECT_NEAR(height_of(moved, at), height_of(road, at) + 5, 1e-12);
  }
  // A place of its own to another one, where the road then heads as asked.
  const CrgRoad put = road_of(with_block(file, mods("REFPOINT_U = 7.3\nREFPOINT_V = 0.4\nREFPOINT_X = 10\n"
                                                    "REFPOINT_Y = 20\nREFPOINT_Z = 30\nREFPOINT_PHI = 1\n")));
  EXPECT_NEAR(plane_place(put, {7.3, 0.4}).x, 10, 1e-9);
  EXPECT_NEAR(plane_place(put, {7.3, 0.4}).y, 20, 1e-9);
  EXPECT_NEAR(height_of(put, {7.3, 0.4}), 30, 1e-12);
  EXPECT_NEAR(course_of(put, {7.3, 0.4}).heading, 1, 1e-12);
}

TEST(CrgOptions, UnsupportedOnesAreNamed) {
  const auto left = [](const std::string& block, const std::string& rows = kRows) {
    const std::string columns = kTwoSections;
    return unsupported_options(closed_as_asked(road_of(with_block(file_of(kStep, columns, rows), block))));
  };
  using List = std::vector<std::string>;
  EXPECT_EQ(left("$ROAD_CRG_OPTS\nBORDER_MODE_U = 3\nBORDER_SMOOTH_UBEG = 1\nWARN_MSGS = 0\nCHECK_EPS = 1e-6\n"),
            List());
  EXPECT_EQ(
      left("$ROAD_CRG_OPTS\nBORDER_MODE_V = 0\nBORDER_MODE_U = 7\nREFLINE_CONTINUATION = 1\nSPARKLE = 2\n"),
      (List{"BORDER_MODE_U = 7",
            "REFLINE_CONTINUATION = 1 (a closed track, but its end, 1 m away from its start, does not lead to it: "
            "the line goes straight on at its ends)",
            "SPARKLE = 2"}));
  EXPECT_EQ(left(mods("GRID_NAN_MODE = 1\nGRID_NAN_OFFSET = 0.5\nSCALE_Z_GRID = 2\n")), List());
  EXPECT_EQ(left(mods("GRID_NAN_MODE = 3\n")), List{"GRID_NAN_MODE = 3 (gaps get the height beside them)"});
  EXPECT_EQ(left(mods("REFPOINT_X = 1\nREFLINE_OFFSET_X = 2\n")),
            List{"REFLINE_OFFSET_X = 2 (beside a reference point)"});
}

// Bytes cut off and bytes changed: a road or a message, never a fault.
TEST(CrgText, BrokenFilesGetAMessageOrARoad) {
  std::uint64_t state = 1;
  const auto draw = [&](std::size_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>(state >> 33) % below;
  };
  int roads = 0, refused = 0;
  for (const char* name : {"handmade_arc.crg", "handmade_banked.crg", "belgian_block.crg"}) {
    std::string whole = bytes_of_road(name);
    if (whole.size() > 40000) whole.resize(40000);
    for (int k = 0; k < 300; ++k) {
      std::string text = whole;
      for (std::size_t change = draw(4); change > 0; --change) text[draw(text.size())] = static_cast<char>(draw(256));
      if (k % 3 == 0) text.resize(draw(text.size()));
      CrgRoad road;
      const std::optional<CrgProblem> problem = read_crg(text, road);
      ++(problem ? refused : roads);
      if (problem) {
        EXPECT_FALSE(problem->message.empty());
        continue;
      }
      const CrgPlace at = road_place(road, plane_place(road, {road.start + 1, 0.1}));
      EXPECT_TRUE(std::isfinite(height_of(road, at)) || !std::isfinite(at.u));
    }
  }
  EXPECT_GT(roads, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace mbgen
