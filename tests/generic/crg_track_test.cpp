// OpenCRG files of closed tracks against closed forms: a ring of straight pieces, whole and with a piece left out.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "compiler/formats/crg_road.hpp"
#include "compiler/formulation/roads/road.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr double kPi = std::numbers::pi;
constexpr int kPieces = 24, kColumns = 3;
constexpr double kPiece = 2, kTurn = 2 * kPi / kPieces, kStart = 5;  // m, rad, m
const std::array<double, kColumns> kSides = {-1.5, -0.25, 1.5};      // m
const double kInner = kPiece / 2 / std::tan(kTurn / 2);              // m, of the circle in the ring

/// Height of a section without a seam, and of one with a step between the last and the first, in single precision.
using Heights = double (*)(int section, int column);
double seamless(int section, int column) {
  return static_cast<double>(static_cast<float>(0.02 * std::sin(3 * kTurn * section + column)));
}
double stepped(int section, int column) { return section * (column + 1) / 1024.0; }

/// A ring that begins at the origin, to the left, of so many of its pieces.
std::string ring(Heights heights, int pieces, const std::string& options, double bend = 0) {
  std::string text = fmt::format(
      "$ROAD_CRG\nREFERENCE_LINE_START_U = {}\nREFERENCE_LINE_START_PHI = {:.15f}\nREFERENCE_LINE_INCREMENT = {}\n"
      "$\n$ROAD_CRG_OPTS\n{}$\n$KD_Definition\n#:LDFI\nD:reference line phi,rad\n",
      kStart, -kTurn / 2, kPiece, options);
  for (const double v : kSides) text += fmt::format("D:long section at v = {},m\n", v);
  text += "$$$$\n";
  for (int i = 0; i <= pieces; ++i) {
    text += fmt::format("{:20.13f}", (i - 0.5) * kTurn + bend * i);
    for (int k = 0; k < kColumns; ++k) text += fmt::format("{:20.13f}", heights(i, k));
    text += "\n";
  }
  return text;
}

Model model_with(const std::string& text) {
  const std::string file = ::testing::TempDir() + "/mbgen_track.crg";
  std::ofstream(file) << text;
  Model model = model_of(R"({ "mbgen": 1, "bodies": { "ground": {} }, "roads": { "road": { "crg": { "file": ")" + file +
                         "\" } } } }");
  std::filesystem::remove(file);
  return model;
}

struct RingPlace {
  int piece = 0;            ///< from the start
  double share = 0, v = 0;  ///< of the piece; m
};

/// The ring's centre is above its start by the radius of its corners, from where corners are kTurn apart.
PlanePlace in_plane(double angle, double radius) {
  const double corner = kInner / std::cos(kTurn / 2), turned = angle;
  return {radius * std::sin(turned), corner - radius * std::cos(turned)};
}

/// In polar coordinates lines across the sections are rays, and lines along are distances of the piece.
RingPlace on_ring(double angle, double radius) {
  const double turns = angle / kTurn, piece = std::floor(turns), off_middle = (turns - piece - 0.5) * kTurn;
  return {static_cast<int>(piece), 0.5 + std::tan(off_middle) / (2 * std::tan(kTurn / 2)),
          kInner - radius * std::cos(off_middle)};
}

double height_on_ring(Heights heights, const RingPlace& at) {
  const double v = std::clamp(at.v, kSides.front(), kSides.back());
  const int column = v > kSides[1] ? 1 : 0;
  const auto i = static_cast<std::size_t>(column);
  const double side = (v - kSides[i]) / (kSides[i + 1] - kSides[i]);
  const auto across = [&](int section) {
    return std::lerp(heights(section, column), heights(section, column + 1), side);
  };
  return std::lerp(across(at.piece), across(at.piece + 1), at.share);
}

detail::RoadHeight<double> solver_height(const Model& model, const PlanePlace& at) {
  return detail::grid_height(*model.samples, model.roads[0].grids[0], at.x, at.y);
}

// Whole rounds, beside the line and beyond its sides: by the solver's tables and by the judge's search.
TEST(CrgTrack, IsARingWhereItsEndsMeet) {
  for (const Heights heights : {seamless, stepped}) {
    const Model model = model_with(ring(heights, kPieces, "REFLINE_CONTINUATION = 1\n"));
    EXPECT_TRUE(model.notes.empty()) << model.notes[0].message;
    const CrgRoad& road = *model.roads[0].grids[0].road;
    ASSERT_EQ(road.closure.kind, CrgClosure::Kind::meeting);
    for (int k = 0; k < 3001; ++k)
      for (const double v : {-2.0, -1.1, -0.3, 0.0, 0.9, 1.7}) {
        const double angle = 2 * kPi * (k + 0.37) / 3001, radius = kInner - v;
        const PlanePlace at = in_plane(angle, radius);
        const RingPlace expected = on_ring(angle, radius);
        const CrgPlace found = road_place(road, at);
        const double u = kStart + kPiece * (expected.piece + expected.share);
        ASSERT_NEAR(found.u, u, 1e-9) << angle << " " << v;
        ASSERT_NEAR(found.v, expected.v, 1e-9);
        const double z = height_on_ring(heights, expected);
        ASSERT_NEAR(height_of(road, found), z, 1e-9);
        ASSERT_NEAR(solver_height(model, at).z, z, 1e-9) << angle << " " << v;
        // u goes on and on.
        const double round = kPiece * kPieces;
        for (const double laps : {-2.0, 0.0, 1.0}) {
          const PlanePlace back = plane_place(road, {u + laps * round, expected.v});
          ASSERT_NEAR(std::hypot(back.x - at.x, back.y - at.y), 0, 1e-9) << laps;
        }
      }
  }
}

// Where heights have no seam none is seen: nearer and nearer to it from both sides heights and slopes along tend to
// each other as at every other section.
TEST(CrgTrack, HasNoStepAtItsSeam) {
  const Model model = model_with(ring(seamless, kPieces, "REFLINE_CONTINUATION = 1\n"));
  for (const double radius : {kInner - 1.4, kInner + 0.1, kInner + 1.2})
    for (const double d : {1e-3, 1e-6, 1e-9}) {
      const auto before = solver_height(model, in_plane(-d, radius)),
                 behind = solver_height(model, in_plane(d, radius));
      EXPECT_NEAR(before.z, behind.z, 0.02 * 3 * kTurn / kPiece * 2 * d * radius * 1.5);
      const auto section = solver_height(model, in_plane(-1e-4, radius));
      EXPECT_NEAR(section.by_x, before.by_x, 1e-3);
    }
}

// Slopes against differences of heights.
TEST(CrgTrack, HasTheSlopesOfItsHeights) {
  const Model model = model_with(ring(seamless, kPieces, "REFLINE_CONTINUATION = 1\n"));
  for (const double angle : {-0.9 * kTurn, -0.1 * kTurn, 0.2 * kTurn, 0.6 * kTurn, 11.3 * kTurn})
    for (const double v : {-0.9, 0.4}) {
      const PlanePlace at = in_plane(angle, kInner - v);
      const auto z = [&](double dx, double dy) { return solver_height(model, {at.x + dx, at.y + dy}).z; };
      const auto height = solver_height(model, at);
      EXPECT_NEAR(height.by_x, (z(1e-6, 0) - z(-1e-6, 0)) / 2e-6, 1e-7) << angle;
      EXPECT_NEAR(height.by_y, (z(0, 1e-6) - z(0, -1e-6)) / 2e-6, 1e-7) << angle;
    }
}

// A piece is left out: its chord is wider than the two straight lines that end and start go on by, which meet in
// between. Source: as the ASAM C API 1.2.0 answers.
TEST(CrgTrack, GoesStraightOnUntilApartEndsMeet) {
  const Model model = model_with(ring(stepped, kPieces - 2, "REFLINE_CONTINUATION = 1\n"));
  const CrgRoad& road = *model.roads[0].grids[0].road;
  ASSERT_EQ(road.closure.kind, CrgClosure::Kind::apart);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_NE(model.notes[0].message.find("REFLINE_CONTINUATION = 1 to the letter (a closed track, but its end is"),
            std::string::npos);
  // Two pieces, 2 kPiece long, turned by kTurn against each other; the headings of both ends are those of the pieces
  // next to them, turned by 3 kTurn in all, of which the header tells 2.5 of the start's.
  const double gap = 2 * kPiece * std::cos(kTurn / 2);
  EXPECT_NEAR(road.closure.gap, gap, 1e-12);
  const double to_end = 1.5 * kTurn, to_start = 1.5 * kTurn - kTurn;  // rad, headings against the gap
  const double behind = gap * std::sin(to_start) / std::sin(to_end + to_start);
  const double before = gap * std::sin(to_end) / std::sin(to_end + to_start);
  EXPECT_NEAR(road.closure.behind, behind, 1e-9);
  EXPECT_NEAR(road.closure.before, before, 1e-9);
  for (const double v : {-1.0, 0.0, 0.6})
    for (const double share : {0.1, 0.7, 0.98}) {
      const CrgPlace end{road.end() + share * behind, v}, start{road.start - share * before, v};
      for (const CrgPlace& expected : {end, start}) {
        if (v != 0 && share > 0.9) continue;  // beside the corner one line hides the other
        const PlanePlace at = plane_place(road, expected);
        EXPECT_NEAR(road_place(road, at).u, expected.u, 1e-9);
        EXPECT_NEAR(road_place(road, at).v, v, 1e-9);
        const double z = height_on_ring(stepped, {expected.u > 20 ? kPieces - 3 : 0, expected.u > 20 ? 1.0 : 0.0, v});
        EXPECT_NEAR(solver_height(model, at).z, z, 1e-9) << expected.u << " " << v;
      }
    }
  // The rest is the ring, up to both ends.
  for (int k = 1; k < 1000; ++k) {
    const double angle = (kPieces - 2) * kTurn * k / 1000;
    ASSERT_NEAR(solver_height(model, in_plane(angle, kInner - 0.4)).z,
                height_on_ring(stepped, on_ring(angle, kInner - 0.4)),
                angle < kTurn || angle > 21 * kTurn ? 2e-3 : 1e-9);
  }
}

// End and start beside or over each other: the C API calls that open, and the line goes straight on.
TEST(CrgTrack, StaysOpenWhereItsEndsOverlap) {
  const Model model = model_with(ring(seamless, kPieces + 1, "REFLINE_CONTINUATION = 1\n"));
  EXPECT_EQ(model.roads[0].grids[0].road->closure.kind, CrgClosure::Kind::open);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_NE(model.notes[0].message.find("does not lead to it: the line goes straight on"), std::string::npos);
  // The tolerance is the file's.
  const double off = 1e-6;  // rad a section
  EXPECT_EQ(model_with(ring(seamless, kPieces, "REFLINE_CONTINUATION = 1\n", off)).roads[0].grids[0].road->closure.kind,
            CrgClosure::Kind::open);
  EXPECT_EQ(model_with(ring(seamless, kPieces, "REFLINE_CONTINUATION = 1\nCHECK_TOL = 0.001\n", off))
                .roads[0]
                .grids[0]
                .road->closure.kind,
            CrgClosure::Kind::meeting);
}

}  // namespace
}  // namespace mbgen
