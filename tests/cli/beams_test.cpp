// Beams of bodies and elastic connections against Euler-Bernoulli theory, a rotating beam and a ladder frame. Sources
// of the numbers: roots of the frequency equations; Ritz solutions of the rotating cantilever in 40 digits; a finite
// element model of the frame by numpy (the project's reference data flex_beams.json and flex_frame.json).

#include <cmath>
#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A round steel beam along x, slender: r/l = 0.0025.
constexpr double kBeamLength = 2, kBeamDiameter = 0.02, kBeamYoungs = 210e9, kBeamDensity = 7850;

class Beams : public CommandLine {
 protected:
  void write_beam(int segments, const std::string& supports, const std::string& more = "",
                  const std::string& bodies = "") const {
    write("beam.json", fmt::format(R"({{ "mbgen": 1, "name": "beam", "gravity": [0, 0, 0],
        "bodies": {{ "ground": {{}}{} }},
        "beams": {{ "rod": {{ "points": {{ "a": [0, 0, 0], "b": [{}, 0, 0] }}, "segments": {},
          "section": {{ "shape": "round", "diameter": {} }}, "supports": {{ {} }} }} }}{} }})",
                                   bodies, kBeamLength, segments, kBeamDiameter, supports, more));
  }
  /// Frequencies, Hz, of modes that oscillate, slowest first; bending has each twice.
  std::vector<double> frequencies(const std::string& more = "") const {
    std::vector<double> list;
    const Json linear = json_of("linearize beam.json --slowest-first --json " + more);
    for (const Json& mode : linear["modes"])
      if (mode["eigenvalue"][1].get<double>() > 1e-3)
        list.push_back(mode["eigenvalue"][1].get<double>() / (2 * std::numbers::pi));
    return list;
  }
  /// sqrt(EI/(rho A l^4)), rad/s.
  static double unit() {
    return std::sqrt(kBeamYoungs / kBeamDensity) * kBeamDiameter / 4 / (kBeamLength * kBeamLength);
  }
};

const std::string kWelded = R"("a": { "body": "ground" })", kPinned = R"("a": { "body": "ground", "type": "pinned" })",
                  kWeldedEnd = R"(, "b": { "body": "ground" })",
                  kPinnedEnd = R"(, "b": { "body": "ground", "type": "pinned" })";

TEST_F(Beams, EightSegmentsHaveTheFirstModesOfSixPairsOfEnds) {
  struct Ends {
    std::string supports;
    double roots[2];
  };
  const Ends all[] = {{kWelded, {1.875104068711961, 4.694091132974175}},
                      {kWelded + kWeldedEnd, {4.730040744862704, 7.853204624095838}},
                      {"", {4.730040744862704, 7.853204624095838}},
                      {kWelded + kPinnedEnd, {3.926602312047919, 7.068582745628732}},
                      {kPinned, {3.926602312047919, 7.068582745628732}},
                      {kPinned + kPinnedEnd, {3.141592653589793, 6.283185307179586}}};
  for (const Ends& ends : all) {
    double before = 0;
    for (const int segments : {4, 8}) {
      write_beam(segments, ends.supports);
      const std::vector<double> found = frequencies();
      double worst = 0;
      for (std::size_t mode = 0; mode < 2; ++mode) {
        const double exact = ends.roots[mode] * ends.roots[mode] * unit() / (2 * std::numbers::pi);
        worst = std::max(worst, std::abs(found.at(2 * mode) / exact - 1));
        EXPECT_NEAR(found.at(2 * mode + 1), found.at(2 * mode), 1e-6 * exact) << "both planes";
      }
      if (segments == 8) {
        EXPECT_LT(worst, 0.01) << ends.supports;
        EXPECT_LT(worst, before / 3.5) << ends.supports;
      }
      before = worst;
    }
  }
}

TEST_F(Beams, TipMassesLowerTheFrequencies) {
  const double mass = kBeamDensity * std::numbers::pi / 4 * kBeamDiameter * kBeamDiameter * kBeamLength;
  const double rows[][3] = {{0.1, 1.722741520593259, 4.399522816156012},
                            {1, 1.247917409606469, 4.03113943671496},
                            {10, 0.7357819193896505, 3.938465833251813}};
  for (const auto& [ratio, first, second] : rows) {
    write_beam(
        8, kWelded, R"(, "joints": { "load": { "type": "fixed", "from": "rod_b.rod_b", "to": "load.rod_b" } })",
        fmt::format(R"(, "load": {{ "mass": {}, "com": [2, 0, 0], "inertia": [1e-9, 1e-9, 1e-9] }})", ratio * mass));
    const std::vector<double> found = frequencies();
    EXPECT_NEAR(found[0], first * first * unit() / (2 * std::numbers::pi), 0.01 * found[0]) << ratio;
    EXPECT_NEAR(found[2], second * second * unit() / (2 * std::numbers::pi), 0.01 * found[2]) << ratio;
  }
}

// (2 n - 1) pi/2 c / l with the speed of sound sqrt(E/rho) or sqrt(G/rho): n bodies err by (2 n - 1)^2 pi^2/96 N^2.
TEST_F(Beams, StretchAndTwistAreWaves) {
  write_beam(8, kWelded);
  const std::vector<double> found = frequencies();
  for (const double modulus : {kBeamYoungs, 80.8e9}) {
    const double exact = std::sqrt(modulus / kBeamDensity) / (4 * kBeamLength);
    double nearest = 1;
    for (const double one : found) nearest = std::min(nearest, std::abs(one / exact - 1));
    EXPECT_LT(nearest, 2e-3) << exact;
  }
}

TEST_F(Beams, StaticDeflectionsAreThoseOfTheBeam) {
  // A hinge at one end and a weld at the other, own weight: M = q l^2 / 8 at the weld; here the deflection of a
  // cantilever.
  write_beam(8, kWelded, R"(, "outputs": { "sag": { "point": "rod_b.rod_b", "quantity": "position", "axis": "z" },
      "twist": { "body": "rod_b", "quantity": "rotation_vector", "axis": "x" } },
      "forces": { "load": { "at": "rod_b.rod_b", "force": [0, 0, -5] }, "turn": { "at": "rod_b.rod_b", "torque": [3, 0, 0] } })");
  const Json outputs = json_of("equilibrium beam.json --json")["outputs"];
  const double second = std::numbers::pi / 64 * std::pow(kBeamDiameter, 4);
  EXPECT_NEAR(outputs["sag"].get<double>(), -5 * 8 / (3 * kBeamYoungs * second), 2e-5);
  EXPECT_NEAR(outputs["twist"].get<double>(), 3 * kBeamLength / (80.8e9 * 2 * second), 1e-5);
}

// A cantilever on a hub that turns about z at a constant rate: flap out of the plane of rotation, lag in it.
TEST_F(Beams, RotationStiffensTheBeam) {
  struct Row {
    double gamma, flap[2], lag;
  };
  const Row rows[] = {{2, {4.13731957303, 22.6149219565}, 3.62179696412},
                      {6, {7.36037301931, 26.8090816785}, 4.26322542019}};
  for (const Row& row : rows) {
    write("beam.json", fmt::format(R"({{ "mbgen": 1, "name": "blade", "gravity": [0, 0, 0],
        "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
          "hub": {{ "mass": 1e4, "inertia": [1e7, 1e7, 1e7], "points": {{ "O": [0, 0, 0] }} }} }},
        "joints": {{ "hub": {{ "type": "revolute", "from": "ground.O", "to": "hub.O", "axis": "z" }} }},
        "beams": {{ "rod": {{ "points": {{ "a": [0, 0, 0], "b": [{}, 0, 0] }}, "segments": 8,
          "section": {{ "shape": "round", "diameter": {} }}, "supports": {{ "a": {{ "body": "hub" }} }} }} }},
        "initial": {{ "velocities": {{ "hub": {} }} }} }})",
                                   kBeamLength, kBeamDiameter, row.gamma * unit()));
    const std::vector<double> found = frequencies(fmt::format("--at steady --hold hub={}", row.gamma * unit()));
    const auto nearest = [&](double exact) {
      double best = 1;
      for (const double one : found) best = std::min(best, std::abs(one * 2 * std::numbers::pi / (exact * unit()) - 1));
      return best;
    };
    EXPECT_LT(nearest(row.flap[0]), 0.01) << row.gamma;
    EXPECT_LT(nearest(row.flap[1]), 0.01) << row.gamma;
    EXPECT_LT(nearest(row.lag), 0.015) << row.gamma;
  }
}

/// The ladder frame of the reference: two rails of eight segments, five cross members through a raised middle.
/// supports: of both rails.
std::string ladder_frame(const std::string& supports = "") {
  std::string beams;
  for (const double side : {0.43, -0.43}) {
    std::string points;
    for (int i = 0; i <= 8; ++i)
      points += fmt::format(R"({}"{}": [{}, {}, 0])", i == 0 ? "" : ", ", fmt::format("p{}", i), 0.9 * i, side);
    beams += fmt::format(R"("{}": {{ "points": {{ {} }}, "segments": 8,
        "section": {{ "shape": "general", "A": 0.0034, "Iy": 3.6e-5, "Iz": 1.9e-6, "J": 7.2e-8 }},
        "supports": {{ {} }} }}, )",
                         side > 0 ? "left" : "right", points, supports);
  }
  for (int i = 0; i <= 8; i += 2)
    beams += fmt::format(
        R"({}"cross{}": {{ "points": {{ "l": [{}, 0.43, 0], "m": [{}, 0, 0.12], "r": [{}, -0.43, 0] }}, "segments": 2,
        "section": {{ "shape": "general", "A": 0.0019, "Iy": 4.1e-6, "Iz": 3.2e-6, "J": 5.6e-6 }},
        "supports": {{ "l": {{ "body": "left_p{}" }}, "r": {{ "body": "right_p{}" }} }} }})",
        i == 0 ? "" : ", ", i, 0.9 * i, 0.9 * i, 0.9 * i, i, i);
  return beams;
}

TEST_F(Beams, ALadderFrameTwistsAndSags) {
  // Soft springs hold the directions that the supports leave free.
  std::string soft;
  for (const char* freedom : {"tx", "ty", "tz", "rx", "ry", "rz"})
    soft += fmt::format(R"({}"{}": {{ "stiffness": 0.01 }})", soft.empty() ? "" : ", ", freedom);
  const auto frame = [&](const std::string& gravity, const std::string& more, const std::vector<std::string>& held) {
    std::string joints;
    for (const std::string& body : held)
      joints +=
          fmt::format(R"({}"on_{}": {{ "type": "point_on_plane", "from": "ground.{}", "to": "{}.{}", "axis": "z" }})",
                      joints.empty() ? "" : ", ", body, body, body, body);
    write("frame.json",
          fmt::format(R"({{ "mbgen": 1, "name": "frame", "gravity": [0, 0, {}], "bodies": {{ "ground": {{}} }},
        "beams": {{ {} }}, "joints": {{ {} }},
        "bushings": {{ "soft": {{ "from": "ground.cross4_m", "to": "cross4_m.cross4_m", {} }} }}{} }})",
                      gravity, ladder_frame(), joints, soft, more));
    return json_of("equilibrium frame.json --json")["outputs"];
  };
  const Json twisted = frame("0", R"(, "forces": { "l": { "at": "left_p0.left_p0", "force": [0, 0, 100] },
        "r": { "at": "right_p0.right_p0", "force": [0, 0, -100] } },
      "outputs": { "l": { "point": "left_p0.left_p0", "quantity": "position", "axis": "z" },
        "r": { "point": "right_p0.right_p0", "quantity": "position", "axis": "z" } })",
                             {"left_p8", "right_p8"});
  const double twist = (twisted["l"].get<double>() - twisted["r"].get<double>()) / 0.86;
  EXPECT_NEAR(100 * 0.86 / twist, 37254.82683439959, 0.005 * 37254.8);
  std::string outputs = R"("rear": { "reaction": "on_left_p2", "quantity": "force", "axis": "z" },
      "front": { "reaction": "on_right_p7", "quantity": "force", "axis": "z" })";
  const std::pair<const char*, double> sags[] = {{"left_p0", -1.8222580946717615e-05},
                                                 {"left_p4", -8.202469878686606e-05},
                                                 {"right_p4", -8.202469878686118e-05},
                                                 {"left_p8", 5.1982479752926735e-05},
                                                 {"cross4_m", 0.12 - 8.3331983272955e-05}};
  for (const auto& [point, sag] : sags)
    outputs += fmt::format(R"(, "{0}": {{ "point": "{0}.{0}", "quantity": "position", "axis": "z" }})", point);
  const Json sagged =
      frame("-9.81", fmt::format(R"(, "outputs": {{ {} }})", outputs), {"left_p2", "right_p2", "left_p7", "right_p7"});
  for (const auto& [point, sag] : sags) EXPECT_NEAR(sagged[point].get<double>(), sag, 1e-5 * 8.2e-5) << point;
  EXPECT_NEAR(sagged["rear"].get<double>(), 1327.0607299459114, 1e-6 * 1327);
  EXPECT_NEAR(sagged["front"].get<double>(), 884.7071532972608, 1e-6 * 885);
}

// Consistent masses and whole beams against nodes with half of their segments: the frame twists first, then bends.
TEST_F(Beams, ALadderFrameVibratesFreely) {
  write("beam.json",
        fmt::format(R"({{ "mbgen": 1, "name": "frame", "gravity": [0, 0, 0], "bodies": {{ "ground": {{}} }},
        "beams": {{ {} }} }})",
                    ladder_frame()));
  const std::vector<double> found = frequencies();
  EXPECT_NEAR(found.at(0), 11.4841231384, 0.007 * 11.48);
  EXPECT_NEAR(found.at(1), 24.6119187432, 0.007 * 24.6);
  EXPECT_NEAR(found.at(2), 31.7008118091, 0.007 * 31.7);
}

// Welded at the interface nodes of the reference's component modes. Further ones are of single cross members, which are
// one or two elements there.
TEST_F(Beams, ALadderFrameVibratesOnItsMounts) {
  write("beam.json",
        fmt::format(R"({{ "mbgen": 1, "name": "frame", "gravity": [0, 0, 0], "bodies": {{ "ground": {{}} }},
        "beams": {{ {} }} }})",
                    ladder_frame(R"("p2": { "body": "ground" }, "p7": { "body": "ground" })")));
  const std::vector<double> found = frequencies();
  EXPECT_NEAR(found.at(0), 26.9892156297, 0.005 * 27);
  EXPECT_NEAR(found.at(1), 27.6036295012, 0.005 * 27.6);
  double mass = 0;
  const Json checked = json_of("check beam.json --json");
  for (const Json& beam : checked["beams"]) mass += beam["mass"].get<double>();
  EXPECT_NEAR(mass, 450.9210771137947, 1e-9 * 451);
}

TEST_F(Beams, CheckTellsTheirFrequencies) {
  write_beam(3, kWelded);
  const Outcome checked = mbgen("check beam.json");
  EXPECT_NE(checked.out.find("  beam rod: 3 segments, 2 m, 4.932 kg, welded-free\n    bending about y: "),
            std::string::npos)
      << checked.out;
  const Json beam = json_of("check beam.json --json")["beams"][0];
  EXPECT_EQ(beam["bending"][0]["segments_for_1_percent"], 5);
  EXPECT_NEAR(beam["bending"][0]["frequency"][1].get<double>(), frequencies()[2], 1e-4 * frequencies()[2]);
}

// The energy of a swinging beam is constant with implicit steps of 1 ms, and falls with damping.
TEST_F(Beams, EnginesAgreeOnASwingingBeam) {
  write("beam.json", R"({ "mbgen": 1, "name": "swing",
      "bodies": { "ground": {} },
      "beams": { "rod": { "points": { "a": [0, 0, 0], "m": [0.5, 0, 0], "b": [1, 0.2, 0] }, "segments": 3, "damping": 1e-4,
        "section": { "shape": "tube", "diameter": 0.01, "wall": 0.002 }, "material": { "E": 3e9, "G": 1e9, "density": 1200 },
        "supports": { "a": { "body": "ground", "type": "hinge", "axis": "y" } } } },
      "outputs": { "tip": { "point": "rod_b.rod_b", "quantity": "position", "axis": "z" } },
      "solver": { "step": 1e-4, "duration": 0.05 } })");
  std::vector<double> tips;
  for (const char* engine : {"generic", "augmented", "generated"}) {
    const Outcome run =
        mbgen(fmt::format("simulate beam.json --engine {} --step 2e-5 --every 100 --out {}.csv", engine, engine));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    tips.push_back(table(std::string(engine) + ".csv").last("tip [m]"));
  }
  EXPECT_LT(tips[0], -1e-3);
  EXPECT_NEAR(tips[1], tips[0], 1e-8);
  EXPECT_NEAR(tips[2], tips[0], 1e-10);
}

}  // namespace
}  // namespace mbgen::cli_test
