// Data of a report's page: poses, shapes, numbers, and text that cannot leave its place.
#include "workbench/report/report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/reader/read_model.hpp"
#include "runtime/generic/generic.hpp"
#include "tests/report/report_support.hpp"
#include "workbench/report/motion.hpp"
#include "workbench/report/poses.hpp"
#include "workbench/report/scene.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

struct Case {
  Model model;
  Topology topology;
  Analysis analysis;
  Results results;
  ReportSource source() const { return {model, topology, analysis, results}; }
};

/// A model with a table of some rows, coordinates growing with time.
Case a_case(Model model, int rows = 3) {
  Topology topology = *build_topology(model);
  Analysis analysis = *analyse(model, topology);
  Results results;
  results.columns.push_back({{"t", "s"}, {}});
  for (int row = 0; row < rows; ++row) results.columns[0].values.push_back(0.1 * row);
  for (const TreeBody& body : topology.bodies) {
    Column column{{"z." + body.coordinate, "rad"}, {}};
    for (int row = 0; row < rows; ++row) column.values.push_back(0.07 * row + 0.01 * results.columns.size());
    results.columns.push_back(std::move(column));
  }
  return {std::move(model), std::move(topology), std::move(analysis), std::move(results)};
}

Json motion_of(const Case& c) {
  return motion_json(GenericSolver(c.model, c.topology, c.analysis), *motion_frames(c.source(), "x.csv"));
}

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64({}), "");
  EXPECT_EQ(base64({0.0f}), "AAAAAA==");
  EXPECT_EQ(base64({1.0f, -2.0f, 0.5f}), "AACAPwAAAMAAAAA/");
}

TEST(KeptRows, KeepEndsAndSpacing) {
  std::vector<double> time;
  for (int i = 0; i <= 5000; ++i) time.push_back(1e-3 * i);
  const std::vector<std::size_t> kept = kept_rows(time, 100000);
  ASSERT_EQ(kept.size(), 501u) << "a frame each 10 ms";
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i], 10 * i);
  EXPECT_EQ(kept_rows(time, 300).size(), 300u);
  EXPECT_EQ(kept_rows(time, 300).back(), 5000u);
  EXPECT_EQ(kept_rows({7.0}, 300), (std::vector<std::size_t>{0}));
  EXPECT_EQ(kept_rows({0, 1e-4, 2e-4}, 300), (std::vector<std::size_t>{0, 1, 2})) << "a short motion keeps all";
}

// Two links of 1 m that swing about y: positions by hand.
TEST(Poses, OfADoublePendulum) {
  const Case pendulum = a_case(model_of("double_pendulum.json"));
  const Json motion = motion_of(pendulum);
  const std::vector<float> poses = decoded(motion["poses"]);
  const std::size_t bodies = pendulum.model.bodies.size();
  ASSERT_EQ(poses.size(), 3 * bodies * 7);
  const Joint& lower = pendulum.model.joints.back();
  for (std::size_t row = 0; row < 3; ++row) {
    const double upper_angle = pendulum.results.columns[1].values[row];
    const Attachment tip = lower.from;  // of the upper link
    const Vector3Quantity& at = pendulum.model.bodies[tip.body].points[tip.point].position;
    const Vector3 local = {at[0].value, at[1].value, at[2].value};
    const Vector3 found = placed(&poses[(row * bodies + tip.body) * 7], local);
    EXPECT_NEAR(found[0], local[0] * std::cos(upper_angle) + local[2] * std::sin(upper_angle), 1e-6);
    EXPECT_NEAR(found[2], local[2] * std::cos(upper_angle) - local[0] * std::sin(upper_angle), 1e-6);
  }
}

/// Adds the global position of the first point of every body to the outputs.
void watch_points(Model& model) {
  model.outputs.clear();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b].points.empty()) continue;
    for (int axis = 0; axis < 3; ++axis) {
      PointOutput output;
      output.point = {static_cast<int>(b), 0};
      output.axis = axis;
      model.outputs.push_back({fmt::format("p{}_{}", b, axis), {}, "m", output});
    }
  }
}

TEST(Poses, CarryThePointsWhereTheOutputsSayTheyAre) {
  for (const char* file : {"coach.json", "truck_mechanism.json"}) {
    Model model = model_of(file);
    watch_points(model);
    const Case vehicle = a_case(std::move(model));
    const std::vector<float> poses = decoded(motion_of(vehicle)["poses"]);
    const GenericSolver solver(vehicle.model, vehicle.topology, vehicle.analysis);
    GenericState state;
    for (int i = 0; i < vehicle.topology.size(); ++i) state.z.push_back(vehicle.results.columns[i + 1].values[2]);
    state.zd.assign(state.z.size(), 0.0);
    state.x = initial_auxiliary_states(vehicle.model);
    GenericDerivative still;
    still.zdd.assign(state.z.size(), 0.0);
    still.xd.assign(state.x.size(), 0.0);
    const std::vector<double> y = solver.outputs(state, state.zd, still).y;
    std::size_t next = 0;
    for (std::size_t b = 0; b < vehicle.model.bodies.size(); ++b) {
      if (vehicle.model.bodies[b].points.empty()) continue;
      const Vector3Quantity& at = vehicle.model.bodies[b].points[0].position;
      const float* pose = &poses[(2 * vehicle.model.bodies.size() + b) * 7];
      const Vector3 found = placed(pose, {at[0].value, at[1].value, at[2].value});
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(found[axis], y[next++], 2e-5) << file << ": " << vehicle.model.bodies[b].name;
      }
    }
  }
}

TEST(Poses, AResultOfAnotherModelIsRefused) {
  Case pendulum = a_case(model_of("double_pendulum.json"));
  pendulum.results.columns[2].heading.name = "z.wrist";
  const auto motion = motion_frames(pendulum.source(), "other.csv");
  ASSERT_FALSE(motion);
  EXPECT_EQ(to_text(motion.problems()),
            fmt::format("other.csv: no column \"z.{}\": not a result of model double_pendulum\n"
                        "  hint: give --model, or simulate again\n",
                        pendulum.topology.bodies[1].coordinate));
}

// By hand from the places of the spring's ends.
TEST(Forces, AreThoseOfTheSpringsLaw) {
  Case four_bar = a_case(model_of("four_bar.json"));
  for (const TreeBody& body : four_bar.topology.bodies) {
    four_bar.results.columns.push_back({{"zd." + body.coordinate, "rad/s"}, {0, 0, 0}});
  }
  const Json table = table_json(four_bar.source());
  ASSERT_EQ(table["columns"].back()["group"], "force");
  const std::string name = four_bar.model.springs[0].name;
  EXPECT_EQ(table["columns"].back()["name"], name + ".force");
  const GenericSolver solver(four_bar.model, four_bar.topology, four_bar.analysis);
  GenericState state;
  for (int i = 0; i < four_bar.topology.size(); ++i) state.z.push_back(four_bar.results.columns[i + 1].values[2]);
  const std::vector<Pose> poses = solver.poses(state);
  const PointSpring& spring = four_bar.model.springs[0];
  Vector3 ends[2];
  for (int e = 0; e < 2; ++e) {
    const Attachment& at = e == 0 ? spring.from : spring.to;
    const Pose& pose = poses[at.body];
    const Vector3Quantity& local = four_bar.model.bodies[at.body].points[at.point].position;
    for (int i = 0; i < 3; ++i) {
      ends[e][i] = pose.origin[i];
      for (int k = 0; k < 3; ++k) ends[e][i] += pose.rotation[3 * i + k] * local[k].value;
    }
  }
  const double length = std::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1], ends[1][2] - ends[0][2]);
  const double force = std::get<Quantity>(*spring.stiffness).value * (length - spring.free_length->value);
  EXPECT_NEAR(table["columns"].back()["last"].get<double>(), force + spring.preload.value, 1e-9 * std::abs(force));
}

std::size_t count_kind(const Json& shapes, const std::string& kind) {
  std::size_t count = 0;
  for (const Json& shape : shapes) count += shape["kind"] == kind ? 1 : 0;
  return count;
}

TEST(Scene, OfTheCoachHasWhatThePeopleKnowOfIt) {
  const Model coach = model_of("coach.json");
  const Json scene = scene_json(coach);
  std::map<std::string, Json> shapes;
  for (const Json& body : scene["bodies"]) shapes[body["name"]] = body["shapes"];
  EXPECT_EQ(count_kind(shapes["wheel_front_left"], "tyre"), 1u);
  EXPECT_EQ(count_kind(shapes["wheel_rear_left"], "tyre"), 2u) << "twins";
  EXPECT_EQ(count_kind(shapes["chassis"], "box"), 8u);
  EXPECT_TRUE(shapes["ground"].empty());
  EXPECT_EQ(coach.bodies[scene["follow"].get<int>()].name, "chassis");
  EXPECT_EQ(scene["road"], -0.022);
  std::map<std::string, int> kinds;
  for (const Json& link : scene["links"]) ++kinds[link["kind"]];
  EXPECT_EQ(kinds, (std::map<std::string, int>{{"air_spring", 8}, {"damper", 8}, {"rod", 11}}))
      << "bump stops stand inside the air springs";
}

TEST(Scene, ABodyIsDrawnWithoutAnyHint) {
  const Json scene = scene_json(model_of("four_bar.json"));
  for (const Json& body : scene["bodies"]) {
    EXPECT_EQ(body["shapes"].empty(), body["name"] == "ground") << body["name"];
  }
  EXPECT_EQ(scene["follow"], -1);
  EXPECT_TRUE(scene["road"].is_null());
  EXPECT_LT(scene["floor"], 0);
}

TEST(Scene, AHookInTheSkyDoesNotMakeTheModelLarge) {
  const Json scene = scene_json(model_of("published/iltis.json"));
  EXPECT_LT(scene["size"].get<double>(), 5) << "of a car on springs that hang from places 1 km above";
  EXPECT_LT(scene["centre"][2].get<double>(), 2);
  std::map<std::string, int> kinds;
  for (const Json& link : scene["links"]) ++kinds[link["kind"]];
  EXPECT_EQ(kinds, (std::map<std::string, int>{{"rod", 4}, {"spring", 4}})) << "and these are not drawn";
}

TEST(Scene, ABumpStopIsARubberThatPointsToTheOtherEnd) {
  const Model model = *read_model(R"({ "mbgen": 1,
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "top": [0.5, 0, 1] } },
                "arm": { "mass": 2, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0], "pad": [0.5, 0, 0] } } },
    "joints": { "turn": { "type": "revolute", "from": "ground.O", "to": "arm.O", "axis": "y" } },
    "springs": { "strut": { "from": "ground.top", "to": "arm.pad", "stiffness": 100 } },
    "bump_stops": { "bump": { "spring": "strut", "clearance": 0.1, "stiffness": 1e4 },
                    "rebound": { "spring": "strut", "side": "extension", "clearance": 0.1, "stiffness": 1e4 },
                    "side": { "from": "arm.pad", "to": "ground.top", "axis": "x", "clearance": 0.1, "stiffness": 1e4 },
                    "end": { "joint": "turn", "side": "above", "clearance": 1, "stiffness": 10 } } })",
                                  "test.json");
  const Json scene = scene_json(model);
  std::map<std::string, Json> marks;
  for (const Json& mark : scene["joints"]) marks[mark["name"]] = mark;
  EXPECT_EQ(marks.size(), 4u) << "the end of a joint has no place of its own";
  for (const char* name : {"bump", "rebound", "side"}) EXPECT_EQ(marks[name]["kind"], "bump_stop") << name;
  EXPECT_EQ(marks["bump"]["body"], 0);
  EXPECT_EQ(marks["bump"]["at"], Json({0.5, 0.0, 1.0}));
  EXPECT_EQ(marks["bump"]["axis"], Json({0.0, 0.0, -1.0}));
  EXPECT_EQ(marks["rebound"]["body"], 1);
  EXPECT_EQ(marks["rebound"]["axis"], Json({0.0, 0.0, 1.0}));
  EXPECT_EQ(marks["side"]["axis"], Json({1.0, 0.0, 0.0}));
}

TEST(Scene, ABushingHasItsAxesForTheArrowOfItsForce) {
  const Model model = *read_model(R"({ "mbgen": 1, "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
    "arm": { "mass": 2, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "arm": { "type": "free", "from": "ground.O", "to": "arm.O" } },
    "bushings": { "eye": { "from": "arm.O", "to": "ground.O", "axis": "y", "axis2": "z", "tz": { "stiffness": 1e6 } } } })",
                                  "test.json");
  const Json marks = scene_json(model)["joints"];
  const Json& eye = marks[marks.size() - 1];
  EXPECT_EQ(eye["kind"], "bushing");
  EXPECT_EQ(eye["axis"], eye["axes"][2]);
  const double expected[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(eye["axes"][k][i].get<double>(), expected[k][i], 1e-15) << k << i;
}

TEST(Scene, AHullHasItsPointsOutsideAndNoSpiderInside) {
  const Model model = *read_model(R"({ "mbgen": 1, "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
    "box": { "mass": 600, "inertia": [250, 850, 1000], "points": { "O": [0, 0, 0], "inside": [0.5, 0, 0], "out": [2.5, 0.3, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "box.O", "axis": "z" } },
    "rods": { "a": { "from": "ground.O", "to": "box.inside" }, "b": { "from": "ground.O", "to": "box.out" } } })",
                                  "test.json");
  const Json scene = scene_json(model);
  const Json& shapes = scene["bodies"][1]["shapes"];
  ASSERT_EQ(count_kind(shapes, "box"), 1u) << shapes;
  ASSERT_EQ(count_kind(shapes, "tube"), 1u) << shapes;
  const double half = shapes[0]["size"][0].get<double>() / 2;
  EXPECT_NEAR(half, std::sqrt(6 * (850 + 1000 - 250) / 600.0) / 2, 1e-12);
  EXPECT_EQ(shapes[1]["from"], Json({half, 0.3, 0.0}));
  EXPECT_EQ(shapes[1]["to"], Json({2.5, 0.3, 0.0}));
}

TEST(Page, ColumnsKnowTheirQuantity) {
  Case pendulum = a_case(*read_model(R"({ "mbgen": 1, "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
    "bob": { "mass": 1, "com": [0, 0, -1], "inertia": [0, 0, 0], "points": { "O": [0, 0, 0], "P": [0, 0, -1] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "bob.O", "axis": "y" } },
    "outputs": { "px": { "point": "bob.P", "quantity": "position", "axis": "x" },
                 "ox": { "point": "bob.O", "quantity": "position", "axis": "x" },
                 "pz": { "point": "bob.P", "quantity": "position", "axis": "z" },
                 "load_1": { "unit": "m", "expression": "z.pin" }, "load_2": { "unit": "m", "expression": "2*z.pin" } } })",
                                     "test.json"));
  for (const char* name : {"px", "ox", "pz", "load_1", "load_2"}) {
    pendulum.results.columns.push_back({{name, "m"}, {0, 1, 2}});
  }
  std::map<std::string, Json> quantities;
  const Json table = table_json(pendulum.source());
  for (const Json& column : table["columns"]) {
    if (column.contains("quantity")) quantities[column["name"]] = column["quantity"];
  }
  EXPECT_EQ(quantities.size(), 5u);
  EXPECT_EQ(quantities["px"], quantities["ox"]);
  EXPECT_NE(quantities["px"], quantities["pz"]);
  EXPECT_EQ(quantities["load_1"], quantities["load_2"]);
  EXPECT_NE(quantities["load_1"], quantities["px"]);
}

/// The data of a page.
Json data_of(const std::string& page) {
  const std::size_t data = page.find('>', page.find("<script id=\"data\"")) + 1;
  return Json::parse(page.substr(data, page.find("</script>", data) - data));
}

// A second result with other times: its values stand at the times of the first one, on the lines between its rows, and
// nowhere after its end.
TEST(Page, OtherResultsHaveTheirColumnsBesideTheFirst) {
  Case first = a_case(model_of("double_pendulum.json"), 5), other = a_case(model_of("double_pendulum.json"), 3);
  first.model.outputs.clear();
  first.results.columns.push_back({{"force", "N"}, {1, 2, 3, 4, 5}});
  other.results.columns.front().values = {0, 0.15, 0.3};
  other.results.columns[1].values = {0, 0.15, 0.6};
  other.results.columns.push_back({{"force", "kN"}, {0, 0, 0}});
  const Json table = table_json(first.source(), {{other.source(), "b.csv", "stiffness = 2"}});
  const std::string name = first.results.columns[1].heading.name;
  const Json& columns = table["columns"];
  ASSERT_EQ(columns.size(), 2 * first.topology.bodies.size() + 2) << "a force of another unit is left out";
  EXPECT_EQ(columns[1]["name"], name);
  EXPECT_FALSE(columns[1].contains("other"));
  EXPECT_EQ(columns[2]["name"], name + " (stiffness = 2)");
  EXPECT_EQ(columns[2]["other"], 1);
  EXPECT_EQ(columns[2]["group"], columns[1]["group"]);
  EXPECT_EQ(columns[2]["largest"], 0.6);
  const std::vector<float> numbers = decoded(table["data"]);
  const auto value = [&](std::size_t row) { return numbers[2 * 5 + row]; };
  EXPECT_NEAR(value(1), 0.1, 1e-7);
  EXPECT_NEAR(value(2), 0.15 + 0.45 / 3, 1e-7);
  EXPECT_NEAR(value(3), 0.6, 1e-7);
  EXPECT_TRUE(std::isnan(value(4))) << "at 0.4 s the other result has ended";
  if (!has_report_page()) return;
  const Json data =
      data_of(*report_html(first.source(), "a.csv", "stiffness = 1", {{other.source(), "b.csv", "stiffness = 2"}}));
  EXPECT_EQ(data["label"], "stiffness = 1");
  ASSERT_EQ(data["others"].size(), 1u);
  EXPECT_EQ(data["others"][0]["label"], "stiffness = 2");
  EXPECT_EQ(data["others"][0]["animation"]["count"], 3);
  EXPECT_TRUE(data["others"][0]["run"].is_null()) << "nothing describes it";
  EXPECT_EQ(data["others"][0]["scene"]["bodies"].size(), first.model.bodies.size());
  EXPECT_FALSE(data_of(*report_html(first.source(), "a.csv")).contains("others"));
  // A result of another model is refused by its own name.
  const Case wrong = a_case(model_of("four_bar.json"));
  const ReportSource foreign{first.model, first.topology, first.analysis, wrong.results};
  const Result<std::string> page = report_html(first.source(), "a.csv", "a", {{foreign, "wrong.csv", "b"}});
  ASSERT_FALSE(static_cast<bool>(page));
  EXPECT_EQ(page.problems().front().where.file, "wrong.csv");
}

TEST(Page, NamesCannotLeaveTheirPlace) {
  if (!has_report_page()) GTEST_SKIP() << "this build has no reports (MBGEN_REPORTS)";
  Case pendulum = a_case(model_of("double_pendulum.json"));
  const std::string hostile = "</script><!-- <b onclick=\"x\">&{{script}}";
  pendulum.model.name = hostile;
  pendulum.model.outputs.clear();
  pendulum.results.columns.push_back({{hostile, "</style>"}, {1, 2, 3}});
  pendulum.results.run = "{\"status\": \"</script>\"}";
  const std::string page = *report_html(pendulum.source(), hostile);
  const std::size_t data = page.find("<script id=\"data\"");
  const std::size_t end = page.find("</script>", data);
  const Json read = Json::parse(page.substr(page.find('>', data) + 1, end - page.find('>', data) - 1));
  EXPECT_EQ(read["model"]["name"], hostile) << "the first end of a script is that of the data";
  EXPECT_EQ(read["table"]["columns"].back()["unit"], "</style>");
  EXPECT_EQ(read["topology"].get<std::string>().find("<!--"), std::string::npos);
  EXPECT_NE(page.find("<title>&lt;/script&gt;&lt;!-- &lt;b onclick=&quot;x&quot;&gt;&amp;{{script}}</title>"),
            std::string::npos);
}

TEST(Page, BytesAreTheSameEachTime) {
  if (!has_report_page()) GTEST_SKIP() << "this build has no reports (MBGEN_REPORTS)";
  const Case pendulum = a_case(model_of("double_pendulum.json"));
  EXPECT_EQ(*report_html(pendulum.source(), "x.csv"), *report_html(pendulum.source(), "x.csv"));
}

}  // namespace
}  // namespace mbgen
