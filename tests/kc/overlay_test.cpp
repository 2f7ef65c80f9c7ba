// Several axles, variants, measured points, and a steering wheel that a rack follows.

#include "compiler/text/user_error.hpp"
#include "tests/kc/kc_support.hpp"
#include "workbench/results/results.hpp"

namespace mbgen::kc_test {
namespace {

/// A wheel on an upright slide over a spring, steered about an upright kingpin by an input over a curved gear.
std::string steered(const std::string& steer, double stiffness = 20000) {
  return R"({ "mbgen": 1, "name": "hand", "gravity": [0, 0, 0],
  "inputs": { "hand": { "unit": "rad" }, "degrees": { "unit": "deg" } },
  "bodies": {
    "ground": { "points": { "o": [0, 0.6, 0.3], "top": [0, 0.6, 0.8] } },
    "slider": { "mass": 5, "com": [0, 0.6, 0.3], "inertia": [1, 1, 1], "points": { "o": [0, 0.6, 0.3] } },
    "hub": { "mass": 10, "com": [0, 0.7, 0.3], "inertia": [1, 1, 1], "points": { "o": [0, 0.6, 0.3], "c": [0, 0.7, 0.3] } } },
  "joints": {
    "slider": { "type": "prismatic", "from": "ground.o", "to": "slider.o", "axis": "z" },
    "kingpin": { "type": "revolute", "from": "slider.o", "to": "hub.o", "axis": "z" } },
  "motions": { "gear": { "joint": "kingpin", "angle": "0.0625*hand + 0.002*hand^3 + 0.001*degrees" } },
  "springs": { "coil": { "from": "ground.top", "to": "slider.o", "stiffness": )" +
         std::to_string(stiffness) + R"( } },
  "axles": { "front": { "left": { "centre": "hub.c", "radius": 0.3 }, "steer": ")" +
         steer + R"(" } } })";
}

TEST(SteeringInput, GivesTheRatioOfTheSteeringWheel) {
  const KcReport report = report_of_text(steered("hand"), {.travel = 0.01, .steer = 2, .points = 9});
  EXPECT_NEAR(figure(report, "steer_ratio"), 16, 1e-9);
  const KcTable& steering = table(report, "steering");
  EXPECT_EQ(steering.columns.front().heading.name, "steer");
  EXPECT_EQ(steering.columns.front().heading.unit, "rad");
  for (const double hand : {-2.0, -1.0, 0.0, 1.5, 2.0}) {
    EXPECT_NEAR(value_at(report, "steering", "steer_angle_left", hand), 0.0625 * hand + 0.002 * hand * hand * hand,
                1e-12);
    // The other wheel is the mirror image, steered by the same angle.
    EXPECT_NEAR(value_at(report, "steering", "steer_ratio", hand), 1 / (0.0625 + 0.006 * hand * hand), 1e-8);
  }
  // As far as the ratio at the start turns the wheels by 0.3 rad.
  EXPECT_NEAR(table(report_of_text(steered("hand"), {.points = 3}), "steering").columns.front().values.back(), 4.8,
              1e-9);
  // From the input's value on: the slope there.
  const Compilation compilation = expect(decide(expect(read_model(steered("hand"), "hand.json"))));
  StateArguments at;
  at.at = "initial";
  at.inputs = {"hand=1"};
  const KcReport turned = kinematics_and_compliance(compilation, find_axle(compilation.model, ""),
                                                    operating_point(compilation, at).point, {.steer = 1, .points = 3});
  EXPECT_NEAR(figure(turned, "steer_ratio"), 1 / 0.0685, 1e-8);
  EXPECT_NEAR(value_at(turned, "steering", "steer_angle_left", 1), 0.125 + 0.016, 1e-12);
}

TEST(SteeringInput, InDegreesHasARatioOfAngles) {
  const KcReport report = report_of_text(steered("degrees"), {.travel = 0.01, .points = 3});
  EXPECT_NEAR(figure(report, "steer_ratio"), 1000 * 0.017453292519943295, 1e-9);
  EXPECT_EQ(table(report, "steering").columns.front().heading.unit, "deg");
}

TEST(Axles, OfOneCallShareADirectory) {
  const Compilation compilation = expect(decide(expect(read_model_file(source_path("models/axles/coach.json")))));
  const std::vector<const Axle*> all = find_axles(compilation.model, {});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1]->name, "rear");
  EXPECT_EQ(find_axles(compilation.model, {"rear", "rear"}).size(), 1u);
  StateArguments at;
  at.at = "initial";
  std::vector<KcReport> reports;
  for (const Axle* axle : all)
    reports.push_back(kinematics_and_compliance(compilation, *axle, operating_point(compilation, at).point,
                                                {.travel = 0.02, .points = 3}));
  const std::vector<NamedText> files = kc_files(reports);
  const auto has = [&](const std::string& path) {
    return std::any_of(files.begin(), files.end(), [&](const NamedText& file) { return file.path == path; });
  };
  for (const char* path : {"front.html", "rear.html", "front_parallel_travel.svg", "rear_parallel_travel.csv"})
    EXPECT_TRUE(has(path)) << path;
  ASSERT_EQ(files.back().path, "index.html");
  EXPECT_NE(files.back().text.find("<a href=\"rear.html\">rear</a>"), std::string::npos);
  EXPECT_NE(files.back().text.find("<th>wheel_rate</th><td>"), std::string::npos) << files.back().text;
  // One report has the files of before.
  EXPECT_EQ(kc_files(std::vector<KcReport>{reports[1]}).back().path, "rear.html");
}

KcReport with_variant() {
  KcReport report = report_of_text(steered("hand"), {.travel = 0.02, .steer = 1, .points = 5});
  KcReport stiff = report_of_text(steered("hand", 30000), {.travel = 0.02, .steer = 1, .points = 5});
  report.overlays.push_back({"stiff.json", false, stiff.figures, stiff.tables, {"a note"}});
  return report;
}

TEST(Overlay, OfAVariantIsDrawnAndCompared) {
  const KcReport report = with_variant();
  const std::string text = kc_text(report);
  EXPECT_NE(text.find("\nstiff.json: at the start, and the difference\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  wheel_rate                                  30            10 N/mm\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("note: a note\n"), std::string::npos);
  const std::string picture = kc_files(report)[1].text;
  EXPECT_NE(picture.find(">load_left, stiff.json<"), std::string::npos) << picture;
  EXPECT_NE(picture.find("stroke-dasharray=\"7 4\" d=\"M"), std::string::npos);
  EXPECT_NE(kc_files(report).back().text.find("<h2>stiff.json</h2>"), std::string::npos);
  const auto json = kc_json(report)["overlays"][0];
  EXPECT_NEAR(json["differences"]["wheel_rate"]["values"][0].get<double>(), 10000, 1e-6);
  EXPECT_EQ(json["label"], "stiff.json");
}

Results measured(const std::string& text) { return expect(read_table(text, "m.csv", "")); }

std::string fault_of(const KcReport& report, const std::string& curve, const std::string& text) {
  const Result<KcOverlay> overlay = measured_overlay(report, curve, measured(text), "m.csv");
  if (overlay) return "";
  const std::string fault = to_text(overlay.problems());
  return fault.substr(0, fault.size() - 1);  // without the end of the line
}

TEST(Overlay, OfMeasuredPointsIsInTheUnitsOfTheTable) {
  KcReport report = report_of_text(steered("hand"), {.travel = 0.02, .steer = 1, .points = 5});
  // 20 N/mm: 3 N more than computed everywhere; out of order, with a gap.
  const Results points = measured("load_left [N],travel [mm]\n203,10\n-197,-10\n3,0\n,5\n");
  report.overlays.push_back(expect(measured_overlay(report, "parallel_travel", points, "rig/m.csv")));
  EXPECT_EQ(report.overlays[0].label, "m.csv");
  EXPECT_NEAR(report.overlays[0].tables[0].columns.front().values[0], 0.01, 1e-15);
  const std::string text = kc_text(report);
  EXPECT_NE(text.find("  parallel_travel load_left                    3             3           3 N\n"),
            std::string::npos)
      << text;
  const std::string picture = kc_files(report)[1].text;
  EXPECT_EQ(std::string::npos, kc_files(report)[3].text.find("<circle")) << "opposite travel has no points";
  std::size_t circles = 0;
  for (std::size_t at = 0; (at = picture.find("<circle", at)) != std::string::npos; ++at) ++circles;
  EXPECT_EQ(circles, 4u) << "three points and the legend's";
  EXPECT_EQ(curve_of_file(report, "rig/front_opposite_travel_2.csv"), "opposite_travel");
}

TEST(Overlay, OfMeasuredPointsNamesItsFaults) {
  const KcReport report = report_of_text(steered("hand"), {.travel = 0.02, .steer = 1, .points = 3});
  EXPECT_EQ(
      fault_of(report, "steering", "steer,camber_lft\n0,0\n"),
      "m.csv:1:1: steering of axle front has no column \"camber_lft\"; known: steer, steer_angle_left, camber_left, "
      "centre_x_left, centre_y_left, contact_y_left, load_left, steer_ratio");
  EXPECT_EQ(fault_of(report, "steering", "steer [deg],camber_left [mm]\n0,0\n"),
            "m.csv:1:1: camber_left: its unit must be rad or deg, found mm");
  EXPECT_EQ(fault_of(report, "steering", "camber_left [deg]\n0\n"),
            "m.csv:1:1: needs the column \"steer\", over which steering is drawn");
  EXPECT_EQ(fault_of(report, "steering", "steer\n0\n").find("m.csv:1:1: has no column beside \"steer\"; known: steer,"),
            0u);
  EXPECT_EQ(fault_of(report, "stearing", "steer\n0\n"),
            "m.csv: axle front has no curve \"stearing\"; known: parallel_travel, opposite_travel, steering\n"
            "  hint: call the file like the table of the curve, or write --measured CURVE=FILE.csv");
  EXPECT_EQ(fault_of(report, "steering", "steer,camber_left,steer\n0,0,0\n"),
            "m.csv:1:1: column \"steer\" stands twice");
  EXPECT_EQ(fault_of(report, "", "steer\n0\n").find("m.csv: its name does not tell the curve; known: parallel_travel"),
            0u);
}

}  // namespace
}  // namespace mbgen::kc_test
