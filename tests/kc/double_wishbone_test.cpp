// A double wishbone corner against its geometry in closed form: where the circles of both arms and the spheres of the
// tie rod put the knuckle. Derivatives by the complex step: Squire, Trapp, SIAM Review 40(1), 1998.

#include <array>
#include <complex>
#include <fstream>
#include <iterator>

#include "tests/kc/kc_support.hpp"

namespace mbgen::kc_test {
namespace {

using Complex = std::complex<double>;
template <class T>
using Vector = std::array<T, 3>;

template <class T, class U>
Vector<T> plus(const Vector<T>& a, const Vector<U>& b, T factor = T(1)) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T>
Vector<T> times(T factor, const Vector<T>& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
template <class T>
Vector<T> unit(const Vector<T>& a) {
  return times(T(1) / std::sqrt(dot(a, a)), a);
}
double real(double value) { return value; }
double real(const Complex& value) { return value.real(); }

template <class T>
Vector<T> as(const Vector<double>& a) {
  return {T(a[0]), T(a[1]), T(a[2])};
}

// Hardpoints of models/starters/double_wishbone.json.
constexpr Vector<double> kLowerFront = {0.15, 0.35, 0.2}, kLowerRear = {-0.15, 0.35, 0.2},
                         kLowerBall = {0.005, 0.7, 0.19};
constexpr Vector<double> kUpperFront = {0.12, 0.42, 0.48}, kUpperRear = {-0.12, 0.42, 0.48},
                         kUpperBall = {-0.02, 0.65, 0.5};
constexpr Vector<double> kRack = {-0.12, 0.32, 0.26}, kTieRod = {-0.13, 0.67, 0.27};
constexpr Vector<double> kStrut = {0, 0.58, 0.2}, kStrutTop = {0, 0.47, 0.7}, kHub = {0, 0.75, 0.31};
constexpr double kRadius = 0.31, kStiffness = 35e3, kPreload = 3900;

/// A point turned about a line.
template <class T>
Vector<T> turned(const Vector<double>& point, const Vector<double>& on_line, const Vector<double>& also, T angle) {
  const Vector<T> axis = unit(plus(as<T>(also), on_line, T(-1))), arm = plus(as<T>(point), on_line, T(-1));
  const Vector<T> along = times(dot(arm, axis), axis), across = plus(arm, along, T(-1));
  return plus(as<T>(on_line),
              plus(along, plus(times(std::cos(angle), across), times(std::sin(angle), cross(axis, across)))));
}

template <class T>
T distance(const Vector<T>& a, const Vector<T>& b) {
  const Vector<T> way = plus(a, b, T(-1));
  return std::sqrt(dot(way, way));
}

/// The angle of the upper arm that keeps its ball at a distance of the lower one: a cos + b sin = c, the root nearest
/// to zero.
template <class T>
T upper_angle(const Vector<T>& lower) {
  const Vector<T> axis = unit(plus(as<T>(kUpperFront), kUpperRear, T(-1)));
  const Vector<T> arm = plus(as<T>(kUpperBall), kUpperRear, T(-1)), along = times(dot(arm, axis), axis);
  const Vector<T> across = plus(arm, along, T(-1)), beside = cross(axis, across);
  const Vector<T> centre = plus(as<T>(kUpperRear), along), way = plus(centre, lower, T(-1));
  const double length = distance(kLowerBall, kUpperBall);
  const T a = T(2) * dot(way, across), b = T(2) * dot(way, beside);
  const T c = T(length * length) - dot(way, way) - dot(across, across);
  const T size = std::sqrt(a * a + b * b);
  // atan2(b, a) +- acos(c/size), both of values near a real one.
  const T first = std::atan(b / a) + (real(a) < 0 ? T(std::acos(-1.0)) : T(0)), second = std::acos(c / size);
  const T one = first - second, other = first + second;
  const auto wrapped = [](T angle) {
    return angle - T(2 * std::acos(-1.0) * std::round(real(angle) / (2 * std::acos(-1.0))));
  };
  return std::abs(real(wrapped(one))) < std::abs(real(wrapped(other))) ? wrapped(one) : wrapped(other);
}

/// The point at given distances from three others, on the side of the old one.
template <class T>
Vector<T> on_spheres(const std::array<Vector<T>, 3>& centres, const std::array<double, 3>& radii, double side) {
  const Vector<T> way = plus(centres[1], centres[0], T(-1)), ex = unit(way),
                  third = plus(centres[2], centres[0], T(-1));
  const T d = dot(way, ex), i = dot(third, ex);
  const Vector<T> ey = unit(plus(third, ex, -i)), ez = cross(ex, ey);
  const T j = dot(third, ey);
  const T x = (T(radii[0] * radii[0] - radii[1] * radii[1]) + d * d) / (T(2) * d);
  const T y = (T(radii[0] * radii[0] - radii[2] * radii[2]) + i * i + j * j - T(2) * i * x) / (T(2) * j);
  const T z = T(side) * std::sqrt(T(radii[0] * radii[0]) - x * x - y * y);
  return plus(plus(plus(centres[0], ex, x), ey, y), ez, z);
}

/// Side of the fourth point on the plane of the first three.
double side_of(const std::array<Vector<double>, 3>& centres, const Vector<double>& point) {
  const Vector<double> normal = cross(plus(centres[1], centres[0], -1.0), plus(centres[2], centres[0], -1.0));
  return dot(normal, plus(point, centres[0], -1.0)) > 0 ? 1 : -1;
}

/// The corner at an angle of the lower arm and a way of the rack.
template <class T>
struct Corner {
  Vector<T> lower, upper, tie_rod, hub, axis, strut;

  explicit Corner(T angle, T rack = T(0)) {
    lower = turned<T>(kLowerBall, kLowerRear, kLowerFront, angle);
    strut = turned<T>(kStrut, kLowerRear, kLowerFront, angle);
    upper = turned<T>(kUpperBall, kUpperRear, kUpperFront, upper_angle(lower));
    const Vector<T> inner = {T(kRack[0]), T(kRack[1]) + rack, T(kRack[2])};
    tie_rod = on_spheres<T>({lower, upper, inner},
                            {distance(kTieRod, kLowerBall), distance(kTieRod, kUpperBall), distance(kTieRod, kRack)},
                            side_of({kLowerBall, kUpperBall, kRack}, kTieRod));
    hub = carried(kHub);
    axis = plus(carried(plus(kHub, Vector<double>{0, 1, 0})), hub, T(-1));
  }

  /// A point of the knuckle, by its components in the triad of lower ball, upper ball and tie rod.
  Vector<T> carried(const Vector<double>& point) const {
    const auto triad = [](const auto& a, const auto& b, const auto& c) {
      using S = std::decay_t<decltype(a[0])>;
      const auto x = unit(plus(b, a, S(-1))), z = unit(cross(x, plus(c, a, S(-1))));
      return std::array{x, cross(z, x), z};
    };
    const auto home = triad(kLowerBall, kUpperBall, kTieRod);
    const auto now = triad(lower, upper, tie_rod);
    const Vector<double> arm = plus(point, kLowerBall, -1.0);
    Vector<T> result = lower;
    for (std::size_t k = 0; k < 3; ++k) result = plus(result, now[k], T(dot(arm, home[k])));
    return result;
  }

  T toe() const { return std::atan(axis[0] / axis[1]); }
  T camber() const { return -std::atan(axis[2] / std::sqrt(axis[0] * axis[0] + axis[1] * axis[1])); }
  T caster() const { return std::atan(-(upper[0] - lower[0]) / (upper[2] - lower[2])); }
  T kingpin() const { return std::atan(-(upper[1] - lower[1]) / (upper[2] - lower[2])); }
  Vector<T> forward() const { return unit(Vector<T>{axis[1], -axis[0], T(0)}); }
  Vector<T> patch() const { return plus(hub, cross(forward(), axis), T(-kRadius)); }
  Vector<T> from_patch_to_axis() const {
    const Vector<T> way = plus(upper, lower, T(-1)), p = patch();
    return plus(plus(lower, way, (p[2] - lower[2]) / way[2]), p, T(-1));
  }
  T trail() const { return dot(from_patch_to_axis(), forward()); }
  T scrub() const { return -dot(from_patch_to_axis(), Vector<T>{-forward()[1], forward()[0], T(0)}); }
  T spring() const { return distance(strut, as<T>(kStrutTop)); }
};

/// d f/d angle by the complex step, over d z of the hub.
template <class Read>
double over_travel(double angle, const Read& read) {
  constexpr double kStep = 1e-30;
  const Corner<Complex> corner(Complex(angle, kStep));
  return read(corner).imag() / corner.hub[2].imag();
}

std::string corner_text(const std::string& more) {
  return R"({"include": [")" + source_path("models/axles/double_wishbone.json") +
         R"("], "mbgen": 1, "gravity": [0, 0, 0])" + more + "}";
}

TEST(DoubleWishbone, PositionsAreThoseOfTheCirclesAndSpheres) {
  for (const double angle : {-0.28, -0.11, 0.07, 0.19, 0.31}) {
    const Corner<double> home(0), corner(angle);
    const double travel = corner.hub[2] - home.hub[2];
    const KcReport report = report_of_text(corner_text(""), {.travel = travel, .points = 3});
    const auto value = [&](const std::string& column) { return value_at(report, "parallel_travel", column, travel); };
    EXPECT_NEAR(value("toe_left"), corner.toe(), 1e-10) << angle;
    EXPECT_NEAR(value("camber_left"), corner.camber(), 1e-10);
    EXPECT_NEAR(value("caster_left"), corner.caster(), 1e-10);
    EXPECT_NEAR(value("kingpin_inclination_left"), corner.kingpin(), 1e-10);
    EXPECT_NEAR(value("caster_trail_left"), corner.trail(), 1e-10);
    EXPECT_NEAR(value("scrub_radius_left"), corner.scrub(), 1e-10);
    EXPECT_NEAR(value("centre_x_left"), corner.hub[0] - home.hub[0], 1e-10);
    EXPECT_NEAR(value("contact_y_left"), corner.patch()[1] - home.patch()[1], 1e-10);
    EXPECT_NEAR(value("track_change"), 2 * (corner.patch()[1] - home.patch()[1]), 1e-10);
    EXPECT_NEAR(value("wheelbase_change"), corner.patch()[0] - home.patch()[0], 1e-10);
  }
}

TEST(DoubleWishbone, GradientsAreDerivativesOfTheClosedForm) {
  for (const double angle : {-0.2, 0.0, 0.25}) {
    const Corner<double> home(0), corner(angle);
    const double travel = corner.hub[2] - home.hub[2];
    const KcReport report = report_of_text(corner_text(""), {.travel = angle == 0 ? 0.02 : travel, .points = 3});
    const auto value = [&](const std::string& column) { return value_at(report, "parallel_travel", column, travel); };
    const double compression = -over_travel(angle, [](const auto& c) { return c.spring(); });
    EXPECT_NEAR(value("ratio_strut"), compression, 1e-9);
    const double force = kPreload - kStiffness * (corner.spring() - home.spring());
    EXPECT_NEAR(value("load_left"), force * compression, 1e-9 * 3900);
    const double rise = over_travel(angle, [](const auto& c) { return c.patch()[2]; });
    const double sideways = over_travel(angle, [](const auto& c) { return c.patch()[1]; });
    EXPECT_NEAR(value("roll_centre_height"), corner.patch()[1] * sideways / rise, 1e-9);
    // Brakes on the carrier: the contact centre is carried with the knuckle, and does not stay below the hub.
    const Vector<double> p = corner.patch(), arm = plus(p, corner.hub, -1.0);
    constexpr double kStep = 1e-30;
    const Corner<Complex> moved(Complex(angle, kStep));
    Vector<double> way{};
    for (std::size_t k = 0; k < 3; ++k) way[k] = moved.hub[k].imag() / moved.hub[2].imag();
    // The arm in the triad of the knuckle now, carried with the moved one.
    const auto triad = [](const auto& c) {
      using S = std::decay_t<decltype(c.lower[0])>;
      const auto x = unit(plus(c.upper, c.lower, S(-1))), z = unit(cross(x, plus(c.tie_rod, c.lower, S(-1))));
      return std::array{x, cross(z, x), z};
    };
    const auto now = triad(corner);
    const auto then = triad(moved);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t e = 0; e < 3; ++e) way[k] += then[e][k].imag() / moved.hub[2].imag() * dot(arm, now[e]);
    EXPECT_NEAR(value("anti_dive"), 0.65 * way[0] / way[2] * 2.6 / 0.5, 1e-9);
    if (angle != 0) continue;
    EXPECT_NEAR(figure(report, "toe_gradient"), over_travel(angle, [](const auto& c) { return c.toe(); }), 1e-9);
    EXPECT_NEAR(figure(report, "camber_gradient"), over_travel(angle, [](const auto& c) { return c.camber(); }), 1e-9);
  }
}

TEST(DoubleWishbone, SteersByItsRack) {
  std::ifstream file(source_path("models/starters/double_wishbone.json"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace(R"("rods": { "tie_rod": { "from": "ground.rack")", R"("rods": { "tie_rod": { "from": "rack.rack")");
  replace(R"("ground": {},)", R"("ground": {}, "rack": { "mass": 1, "inertia": [1, 1, 1], "com": [-0.12, 0, 0.26] },)");
  replace("\"joints\": {", R"json("motions": { "rack": { "joint": "rack", "position": "0.01*sin(t)" } },
  "axles": { "front": { "left": { "centre": "wheel.hub", "radius": 0.31,
    "steering_axis": ["knuckle.lower_ball", "knuckle.upper_ball"] }, "steer": "rack", "wheelbase": 2.6, "without": ["road"] } },
  "joints": { "rack": { "type": "prismatic", "from": "ground.rack", "to": "rack.rack", "axis": "y" },)json");
  const KcReport report = report_of_text(text, {.steer = 0.02, .points = 3});
  // The lower arm turns so that the hub stays at its height: Newton's steps on the closed form.
  const auto at_height = [](double way) {
    double angle = 0;
    for (int step = 0; step < 20; ++step) {
      const Corner<Complex> corner(Complex(angle, 1e-30), Complex(way));
      angle -= (corner.hub[2].real() - kHub[2]) / (corner.hub[2].imag() / 1e-30);
    }
    return Corner<double>(angle, way);
  };
  const Corner<double> out = at_height(0.02), in = at_height(-0.02);
  EXPECT_NEAR(value_at(report, "steering", "steer_angle_left", 0.02), -out.toe(), 1e-10);
  EXPECT_NEAR(value_at(report, "steering", "steer_angle_left", -0.02), -in.toe(), 1e-10);
  EXPECT_NEAR(value_at(report, "steering", "camber_left", 0.02), out.camber(), 1e-10);
  // The right wheel is the mirror at the other steering; the rods are behind the axis: the rack to the left steers
  // right.
  const double left = -out.toe(), right = in.toe();
  ASSERT_LT(left, 0);
  const double inner = -right, outer = -left, track = 2 * 0.75;
  const double ideal = std::atan(1 / (1 / std::tan(inner) + track / 2.6));
  EXPECT_NEAR(value_at(report, "steering", "ackermann", 0.02), (inner - outer) / (inner - ideal), 1e-8);
  const Corner<Complex> by_angle(Complex(0, 1e-30)), by_rack(Complex(0), Complex(0, 1e-30));
  const double share = by_rack.hub[2].imag() / by_angle.hub[2].imag();
  const double rate = -(by_rack.toe().imag() - share * by_angle.toe().imag()) / 1e-30;
  EXPECT_NEAR(figure(report, "steer_ratio"), 1 / rate, 1e-9);
}

}  // namespace
}  // namespace mbgen::kc_test
