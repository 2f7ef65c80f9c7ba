// Tyres on roads against closed forms: a quarter car over waves, a cart on slopes, shapes of features.

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/formats/crg_road.hpp"
#include "compiler/formulation/roads/road.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/quarter_car.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr double kPi = std::numbers::pi;

// --- a quarter car ---

/// Complex amplitudes of hub and body over that of the road, by the equations of the two masses.
std::array<std::complex<double>, 2> transfer(double omega) {
  using C = std::complex<double>;
  const C s(0, omega), strut = kSpring + kDamper * s, tyre = kTyre + kTyreDamper * s;
  const C body = kSprung * s * s + strut, hub = kUnsprung * s * s + strut + tyre;
  const C hub_over_road = tyre * body / (hub * body - strut * strut);
  return {hub_over_road, strut / body * hub_over_road};
}

// The road's height is small, so that nothing of second order is left. The motion starts as the closed form has it.
TEST(QuarterCar, FollowsASineRoadAsItsTransferFunctionHasIt) {
  constexpr double kAmplitude = 1e-7, kStep = 2.5e-4;
  for (const auto& [frequency, wave_length] : {std::pair(1.5, 20.0), std::pair(11.0, 6.0)}) {
    const double omega = 2 * kPi * frequency;
    const auto [hub, body] = transfer(omega);
    const std::string feature =
        fmt::format(R"({{ "type": "sine", "height": {}, "wave_length": {} }})", kAmplitude, wave_length);
    MechanismInState car = quarter_car(R"({ "features": { "waves": )" + feature + " } }", frequency * wave_length);
    const auto position = [&](std::complex<double> of, double t) {
      return kAmplitude * std::imag(of * std::polar(1.0, omega * t));
    };
    const std::complex<double> rate(0, omega);
    car.set("hub", position(hub, 0), position(hub * rate, 0));
    car.set("body", position(body, 0), position(body * rate, 0));
    ASSERT_TRUE(car.solver().project_motion(car.state()).ok());
    const Dynamics dynamics{car.solver()};
    for (int k = 1; k <= 4000; ++k) {
      ASSERT_TRUE(step_rk4(dynamics, car.state(), kStep).ok());
      ASSERT_NEAR(car.z("hub"), position(hub, k * kStep), 1e-6 * kAmplitude * std::abs(hub))
          << frequency << " Hz " << k;
      ASSERT_NEAR(car.z("body"), position(body, k * kStep), 1e-6 * kAmplitude * std::abs(body)) << frequency;
    }
  }
}

// --- a cart on slopes ---

/// A mechanism whose accelerations are asked for.
class Moving : public MechanismInState {
 public:
  using MechanismInState::MechanismInState;
  /// Rates of the auxiliary states; zdd() gives the accelerations.
  const std::vector<double>& solve() {
    EXPECT_TRUE(solver_.solve_motion(state_, derivative_).ok());
    return derivative_.xd;
  }
};

/// A cart whose wheels have toe and camber, pulled sideways by its speed.
Moving cart(const std::string& gravity, const std::string& road) {
  std::string bodies, joints, tyres;
  for (const auto& [name, x, y] : {std::tuple("a", 0.8, 0.6), {"b", 0.8, -0.6}, {"c", -0.8, 0.6}, {"d", -0.8, -0.6}}) {
    bodies += fmt::format(R"(, "{0}": {{ "mass": 12, "com": [{1}, {2}, 0.3], "inertia": [0.4, 0.7, 0.4],
      "points": {{ "O": [{1}, {2}, 0.3] }} }})",
                          name, x, y);
    joints += fmt::format(
        R"(, "{0}": {{ "type": "revolute", "from": "cart.{0}", "to": "{0}.O", "axis": [0.03, 1, 0.05] }})", name);
    tyres += fmt::format(R"({} "{}": {{ "centre": "{}.O", "data": "rubber", "stiffness": 1e5, "damping": 300 }})",
                         tyres.empty() ? "" : ",", name, name);
  }
  Model model =
      model_of(R"({ "mbgen": 1, "name": "cart", "gravity": )" + gravity + R"(,
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "cart": { "mass": 400, "com": [0.1, 0, 0.6], "inertia": [60, 150, 170], "points": { "O": [0, 0, 0],
        "a": [0.8, 0.6, 0.3], "b": [0.8, -0.6, 0.3], "c": [-0.8, 0.6, 0.3], "d": [-0.8, -0.6, 0.3] } })" +
               bodies + R"( }, "joints": { "cart": { "type": "free", "from": "ground.O", "to": "cart.O" })" + joints +
               " }, " + kRubber + R"(, "roads": { "road": )" + road + R"( }, "tyres": {)" + tyres + " } }");
  return Moving(analysed(std::move(model)));
}

/// Accelerations of the cart along x, y, z and of its wheels, from a state given in axes turned by an angle about x or
/// y.
std::vector<double> accelerations(Moving m, char axis, double angle) {
  const auto turned = [&](double x, double y, double z, double by) -> std::array<double, 3> {
    const double c = std::cos(by), s = std::sin(by);
    if (axis == 'x') return {x, c * y - s * z, s * y + c * z};
    return {c * x + s * z, y, c * z - s * x};
  };
  const auto at = turned(1.2, -0.7, -0.02, angle), v = turned(9, 0.8, -0.1, angle);
  m.set("cart_tx", at[0], v[0]);
  m.set("cart_ty", at[1], v[1]);
  m.set("cart_tz", at[2], v[2]);
  m.set(axis == 'x' ? "cart_rx" : "cart_ry", angle, 0.3);
  for (const char* wheel : {"a", "b", "c", "d"}) m.set(wheel, 0.1, 31);
  for (double& x : m.state().x) x = 0.002;
  const std::vector<double> rates = m.solve();
  const auto a = turned(m.zdd("cart_tx"), m.zdd("cart_ty"), m.zdd("cart_tz"), -angle);
  std::vector<double> result(a.begin(), a.end());
  for (const char* wheel : {"a", "b", "c", "d"}) result.push_back(m.zdd(wheel));
  result.insert(result.end(), rates.begin(), rates.end());
  return result;
}

// A slope is a flat road with gravity turned. One written as a height, one as another height of a turned road.
TEST(InclinedRoad, IsAFlatOneWithGravityTurned) {
  constexpr double kAngle = 0.3;
  const double s = kGravity * std::sin(kAngle), c = kGravity * std::cos(kAngle);
  const std::string straight = fmt::format("[0, 0, {}]", -kGravity);
  for (const char axis : {'x', 'y'}) {
    // Turned about x the left side rises, about y the front sinks.
    const std::string gravity = axis == 'x' ? fmt::format("[0, {}, {}]", -s, -c) : fmt::format("[{}, 0, {}]", s, -c);
    const double rise = axis == 'x' ? std::tan(kAngle) : -std::tan(kAngle);
    const std::vector<double> expected = accelerations(cart(gravity, "{}"), axis, 0);
    const std::string roads[] = {
        fmt::format(R"({{ "height": "{}*{}" }})", rise, axis == 'x' ? 'y' : 'x'),
        fmt::format(R"({{ "origin": [3, 4, {}], "heading": {{ "deg": 90 }}, "height": "{}*{}" }})",
                    rise * (axis == 'x' ? 4 : 3), rise, axis == 'x' ? "x" : "(-y)")};
    for (const std::string& road : roads)
      EXPECT_LT(relative_error(accelerations(cart(straight, road), axis, kAngle), expected), 1e-11) << axis << road;
  }
}

// --- shapes ---

/// Height of a road at places along y = 0, by the load of a tyre that stands there.
class Roads : public ::testing::Test {
 protected:
  static double load_at(const std::string& road, double x, double y = 0) {
    Model model = model_of(fmt::format(
        R"({{ "mbgen": 1, "name": "feeler", "gravity": [0, 0, 0], "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
        "hub": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "O": [0, 0, 0] }} }} }},
        "joints": {{ "hub": {{ "type": "free", "from": "ground.O", "to": "hub.O" }} }}, {}, "roads": {{ "road": {} }},
        "tyres": {{ "tyre": {{ "centre": "hub.O", "data": "rubber", "stiffness": 1e5 }} }},
        "outputs": {{ "load": {{ "tyre": "tyre", "quantity": "load" }} }} }})",
        kRubber, road));
    MechanismInState m(analysed(std::move(model)));
    m.set("hub_tx", x, 0);
    m.set("hub_ty", y, 0);
    m.set("hub_tz", 0.2, 0);  // 0.1 m into a flat road
    return outputs_at(m.solver(), m.state(), std::vector<double>(6, 0.0))[0];
  }
};

TEST_F(Roads, HaveTheShapesOfTheirFeatures) {
  // load = k (r - (h - z) cos(slope)) of a wheel whose axis is across the slope.
  const auto load_of = [](double z, double slope) { return 1e5 * (0.3 - (0.2 - z) / std::hypot(1, slope)); };
  const auto one = [](const std::string& feature) { return R"({ "features": { "it": )" + feature + " } }"; };
  const auto near = [&](const std::string& road, double x, double z, double slope) {
    EXPECT_NEAR(load_at(road, x), load_of(z, slope), 1e-8) << road << x;
  };
  const std::string bump = one(R"({ "type": "bump", "from": 2, "length": 3, "height": 0.1 })");
  near(bump, 1.99, 0, 0);
  near(bump, 3.5, 0.1, 0);
  near(bump, 2.75, 0.05, 0.1 * kPi / 3);
  near(bump, 5.01, 0, 0);
  const std::string hole = one(R"({ "type": "pothole", "from": 2, "length": 3, "height": 0.04, "ramp": 0.5 })");
  near(hole, 2.25, -0.02, -0.04 * 1.5 / 0.5);
  near(hole, 3, -0.04, 0);
  near(hole, 4.75, -0.02, 0.04 * 1.5 / 0.5);
  const std::string steps = one(R"({ "type": "plank", "from": 2, "length": 3, "height": 0.04, "ramp": 0 })");
  near(steps, 1.999, 0, 0);
  near(steps, 2.001, 0.04, 0);
  near(steps, 5.001, 0, 0);
  // Wave numbers 1/4 to 1 over 10 m: after 10 m there were (1/4 + 1) / 2 * 10 = 6.25 waves, after 5 m 2.1875.
  const std::string sweep = one(
      R"({ "type": "sweep", "from": 0, "length": 10, "ramp": 0, "height": 0.01, "wave_length": 4, "last_wave_length": 1 })");
  near(sweep, 5, 0.01 * std::sin(2 * kPi * 2.1875), 0.01 * 2 * kPi * 0.625 * std::cos(2 * kPi * 2.1875));
  near(sweep, 9.9999999999, 0.01, 0);
}

TEST_F(Roads, AddFeaturesBetweenTheirSides) {
  const std::string road = R"({ "height": "0.01 + 0*x", "features": {
    "left":  { "type": "plank", "length": 2, "height": 0.02, "right": 0.5, "left": 1 },
    "right": { "type": "plank", "length": 2, "height": 0.03, "left": 0.7 } } })";
  EXPECT_NEAR(load_at(road, 1, 0), 1e5 * (0.1 + 0.04), 1e-8);
  EXPECT_NEAR(load_at(road, 1, 0.6), 1e5 * (0.1 + 0.06), 1e-8);
  EXPECT_NEAR(load_at(road, 1, 0.8), 1e5 * (0.1 + 0.03), 1e-8);
  EXPECT_NEAR(load_at(road, 1, 1.1), 1e5 * (0.1 + 0.01), 1e-8);
}

// The spline goes through the heights and is level outside.
TEST_F(Roads, FollowAMeasuredProfile) {
  const std::string directory = ::testing::TempDir(), file = directory + "/mbgen_road_profile.csv";
  std::ofstream csv(file);
  csv << "s,right,left\n";
  const auto height = [](double s, double side) { return 0.02 * std::sin(0.9 * s + side) + 0.001 * side * s; };
  for (int i = 0; i <= 80; ++i)
    csv << fmt::format("{},{:.17g},{:.17g}\n", 1 + 0.1 * i, height(1 + 0.1 * i, 0), height(1 + 0.1 * i, 0.5));
  csv.close();
  const std::string road =
      fmt::format(R"({{ "profile": {{ "csv": "{}", "right": "right", "left": "left", "track": 1.5 }} }})", file);
  const auto load_of = [](double z, double slope) { return 1e5 * (0.3 - (0.2 - z) / std::hypot(1, slope)); };
  for (const double x : {2.0, 3.3, 5.0, 7.7}) {
    EXPECT_NEAR(load_at(road, x, -0.8), load_of(height(x, 0), 0.018 * std::cos(0.9 * x)), 0.01) << x;
    EXPECT_NEAR(load_at(road, x + 0.05, 5), load_of(height(x + 0.05, 0.5), 0.018 * std::cos(0.9 * x + 0.545) + 0.0005),
                0.01);
  }
  EXPECT_NEAR(load_at(road, 0.9, -0.8), load_of(height(1, 0), 0), 1e-8);
  EXPECT_NEAR(load_at(road, 12, 0.8), load_of(height(9, 0.5), 0), 1e-8);
  std::remove(file.c_str());
}

// Heights by the tables that a solver has, as the C API of ASAM answers; slopes by differences of the road itself.
TEST(CrgGrid, HasTheHeightsOfTheApi) {
  const std::string directory = source_path("tests/data/opencrg/");
  for (const char* name :
       {"handmade_arc", "handmade_banked", "handmade_circle", "handmade_curved", "handmade_curved_minimalist",
        "handmade_sloped", "handmade_straight", "handmade_vtest", "belgian_block"}) {
    const Model model =
        model_of(R"({ "mbgen": 1, "bodies": { "ground": {} }, "roads": { "road": { "crg": { "file": ")" + directory +
                 name + R"(.crg" } } } })");
    const RoadGrid& grid = model.roads[0].grids[0];
    const CrgRoad& road = *grid.road;
    const bool is_moved = std::string(name) != "handmade_curved_minimalist";
    const CrgPlace border{road.start, road.v.front()};
    const PlanePlace corner = is_moved ? plane_place(road, border) : PlanePlace{};
    const double base = is_moved ? height_of(road, border) : 0, turn = is_moved ? road.heading[0] : 0;
    std::ifstream file(directory + name + ".json");
    const nlohmann::json answers = nlohmann::json::parse(file);
    for (const nlohmann::json& point : answers.at("points")) {
      const double ax = point.at("x"), ay = point.at("y"), c = std::cos(turn), s = std::sin(turn);
      const double x = corner.x + c * ax - s * ay, y = corner.y + s * ax + c * ay;
      const detail::RoadHeight<double> height = detail::grid_height(*model.samples, grid, x, y);
      EXPECT_NEAR(height.z - base, point.at("z_of_xy").get<double>(), 1e-9) << name << point;
      const auto z = [&](double dx, double dy) { return height_of(road, road_place(road, {x + dx, y + dy})); };
      const CrgPlace at = road_place(road, {x, y});
      const double rest = std::remainder((at.u - road.start) / road.increment, 1.0);
      const auto is_near = [&](double v) { return std::abs(v - at.v) < 1e-4; };
      if (std::abs(rest) < 1e-3 || std::ranges::any_of(road.v, is_near)) continue;  // a corner is close
      EXPECT_NEAR(height.by_x, (z(1e-6, 0) - z(-1e-6, 0)) / 2e-6, 1e-6) << name << point;
      EXPECT_NEAR(height.by_y, (z(0, 1e-6) - z(0, -1e-6)) / 2e-6, 1e-6) << name << point;
    }
  }
}

/// A road of two metres with heights that are bilinear in u and v, with options in its file and in the model.
Model short_road(const std::string& options, const std::string& fields = "") {
  const std::string file = ::testing::TempDir() + "/mbgen_short_road.crg";
  std::ofstream(file)
      << "$ROAD_CRG\nREFERENCE_LINE_INCREMENT = 1\n$\n$ROAD_CRG_OPTS\n" + options +
             "$\n$KD_Definition\n#:LRFI\nD:long section at v = -1,m\nD:long section at v = 0.5,m\n$$$$\n" +
             " 0.1250000 0.2500000\n 0.5000000 0.1250000\n 0.7500000 1.0000000\n";
  Model model = model_of(R"({ "mbgen": 1, "bodies": { "ground": {} }, "roads": { "road": { "crg": { "file": ")" + file +
                         "\"" + fields + " } } } }");
  std::remove(file.c_str());
  return model;
}

// Repeated it is periodic, reflected it is even about its borders and has twice the period.
TEST(CrgGrid, GoesOnBeyondItsBordersAsAsked) {
  const auto height = [](const Model& model, double x, double y) {
    return detail::grid_height(*model.samples, model.roads[0].grids[0], x, y);
  };
  const Model kept = short_road(""), repeated = short_road("BORDER_MODE_U = 3\nBORDER_MODE_V = 3\n"),
              mirrored = short_road("BORDER_MODE_U = 4\nBORDER_MODE_V = 4\n"),
              flat = short_road("BORDER_MODE_U = 1\nBORDER_OFFSET_U = 0.3\nBORDER_OFFSET_V = 0.2\n"),
              narrow = short_road("BORDER_MODE_V = 1\nBORDER_OFFSET_V = -0.1\n");
  for (const double u : {0.3, 1.6})
    for (const double v : {-0.7, 0.2}) {
      const detail::RoadHeight<double> inside = height(kept, u, v);
      for (const int k : {-3, -1, 0, 1, 2})
        for (const int m : {-2, 0, 1}) {
          const detail::RoadHeight<double> again = height(repeated, u + 2 * k, v + 1.5 * m);
          EXPECT_NEAR(again.z, inside.z, 1e-12) << u << " " << v << " " << k << " " << m;
          EXPECT_NEAR(again.by_x, inside.by_x, 1e-12);
          EXPECT_NEAR(again.by_y, inside.by_y, 1e-12);
          const bool is_back = k % 2 != 0, is_left = m % 2 != 0;
          const detail::RoadHeight<double> mirror =
              height(mirrored, 2 * k + (is_back ? 2 - u : u), -1 + 1.5 * m + (is_left ? 1.5 - (v + 1) : v + 1));
          EXPECT_NEAR(mirror.z, inside.z, 1e-12) << u << " " << v << " " << k << " " << m;
          EXPECT_NEAR(mirror.by_x, is_back ? -inside.by_x : inside.by_x, 1e-12);
          EXPECT_NEAR(mirror.by_y, is_left ? -inside.by_y : inside.by_y, 1e-12);
        }
      EXPECT_NEAR(height(flat, u, v).z, inside.z, 1e-12);
      EXPECT_NEAR(height(flat, u + 2, v).z, 0.3, 1e-12);
      EXPECT_NEAR(height(flat, u, v + 3).z, height(kept, u, 0.5).z + 0.2, 1e-12);
      EXPECT_NEAR(height(flat, -u, v - 3).z, 0.3 + 0.2, 1e-12);
      EXPECT_NEAR(height(narrow, u, v - 3).z, -0.1, 1e-12);
      EXPECT_NEAR(height(narrow, u + 2, v).z, height(kept, 2, v).z, 1e-12);
    }
  ASSERT_EQ(short_road("SPARKLE = 1\n").notes.size(), 1u);
  EXPECT_NE(short_road("SPARKLE = 1\n").notes[0].message.find("options that mbgen does not follow: SPARKLE = 1"),
            std::string::npos);
  // The model's choice takes precedence over the file's; both smooth the road at every repetition.
  const Model chosen = short_road("BORDER_MODE_U = 4\nBORDER_SMOOTH_UBEG = 1\n", R"(, "beyond_ends": "repeat")");
  EXPECT_NEAR(height(chosen, 2.25, 0).z, 0.25 * height(kept, 0.25, 0).z, 1e-12);
  EXPECT_NEAR(height(short_road("BORDER_SMOOTH_UBEG = 1\n", R"(, "smooth_begin": 0)"), 0.25, 0).z,
              height(kept, 0.25, 0).z, 1e-12);
}

// Beyond a border that refuses there is no height and no slope, up to it all is as it was.
TEST(CrgGrid, HasNoHeightBeyondABorderThatRefuses) {
  const Model kept = short_road(""), ends = short_road("BORDER_MODE_U = 0\n"),
              sides = short_road("", R"(, "beyond_sides": "refuse")");
  EXPECT_TRUE(ends.notes.empty());
  const auto height = [](const Model& model, double x, double y) {
    return detail::grid_height(*model.samples, model.roads[0].grids[0], x, y);
  };
  for (const double u : {-0.5, -1e-6, 0.0, 0.7, 2.0, 2.000001, 3.0})
    for (const double v : {-2.0, -1.000001, -1.0, 0.3, 0.5, 0.500001, 4.0}) {
      const bool is_beyond = u < 0 || u > 2, is_beside = v < -1 || v > 0.5;
      const auto at_end = height(ends, u, v), at_side = height(sides, u, v), as_kept = height(kept, u, v);
      EXPECT_EQ(std::isnan(at_end.z), is_beyond) << u << " " << v;
      EXPECT_EQ(std::isnan(at_end.by_x), is_beyond) << u << " " << v;
      EXPECT_EQ(std::isnan(at_side.z), is_beside) << u << " " << v;
      EXPECT_EQ(std::isnan(at_side.by_y), is_beside) << u << " " << v;
      EXPECT_TRUE(is_beyond || at_end.z == as_kept.z);
      EXPECT_TRUE(is_beside || at_side.by_x == as_kept.by_x);
    }
}

// Ground that a host gives: height and slopes of the place under the wheel.
TEST_F(Roads, TakeHeightAndSlopesFromOutside) {
  // The wheel's axis is y: its load is along the normal, its loaded radius counts in the plane of the wheel.
  const double a = 0.3, b = 0.2, n = std::sqrt(1 + a * a + b * b);
  const double radius = (0.2 - 0.01) / n / std::sqrt(1 - b * b / (n * n));
  EXPECT_NEAR(load_at(R"({ "height": "0.01 + 0*x", "slope_x": 0.3, "slope_y": 0.2 })", 4, 7), 1e5 * (0.3 - radius),
              1e-8);
  // Turned by a right angle to the left its x is the global y.
  EXPECT_NEAR(load_at(R"({ "heading": { "deg": 90 }, "height": 0.01, "slope_x": 0.2, "slope_y": -0.3 })", 4, 7),
              1e5 * (0.3 - radius), 1e-8);
}

// A sliding tyre pulls with friction times load; the last patch at a place counts.
TEST(RoadPatches, GiveTheirFriction) {
  const auto pull_at = [](const std::string& road, double x, double y) {
    Model model = model_of(R"({ "mbgen": 1, "name": "sledge", "gravity": [0, 0, 0],
      "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
        "hub": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
      "joints": { "hub": { "type": "free", "from": "ground.O", "to": "hub.O" } }, )" +
                           kRubber + R"(, "roads": { "road": )" + road + R"( }, "tyres": { "tyre": { "centre": "hub.O",
        "data": "rubber", "stiffness": 4e4, "rolling_resistance": 0 } },
      "outputs": { "pull": { "tyre": "tyre", "quantity": "longitudinal_force" } } })");
    MechanismInState m(analysed(std::move(model)));
    m.set("hub_tx", x, 20);
    m.set("hub_ty", y, 0);
    m.set("hub_tz", 0.2, 0);
    m.state().x[0] = -0.1;
    return outputs_at(m.solver(), m.state(), std::vector<double>(6, 0.0))[0];
  };
  const double full = pull_at("{}", 0, 0);
  EXPECT_LT(full, -3000);
  const std::string road = R"({ "friction": "0.8 + 0*x", "patches": { "wet": { "friction": 0.6, "left": 0 },
    "ice": { "friction": 0.1, "from": 5, "length": 4 } } })";
  EXPECT_NEAR(pull_at("{ \"friction\": 0.5 }", 1, 0),
              pull_at("{ \"patches\": { \"all\": { \"friction\": 0.5 } } }", 1, 0), 1e-9);
  EXPECT_NEAR(pull_at(road, 1, 0.5), pull_at("{ \"friction\": 0.8 }", 1, 0.5), 1e-9);
  EXPECT_NEAR(pull_at(road, 1, -0.5), pull_at("{ \"friction\": 0.6 }", 1, 0.5), 1e-9);
  for (const double y : {0.5, -0.5}) EXPECT_NEAR(pull_at(road, 6, y), pull_at("{ \"friction\": 0.1 }", 1, 0.5), 1e-9);
  EXPECT_NEAR(pull_at("{ \"friction\": 1 }", 1, 0.5), full, 1e-9);
  EXPECT_GT(pull_at(road, 6, 0), 0.2 * full);
}

}  // namespace
}  // namespace mbgen
