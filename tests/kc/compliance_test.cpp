// Compliance matrices of wheels: against closed forms, other figures and each other.

#include "compiler/model/vectors.hpp"
#include "tests/kc/kc_support.hpp"

namespace mbgen::kc_test {
namespace {

const KcMatrix& matrix(const KcReport& report, const std::string& name) {
  for (const KcMatrix& one : report.matrices)
    if (one.name == name) return one;
  throw std::out_of_range("no matrix " + name);
}

double element(const KcMatrix& of, const std::string& row, const std::string& column) {
  const auto place = [](const std::vector<Heading>& headings, const std::string& name) {
    for (std::size_t i = 0; i < headings.size(); ++i)
      if (headings[i].name == name) return i;
    throw std::out_of_range("no heading " + name);
  };
  return of.values[place(of.rows, row)][place(of.columns, column)];
}

// A wheel held by one bushing on its body, behind and inside of its centre.
constexpr const char* kOnABushing = R"({ "mbgen": 1, "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "b": [-0.1, 0.5, 0.35], "o": [0, 0.7, 0.3] } },
    "wheel": { "mass": 20, "com": [0, 0.7, 0.3], "inertia": [1, 1, 1],
      "points": { "b": [-0.1, 0.5, 0.35], "o": [0, 0.7, 0.3] } } },
  "joints": { "wheel": { "type": "free", "from": "ground.o", "to": "wheel.o" } },
  "bushings": { "mount": { "from": "ground.b", "to": "wheel.b",
    "tx": { "stiffness": 1e6 }, "ty": { "stiffness": 2e6 }, "tz": { "stiffness": 3e5 },
    "rx": { "stiffness": 4000 }, "ry": { "stiffness": 7000 }, "rz": { "stiffness": 5000 } } },
  "axles": { "front": { "left": { "centre": "wheel.o", "radius": 0.3 } } } })";

/// Displacement (3) and rotation (3) of a point of the wheel under a unit load there, by the bushing's six springs.
std::array<double, 6> on_the_bushing(const Vector3& point, int load) {
  const Vector3 bushing = {-0.1, 0.5, 0.35};
  const Vector3 arm = {point[0] - bushing[0], point[1] - bushing[1], point[2] - bushing[2]};
  Vector3 force{}, moment{};
  (load < 3 ? force : moment)[static_cast<std::size_t>(load % 3)] = 1;
  const Vector3 more = cross(arm, force);
  const double turn_rates[] = {4000, 7000, 5000}, rates[] = {1e6, 2e6, 3e5};
  Vector3 turn, way;
  for (std::size_t i = 0; i < 3; ++i) turn[i] = (moment[i] + more[i]) / turn_rates[i];
  const Vector3 carried = cross(turn, arm);
  for (std::size_t i = 0; i < 3; ++i) way[i] = force[i] / rates[i] + carried[i];
  return {way[0], way[1], way[2], turn[0], turn[1], turn[2]};
}

constexpr const char* kWays[] = {"x", "y", "z", "rotation_x", "rotation_y", "rotation_z"};
constexpr const char* kLoadsOf[] = {"fx", "fy", "fz", "mx", "my", "mz"};

TEST(ComplianceMatrix, IsThatOfAWheelOnABushing) {
  const KcReport report = report_of_text(kOnABushing, {.travel = 0.001, .points = 3});
  ASSERT_EQ(report.matrices.size(), 4u);
  for (const auto& [name, point] :
       {std::pair<std::string, Vector3>{"centre", {0, 0.7, 0.3}}, {"contact", {0, 0.7, 0}}}) {
    const KcMatrix& free = matrix(report, name);
    ASSERT_EQ(free.columns.size(), 6u);
    ASSERT_EQ(free.rows.size(), 9u);
    for (int load = 0; load < 6; ++load) {
      const std::array<double, 6> expected = on_the_bushing(point, load);
      const std::string column = std::string(kLoadsOf[load]) + "_left";
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(element(free, std::string(kWays[i]) + "_left", column), expected[i], 1e-9 * 1e-3)
            << name << kWays[i] << column;
      // Steer angle, camber and wind-up of a left wheel that stands straight: about z, minus x, and y.
      EXPECT_NEAR(element(free, "steer_angle_left", column), expected[5], 1e-12);
      EXPECT_NEAR(element(free, "camber_left", column), -expected[3], 1e-12);
      EXPECT_NEAR(element(free, "wind_up_left", column), expected[4], 1e-12);
    }
  }
  // Held at its height, the wheel bears the vertical force that undoes its rise.
  const KcMatrix& held = matrix(report, "centre_held");
  ASSERT_EQ(held.columns.size(), 5u);
  const std::array<double, 6> up = on_the_bushing({0, 0.7, 0.3}, 2);
  for (const int load : {0, 1, 3, 4, 5}) {
    const std::array<double, 6> at = on_the_bushing({0, 0.7, 0.3}, load);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(element(held, std::string(kWays[i]) + "_left", std::string(kLoadsOf[load]) + "_left"),
                  at[i] - up[i] * at[2] / up[2], 1e-12)
          << kWays[i] << load;
  }
}

/// Two corners in rubber, the hubs coupled by a spring across.
std::string coupled_corners() {
  const std::string corner = source_path("models/rubber_wishbone.json");
  return R"({"mbgen": 1, "initial": { "equilibrium": true }, "instances": {
      "l": { "file": ")" +
         corner + R"(", "suffix": "_l" },
      "r": { "file": ")" +
         corner + R"(", "suffix": "_r", "mirror": "xz" } },
    "springs": { "across": { "from": "wheel_l.hub", "to": "wheel_r.hub", "stiffness": 2e5, "free_length": 1.4 } },
    "axles": { "front": { "left": { "centre": "wheel_l.hub", "radius": 0.31 },
      "right": { "centre": "wheel_r.hub", "radius": 0.31 }, "without": ["road_l", "road_r"] } } })";
}

/// Size of a way or turn by a force or moment: mixed ones are compared over a lever of 0.3 m.
double size_of(const KcMatrix& of, std::size_t row, std::size_t column) {
  constexpr double kSoft = 1e-6, kLever = 0.3;  // m/N
  return kSoft / (of.rows[row].unit == "rad" ? kLever : 1) / (of.columns[column].unit == "N m" ? kLever : 1);
}

// Maxwell and Betti: displacement i by load k is displacement k by load i, left and right alike.
TEST(ComplianceMatrix, IsSymmetricLeftAndRight) {
  const KcReport report = report_of_text(coupled_corners(), {.travel = 0.001, .points = 3});
  double cross_term = 0;
  for (const std::string name : {"centre", "contact", "centre_held", "contact_held"}) {
    const KcMatrix& of = matrix(report, name);
    const bool is_held = name.ends_with("_held");
    for (const std::string a : {"left", "right"}) {
      for (const std::string b : {"left", "right"}) {
        for (std::size_t i = 0; i < 6; ++i) {
          for (std::size_t k = 0; k < 6; ++k) {
            if (is_held && (i == 2 || k == 2)) continue;
            const double one = element(of, std::string(kWays[i]) + "_" + a, std::string(kLoadsOf[k]) + "_" + b);
            const double other = element(of, std::string(kWays[k]) + "_" + b, std::string(kLoadsOf[i]) + "_" + a);
            const double size = size_of(of, i, k < 3 ? 0 : of.columns.size() / 4 - 1);
            EXPECT_NEAR(one, other, 1e-8 * size)
                << name << ' ' << kWays[i] << '_' << a << ' ' << kLoadsOf[k] << '_' << b;
            if (a != b) cross_term = std::max(cross_term, std::abs(one) / size);
          }
        }
      }
    }
    for (std::size_t row = 0; row < of.rows.size(); ++row) {
      const std::size_t loads = of.columns.size() / 4;
      for (std::size_t k = 0; k < loads; ++k) {
        const double left = of.values[row][k], right = of.values[row][loads + k], size = size_of(of, row, k);
        EXPECT_NEAR(of.values[row][2 * loads + k], left + right, 1e-12 * size);
        EXPECT_NEAR(of.values[row][3 * loads + k], left - right, 1e-12 * size);
      }
    }
  }
  EXPECT_GT(cross_term, 1e-3) << "the spring across couples the wheels";
}

// The rise by a vertical load is that of the wheel rates; held wheels under a load have the figures of the curves.
TEST(ComplianceMatrix, AgreesWithRatesAndGradients) {
  const KcReport report = report_of_text(coupled_corners(), {.travel = 0.001, .points = 3});
  const KcMatrix& free = matrix(report, "centre");
  for (const std::size_t which : {0, 1}) {
    const std::string side = which == 0 ? "_left" : "_right";
    const double rise = element(free, "z" + side, "fz_both");
    EXPECT_NEAR(rise * figure(report, "wheel_rate", which), 1, 1e-9);
    const double roll = element(free, "z" + side, "fz_opposite") * (which == 0 ? 1 : -1);
    EXPECT_NEAR(roll * figure(report, "wheel_rate_roll", which), 1, 1e-9);
    EXPECT_NEAR(element(free, "camber" + side, "fz_both"), figure(report, "camber_gradient", which) * rise,
                1e-9 * std::abs(rise));
  }
  const KcMatrix& held = matrix(report, "contact_held");
  EXPECT_NEAR(element(held, "steer_angle_left", "mz_both"), figure(report, "steer_by_aligning_moment", 0), 1e-15);
  EXPECT_NEAR(element(held, "camber_right", "mz_both"), figure(report, "camber_by_aligning_moment", 1), 1e-15);
}

TEST(ComplianceMatrix, IsShownInTextFilesAndJson) {
  const KcReport report = report_of_text(kOnABushing, {.travel = 0.001, .points = 3});
  const std::string text = kc_matrix_text(report, "centre");
  // A steer angle of 1/5000 rad per N m is 11.459 deg/(kN m).
  EXPECT_NE(text.find("Compliance: loads at the wheel centre, wheel centres free\n"
                      "  left wheel by loads at the left wheel\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("mz [kN m]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("11.459\n"), std::string::npos) << text;
  const std::vector<NamedText> files = kc_files(report);
  const auto file = std::find_if(files.begin(), files.end(),
                                 [](const NamedText& one) { return one.path == "front_compliance_contact.csv"; });
  ASSERT_NE(file, files.end());
  EXPECT_EQ(
      file->text.find("row,fx_left [N],fy_left [N],fz_left [N],mx_left [N m],my_left [N m],mz_left [N m]\nx_left [m],"),
      0u)
      << file->text;
  EXPECT_NE(files.back().text.find("<h2>Compliance</h2>"), std::string::npos);
  const auto json = kc_json(report)["compliance"]["centre"];
  EXPECT_NEAR(json["values"][5][5].get<double>(), 1.0 / 5000, 1e-15);
  EXPECT_EQ(json["rows"][5]["name"], "rotation_z_left");
}

TEST(ComplianceMatrix, OfWheelsWithoutASpringIsThatOfHeldOnes) {
  std::string text = kOnABushing;
  const std::string spring = R"("tz": { "stiffness": 3e5 },)";
  text.erase(text.find(spring), spring.size());
  const KcReport report = report_of_text(text, {.travel = 0.001, .points = 3});
  EXPECT_EQ(report.matrices.size(), 2u);
  try {
    kc_matrix_text(report, "contact");
    ADD_FAILURE() << "there is none";
  } catch (const UserError& error) {
    EXPECT_STREQ(
        error.what(),
        "--compliance contact: no spring carries the wheels of axle front, which have no compliance while they "
        "are free\n  hint: ask for contact_held\n");
  }
}

}  // namespace
}  // namespace mbgen::kc_test
