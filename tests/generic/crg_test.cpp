// OpenCRG files: what the ASAM C API answers to them, and files that are none.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compiler/model/crg_road.hpp"

namespace mbgen {
namespace {

std::string bytes_of(const std::string& file) {
  std::ifstream stream(std::string(MBGEN_SOURCE_DIR) + "/tests/data/opencrg/" + file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

CrgRoad road_of(const std::string& name) {
  CrgRoad road;
  const std::optional<CrgProblem> problem = read_crg(bytes_of(name + ".crg"), road);
  EXPECT_FALSE(problem) << problem->line << ": " << problem->message;
  return road;
}

class CrgFile : public ::testing::TestWithParam<std::string> {};

// The API moves the right border of the start into the origin where the file tells it, see README.md beside the
// answers.
TEST_P(CrgFile, AnswersAsTheApiOfAsam) {
  CrgRoad road = road_of(GetParam());
  if (GetParam() != "handmade_curved_minimalist") road = laid_at_origin(road);
  const nlohmann::json answers = nlohmann::json::parse(bytes_of(GetParam() + ".json"));
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
const std::string kColumns = "#:LRFI\nD:long section at v = -1,m\nD:long section at v = 1,m\n";
const std::string kRows = " 0.1000000 0.2000000\n 0.3000000 0.4000000\n";

TEST(CrgText, IsReadWithItsSections) {
  CrgRoad road;
  ASSERT_FALSE(read_crg(file_of(kStep, kColumns, kRows), road));
  EXPECT_NEAR(height_of(road, {0.5, 0}), 0.25, 1e-7);
  // Missing heights are those beside them.
  ASSERT_FALSE(read_crg(file_of(kStep, kColumns, "****       0.2000000\n 0.3000000*\n"), road));
  EXPECT_NEAR(height_of(road, {0, -1}), 0.2, 1e-7);
  EXPECT_NEAR(height_of(road, {1, 1}), 0.3, 1e-7);
}

TEST(CrgText, ThatIsNoRoadSaysWhereAndWhy) {
  const auto problem = [](const std::string& text) {
    CrgRoad road;
    const std::optional<CrgProblem> found = read_crg(text, road);
    return found ? std::to_string(found->line) + ": " + found->message : "";
  };
  EXPECT_EQ(problem(""), "0: file has no data: no line of $$$$ ends its text part");
  EXPECT_EQ(problem("a\nb\n"), "2: file has no data: no line of $$$$ ends its text part");
  EXPECT_EQ(problem(file_of("REFERENCE_LINE_INCREMENT = much\n", kColumns, kRows)),
            "3: REFERENCE_LINE_INCREMENT must be a number, got \"much\"");
  EXPECT_EQ(problem(file_of("", kColumns, kRows)), "3: REFERENCE_LINE_INCREMENT must be above 1e-6 m, got 0");
  EXPECT_EQ(problem(file_of(kStep, "#:XRFI\n", kRows)),
            "5: data format must be one of LRFI, LDFI, KRBI, KDBI, got \"XRFI\"");
  EXPECT_EQ(problem(file_of(kStep, "#:LRFI\nD:wind,m/s\n", kRows)), "6: unknown column \"WIND\"");
  EXPECT_EQ(problem(file_of(kStep, "#:LRFI\nD:long section at v = 1,m\nD:long section at v = -1,m\n", kRows)),
            "4: v of long sections must increase, -1 comes after 1");
  EXPECT_EQ(problem(file_of(kStep, "#:LRFI\nD:long section 1,m\nD:long section 2,m\n", kRows)),
            "4: file does not tell the v of its long sections");
  EXPECT_EQ(problem(file_of(kStep, kColumns, " 0.1000000\n")), "9: section has 1 numbers, 2 columns are defined");
  EXPECT_EQ(problem(file_of(kStep, kColumns, " 0.1000000 0.2x00000\n")), "9: must be a number, got \"0.2x00000\"");
  EXPECT_EQ(problem(file_of(kStep, kColumns, " 0.1000000 0.2000000\n")),
            "8: a road needs 2 sections of data, file has 1");
  EXPECT_EQ(problem(file_of(kStep, kColumns, "****      ****\n 0.1000000 0.2000000\n")), "0: section 1 has no height");
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
    std::string whole = bytes_of(name);
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
