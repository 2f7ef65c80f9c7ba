// Roads as the page draws them: heights against closed forms, how many places, and what is said of others.
#include "workbench/report/ground.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/report/report_support.hpp"
#include "workbench/report/strip.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPi = std::numbers::pi, kRadius = 0.3;

/// A cart on two wheels, 1.6 m apart, on roads; tyres: what is said of both, of the left and of the right one.
struct Cart {
  Model model;
  Topology topology;
  Analysis analysis;

  explicit Cart(const std::string& roads, const std::string& both = "", const std::string& left = "",
                const std::string& right = "")
      : model(*read_model(
            fmt::format(
                R"({{ "mbgen": 1, "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }}, "cart": {{ "mass": 9,
  "inertia": [1, 1, 1], "points": {{ "O": [0, 0, 0], "left": [0.5, 0.8, 0.3], "right": [0.5, -0.8, 0.3] }} }} }},
  "joints": {{ "cart": {{ "type": "free", "from": "ground.O", "to": "cart.O" }} }},
  "inputs": {{ "lift": {{ "unit": "m" }} }},
  "tyre_data": {{ "rubber": {{ "model": "pac2002", "coefficients": {{ "UNLOADED_RADIUS": {}, "FNOMIN": 4000, "PCX1": 1.6,
    "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 }} }} }},
  {} "tyres": {{ "left": {{ "centre": "cart.left", "data": "rubber", "stiffness": 1e5 {} {} }},
    "right": {{ "centre": "cart.right", "data": "rubber", "stiffness": 1e5 {} {} }} }} }})",
                kRadius, roads.empty() ? "" : "\"roads\": { " + roads + " }, ", both, left, both, right),
            "cart.json")),
        topology(*build_topology(model)),
        analysis(*analyse(model, topology)) {}

  /// Driven from the origin in a direction, rad, a frame each 0.2 m, at 10 m/s.
  Json driven(double length, double direction = 0, bool knows_inputs = false) const {
    std::vector<GenericState> frames;
    for (int i = 0; 0.2 * i <= length; ++i) {
      const double s = 0.2 * i;
      GenericState& frame = frames.emplace_back();
      frame.z = {s * std::cos(direction), s * std::sin(direction), 0, 0, 0, direction};
      frame.zd.assign(6, 0);
      frame.x = initial_auxiliary_states(model);
      frame.t = s / 10;
    }
    return ground_json(model, GenericSolver(model, topology, analysis), frames, knows_inputs);
  }
};

/// A strip of a page.
struct Drawn {
  Strip strip;
  std::size_t width = 0, length = 0;
  bool has_friction = false;

  explicit Drawn(const Json& json) : has_friction(!json["friction"].is_null()) {
    const std::vector<float> stations = decoded(json["stations"]), offsets = decoded(json["offsets"]),
                             heights = decoded(json["heights"]);
    for (std::size_t i = 0; i < stations.size(); i += 4)
      strip.stations.push_back({stations[i], stations[i + 1], stations[i + 2], stations[i + 3]});
    strip.offsets.assign(offsets.begin(), offsets.end());
    for (const float height : heights) strip.road.push_back({height, 1});
    if (has_friction) {
      const std::vector<float> friction = decoded(json["friction"]);
      EXPECT_EQ(friction.size(), heights.size());
      for (std::size_t i = 0; i < friction.size(); ++i) strip.road[i].friction = friction[i];
    }
    width = strip.offsets.size(), length = strip.stations.size();
    EXPECT_EQ(heights.size(), width * length);
  }

  /// Calls see(place, road) at all places, and in the middle of all cells with the road as it is drawn there.
  void at_all(const std::function<void(const GroundPlace&, const RoadBelow&)>& see) const {
    const auto place = [&](std::size_t i, std::size_t k) { return Strip::place(strip.stations[i], strip.offsets[k]); };
    for (std::size_t i = 0; i < length; ++i)
      for (std::size_t k = 0; k < width; ++k) see(place(i, k), strip.road[i * width + k]);
  }
  void in_all_cells(const std::function<void(const GroundPlace&, double height)>& see) const {
    for (std::size_t i = 0; i + 1 < length; ++i)
      for (std::size_t k = 0; k + 1 < width; ++k) {
        GroundPlace middle{};
        double height = 0;
        for (std::size_t corner = 0; corner < 4; ++corner) {
          const std::size_t row = i + corner / 2, column = k + corner % 2;
          const GroundPlace at = Strip::place(strip.stations[row], strip.offsets[column]);
          for (std::size_t axis = 0; axis < 2; ++axis) middle[axis] += at[axis] / 4;
          height += strip.road[row * width + column].height / 4;
        }
        see(middle, height);
      }
  }
};

// An inclined plane that is turned and moved: four corners say it all.
TEST(RoadStrip, OfAPlaneHasFourCorners) {
  const Cart cart(R"("hill": { "origin": [1, 2, 0.5], "heading": 0.4, "height": "0.05*x - 0.02*y" })");
  const Json ground = cart.driven(20);
  ASSERT_EQ(ground["strips"].size(), 1u);
  const Drawn drawn(ground["strips"][0]);
  EXPECT_EQ(drawn.strip.road.size(), 4u);
  drawn.at_all([](const GroundPlace& at, const RoadBelow& road) {
    const double x = std::cos(0.4) * (at[0] - 1) + std::sin(0.4) * (at[1] - 2);
    const double y = std::cos(0.4) * (at[1] - 2) - std::sin(0.4) * (at[0] - 1);
    EXPECT_NEAR(road.height, 0.5 + 0.05 * x - 0.02 * y, 1e-6);
  });
  // The wheels stand at x = 0.5 .. 20.5 and y = -0.8 and 0.8; three radii around them.
  EXPECT_NEAR(drawn.strip.stations.front().x, 0.5 - 3 * kRadius, 1e-5);
  EXPECT_NEAR(drawn.strip.stations.back().x, 20.5 + 3 * kRadius, 1e-5);
  EXPECT_NEAR(drawn.strip.offsets.back(), 0.8 + 3 * kRadius, 1e-5);
  EXPECT_FALSE(drawn.has_friction);
  double lowest = INFINITY;
  drawn.at_all([&](const GroundPlace&, const RoadBelow& road) { lowest = std::min(lowest, road.height); });
  EXPECT_LT(ground["floor"].get<double>(), lowest);
}

// Between its places too, along a way that is not that of the road.
TEST(RoadStrip, FollowsABump) {
  const Cart cart(R"("street": { "features": { "hump": { "type": "bump", "from": 8, "length": 3, "height": 0.1 } } })");
  const auto bump = [](double x) {
    const double u = std::clamp((x - 8) / 3, 0.0, 1.0);
    return 0.1 * std::pow(std::sin(kPi * u), 2);
  };
  for (const double direction : {0.0, 0.3}) {
    const Drawn drawn(cart.driven(20, direction)["strips"][0]);
    double highest = 0;
    drawn.at_all([&](const GroundPlace& at, const RoadBelow& road) {
      EXPECT_NEAR(road.height, bump(at[0]), 1e-6);
      highest = std::max(highest, road.height);
    });
    EXPECT_NEAR(highest, 0.1, 1e-4);
    // Twice the tolerance of a 500th of a radius: along the way and across it.
    drawn.in_all_cells(
        [&](const GroundPlace& at, double height) { EXPECT_NEAR(height, bump(at[0]), 1.2e-3) << at[0]; });
    EXPECT_LT(drawn.strip.road.size(), direction == 0 ? 150u : 4000u);
  }
}

TEST(RoadStrip, KeepsEdgesOfPlanksAndIce) {
  const Cart cart(R"("street": { "features": {
      "plank": { "type": "plank", "from": 6, "length": 1, "ramp": 0, "height": 0.05, "left": -0.5 } },
    "patches": { "ice": { "friction": 0.1, "from": 12, "length": 3, "right": 0.01 } } })");
  const Drawn drawn(cart.driven(20)["strips"][0]);
  ASSERT_TRUE(drawn.has_friction);
  // No place is farther from an edge than a place of the finest grid, a 25th of a radius, on either side of it.
  std::size_t high = 0, icy = 0;
  drawn.at_all([&](const GroundPlace& at, const RoadBelow& road) {
    const bool on_plank = at[0] > 6 && at[0] < 7 && at[1]<-0.5, on_ice = at[0]> 12 && at[0] < 15 && at[1] > 0.01;
    EXPECT_NEAR(road.height, on_plank ? 0.05 : 0, 1e-6) << at[0] << " " << at[1];
    EXPECT_NEAR(road.friction, on_ice ? 0.1 : 1, 1e-6) << at[0] << " " << at[1];
    high += on_plank ? 1 : 0;
    icy += on_ice ? 1 : 0;
  });
  EXPECT_GT(high, 0u);
  EXPECT_GT(icy, 0u);
  drawn.in_all_cells([&](const GroundPlace& at, double height) {
    const auto near = [](double place, double edge) { return std::abs(place - edge) < kRadius / 25; };
    if (near(at[0], 6) || near(at[0], 7) || near(at[1], -0.5)) return;
    EXPECT_NEAR(height, at[0] > 6 && at[0] < 7 && at[1] < -0.5 ? 0.05 : 0, 1e-3) << at[0] << " " << at[1];
  });
}

TEST(RoadStrip, OfALongRoughRoadHasAsManyPlacesAsAPageHolds) {
  const Cart cart(R"("rough": { "iso_8608": { "class": "F", "track": 1.6 } })");
  const Drawn drawn(cart.driven(900)["strips"][0]);
  EXPECT_LE(drawn.strip.road.size(), 40'000u);
  EXPECT_GT(drawn.strip.road.size(), 5'000u);
}

// Wheels that stand still have the road around them.
TEST(RoadStrip, SurroundsWheelsThatStand) {
  const Cart cart(R"("yard": { "heading": 0.3, "height": "0.01*x*x" })");
  const Drawn drawn(cart.driven(0)["strips"][0]);
  EXPECT_GT(drawn.length, 2u);
  drawn.at_all([](const GroundPlace& at, const RoadBelow& road) {
    const double x = std::cos(0.3) * at[0] + std::sin(0.3) * at[1];
    EXPECT_NEAR(road.height, 0.01 * x * x, 1e-6);
  });
}

TEST(Ground, HasAStripForEachRoadAndHeight) {
  const std::string roads = R"("a": { "height": 0.1 }, "b": { "height": 0.2 })";
  const Json two = Cart(roads, "", R"(, "road": "a")", R"(, "road": "b")").driven(5);
  ASSERT_EQ(two["strips"].size(), 2u);
  EXPECT_EQ(two["strips"][1]["road"], "b");
  EXPECT_NEAR(decoded(two["tracks"][0]["heights"]).back(), 0.1, 1e-7);
  EXPECT_NEAR(decoded(two["tracks"][1]["heights"]).back(), 0.2, 1e-7);
  EXPECT_TRUE(two["notes"].empty());
  const Json raised = Cart(roads, R"(, "road": "a")", R"(, "road_height": 0.05)").driven(5);
  ASSERT_EQ(raised["strips"].size(), 2u);
  EXPECT_NEAR(Drawn(raised["strips"][0]).strip.road[0].height, 0.15, 1e-7);
}

TEST(Ground, ThatCannotBeKnownIsSaidToBe) {
  const Json hosted =
      Cart(R"("host": { "height": "lift" }, "flat": {})", "", R"(, "road": "host")", R"(, "road": "flat")").driven(5);
  ASSERT_EQ(hosted["strips"].size(), 1u);
  EXPECT_EQ(hosted["strips"][0]["road"], "flat");
  EXPECT_EQ(hosted["notes"], Json({"Road host depends on inputs, which a result does not hold: it is not drawn."}));
  const Cart known(R"("host": { "height": "0.3 + lift" })");
  EXPECT_NEAR(Drawn(known.driven(5, 0, true)["strips"][0]).strip.road[0].height, 0.3, 1e-7) << "at a point it is known";
  const Json moving = Cart(R"("plate": { "height": "0.1 + 0.2*t" })").driven(5);
  EXPECT_EQ(moving["notes"], Json({"Road plate moves: it is drawn as it is at 0 s."}));
  EXPECT_NEAR(Drawn(moving["strips"][0]).strip.road[0].height, 0.1, 1e-7);
  EXPECT_NEAR(decoded(moving["tracks"][0]["heights"]).back(), 0.2, 1e-6) << "after 0.5 s";
  const Json without = Cart("", R"(, "road_height": "lift")").driven(5);
  EXPECT_EQ(without["notes"].size(), 2u);
  EXPECT_TRUE(without["strips"].empty() && without["tracks"].empty());
  const Json holes = Cart(R"road("half": { "height": "sqrt(x - 3)" })road").driven(5);
  EXPECT_EQ(holes["notes"].size(), 1u);
}

}  // namespace
}  // namespace mbgen
