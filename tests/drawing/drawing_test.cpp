// Pictures: well-formed, the same bytes each time, and showing what they are to show.
#include "workbench/drawing/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <regex>

#include "compiler/reader/read_model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {
namespace {

struct Described {
  Model model;
  Topology topology;
  Analysis analysis;
  std::string svg() const { return topology_svg(model, topology, analysis); }
};

Described described(const std::string& file) {
  Model model = *read_model_file(std::string(MBGEN_SOURCE_DIR) + "/models/" + file);
  Topology topology = *build_topology(model);
  Analysis analysis = *analyse(model, topology);
  return {std::move(model), std::move(topology), std::move(analysis)};
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// Every tag is closed in its order.
void expect_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  const std::regex tag("<(/?)([a-zA-Z]+)[^<>]*?(/?)>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it) {
    if ((*it)[3] == "/") continue;
    if ((*it)[1] == "/") {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), (*it)[2]);
      open.pop_back();
    } else {
      open.push_back((*it)[2]);
    }
  }
  EXPECT_TRUE(open.empty());
}

TEST(TopologyDrawing, ShowsTheCoachAsItsAnalysisHasIt) {
  const Described coach = described("coach_mechanism.json");
  const std::string svg = coach.svg();
  expect_well_formed(svg);
  EXPECT_EQ(svg, coach.svg());
  for (const Body& body : coach.model.bodies) EXPECT_EQ(count(svg, ">" + body.name + "</text>"), 1u) << body.name;
  for (const Loop& loop : coach.topology.loops) EXPECT_EQ(count(svg, ">" + loop.name + " ("), 1u) << loop.name;
  EXPECT_EQ(count(svg, ", independent</title>"), free_coordinates(coach.topology, coach.analysis).size());
  EXPECT_EQ(count(svg, ", independent</title>") + count(svg, ", dependent</title>"), coach.topology.bodies.size());
  EXPECT_EQ(count(svg, "loop block "), coach.topology.blocks.size());
}

TEST(TopologyDrawing, BoxesDoNotOverlap) {
  for (const char* file : {"coach_mechanism.json", "truck_mechanism.json", "andrews_squeezer.json"}) {
    const std::string svg = described(file).svg();
    const std::regex box("<rect x=\"([0-9.]+)\" y=\"([0-9.]+)\" width=\"([0-9.]+)\" height=\"([0-9.]+)\" rx=\"5\"");
    double bottom = 0;
    int boxes = 0;
    for (std::sregex_iterator it(svg.begin(), svg.end(), box), end; it != end; ++it, ++boxes) {
      EXPECT_GE(std::stod((*it)[2]), bottom) << file;
      bottom = std::stod((*it)[2]) + std::stod((*it)[4]);
    }
    EXPECT_GT(boxes, 5) << file;
  }
}

TEST(TopologyDrawing, TextCannotLeaveItsPlace) {
  Described four_bar = described("four_bar.json");
  four_bar.model.name = "<script>\"&'\x01";
  const std::string svg = four_bar.svg();
  EXPECT_NE(svg.find("&lt;script&gt;&quot;&amp;' "), std::string::npos);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

/// The texts of ticks of the vertical axis of the first panel.
std::vector<std::string> ticks(const std::vector<double>& values, const std::string& unit = "m") {
  std::vector<double> time;
  for (std::size_t i = 0; i < values.size(); ++i) time.push_back(static_cast<double>(i));
  const std::string svg = plot_svg({}, {{unit, {{"curve", time, values}}}});
  expect_well_formed(svg);
  std::vector<std::string> found;
  const std::regex text("<text x=\"71\" y=\"[0-9.]+\" text-anchor=\"end\">([-0-9.e+]+)</text>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

TEST(Plot, TicksAreRoundAndEncloseTheCurve) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(ticks({-2.8, 2.73}), (Texts{"-4", "-2", "0", "2", "4"}));
  EXPECT_EQ(ticks({0, 1}), (Texts{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(ticks({0.1, 0.3}), (Texts{"0.10", "0.15", "0.20", "0.25", "0.30"}));
  EXPECT_EQ(ticks({5, 5}), (Texts{"4.6", "4.8", "5.0", "5.2", "5.4"}));
  EXPECT_EQ(ticks({0, 0}), (Texts{"-0.5", "0.0", "0.5"}));
  EXPECT_EQ(ticks({16100, 65000}, "N"), (Texts{"0", "20", "40", "60", "80"})) << "in kN";
}

TEST(Plot, ManyPointsAreDrawnByTheirExtremes) {
  std::vector<double> time, values;
  constexpr int kPoints = 200000;
  for (int i = 0; i < kPoints; ++i) {
    time.push_back(1e-3 * i);
    values.push_back(i == kPoints / 2 ? 10 : 0);
  }
  const std::string svg = plot_svg({}, {{"m", {{"spike", time, values}}}});
  EXPECT_LT(svg.size(), 60000u);
  const std::size_t top = svg.find(" 34.0L");
  EXPECT_NE(top, std::string::npos) << "the spike reaches the top of its frame";
}

TEST(Plot, LegendsAreEscaped) {
  const std::string svg = plot_svg({}, {{"<m>", {{"a<b & c", {0, 1}, {0, 1}}}}});
  expect_well_formed(svg);
  EXPECT_NE(svg.find("a&lt;b &amp; c"), std::string::npos);
}

// A circle: x goes back, and all of it is drawn.
TEST(Plot, CurvesMayTurnBack) {
  Curve circle{"circle", {}, {}};
  constexpr int kPoints = 4000;
  for (int i = 0; i <= kPoints; ++i) {
    circle.x.push_back(2 * std::cos(2 * std::numbers::pi * i / kPoints));
    circle.y.push_back(std::sin(2 * std::numbers::pi * i / kPoints));
  }
  const std::string svg = plot_svg({"x", "m"}, {{"m", {circle}}});
  expect_well_formed(svg);
  EXPECT_NE(svg.find(">x, m</text>"), std::string::npos);
  const std::size_t begin = svg.find("d=\"M", svg.find("class=\"curve\""));
  const std::string path = svg.substr(begin, svg.find('"', begin + 4) - begin);
  EXPECT_GT(count(path, "L"), 40u);
  EXPECT_LT(count(path, "L"), 400u);
  EXPECT_NE(path.find("942.0"), std::string::npos) << "right, " << path.substr(0, 60);
  EXPECT_NE(path.find("78.0"), std::string::npos) << "left";
}

TEST(Plot, PointsThatAreNoNumbersAreLeftOut) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = plot_svg({}, {{"m", {{"a", {0, 1, 2}, {1, none, 3}}, {"b", {0, 1}, {none, none}}}}});
  expect_well_formed(svg);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace mbgen
